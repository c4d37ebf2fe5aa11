// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/collision/collision.hpp>
#include <carom/collision/law.hpp>

namespace carom::properties::diagnosis {

/// The order in which a solver computes the normal and the tangential part of an impulse.
enum class FrictionOrder {
  together,           // as the law says
  after_normal,       // once, against the slip that the frictionless impulse leaves
  of_slip_before,     // once, against the slip before the impulse
  apart_from_normal,  // the law's tangential part, and the frictionless normal part
  before_normal,      // once, before the normal impulse
  before_approach,    // once, before the normal impulse, which is that of the approach then
  along_slip,         // together; beyond the cone, against the slip before
  along_sticking,     // together; beyond the cone, along the impulse that stops the slip
};

enum class FrictionLimit {
  cone,
  box,      // each of two tangential parts is limited alone
  pyramid,  // the sum of two tangential parts is limited
  none,     // friction always stops the slip
  always,   // friction is always μ F_n
};

/// The tangents of a box or a pyramid.
enum class Tangents {
  beside_normal,  // the first is orthogonal to the x or z axis, whichever is less along N
  of_least_axis,  // the first is the part across N of the axis that is least along N
  branchless,     // T. Duff and others, Building an Orthonormal Basis, Revisited, JCGT 6, 2017
  of_slip,        // the first is along the slip
};

/// The impulse that stops a slip, in a solver.
enum class FrictionResponse {
  along_slip,        // the slip over t·K t, with its direction t
  by_matrix,         // by K across N
  without_turning,   // as if the bodies could not turn
  of_solid_spheres,  // 2/7 of the slip over 1/m_A + 1/m_B
  of_read_slip,      // as the slip, with its mistakes, responds
};

/// How a solver computes friction. The default makes no mistake.
struct FrictionSteps {
  FrictionOrder order = FrictionOrder::together;
  FrictionLimit limit = FrictionLimit::cone;
  Tangents tangents = Tangents::beside_normal;
  FrictionResponse response = FrictionResponse::along_slip;
  double stopped = 1;    // the share of the slip that friction stops
  double spin_of_a = 1;  // the factor of A's spin in the slip
  double spin_of_b = 1;
  bool has_arms_of_length_1 = false;  // in the slip

  bool operator==(const FrictionSteps&) const = default;
};

/// J⁻¹ of a movable body in world axes, as a solver computes it.
using InverseInertia = Matrix3<long double> (*)(const BasicBody<long double>&);

/// R diag(1/I) Rᵀ.
[[nodiscard]] Matrix3<long double> inverse_inertia(const BasicBody<long double>& body);

/// How a solver computes the collision matrix K, and J⁻¹ in both steps. The default makes no mistake.
struct MatrixSteps {
  InverseInertia inverse_of_a = inverse_inertia;
  InverseInertia inverse_of_b = inverse_inertia;
  double added = 0;  // to the diagonal [1/kg]
  bool is_diagonal = false;

  bool operator==(const MatrixSteps&) const = default;
};

/// Whether the law has a tangential impulse against the slip.
[[nodiscard]] bool has_friction(Law law);

/// The impulse on A [N s] of a solver that makes these mistakes, in the formula for a contact that collides. No value
/// if there is none, or if `coulomb` has several answers. Preconditions: the collision is valid; a body is movable.
[[nodiscard]] std::optional<Vector3<double>> impulse_by(const Collision& collision, Law law, const FrictionSteps& steps,
                                                        const MatrixSteps& matrix = {});

}  // namespace carom::properties::diagnosis
