// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/impulse/numbers/difference_of_products.hpp>
#include <carom/properties/conformance/subject.hpp>
#include <carom/properties/draws/moment_ratio.hpp>
#include <carom/properties/gate/gate.hpp>

/// Solvers in coordinates that users might choose. Solvers that divide torques by the moments in the body frame are
/// sound. A needle struck on its tip needs an accurate cross product, or vectors in body axes. A solver with the
/// inverse inertia tensor in world axes fails on slender bodies.
namespace carom::properties {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;

/// v / ‖v‖. The scaling prevents an overflow of squares.
template <class V>
V unit(const V& v) {
  const V scaled = v / v.cwiseAbs().maxCoeff();
  return scaled / scaled.norm();
}

Matrix axes_of(const Body& body) {
  const Quaternion<double> q = unit(body.orientation);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

/// The spin J⁻¹ (r × N) of a body, and N·(spin × r).
struct Response {
  Vector spin;
  double along_normal;
};
using FindResponse = std::function<Response(const Body&, const Vector& arm, const Vector& normal)>;

/// The law `frictionless`. `turn` maps world axes to the axes in which `response` computes.
struct Solver {
  std::function<Matrix(const Collision&)> turn;
  FindResponse response;

  Outcome<double> operator()(const Collision& c) const {
    const Matrix to = turn(c);
    const Vector normal = unit(Vector(to * c.normal));
    const auto arm = [&](const Body& body) { return Vector(to * (c.point - body.position)); };
    const auto velocity = [&](const Body& body) {
      return Vector(to * body.velocity + Vector(to * body.angular_velocity).cross(arm(body)));
    };
    Outcome<double> after = unchanged(c);
    const double approach = normal.dot(velocity(c.a) - velocity(c.b));
    if (approach >= 0 || (c.a.immovable && c.b.immovable)) {
      return after;
    }
    double divisor = 0;
    const auto add = [&](const Body& body) {
      return body.immovable ? Response{Vector::Zero(), 0} : response(turned(body, to), arm(body), normal);
    };
    const Response of_a = add(c.a);
    const Response of_b = add(c.b);
    divisor += c.a.immovable ? 0 : 1 / c.a.mass + of_a.along_normal;
    divisor += c.b.immovable ? 0 : 1 / c.b.mass + of_b.along_normal;
    const double impulse = -(1 + c.restitution) * approach / divisor;
    const auto push = [&](const Body& body, const Response& of, BodyVelocity<double>& motion, double sign) {
      if (!body.immovable) {
        motion.velocity += to.transpose() * normal * (sign * impulse / body.mass);
        motion.angular_velocity += to.transpose() * of.spin * (sign * impulse);
      }
    };
    push(c.a, of_a, after.a, 1);
    push(c.b, of_b, after.b, -1);
    return after;
  }

  static Body turned(Body body, const Matrix& to) {
    const Eigen::Quaterniond q(Matrix(to * axes_of(body)));
    body.orientation = {q.w(), q.x(), q.y(), q.z()};
    return body;
  }
};

Matrix world(const Collision& /*collision*/) { return Matrix::Identity(); }

/// {N, T0, T1}. T0 is orthogonal to N and to the axis along which N has its least component.
Matrix contact_basis(const Collision& c) {
  const Vector n = unit(c.normal);
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Vector t = unit(Vector(n.cross(Vector::Unit(least))));
  Matrix basis;
  basis.row(0) = n;
  basis.row(1) = t;
  basis.row(2) = n.cross(t);
  return basis;
}

/// Rotates the torque into the body frame, divides it by the moments, and rotates the quotient back.
Response by_torque_in_body(const Body& body, const Vector& arm, const Vector& normal) {
  const Matrix axes = axes_of(body);
  const Vector torque = impulse::accurate_cross<double>(arm, normal);
  const Vector in_body = axes.transpose() * torque;
  const Vector spin = axes * in_body.cwiseQuotient(body.principal_inertia);
  return {spin, torque.dot(spin)};
}

Response in_body(const Body& body, const Vector& arm, const Vector& normal) {
  const Matrix axes = axes_of(body);
  const Vector torque = (axes.transpose() * arm).cross(axes.transpose() * normal);
  const Vector spin = torque.cwiseQuotient(body.principal_inertia);
  return {axes * spin, torque.dot(spin)};
}

/// Multiplies by J⁻¹ in world axes, which many engines store.
Response by_world_inertia(const Body& body, const Vector& arm, const Vector& normal) {
  const Matrix axes = axes_of(body);
  const Matrix inverse = axes * body.principal_inertia.cwiseInverse().asDiagonal() * axes.transpose();
  const Vector spin = inverse * arm.cross(normal);
  return {spin, normal.dot(spin.cross(arm))};
}

struct Named {
  const char* name;
  Solver solver;
};

SubjectResult gated(const Named& named) {
  GateOptions options;
  for (const Family& family : all_families()) {
    options.families.push_back(&family);
  }
  options.cases = 100;
  options.seed = 5;
  options.relations_every = 4;
  const Subject subject = conformance::subject<double>(named.name, Law::frictionless, named.solver);
  return run_gate({subject}, options).results.at(0);
}

TEST(Coordinates, AreTheSolversOwn) {
  for (const Named& named :
       {Named{"in world coordinates", {world, by_torque_in_body}}, Named{"in body coordinates", {world, in_body}},
        Named{"in contact coordinates", {contact_basis, by_torque_in_body}}}) {
    const SubjectResult result = gated(named);
    EXPECT_TRUE(result.error.empty()) << result.error;
    EXPECT_TRUE(result.is_sound()) << result.not_judged;
    for (const Invariant* invariant : result.violated_invariants()) {
      ADD_FAILURE() << named.name << " violates " << invariant->name;
    }
  }
}

double greater_moment_ratio(const Collision& c) { return std::max(moment_ratio(c.a), moment_ratio(c.b)); }

/// If J⁻¹ is in world axes, a residual in ulps is at most a tenth of the ratio of the moments
/// (docs/findings/accuracy.md).
TEST(Coordinates, OfTheWorldLoseSlenderBodiesAlone) {
  const SubjectResult result = gated({"with J⁻¹ in world axes", {world, by_world_inertia}});
  std::size_t seen = 0;
  for (const FamilyResult& family : result.families) {
    for (const auto& [invariant, worst] : family.worst) {
      EXPECT_GE(greater_moment_ratio(worst.original.collision), 30) << invariant->name;
      ++seen;
    }
    for (const ViolatedCase& violated : family.first_violated) {
      EXPECT_GE(greater_moment_ratio(violated.one.collision), 30);
      ++seen;
    }
  }
  EXPECT_GT(seen, 0U);
}

}  // namespace
}  // namespace carom::properties
