// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <variant>
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
  double length_of_normal;   // as read
};

/// The uses of a body's data in a solver. A defect may concern any of them.
enum Use : unsigned { in_velocity = 1, in_matrix = 2, in_application = 4, in_impulse = 3, everywhere = 7 };

/// The bodies whose data are wrong, and in which use.
struct Place {
  bool a = true;
  bool b = true;
  Use use = everywhere;
};

/// The numbers and the place that a seed draws for a defect.
struct Drawn {
  std::size_t way = 0;  // of the ways in which the defect can be
  double number = 0;
  int axis = 0;
  Place at = {};
};

// The changes that a defect can make in a solver.
using ReadCollision = void (*)(Collision&, const Drawn&);  // leaves the collision valid
using ReadBody = void (*)(Body&, const Drawn&);            // for each body of the place
using UseContact = void (*)(impulse::Contact<double>&, const Collision& read, const Drawn&);  // in the place's use
using UseBody = void (*)(impulse::ContactBody<double>&, const Body& read, const Drawn&);      // in the place
using TestApproach = bool (*)(const Problem&, const Drawn&);                                  // in place of N·V⁻ < 0
using ChangeProblem = void (*)(Problem&, const Drawn&);                    // before the impulse is computed
using ComputeImpulse = Vector3<double> (*)(const Problem&, const Drawn&);  // F, in place of the law's [N s]
using ChangeImpulse = void (*)(Vector3<double>&, const Problem&, const Drawn&);
using ChangeOutcome = void (*)(Outcome<double>&, const Drawn&);
using Change = std::variant<ReadCollision, ReadBody, UseContact, UseBody, TestApproach, ChangeProblem, ComputeImpulse,
                            ChangeImpulse, ChangeOutcome>;

struct DrawnChange {
  Change change;
  Drawn drawn;
};

/// F of the law [N s], computed with the problem's matrix. Precondition: the matrix is positive definite.
[[nodiscard]] Vector3<double> impulse_by_matrix(const Problem& problem);

/// The subject that computes the law in binary64 with these changes. Without changes, it is sound.
[[nodiscard]] Subject changed_solver(std::string name, Law law, std::vector<DrawnChange> changes);

}  // namespace carom::mutants
