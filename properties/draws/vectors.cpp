// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <utility>

#include <carom/properties/draws/vectors.hpp>

#ifdef __FAST_MATH__
#error "families are drawn by IEEE arithmetic: compile them without -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "each operation is rounded to binary64: on 32-bit x86, -msse2 -mfpmath=sse");

namespace carom::properties {

double dot(const Vector3<double>& u, const Vector3<double>& v) {
  const double first_two = u[0] * v[0] + u[1] * v[1];
  return first_two + u[2] * v[2];
}

Vector3<double> cross(const Vector3<double>& u, const Vector3<double>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Vector3<double> negated(const Vector3<double>& v) { return {-v[0], -v[1], -v[2]}; }

Quaternion<double> negated(const Quaternion<double>& q) { return {-q[0], -q[1], -q[2], -q[3]}; }

double sum(const Vector3<double>& v) {
  const double first_two = v[0] + v[1];
  return first_two + v[2];
}

double squared_length(const Vector3<double>& v) { return dot(v, v); }

double length(const Vector3<double>& v) { return std::sqrt(squared_length(v)); }

double squared_length(const Quaternion<double>& q) {
  double sum = q[0] * q[0];
  for (int i = 1; i < 4; ++i) {
    sum += q[i] * q[i];
  }
  return sum;
}

double least(const Vector3<double>& v) { return std::min({v[0], v[1], v[2]}); }

double greatest(const Vector3<double>& v) { return std::max({v[0], v[1], v[2]}); }

int place_of_least(const Vector3<double>& v) {
  int place = 0;
  for (int i = 1; i < 3; ++i) {
    place = v[i] < v[place] ? i : place;
  }
  return place;
}

Vector3<double> plus(const Vector3<double>& v, const Vector3<double>& u, double s) {
  return {v[0] + s * u[0], v[1] + s * u[1], v[2] + s * u[2]};
}

Vector3<double> turned(const Quaternion<double>& q, const Vector3<double>& v) {
  // Let q = (w, u). Then q v = (−u·v, t) with t = w v + u × v. The result is the vector part of q v q* divided by ‖q‖²,
  // with q* = (w, −u).
  const double w = q[0];
  const Vector3<double> u{q[1], q[2], q[3]};
  const Vector3<double> t = plus(cross(u, v), v, w);
  const Vector3<double> along = plus(cross(u, t), t, w);
  return plus(along, u, dot(u, v)) * (1 / squared_length(q));
}

Quaternion<double> conjugate(const Quaternion<double>& q) { return {q[0], -q[1], -q[2], -q[3]}; }

Vector3<double> product(const Columns& m, const Vector3<double>& v) {
  return plus(plus(m.x * v[0], m.y, v[1]), m.z, v[2]);
}

Vector3<double> solution(const Columns& m, const Vector3<double>& v) {
  using Row = std::array<double, 4>;  // of the matrix, with the right-hand side
  std::array<Row, 3> rows{};
  for (int i = 0; i < 3; ++i) {
    rows[static_cast<std::size_t>(i)] = {m.x[i], m.y[i], m.z[i], v[i]};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto pivot = std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                        [&](const Row& a, const Row& b) { return std::abs(a[k]) < std::abs(b[k]); });
    std::swap(rows[k], *pivot);
    for (std::size_t i = k + 1; i < 3; ++i) {
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < 4; ++j) {
        rows[i][j] -= factor * rows[k][j];
      }
    }
  }
  const double z = rows[2][3] / rows[2][2];
  const double y = (rows[1][3] - rows[1][2] * z) / rows[1][1];
  const double x = ((rows[0][3] - rows[0][1] * y) - rows[0][2] * z) / rows[0][0];
  return {x, y, z};
}

Vector3<double> orthogonal(const Vector3<double>& vector) {
  if (vector[0] != 0 || vector[1] != 0) {
    return {-vector[1], vector[0], 0};
  }
  return {0, -vector[2], vector[1]};
}

}  // namespace carom::properties
