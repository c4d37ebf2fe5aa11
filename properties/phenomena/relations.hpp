// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/stepper.hpp>

/// Relations that need no known answer. A heap of twenty spheres and boxes falls for two seconds, twice. A ball hits a
/// row of balls, which does not gain energy.
namespace carom::properties {

enum class Likeness { same_bits, same_places, same_digits, differs, unanswered };

struct RelationResult {
  std::string_view name;    // of the relation of impulses, if there is one
  std::string_view change;  // "with the bodies in another order"
  Likeness likeness = Likeness::unanswered;
  int digits = 0;     // if `same_digits`: places and attitudes agree to 10 to the power −digits, in m and rad
  double time = 0;    // [s]: the end, or the time from which on they differ by more than a millimetre or milliradian
  std::string why;    // if unanswered
  double energy = 0;  // of the row of balls, relative to the energy before; 0 for the heap
  bool is_failure = false;  // if unanswered: as of `NoAnswer`
};

/// The heap. A planar one has discs and rectangles.
[[nodiscard]] SteppedScene heap(bool planar);

/// Poses the heap, each related heap, and the row of balls, with this step.
[[nodiscard]] std::vector<RelationResult> heap_relations(const Stepper& stepper, Stepper::Session& session,
                                                         double step);

/// "same bits", "same places, other velocities until 2 s", "same to 6 digits until 2 s", "differs from 0.65 s on",
/// "0.98 times the energy", or the reason for no answer.
[[nodiscard]] std::string in_words(const RelationResult& result);

}  // namespace carom::properties
