// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <carom/collision/model.hpp>
#include <carom/collision/outcome.hpp>
#include <carom/collision/precision.hpp>

namespace carom {

/// The case cannot be posed to the subject. Counted, never a pass.
struct Skipped {
  std::string why;
};

/// The subject refused the input: right for an invalid collision, wrong for a valid one.
struct Refused {
  std::string why;
};

using Answer = std::variant<ReportedOutcome, Skipped, Refused>;

/// Answers collisions in order, one answer each. Used by one thread at a time.
using Session = std::function<std::vector<Answer>(std::span<const Collision>)>;

/// A solver under test.
struct Subject {
  std::string name;
  std::string summary;
  Model model = Model::any;
  Precision precision = Precision::binary64;
  /// Whether its author claims that it is right. One that is kept because it fails is shown, and does not count.
  bool expected_to_pass = true;
  /// Names of invariants that the subject does not claim.
  std::vector<std::string> deviates;
  /// Why the subject cannot be run here (an engine that is not installed); empty where it can.
  std::string absent;
  /// A session of its own for each thread. Empty where `absent` is not.
  std::function<Session()> open;
  /// The collision matrix as the subject computes it, in an orthonormal basis of its choice; empty where it shows none.
  /// Precondition: the collision is valid.
  std::function<Matrix3<long double>(const Collision&)> collision_matrix;
};

}  // namespace carom
