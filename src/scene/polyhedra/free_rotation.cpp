// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <carom/collision/expects.hpp>
#include <carom/impulse/rotation.hpp>
#include <carom/scene/crossing.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>

namespace carom::scene {
namespace {

/// q ω, with ω a quaternion without a scalar part.
Quaternion<double> product(const Quaternion<double>& q, const Vector3<double>& w) {
  return {-(q[1] * w[0] + q[2] * w[1] + q[3] * w[2]), q[0] * w[0] + q[2] * w[2] - q[3] * w[1],
          q[0] * w[1] + q[3] * w[0] - q[1] * w[2], q[0] * w[2] + q[1] * w[1] - q[2] * w[0]};
}

/// (x₂y₃, x₃y₁, x₁y₂), whose norm is at most ‖x‖ ‖y‖.
Vector3<double> crosswise(const Vector3<double>& x, const Vector3<double>& y) {
  return {x[1] * y[2], x[2] * y[0], x[0] * y[1]};
}

/// ∂ω'/∂ω in Euler's equations. a holds the aᵢ of RotationPath.
Matrix3<double> derivative(const Vector3<double>& a, const Vector3<double>& w) {
  Matrix3<double> b;
  b << 0, a[0] * w[2], a[0] * w[1],  //
      a[1] * w[2], 0, a[1] * w[0],   //
      a[2] * w[1], a[2] * w[0], 0;
  return b;
}

/// The derivative of ω at the end of a step with respect to ω at its beginning: the Taylor series of the variational
/// equation. In each step, max |aᵢ| ‖ω‖ length ≤ 0.14, so the remainder after nine terms is below 2⁻⁴⁰.
template <class Coefficients>
Matrix3<double> derivative_of_step(const Vector3<double>& a, const Coefficients& rate, double length) {
  constexpr int terms = 9;
  std::array<Matrix3<double>, terms> series;
  series[0] = Matrix3<double>::Identity();
  Matrix3<double> sum = series[0];
  for (std::size_t k = 0; k + 1 < terms; ++k) {
    Matrix3<double> next = Matrix3<double>::Zero();
    for (std::size_t j = 0; j <= k; ++j) {
      next += derivative(a, rate.col(static_cast<Eigen::Index>(j))) * series[k - j];
    }
    series[k + 1] = next * (length / static_cast<double>(k + 1));
    sum += series[k + 1];
  }
  return sum;
}

/// An upper bound of the greatest eigenvalue of the symmetric part of `derivative`, divided by ‖ω‖. The diagonal of
/// this part S is zero, so the eigenvalue is at most √(2/3) of the Frobenius norm of S. This norm is at most max |aᵢ +
/// aⱼ| ‖ω‖/√2.
double growth_rate(const Vector3<double>& a) {
  const double greatest =
      std::max({std::abs(a[0] + a[1]), std::abs(a[1] + a[2]), std::abs(a[2] + a[0])}) + 8 * roundoff;
  return greatest * std::numbers::inv_sqrt3;
}

/// The greatest ‖v‖² of all angular velocities v that have the same energy and the same size of the angular momentum as
/// ω. This is a linear programme in yᵢ = vᵢ². At each vertex of the feasible set, one yₖ is 0, and Σ y = ωᵢ² + ωⱼ² +
/// ωₖ² Iₖ (Iᵢ + Iⱼ − Iₖ)/(Iᵢ Iⱼ), with the moments I.
double greatest_squared_rate(const Vector3<double>& moments, const Vector3<double>& rate) {
  const Vector3<double> squares = rate.cwiseAbs2();
  double greatest = squares.sum();
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    // A vertex with a negative y is not feasible. If rounding leaves the sign open, including the vertex can only make
    // the bound larger.
    const auto is_negative = [&](int p, int q) {
      const double own = moments[p] * (moments[p] - moments[q]) * squares[p];
      const double other = moments[k] * (moments[k] - moments[q]) * squares[k];
      const double sum = (own + other) * (moments[p] < moments[q] ? -1 : 1);
      return sum < -0x1p-40 * (std::abs(own) + std::abs(other));
    };
    if (!is_negative(i, j) && !is_negative(j, i)) {
      greatest = std::max(greatest, squares[i] + squares[j] +
                                        squares[k] * (moments[k] / moments[i]) *
                                            ((moments[i] + (moments[j] - moments[k])) / moments[j]));
    }
  }
  return greatest;
}

}  // namespace

Vector3<double> world_rate(const RotationState& state) {
  return impulse::rotation_matrix(state.orientation) * state.body_rate;
}

