// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/principal_axes.hpp>

namespace carom::scene {
namespace {

using impulse::DoubleDouble;

DoubleDouble absolute(const DoubleDouble& x) { return x < DoubleDouble(0) ? -x : x; }

[[maybe_unused]] double greatest_size(const Matrix3<DoubleDouble>& matrix) {
  return matrix.cast<double>().cwiseAbs().maxCoeff();
}

/// The tangent t, |t| ≤ 1, of the rotation that makes the off-diagonal number zero: t² + 2 t θ − 1 = 0, with θ as below
/// (G. Golub, C. Van Loan, "Matrix Computations", §8.5.2).
DoubleDouble tangent_of_rotation(const DoubleDouble& on_p, const DoubleDouble& on_q, const DoubleDouble& off) {
  const DoubleDouble theta = (on_q - on_p) / (DoubleDouble(2) * off);
  if (std::abs(theta.high()) > 0x1p200) {  // the square could overflow
    return DoubleDouble(1) / (DoubleDouble(2) * theta);
  }
  const DoubleDouble t = DoubleDouble(1) / (absolute(theta) + sqrt(theta * theta + DoubleDouble(1)));
  return theta < DoubleDouble(0) ? -t : t;
}

void rotate(PrincipalAxes& result, Matrix3<DoubleDouble>& j, int p, int q) {
  const DoubleDouble t = tangent_of_rotation(j(p, p), j(q, q), j(p, q));
  const DoubleDouble cosine = DoubleDouble(1) / sqrt(t * t + DoubleDouble(1));
  const DoubleDouble sine = t * cosine;
  const int r = 3 - p - q;
  const DoubleDouble moved = t * j(p, q);
  j(p, p) -= moved;
  j(q, q) += moved;
  j(p, q) = j(q, p) = DoubleDouble(0);
  const DoubleDouble rp = j(r, p);
  const DoubleDouble rq = j(r, q);
  j(r, p) = j(p, r) = cosine * rp - sine * rq;
  j(r, q) = j(q, r) = sine * rp + cosine * rq;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble ip = result.axes(i, p);
    const DoubleDouble iq = result.axes(i, q);
    result.axes(i, p) = cosine * ip - sine * iq;
    result.axes(i, q) = sine * ip + cosine * iq;
  }
}

}  // namespace

PrincipalAxes principal_axes(Matrix3<DoubleDouble> inertia) {
  CAROM_EXPECTS(inertia == inertia.transpose(), inertia);
  CAROM_EXPECTS(0x1p-100 <= greatest_size(inertia) && greatest_size(inertia) <= 0x1p+100, greatest_size(inertia));
  PrincipalAxes result;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      result.axes(i, k) = DoubleDouble(i == k ? 1 : 0);
    }
  }
  constexpr int most_sweeps = 12;  // five suffice
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool rotated = false;
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      const double off = std::abs(inertia(p, q).high());
      const double least = std::min(inertia(p, p).high(), inertia(q, q).high());
      if (off > 0x1p-105 * least) {
        rotate(result, inertia, p, q);
        rotated = true;
      }
    }
    if (!rotated) {
      break;
    }
  }
  result.moments = {inertia(0, 0), inertia(1, 1), inertia(2, 2)};
  return result;
}

Quaternion<double> quaternion_of(const Matrix3<DoubleDouble>& r) {
  // Row i of `candidates` is 4 qᵢ times the quaternion q (K. Shoemake, "Quaternions", 1994).
  const DoubleDouble one(1);
  const std::array<std::array<DoubleDouble, 4>, 4> candidates{{
      {one + r(0, 0) + r(1, 1) + r(2, 2), r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)},
      {r(2, 1) - r(1, 2), one + r(0, 0) - r(1, 1) - r(2, 2), r(0, 1) + r(1, 0), r(0, 2) + r(2, 0)},
      {r(0, 2) - r(2, 0), r(0, 1) + r(1, 0), one - r(0, 0) + r(1, 1) - r(2, 2), r(1, 2) + r(2, 1)},
      {r(1, 0) - r(0, 1), r(0, 2) + r(2, 0), r(1, 2) + r(2, 1), one - r(0, 0) - r(1, 1) + r(2, 2)},
  }};
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (candidates[i][i] > candidates[best][best]) {
      best = i;
    }
  }
  DoubleDouble squared_length(0);
  for (const DoubleDouble& number : candidates[best]) {
    squared_length += number * number;
  }
  const DoubleDouble length = sqrt(squared_length);
  Quaternion<double> quaternion;
  for (int i = 0; i < 4; ++i) {
    quaternion[i] = (candidates[best][static_cast<std::size_t>(i)] / length).high();
  }
  return quaternion;
}

}  // namespace carom::scene
