// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <carom/properties/plan/candidate.hpp>

namespace carom::tool::plan {

/// The call of a built-in method in C++, in a program that links carom::impulse.
struct Spelling {
  std::vector<std::string> headers;  // "carom/impulse/frictionless.hpp"
  std::string reads;                 // the input of the call, "const carom::Collision& collision"
  std::string call;                  // "carom::impulse::frictionless(carom::impulse::make_contact<float>(collision))"
};

/// A built-in method as a candidate, with its spelling.
struct SpelledCandidate {
  properties::plan::Candidate candidate;
  Spelling spelling;
};

/// The method of this subject. None if plans never choose it, because its basis fails near head-on. Throws
/// std::logic_error if no method has this name.
[[nodiscard]] std::optional<SpelledCandidate> spelled(const Subject& subject);

/// Every method that a plan may choose.
[[nodiscard]] std::vector<SpelledCandidate> spelled_candidates();

}  // namespace carom::tool::plan