RotationState rotation_state(const Quaternion<double>& orientation, const Vector3<double>& world_rate) {
  CAROM_EXPECTS(!orientation.isZero(0), orientation);
  const Quaternion<double> scaled = orientation / orientation.cwiseAbs().maxCoeff();
  const Quaternion<double> q = scaled / scaled.norm();
  return {q, impulse::rotation_matrix(q).transpose() * world_rate};
}

RotationPath::Bounds RotationPath::bounds_for(double a) {
  Bounds bounds;
  std::array<double, order + 2> rate{};      // bounds of the coefficients of ω, divided by ‖ω‖
  std::array<double, order + 2> rotation{};  // bounds of the coefficients of q
  double rest_of_rate = 0;
  double rest_of_rotation = 0;
  double x = 2;
  for (;; x *= 0.9) {
    rate[0] = rotation[0] = 1;
    for (std::size_t k = 0; k <= order; ++k) {
      const auto n = static_cast<double>(k);
      rate[k + 1] = rate[k] * a * x;
      rotation[k + 1] = rotation[k] * x * (0.5 + n * a) / (n + 1);
    }
    const double ratio = x * std::max(0.5, a);  // upper bound of the ratio of successive coefficients
    if (ratio < 0.9) {
      rest_of_rate = rate[order + 1] / (1 - a * x);
      rest_of_rotation = rotation[order + 1] / (1 - ratio);
      if (std::max(rest_of_rate, rest_of_rotation) <= 0x1p-56) {
        break;
      }
    }
  }
  bounds.scaled_length = x;

  // The same recurrences bound the errors of the computed coefficients, in unit roundoffs u. The error of a sum of k +
  // 1 products is at most (k + 1) u Σ|terms|. Seven more roundings cover aᵢ, the length and the division.
  std::array<double, order + 1> rate_error{};
  std::array<double, order + 1> rotation_error{};
  double rate_units = 1;      // the last addition of Horner's scheme rounds the whole value
  double rotation_units = 5;  // that addition, and four roundings for the division of the quaternion by its norm
  for (std::size_t k = 0; k < order; ++k) {
    const auto n = static_cast<double>(k);
    double of_rate = 0;
    double of_rotation = 0;
    for (std::size_t j = 0; j <= k; ++j) {
      of_rate += rate_error[j] * rate[k - j] + rate[j] * rate_error[k - j];
      of_rotation += rotation_error[j] * rate[k - j] + rotation[j] * rate_error[k - j];
    }
    rate_error[k + 1] = of_rate * a * x / (n + 1) + (n + 8) * rate[k + 1];
    // The norm of a product of quaternions of absolute values is at most twice the product of their norms.
    rotation_error[k + 1] = of_rotation * x / (2 * (n + 1)) + 2 * (n + 8) * rotation[k + 1];
    // Horner's scheme rounds the term of the k-th power 2 k + 1 times. The rounding of the argument adds k.
    rate_units += rate_error[k + 1] + (3 * (n + 1) + 1) * rate[k + 1];
    rotation_units += rotation_error[k + 1] + (3 * (n + 1) + 1) * rotation[k + 1];
  }
  bounds.relative_rate = rest_of_rate + roundoff * rate_units;
  // An error e of a unit quaternion is a rotation by an angle of about 2 ‖e‖.
  bounds.angle = 2.01 * (rest_of_rotation + roundoff * rotation_units);
  return bounds;
}

RotationPath::RotationPath(const Quaternion<double>& orientation)
    : duration_(std::numeric_limits<double>::infinity()),
      start_(rotation_state(orientation, Vector3<double>::Zero())) {}

