// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/stepper.hpp>

namespace carom::properties {

/// A number that a run shows, beside the known answer.
struct Reading {
  std::string what;  // "height of bounce 1, ε = 0.5"
  std::string unit;  // "m"; empty for a ratio
  double measured = 0;
  double right = 0;
  double bound = 0;       // of the rounding of `right`, and of what reading it off rounded states may cost
  double scale = 1;       // the relative error is |measured − right| / scale; > 0
  double step_worth = 0;  // the error that one step's worth of acceleration explains; 0 if none is explained
};

/// A scene, posed with a step and a phase, and how its answer is read.
struct PosedRun {
  Stepping stepping;
  std::function<std::vector<Reading>(const SteppedStates&)> read;
};

/// The steps and the phases at which a phenomenon is measured.
struct Ladder {
  std::vector<double> steps;  // h [s], descending
  unsigned phases = 24;       // of the impact within a step
};

/// The steps 1/30, 1/60, …, 1/3840 s, and 24 phases.
[[nodiscard]] Ladder full_ladder();

/// The steps 1/60 and 1/240 s, and six phases.
[[nodiscard]] Ladder quick_ladder();

/// A named set-up in time with a known answer. It is frozen: another set-up has another version.
struct Phenomenon {
  std::string_view name;  // "slide-to-roll"
  unsigned version = 1;
  std::string_view question;  // "Does a ball that slides end up rolling at 5/7 of its speed?"
  std::string_view set_up;    // in numbers
  std::string_view answer;    // the equation, with its source
  std::string_view measured;  // what is read off the states
  std::string_view yardstick;
  /// The runs for a ladder. A planar stepper gets only scenes in the plane z = 0, with discs and rectangles.
  std::vector<PosedRun> (*runs)(const Ladder& ladder, bool planar);
};

/// The ten phenomena, one file each.
[[nodiscard]] std::span<const Phenomenon> all_phenomena();
[[nodiscard]] std::vector<std::string> phenomenon_names();

}  // namespace carom::properties
