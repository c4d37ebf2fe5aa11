// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <carom/properties/plan/candidate.hpp>

namespace carom::tool::plan {

/// The C++ call of a built-in method, for a program that links carom::impulse.
struct CppCall {
  std::vector<std::string> headers;  // "carom/impulse/frictionless.hpp"
  std::string reads;                 // the input of the call, "const carom::Collision& collision"
  std::string call;                  // "carom::impulse::frictionless(carom::impulse::make_contact<float>(collision))"
};

/// A built-in method as a candidate, with its call.
struct CallableCandidate {
  properties::plan::Candidate candidate;
  CppCall code;
};

/// The method of this subject. None for methods whose tangent basis fails near head-on collisions. Throws
/// std::logic_error if no method has this name.
[[nodiscard]] std::optional<CallableCandidate> callable_candidate(const Subject& subject);

[[nodiscard]] std::vector<CallableCandidate> callable_candidates();

}  // namespace carom::tool::plan
