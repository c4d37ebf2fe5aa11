// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <carom/collision/vector.hpp>

namespace carom::scene {

/// A body that turns without torque, at one time.
struct RotationState {
  Quaternion<double> orientation{1, 0, 0, 0};  // body axes to world axes, of length 1 within rounding
  Vector3<double> body_rate{0, 0, 0};          // the angular velocity along the body axes [rad/s]
};

/// The angular velocity along the world axes [rad/s].
[[nodiscard]] Vector3<double> world_rate(const RotationState& state);

/// Orientation and world angular velocity as they are after an impact. Precondition: the orientation is not zero.
[[nodiscard]] RotationState rotation_state(const Quaternion<double>& orientation, const Vector3<double>& world_rate);

/// A state with what it may be wrong by, against the exact motion from the state that the path began with.
struct BoundedRotation {
  RotationState state;
  double angle_error = 0;  // at least the angle of the rotation from the exact orientation to this one [rad]
  double rate_error = 0;   // at least the distance of body_rate from the exact one [rad/s]
};

/// The free rotation of a body over a duration: Euler's equations I₁ ω₁' = (I₂ − I₃) ω₂ ω₃ (and so on) and
/// q' = ½ q ω by Taylor series of high order, step after step, kept so that the state at any time is one evaluation.
///
/// Rates are taken along the body axes since there alone slender bodies keep their digits: a world angular momentum,
/// divided by the moments, would lose I_max/I_min.
///
/// The bound. Let aᵢ = (Iⱼ − Iₖ)/Iᵢ; a body has |aᵢ| ≤ 1, and a is the greatest. With W = ‖ω‖ where a step begins, the
/// coefficients of ω are at most those of W/(1 − a W t), and those of q at most those of (1 − a W t)^(−1/(2a)) (both by
/// induction from ‖(x₂y₃, x₃y₁, x₁y₂)‖ ≤ ‖x‖ ‖y‖), so what a series leaves out is bounded by a geometric series.
/// Roundings are counted by running the recurrence over their bounds. An error of ω grows by the equation's derivative:
/// at most by Gronwall's exp ∫Λ, Λ the greatest eigenvalue of its symmetric part, and, as long as it is below 2⁻²⁰ ‖ω‖,
/// as the derivatives of the steps say, followed in orthogonal frames (R. Lohner, "Enclosing the solutions of ordinary
/// initial and boundary value problems", 1987); the less of both is taken. An error e of ω turns the orientation away
/// by at most e a second, and errors of orientation do not grow.
class RotationPath {
 public:
  /// Preconditions: moments positive, each at most the sum of the others (within rounding); the duration finite and ≥
  /// 0; ‖ω‖ × duration at most about 10⁵, since the path holds some eight steps a radian.
  RotationPath(const Vector3<double>& principal_inertia, const RotationState& start, double duration);

  /// A body that does not turn, for any duration.
  explicit RotationPath(const Quaternion<double>& orientation);

  /// The state at a time [s]. Precondition: 0 ≤ time ≤ duration.
  [[nodiscard]] BoundedRotation at(double time) const;

  [[nodiscard]] double duration() const { return duration_; }

  /// At least ‖ω‖ at any time, exactly computed or not: of all ω with this energy and this angular momentum the
  /// fastest, a linear programme in the squares of ω's components.
  [[nodiscard]] double greatest_rate() const { return greatest_rate_; }

  /// At least ‖ω'‖/‖ω‖² at any time: a/√3. The acceleration of a point at r is at most ‖ω‖² (1 + this) ‖r‖.
  [[nodiscard]] double greatest_turning() const { return greatest_turning_; }

 private:
  static constexpr int order = 18;

  struct Step {
    double start = 0;   // [s]
    double length = 0;  // [s]
    double angle_error = 0;
    double rate_error = 0;
    double growth = 1;  // at most how an error of ω grows within the step
    // Coefficient k is that of ((t − start)/length)ᵏ.
    Eigen::Matrix<double, 4, order + 1> orientation;
    Eigen::Matrix<double, 3, order + 1> rate;
  };

  struct Bounds {
    double scaled_length = 0;  // ‖ω‖ × length of a step
    double angle = 0;          // what a step adds to angle_error
    double relative_rate = 0;  // what a step adds to rate_error, as a share of ‖ω‖
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
