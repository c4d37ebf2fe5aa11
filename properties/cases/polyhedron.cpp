// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cstdint>

#include <Eigen/Geometry>

#include <carom/properties/cases/polyhedron.hpp>

namespace carom::properties {
namespace {

using oracles::Rational;
using IntegerVector = Vector3<std::int64_t>;
using IntegerMatrix = Matrix3<std::int64_t>;

/// Integrals over a polyhedron, scaled to integers: 6 ∫1, 24 ∫x, 120 ∫x xᵀ.
struct Integrals {
  std::int64_t volume = 0;
  IntegerVector first = IntegerVector::Zero();
  IntegerMatrix second = IntegerMatrix::Zero();
};

/// Adds the tetrahedron with this face and its apex at the origin. Its volume has a sign, so the origin may lie outside
/// the polyhedron.
void add_tetrahedron(Integrals& integrals, const IntegerVector& a, const IntegerVector& b, const IntegerVector& c) {
  const std::int64_t determinant = a.dot(b.cross(c));
  const IntegerVector sum = a + b + c;
  integrals.volume += determinant;
  integrals.first += determinant * sum;
  integrals.second += determinant * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
}

/// The integrals over the hull. A triangle is a face if all other points lie on one side of it. If four points share a
/// plane, all integrals are 0, because a face with more corners would count twice.
Integrals integrals_of_hull(const std::vector<IntegerVector>& points) {
  Integrals integrals;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        const IntegerVector normal = (points[j] - points[i]).cross(points[k] - points[i]);
        bool above = false;
        bool below = false;
        for (std::size_t other = 0; other < n; ++other) {
          if (other == i || other == j || other == k) {
            continue;
          }
          const std::int64_t side = normal.dot(points[other] - points[i]);
          if (side == 0) {
            return {};
          }
          (side > 0 ? above : below) = true;
        }
        if (above && !below) {
          add_tetrahedron(integrals, points[i], points[k], points[j]);
        } else if (below && !above) {
          add_tetrahedron(integrals, points[i], points[j], points[k]);
        }
      }
    }
  }
  return integrals;
}

}  // namespace

PrincipalShape random_polyhedron(Stream& stream) {
  std::vector<IntegerVector> points(static_cast<std::size_t>(stream.integer(4, 8)));
  for (IntegerVector& point : points) {
    for (int i = 0; i < 3; ++i) {
      point[i] = stream.integer(-64, 64);
    }
  }
  Integrals integrals = integrals_of_hull(points);
  if (integrals.volume == 0) {
    points = {{0, 0, 0}, {64, 0, 0}, {0, 64, 0}, {0, 0, 64}};
    integrals = integrals_of_hull(points);
  }

  const Rational volume(static_cast<double>(integrals.volume));
  std::array<Rational, 3> centroid;
  Matrix3<Rational> s;
  for (int i = 0; i < 3; ++i) {
    centroid[static_cast<std::size_t>(i)] = Rational(static_cast<double>(integrals.first[i])) / (4 * volume);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      s(i, j) = Rational(static_cast<double>(integrals.second(i, j))) / (20 * volume) -
                centroid[static_cast<std::size_t>(i)] * centroid[static_cast<std::size_t>(j)];
    }
  }

  // A corner of the hull, or a mean of corners with weights k/8.
  std::array<Rational, 3> point{0, 0, 0};
  const int parts = stream.chance(2) ? 1 : 8;
  for (int part = 0; part < parts; ++part) {
    const auto corner = static_cast<std::size_t>(stream.integer(0, static_cast<int>(points.size()) - 1));
    for (int i = 0; i < 3; ++i) {
      point[static_cast<std::size_t>(i)] += Rational(static_cast<int>(points[corner][i])) / parts;
    }
  }

  // S = L D Lᵀ, and y = L⁻¹ (point − centroid).
  const Rational l10 = s(1, 0) / s(0, 0);
  const Rational l20 = s(2, 0) / s(0, 0);
  const Rational d1 = s(1, 1) - l10 * s(1, 0);
  const Rational e21 = s(2, 1) - l20 * s(1, 0);
  const Rational l21 = e21 / d1;
  const Rational d2 = s(2, 2) - l20 * s(2, 0) - l21 * e21;
  const Rational y0 = point[0] - centroid[0];
  const Rational y1 = point[1] - centroid[1] - l10 * y0;
  const Rational y2 = point[2] - centroid[2] - l20 * y0 - l21 * y1;
  constexpr double unit = 1.0 / 64;
  return {Vector3<double>{oracles::to_double(s(0, 0)), oracles::to_double(d1), oracles::to_double(d2)} * unit * unit,
          Vector3<double>{oracles::to_double(y0), oracles::to_double(y1), oracles::to_double(y2)} * unit};
}

}  // namespace carom::properties
