// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// The state of a body that turns without torque, at one time.
struct RotationState {
  Quaternion<double> orientation{1, 0, 0, 0};  // body axes to world axes, of length 1 within rounding
  Vector3<double> body_rate{0, 0, 0};          // the angular velocity along the body axes [rad/s]
};

/// The angular velocity along the world axes [rad/s].
[[nodiscard]] Vector3<double> world_rate(const RotationState& state);

/// The state for an orientation and an angular velocity in world axes. Precondition: the orientation is not zero.
[[nodiscard]] RotationState rotation_state(const Quaternion<double>& orientation, const Vector3<double>& world_rate);

/// A state, with bounds of its distance from the exact motion that begins with the path's first state.
struct BoundedRotation {
  RotationState state;
  double angle_error = 0;  // upper bound of the angle between the exact and this orientation [rad]
  double rate_error = 0;   // upper bound of the distance of body_rate from the exact rate [rad/s]
};

/// The free rotation of a body over a duration. Taylor series of high order, step after step, solve q' = ½ q ω and
/// Euler's equations I₁ ω₁' = (I₂ − I₃) ω₂ ω₃ (and so on). Here q is the orientation, ω the angular velocity along the
/// body axes, and I the moments. The series are stored, so the state at any time is one evaluation. Along other axes,
/// the ω of a slender body would lose digits.
///
/// Let aᵢ = (Iⱼ − Iₖ)/Iᵢ for cyclic i, j, k, and α = max |aᵢ| ≤ 1 (`a` in the code). Let W = ‖ω‖ at the beginning of a
/// step. The norms of the Taylor coefficients of ω are at most the coefficients of W/(1 − α W t). The norms of those of
/// q are at most the coefficients of (1 − α W t)^(−1/(2α)). Both follow by induction from ‖(x₂y₃, x₃y₁, x₁y₂)‖ ≤ ‖x‖
/// ‖y‖. So a geometric series bounds the remainder of each series. A similar recurrence bounds the rounding errors of
/// the coefficients.
///
/// The class uses the smaller of two bounds of the factor by which an error of ω grows. Gronwall's bound is exp ∫Λ,
/// with Λ the greatest eigenvalue of the symmetric part of ∂ω'/∂ω. The second bound applies to errors below 2⁻²⁰ ‖ω‖:
/// it multiplies the derivatives of the steps, in orthogonal frames (R. Lohner, "Enclosing the solutions of ordinary
/// initial and boundary value problems", 1987). An error e of ω [rad/s] changes the orientation by at most the angle e
/// each second. Errors of the orientation do not grow.
class RotationPath {
 public:
  /// Preconditions: the moments are positive, and each is at most the sum of the others (within rounding). The duration
  /// is finite and ≥ 0. The angle ‖ω‖ × duration is at most about 10⁵ (the path stores about eight steps a radian).
  RotationPath(const Vector3<double>& principal_inertia, const RotationState& start, double duration);

  /// The path of a body that does not turn, for any duration.
  explicit RotationPath(const Quaternion<double>& orientation);

  /// The state at a time [s]. Precondition: 0 ≤ time ≤ duration.
  [[nodiscard]] BoundedRotation at(double time) const;

  [[nodiscard]] double duration() const { return duration_; }

  /// An upper bound of ‖ω‖ at any time [rad/s], for the exact and the computed motion: the greatest ‖ω‖ with the same
  /// energy and angular momentum.
  [[nodiscard]] double greatest_rate() const { return greatest_rate_; }

  /// An upper bound of ‖ω'‖/‖ω‖² at any time: α/√3. The acceleration of a point at r is at most ‖ω‖² (1 + this bound)
  /// ‖r‖.
  [[nodiscard]] double greatest_turning() const { return greatest_turning_; }

 private:
  static constexpr int order = 18;

  struct Step {
    double start = 0;   // [s]
    double length = 0;  // [s]
    double angle_error = 0;
    double rate_error = 0;
    double growth = 1;  // upper bound of the growth of an error of ω within the step
    // Column k is the coefficient of ((t − start)/length)ᵏ.
    Eigen::Matrix<double, 4, order + 1> orientation;
    Eigen::Matrix<double, 3, order + 1> rate;
  };

  struct Bounds {
    double scaled_length = 0;  // ‖ω‖ × length of a step
    double angle = 0;          // increase of angle_error in a step [rad]
    double relative_rate = 0;  // increase of rate_error in a step, relative to ‖ω‖
  };

  [[nodiscard]] static Bounds bounds_for(double a);
  void add_step(const BoundedRotation& start, double time, double length);
  [[nodiscard]] BoundedRotation evaluate(const Step& step, double time) const;

  Vector3<double> a_{0, 0, 0};  // (Iⱼ − Iₖ)/Iᵢ
  double duration_ = 0;
  double greatest_rate_ = 0;
  double greatest_turning_ = 0;
  Bounds bounds_;
  std::vector<Step> steps_;
  RotationState start_;
};

}  // namespace carom::scene