RotationPath::RotationPath(const Vector3<double>& principal_inertia, const RotationState& start, double duration)
    : duration_(duration), start_(start) {
  CAROM_EXPECTS(principal_inertia.minCoeff() > 0, principal_inertia);
  CAROM_EXPECTS(std::isfinite(duration) && duration >= 0, duration);
  start_.orientation /= start_.orientation.stableNorm();
  double a = 0;
  for (int i = 0; i < 3; ++i) {
    a_[i] = (principal_inertia[(i + 1) % 3] - principal_inertia[(i + 2) % 3]) / principal_inertia[i];
    a = std::max(a, std::abs(a_[i]));
  }
  greatest_turning_ = (a + 4 * roundoff) * std::numbers::inv_sqrt3;
  greatest_rate_ = std::sqrt(greatest_squared_rate(principal_inertia, start_.body_rate)) * (1 + 32 * roundoff);
  if (a == 0 || greatest_rate_ == 0) {
    return;  // rotation about a fixed axis
  }

  bounds_ = bounds_for(a);
  const double growth_per_angle = growth_rate(a_);
  BoundedRotation now{start_, 4 * roundoff, 0};
  double by_norms = 0;  // rate_error by Gronwall's inequality
  // The second bound of the error of ω, after R. Lohner: the error is frame · e with |eᵢ| ≤ widths[i]. Each step
  // multiplies the error by the derivative of the step.
  Matrix3<double> frame = Matrix3<double>::Identity();
  Vector3<double> widths = Vector3<double>::Zero();
  double greatest_error = 0;
  for (double time = 0; time < duration;) {
    const double rate = now.state.body_rate.norm();
    // Each step except for the first is at most as long as its start time, so differences of times are exact (P.
    // Sterbenz).
    const double furthest = time > 0 ? std::min(duration, 2 * time) : duration;
    const double end = std::min(furthest, time + bounds_.scaled_length / rate);
    add_step(now, time, end - time);
    Step& step = steps_.back();
    const double fastest = rate / (1 - a * rate * step.length);
    step.growth = std::exp(growth_per_angle * fastest * step.length) * (1 + 64 * roundoff);
    now = evaluate(step, end);

    const double added = bounds_.relative_rate * rate;
    by_norms = by_norms * step.growth + added;
    const Matrix3<double> moved = derivative_of_step(a_, step.rate, step.length) * frame;
    const Eigen::HouseholderQR<Matrix3<double>> factors(moved);
    frame = factors.householderQ();
    // The factor 1 + 2⁻²⁰ covers the remainder of the series, rounding errors, and terms quadratic in the error.
    widths = (frame.transpose() * moved).cwiseAbs() * widths * (1 + 0x1p-20) + Vector3<double>::Constant(added);
    const double by_derivatives = widths.norm();
    now.rate_error = by_derivatives < 0x1p-20 * rate ? std::min(by_norms, by_derivatives) : by_norms;
    greatest_error = std::max(greatest_error, now.rate_error);
    time = end;
  }
  greatest_rate_ += greatest_error;
}

void RotationPath::add_step(const BoundedRotation& start, double time, double length) {
  Step step;
  step.start = time;
  step.length = length;
  step.angle_error = start.angle_error;
  step.rate_error = start.rate_error;
  step.rate.col(0) = start.state.body_rate;
  step.orientation.col(0) = start.state.orientation;
  for (int k = 0; k < order; ++k) {
    Vector3<double> rate = Vector3<double>::Zero();
    Quaternion<double> orientation = Quaternion<double>::Zero();
    for (int j = 0; j <= k; ++j) {
      rate += crosswise(step.rate.col(j), step.rate.col(k - j));
      orientation += product(step.orientation.col(j), step.rate.col(k - j));
    }
    step.rate.col(k + 1) = a_.cwiseProduct(rate) * (length / (k + 1));
    step.orientation.col(k + 1) = orientation * (length / (2 * (k + 1)));
  }
  steps_.push_back(step);
}

BoundedRotation RotationPath::evaluate(const Step& step, double time) const {
  const double elapsed = time - step.start;
  const double power = elapsed / step.length;
  Quaternion<double> orientation = step.orientation.col(order);
  Vector3<double> rate = step.rate.col(order);
  for (int k = order; k-- > 0;) {
    orientation = orientation * power + step.orientation.col(k);
    rate = rate * power + step.rate.col(k);
  }
  BoundedRotation result;
  result.state = {orientation / orientation.norm(), rate};
  const double added = bounds_.relative_rate * step.rate.col(0).norm();
  result.rate_error = step.rate_error * step.growth + added;
  result.angle_error = step.angle_error + bounds_.angle + result.rate_error * elapsed;
  return result;
}

BoundedRotation RotationPath::at(double time) const {
  CAROM_EXPECTS(0 <= time && time <= duration_, time, duration_);
  if (!steps_.empty()) {
    const auto after = std::upper_bound(steps_.begin() + 1, steps_.end(), time,
                                        [](double t, const Step& step) { return t < step.start; });
    return evaluate(*(after - 1), time);
  }
  const double rate = start_.body_rate.norm();
  if (rate == 0 || time == 0) {
    return {start_, 4 * roundoff, 0};  // 4 u: the constructor divided the quaternion by its norm
  }
  // The half angle has at most four roundings. Sine and cosine have an error of an ulp, and the rest has at most ten
  // roundings.
  const double half_angle = rate * time / 2;
  const Vector3<double> axis = start_.body_rate / rate;
  const Quaternion<double> turned =
      std::cos(half_angle) * start_.orientation + std::sin(half_angle) * product(start_.orientation, axis);
  return {{turned / turned.norm(), start_.body_rate}, 2 * roundoff * (4 * half_angle + 16), 0};
}

}  // namespace carom::scene
