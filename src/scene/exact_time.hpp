// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <compare>
#include <memory>
#include <optional>
#include <utility>

#include <carom/scene/crossing.hpp>
#include <carom/scene/motion.hpp>

/// What bounds cannot decide, decided exactly: real roots of polynomials with rational coefficients, by CGAL.
namespace carom::scene {

/// A plane as spheres of one radius meet it: a centre x touches it where N·x is `reach`, and stays above.
struct Reach {
  Vector3<double> normal;  // any nonzero length
  double reach = 0;
};

/// An instant: a number, or a real root of a polynomial.
class ExactTime {
 public:
  struct Instant;  // of CGAL, kept out of sight
  explicit ExactTime(std::shared_ptr<const Instant> instant) : instant_(std::move(instant)) {}
  /// Precondition: finite.
  [[nodiscard]] static ExactTime at(double time);

  friend std::strong_ordering operator<=>(const ExactTime& left, const ExactTime& right);
  [[nodiscard]] friend bool operator==(const ExactTime& left, const ExactTime& right) {
    return (left <=> right) == std::strong_ordering::equal;
  }
  /// The greatest double not after the instant, and the least not before it.
  [[nodiscard]] TimeBounds bounds() const;

 private:
  std::shared_ptr<const Instant> instant_;
};

/// The first instant from `now` on at which the gap |x_A − x_B| − R_A − R_B falls below 0; none where it does not. To
/// touch without falling below is no contact. Precondition: at `now` the gap is at least 0.
[[nodiscard]] std::optional<ExactTime> exact_contact(const Path& a, const Path& b, double now);

/// The same of a sphere and a plane.
[[nodiscard]] std::optional<ExactTime> exact_contact(const Path& sphere, const Reach& plane, double now);

/// −1, 0 or 1: the sign of the gap at a time.
[[nodiscard]] int sign_of_gap(const Path& a, const Path& b, double time);
[[nodiscard]] int sign_of_gap(const Path& sphere, const Reach& plane, double time);

/// The least double that is at least N·p + R |N|: from there on a sphere of radius R is clear of the plane.
[[nodiscard]] double reach_of(const Vector3<double>& normal, const Vector3<double>& point, double radius);

}  // namespace carom::scene
