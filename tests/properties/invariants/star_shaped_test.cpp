// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/exact/definiteness.hpp>

#include "support/exact.hpp"

/// Tests star_shaped.v of properties/proofs in ℚ: λI ⪯ C ⪯ 16 λI for uniform bodies that are star-shaped from the
/// contact point. C is the collision matrix and λ = Σ 1/m. The contact point is the origin.
namespace carom::properties {
namespace {

using oracles::is_at_least;
using oracles::is_at_most;
using unit::ExactMatrix;
using unit::ExactVector;
using unit::ratio;
using unit::Rational;

using Triangle = std::array<ExactVector, 3>;  // counterclockwise, seen from outside
using Surface = std::vector<Triangle>;        // the bases of the tetrahedra with the origin as apex

Rational six_volumes(const Triangle& t) { return t[0].dot(t[1].cross(t[2])); }

ExactMatrix squared(const ExactVector& v) { return v * v.transpose(); }

struct Shape {
  ExactVector centre;          // of mass
  ExactMatrix second_moments;  // S, about the centre, divided by the mass
};

/// A uniform tetrahedron with corners 0, a, b and c has its centre at s/4, with s = a + b + c. Its second moments about
/// 0 are (aaᵀ + bbᵀ + ccᵀ + ssᵀ)/20.
Shape shape_of(const Surface& surface) {
  Rational volume(0);
  ExactVector centre(0, 0, 0);
  ExactMatrix moments = ExactMatrix::Zero();
  for (const Triangle& t : surface) {
    const Rational share = six_volumes(t);
    const ExactVector sum = t[0] + t[1] + t[2];
    volume += share;
    centre += sum * share;
    moments += (squared(t[0]) + squared(t[1]) + squared(t[2]) + squared(sum)) * share;
  }
  centre /= 4 * volume;
  return {centre, moments / (20 * volume) - squared(centre)};
}

bool is_star_shaped(const Surface& surface) {
  return std::all_of(surface.begin(), surface.end(), [](const Triangle& t) { return six_volumes(t) > 0; });
}

bool is_dented(const Surface& surface) {
  for (const Triangle& face : surface) {
    const ExactVector outwards = ExactVector(face[1] - face[0]).cross(ExactVector(face[2] - face[0]));
    for (const Triangle& other : surface) {
      for (const ExactVector& corner : other) {
        if (outwards.dot(ExactVector(corner - face[0])) > 0) {
          return true;
        }
      }
    }
  }
  return false;
}

/// Whether rrᵀ ⪯ 15 S, with r from the centre to the point.
bool dominates(const Shape& shape, const ExactVector& point) {
  const ExactVector r = point - shape.centre;
  return oracles::is_positive_semidefinite(shape.second_moments * Rational(15) - squared(r));
}

/// The body's part of C, I/m + [r]ᵀ J⁻¹ [r], with J = m (tr(S) I − S).
ExactMatrix share_of_matrix(const Shape& shape, const Rational& mass, const ExactVector& point) {
  const ExactVector r = point - shape.centre;
  const ExactMatrix inertia = (ExactMatrix::Identity() * shape.second_moments.trace() - shape.second_moments) * mass;
  ExactMatrix cross;  // r × x
  cross << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  // The adjugate needs only one division.
  ExactMatrix adjugate;
  for (int i = 0; i < 3; ++i) {
    adjugate.row(i) = inertia.col((i + 1) % 3).cross(inertia.col((i + 2) % 3));
  }
  const ExactMatrix turning = cross.transpose() * adjugate * cross;
  return ExactMatrix::Identity() / mass + turning / inertia.col(0).dot(adjugate.row(0).transpose());
}

/// A number d · 10ᵏ with 1 ≤ d ≤ 9 and 0 ≤ k ≤ 6.
Rational spiky_radius(Stream& stream) {
  Rational radius(stream.integer(1, 9));
  for (int tens = stream.integer(0, 6); tens > 0; --tens) {
    radius *= 10;
  }
  return radius;
}

/// A surface with 14 corners at random distances: in perturbed directions of the 6 corners of an octahedron, and in the
/// middle of each of its 8 faces. If the body lacks some of the 24 tetrahedra, the contact is on its surface.
template <class Radius>
Surface random_surface(Stream& stream, const Radius& radius) {
  std::array<std::array<ExactVector, 2>, 3> directions;
  std::array<std::array<Rational, 2>, 3> radii;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      auto& direction = directions[axis][side];
      for (int i = 0; i < 3; ++i) {
        // The diagonal dominates, so the determinant of each octant keeps its sign.
        direction[i] = i == axis ? (side == 0 ? 8 : -8) : stream.integer(-3, 3);
      }
      radii[axis][side] = radius();
    }
  }
  const bool is_whole = stream.chance(2);
  Surface surface;
  for (int octant = 0; octant < 8; ++octant) {
    const std::array<int, 3> sides{octant & 1, octant >> 1 & 1, octant >> 2 & 1};
    const bool is_mirrored = (sides[0] + sides[1] + sides[2]) % 2 == 1;
    Triangle base;
    ExactVector middle(0, 0, 0);
    for (int corner = 0; corner < 3; ++corner) {
      const int axis = is_mirrored ? 2 - corner : corner;
      const ExactVector& direction = directions[axis][sides[axis]];
      base[corner] = direction * radii[axis][sides[axis]];
      middle += direction;
    }
    middle *= radius();
    for (int i = 0; i < 3; ++i) {
      if (is_whole || stream.chance(3)) {
        surface.push_back({base[i], base[(i + 1) % 3], middle});
      }
    }
  }
  return surface.empty() ? random_surface(stream, radius) : surface;
}

