// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <carom/properties/plan/candidate.hpp>

namespace carom::tool::plan {

/// How a built-in method is called from C++, as a program that links carom::impulse writes it.
struct Spelling {
  std::vector<std::string> headers;  // "carom/impulse/frictionless.hpp"
  std::string reads;                 // what the call reads, "const carom::Collision& collision"
  std::string call;                  // "carom::impulse::frictionless(carom::impulse::make_contact<float>(collision))"
};

/// A built-in method as a candidate, with its spelling.
struct SpelledCandidate {
  properties::plan::Candidate candidate;
  Spelling spelling;
};

/// The method of this subject; none where it is not to be chosen: its basis fails near head-on, whatever a file holds.
/// Throws std::logic_error if no method has this name.
[[nodiscard]] std::optional<SpelledCandidate> spelled(const Subject& subject);

/// Every method that may be chosen.
[[nodiscard]] std::vector<SpelledCandidate> spelled_candidates();

}  // namespace carom::tool::plan
