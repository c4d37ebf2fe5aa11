// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <carom/collision/law.hpp>
#include <carom/collision/vector.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/laws/truth.hpp>

namespace carom::oracles {

struct ScalarBall {
  double centre = 0;
  double radius = 0;

  [[nodiscard]] double least() const { return centre - radius; }
  [[nodiscard]] double largest() const { return centre + radius; }
  [[nodiscard]] bool contains(double x) const { return std::abs(x - centre) <= radius; }
};

struct VectorBall {
  Vector3<double> centre = Vector3<double>::Zero();
  double radius = 0;

  /// The largest length of a vector in the ball.
  [[nodiscard]] double largest() const { return norm_of(centre) + radius; }
};

[[nodiscard]] inline ScalarBall operator-(const ScalarBall& x) { return {-x.centre, x.radius}; }
[[nodiscard]] inline ScalarBall operator+(const ScalarBall& x, const ScalarBall& y) {
  return {x.centre + y.centre, x.radius + y.radius};
}
[[nodiscard]] inline ScalarBall operator*(const ScalarBall& x, const ScalarBall& y) {
  return {x.centre * y.centre, std::abs(x.centre) * y.radius + x.radius * std::abs(y.centre) + x.radius * y.radius};
}

[[nodiscard]] inline VectorBall operator-(const VectorBall& v) { return {-v.centre, v.radius}; }
[[nodiscard]] inline VectorBall operator+(const VectorBall& v, const VectorBall& w) {
  return {v.centre + w.centre, v.radius + w.radius};
}
[[nodiscard]] inline VectorBall operator-(const VectorBall& v, const VectorBall& w) { return v + -w; }
[[nodiscard]] inline VectorBall operator*(const ScalarBall& x, const VectorBall& v) {
  return {x.centre * v.centre, std::abs(x.centre) * v.radius + x.radius * v.largest()};
}

namespace detail {

/// The radius of a bilinear product v ∘ w of two vectors. Precondition: ‖v ∘ w‖ ≤ ‖v‖ ‖w‖.
[[nodiscard]] inline double radius_of_product(const VectorBall& v, const VectorBall& w) {
  return norm_of(v.centre) * w.radius + v.radius * w.largest();
}

}  // namespace detail

[[nodiscard]] inline ScalarBall dot(const VectorBall& v, const VectorBall& w) {
  return {v.centre.dot(w.centre), detail::radius_of_product(v, w)};
}
[[nodiscard]] inline VectorBall cross(const VectorBall& v, const VectorBall& w) {
  return {v.centre.cross(w.centre), detail::radius_of_product(v, w)};
}

class ExactCase;

/// All collisions whose quantities (quantities.hpp) differ from those of a given collision by at most `allowance` times
/// their lengths. The class encloses a law's answers to these collisions. The judge uses it if derivatives do not
/// describe these answers (`derivatives_fail`).
class PermittedInputs {
 public:
  /// Preconditions: the collision is valid; 0 < allowance < 1/2.
  PermittedInputs(const ExactCase& exact_case, double allowance);

  /// Whether derivatives fail to describe the law's answers to permitted inputs, by conditions 1 to 3 of
  /// docs/reference/yardstick.md#hard-cases. `normal_velocity_sensitivity` is Σ_q ‖∂(N·V⁻)/∂q‖ ‖q‖.
  [[nodiscard]] static bool derivatives_fail(const Collision& collision, double allowance,
                                             double normal_velocity_sensitivity);

  /// Whether velocities, lever arms, and the bodies' responses to an impulse have finite enclosures.
  [[nodiscard]] bool is_finite() const;

  /// For each vector, an upper bound of the distance from y to the law's answers to permitted inputs. The vector y
  /// belongs to the law's colliding answer, with the impulse `impulse`. If `from_rest`, y is the vector before the
  /// impulse instead. The bound is infinite if a number leaves the range of binary64. Preconditions: `exact_case` is
  /// that of the constructor; a body is movable; the law is one of `laws_with_truth`.
  [[nodiscard]] PerVector<double> distance_of_answers(const ExactCase& exact_case, const Vector3<double>& impulse,
                                                      Law law, Branch branch, bool from_rest) const;

  /// Whether answers of the law `rough` to permitted inputs may lie on both sides of the cone's surface.
  /// Preconditions: `exact_case` is that of the constructor; a body is movable.
  [[nodiscard]] bool reach_both_sides_of_cone(const ExactCase& exact_case) const;

  /// An upper bound of the second-order change of K by changes δr of the lever arms: Σ ‖[δr]ᵀ J⁻¹ [δr]‖ over the
  /// bodies, with [δr] y = δr × y.
  [[nodiscard]] double second_order_of_matrix() const;

  /// V⁻.
  [[nodiscard]] const VectorBall& relative_velocity() const { return relative_velocity_; }
  /// N·V⁻ / ‖N‖.
  [[nodiscard]] const ScalarBall& normal_velocity() const { return normal_velocity_; }

  /// N / ‖N‖.
  [[nodiscard]] const VectorBall& unit_normal() const { return unit_normal_; }
  [[nodiscard]] const VectorBall& lever_arm_of_a() const { return a_.arm; }
  [[nodiscard]] const VectorBall& lever_arm_of_b() const { return b_.arm; }

  [[nodiscard]] double allowance() const { return allowance_; }
  [[nodiscard]] ScalarBall scalar(double x) const { return {x, allowance_ * std::abs(x)}; }
  [[nodiscard]] VectorBall vector(const Vector3<double>& v) const { return {v, allowance_ * norm_of(v)}; }

 private:
  struct OfBody {
    Body body;
    VectorBall arm;
  };
  struct Change {
    VectorBall velocity;
    VectorBall angular_velocity;
  };
  /// The impulses P_I and D = P_II − P_I of the law `rough` (models/rough.hpp), and the least and the largest κ that
  /// put F on the cone's surface.
  struct RoughParts {
    VectorBall stops_approach;
    VectorBall difference;
    double least_share;
    double largest_share;
  };

  [[nodiscard]] VectorBall rotated(const VectorBall& v, const Quaternion<double>& orientation) const;
  [[nodiscard]] Change response(const OfBody& of, const VectorBall& impulse) const;
  /// K F.
  [[nodiscard]] VectorBall response_at_point(const VectorBall& impulse) const;
  /// All impulses F′ = φ′ N′ with |N′·K′ F′ − N·K F| ≤ `radius`, for F = `impulse`. A prime marks the numbers of
  /// permitted inputs. Precondition: F is along N.
  [[nodiscard]] VectorBall along_normal(const Vector3<double>& impulse, double radius) const;
  /// All impulses F′ with ‖K′ F′ − K F‖ ≤ `radius`, for F = `impulse`.
  [[nodiscard]] VectorBall by_matrix(const Vector3<double>& impulse, double radius) const;
  [[nodiscard]] RoughParts rough_parts(const ExactCase& exact_case) const;
  [[nodiscard]] VectorBall rough(const ExactCase& exact_case, const Vector3<double>& impulse) const;
  [[nodiscard]] VectorBall impulses(const ExactCase& exact_case, const Vector3<double>& impulse, Law law,
                                    Branch branch) const;

  double allowance_;
  OfBody a_;
  OfBody b_;
  VectorBall unit_normal_;
  VectorBall relative_velocity_;
  ScalarBall normal_velocity_;
  ScalarBall restitution_;
  ScalarBall friction_;
  ScalarBall whole_share_;       // 1 + e_t
  double least_inverse_mass_{};  // lower bound of λ
};

}  // namespace carom::oracles