Surface spiky_surface(Stream& stream) {
  return random_surface(stream, [&] { return spiky_radius(stream); });
}

/// The shift moves the surface, but not the apex. So the apex may lie outside, and some tetrahedra have negative
/// volumes.
TEST(StarShaped, HaveMomentsThatDoNotDependOnTheApex) {
  Stream stream = stream_from(41);
  for (int i = 0; i < 50; ++i) {
    Surface surface;
    while (surface.size() < 24) {  // closed
      surface = spiky_surface(stream);
    }
    const Shape shape = shape_of(surface);
    const ExactVector shift = unit::exact_eighths3(stream, 1000000);
    for (Triangle& t : surface) {
      for (ExactVector& corner : t) {
        corner += shift;
      }
    }
    const Shape shifted = shape_of(surface);
    EXPECT_TRUE(unit::same(shifted.centre, ExactVector(shape.centre + shift))) << i;
    EXPECT_TRUE(unit::same(shifted.second_moments, shape.second_moments)) << i;
  }
}

TEST(StarShaped, AreWellConditioned) {
  Stream stream = stream_from(42);
  int dented = 0;
  int closed = 0;
  ExactMatrix of_last = ExactMatrix::Zero();
  Rational lambda_of_last(0);
  constexpr int bodies = 2000;
  for (int i = 0; i < bodies; ++i) {
    const Surface surface = spiky_surface(stream);
    ASSERT_TRUE(is_star_shaped(surface)) << i;
    dented += is_dented(surface) ? 1 : 0;
    closed += surface.size() == 24 ? 1 : 0;
    const Shape shape = shape_of(surface);
    const ExactVector point(0, 0, 0);
    EXPECT_TRUE(dominates(shape, point)) << i;
    // Contacts with an immovable body, and with the previous body.
    const Rational lambda = 1 / spiky_radius(stream);
    const ExactMatrix matrix = share_of_matrix(shape, 1 / lambda, point);
    EXPECT_TRUE(is_at_least(matrix, lambda) && is_at_most(matrix, 16 * lambda)) << i;
    EXPECT_TRUE(is_at_least(matrix + of_last, lambda + lambda_of_last)) << i;
    EXPECT_TRUE(is_at_most(matrix + of_last, 16 * (lambda + lambda_of_last))) << i;
    of_last = matrix;
    lambda_of_last = lambda;
  }
  EXPECT_GT(dented, bodies / 2);
  EXPECT_GT(closed, bodies / 3);
}

