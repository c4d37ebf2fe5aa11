// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>

#include <gmpxx.h>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/orientation.hpp>

namespace carom::scene {
namespace {

using RationalVector = std::array<mpq_class, 3>;

RationalVector difference(const Vector3<double>& left, const Vector3<double>& right) {
  RationalVector result;
  for (int i = 0; i < 3; ++i) {
    result[static_cast<std::size_t>(i)] = mpq_class(left[i]) - mpq_class(right[i]);
  }
  return result;
}

RationalVector cross(const RationalVector& x, const RationalVector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

int exact_orientation(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                      const Vector3<double>& d) {
  const RationalVector normal = cross(difference(b, a), difference(c, a));
  const RationalVector to_d = difference(d, a);
  return sgn(mpq_class(normal[0] * to_d[0] + normal[1] * to_d[1] + normal[2] * to_d[2]));
}

}  // namespace

int orientation(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                const Vector3<double>& d) {
  CAROM_EXPECTS(a.allFinite() && b.allFinite() && c.allFinite() && d.allFinite(), a, b, c, d);
  const Vector3<double> x = b - a;
  const Vector3<double> y = c - a;
  const Vector3<double> z = d - a;
  const double determinant =
      z[0] * (x[1] * y[2] - x[2] * y[1]) + z[1] * (x[2] * y[0] - x[0] * y[2]) + z[2] * (x[0] * y[1] - x[1] * y[0]);
  const double permanent = std::abs(z[0]) * (std::abs(x[1] * y[2]) + std::abs(x[2] * y[1])) +
                           std::abs(z[1]) * (std::abs(x[2] * y[0]) + std::abs(x[0] * y[2])) +
                           std::abs(z[2]) * (std::abs(x[0] * y[1]) + std::abs(x[1] * y[0]));
  const double largest = std::max({x.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff(), z.cwiseAbs().maxCoeff()});
  constexpr double unit_roundoff = 0x1p-53;
  // With the unit roundoff u, roundings cost at most (7 + 56 u) u times the permanent (Shewchuk 1997). An underflow in
  // a product of two differences costs at most 2⁻¹⁰⁷⁴ times the third difference. Under the two conditions below,
  // underflows cost less than 2⁻⁹⁹⁰, which is less than (1 − 56 u) u times the permanent.
  constexpr double relative_error = 8 * unit_roundoff;
  if (permanent > 0x1p-900 && largest < 0x1p+75 && std::abs(determinant) > relative_error * permanent) {
    return determinant > 0 ? 1 : -1;
  }
  return exact_orientation(a, b, c, d);
}

Vector3<int> normal_signs(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c) {
  CAROM_EXPECTS(a.allFinite() && b.allFinite() && c.allFinite(), a, b, c);
  const RationalVector normal = cross(difference(b, a), difference(c, a));
  return {sgn(normal[0]), sgn(normal[1]), sgn(normal[2])};
}

}  // namespace carom::scene
