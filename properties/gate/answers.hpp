// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <exception>
#include <span>
#include <stdexcept>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/oracles/laws/judge_error.hpp>

namespace carom::properties {

/// A subject threw an exception that is no SessionFailure, or gave too few or too many answers.
class SubjectError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// call(), which calls the subject. An exception of the subject becomes a SubjectError, so that it differs from a fault
/// of the judge.
template <class Call>
auto of_subject(const Call& call) {
  try {
    return call();
  } catch (const SessionFailure&) {
    throw;
  } catch (const oracles::JudgeError&) {
    throw;
  } catch (const std::exception& error) {
    throw SubjectError(error.what());
  }
}

/// The answers of a session, one for each collision. Throws SessionFailure or SubjectError.
[[nodiscard]] std::vector<Answer> answers_of(Session& session, std::span<const Collision> collisions);

}  // namespace carom::properties