/// A tetrahedron a thousand times as long as wide touches with its apex. As C r = λ r for its lever arm r, the
/// condition number of C is its largest eigenvalue divided by λ.
TEST(StarShaped, HaveConditionNumbersOfNearly16AsNeedles) {
  Stream stream = stream_from(43);
  for (int i = 0; i < 200; ++i) {
    const ExactVector tip(stream.integer(5000, 9000), stream.integer(-9000, 9000), stream.integer(-9000, 9000));
    const auto corner = [&](int y, int z) {
      return ExactVector(tip + ExactVector(stream.integer(-1, 1), y, z) + unit::exact_eighths3(stream, 2));
    };
    const Surface needle{{corner(-2, -2), corner(2, -2), corner(0, 2)}};
    ASSERT_TRUE(is_star_shaped(needle)) << i;
    const Shape shape = shape_of(needle);
    const ExactVector point(0, 0, 0);
    EXPECT_TRUE(dominates(shape, point)) << i;
    const ExactMatrix matrix = share_of_matrix(shape, 1, point);
    EXPECT_TRUE(unit::same(ExactVector(matrix * shape.centre), shape.centre)) << i;
    EXPECT_TRUE(is_at_most(matrix, 16)) << i;
    EXPECT_FALSE(is_at_most(matrix, ratio(159, 10))) << i;
  }
}

TEST(StarShaped, ExceedTheBoundWhereTheContactIsFarOutside) {
  Stream stream = stream_from(44);
  for (int i = 0; i < 200; ++i) {
    const Shape shape = shape_of(spiky_surface(stream));
    // The coordinates of a corner are at most (8 + 3 + 3) · 9 · 10⁶. One coordinate of the point is 10¹¹.
    ExactVector point = unit::exact_eighths3(stream, 8);
    point[stream.integer(0, 2)] = 1000;
    point *= Rational(100000000);
    EXPECT_FALSE(dominates(shape, point)) << i;
    const ExactMatrix matrix = share_of_matrix(shape, 1, point);
    EXPECT_TRUE(is_at_least(matrix, 1)) << i;
    EXPECT_FALSE(is_at_most(matrix, 16)) << i;
  }
}

/// A hammer with a thin handle of nearly no mass. From the end of the handle, a part of the head is hidden.
TEST(StarShaped, ExceedTheBoundWhereABodyIsTouchedInAPointThatDoesNotSeeAllOfIt) {
  Surface hammer;
  for (int octant = 0; octant < 8; ++octant) {
    const int x = octant % 2 == 0 ? 1 : -1;
    const int y = octant / 2 % 2 == 0 ? 1 : -1;
    const int z = octant / 4 % 2 == 0 ? 1 : -1;
    const ExactVector handle(x > 0 ? 100 : -1, 0, 0);
    const ExactVector dent = ExactVector(x, y, z) / (x > 0 ? Rational(1000000) : Rational(2));
    const Triangle base{handle, ExactVector(0, y, 0), ExactVector(0, 0, z)};
    for (int i = 0; i < 3; ++i) {
      Triangle part{base[i], base[(i + 1) % 3], dent};
      if (x * y * z < 0) {
        std::swap(part[0], part[1]);
      }
      hammer.push_back(part);
    }
  }
  ASSERT_TRUE(is_star_shaped(hammer) && is_dented(hammer));
  const Shape shape = shape_of(hammer);
  EXPECT_TRUE(dominates(shape, ExactVector(0, 0, 0)));
  EXPECT_TRUE(is_at_most(share_of_matrix(shape, 1, ExactVector(0, 0, 0)), 16));
  EXPECT_FALSE(dominates(shape, ExactVector(100, 0, 0)));
  EXPECT_FALSE(is_at_most(share_of_matrix(shape, 1, ExactVector(100, 0, 0)), 16));
}

}  // namespace
}  // namespace carom::properties
