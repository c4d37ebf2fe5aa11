// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/impulse/contact.hpp>

namespace carom::mutants {

/// The input of the computation of an impulse.
struct Problem {
  Law law;
  impulse::Contact<double> contact;
  Vector3<double> velocity;  // V⁻, the relative velocity [m/s]
  Matrix3<double> matrix;    // K, the collision matrix [1/kg]
};

/// The uses of a body's data in a solver. A defect may concern any of them.
enum Use : unsigned { in_velocity = 1, in_matrix = 2, in_application = 4, in_impulse = 3, everywhere = 7 };

/// The changes that a defect makes in a solver. An empty function changes nothing.
struct Change {
  std::function<void(Collision&)> read;  // leaves the collision valid
  unsigned uses = 0;                     // uses of the data that `data` changes
  std::function<void(impulse::Contact<double>&, const Collision&)> data;
  std::function<bool(const Problem&)> test;                // in place of N·V⁻ < 0
  std::function<void(Problem&)> problem;                   // before the impulse is computed
  std::function<Vector3<double>(const Problem&)> impulse;  // F, in place of the law's [N s]
  std::function<void(Vector3<double>&, const Problem&)> impulse_after;
  std::function<void(Outcome<double>&)> outcome;
};

/// F of the law [N s], computed with the problem's matrix. Precondition: the matrix is positive definite.
[[nodiscard]] Vector3<double> impulse_by_matrix(const Problem& problem);

/// The subject that computes the law in binary64 with these changes. Without changes, it is sound.
[[nodiscard]] Subject changed_solver(std::string name, Law law, std::vector<Change> changes);

}  // namespace carom::mutants
