// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

void sort_moments(Body& body, bool ascending) {
  V& moments = body.principal_inertia;
  if (moments[0] == moments[1] || moments[1] == moments[2] || moments[0] == moments[2]) {
    moments = V{moments[0], moments[0] * 1.25, moments[0] * 1.5};
  }
  std::sort(moments.data(), moments.data() + 3);
  if (!ascending) {
    std::swap(moments[0], moments[2]);
  }
}

bool are_equal(const V& moments) { return moments[0] == moments[1] && moments[1] == moments[2]; }

bool is_flat(const V& i) { return i[0] + i[1] == i[2] || i[1] + i[2] == i[0] || i[2] + i[0] == i[1]; }

}  // namespace

std::vector<Feature> of_inertia() {
  constexpr auto special = FeatureKind::special_value;
  constexpr auto relation = FeatureKind::relation;
  return for_both({
      {"mass_one", special, "the mass is 1", "m, 1/m and m² are equal, so an error in m has no effect", true,
       [](const Collision&, const Body& b) { return b.mass == 1; },
       [](Stream&, Collision&, Body& b) { set_mass(b, 1); }},
      {"mass_power_of_two", special, "the mass is a power of two other than 1", "1/m is exact", true,
       [](const Collision&, const Body& b) {
         int exponent = 0;
         return std::frexp(b.mass, &exponent) == 0.5 && b.mass != 1;
       },
       [](Stream& stream, Collision&, Body& b) {
         int exponent = 0;
         std::frexp(b.mass, &exponent);
         set_mass(b, std::ldexp(1.0, exponent == 1 ? stream.integer(2, 4) : exponent - 1));
       }},
      {"moments_equal", relation, "the three moments are equal", "spheres and cubes: a fast path without R", true,
       [](const Collision&, const Body& b) { return are_equal(b.principal_inertia); },
       [](Stream&, Collision&, Body& b) { b.principal_inertia.setConstant(greatest(b.principal_inertia)); }},
      {"moments_one", special, "the three moments are 1", "the default of many engines; J⁻¹ = J", true,
       [](const Collision&, const Body& b) { return b.principal_inertia == V(1, 1, 1); },
       [](Stream& stream, Collision& c, Body& b) {
         // Either the mass changes within its domain, or the size changes.
         const double mass = 3 * b.mass / sum(b.principal_inertia);
         if (mass >= least_mass && mass < largest_mass && stream.chance(2)) {
           b.mass = mass;
         }
         b.principal_inertia.setOnes();
         const V r = lever_arm(c, b);
         const double size = radius_of_gyration(b);
         if (length(r) > size) {
           set_lever_arm(c, b, turned_along(V(size, 0, 0), r));
         }
       }},
      {"moments_two_equal", relation, "exactly two moments are equal", "discs, cylinders, capsules", true,
       [](const Collision&, const Body& b) {
         const V& i = b.principal_inertia;
         return !are_equal(i) && (i[0] == i[1] || i[1] == i[2] || i[2] == i[0]);
       },
       [](Stream& stream, Collision&, Body& b) {
         V& i = b.principal_inertia;
         const int other = stream.integer(0, 2);
         i[(other + 1) % 3] = i[(other + 2) % 3];
         i[other] = i[(other + 1) % 3] * 1.5;
       }},
      {"moments_ascending", relation, "the moments ascend", "sorted moments, or eigenvalues in the order of a library",
       true,
       [](const Collision&, const Body& b) {
         return b.principal_inertia[0] < b.principal_inertia[1] && b.principal_inertia[1] < b.principal_inertia[2];
       },
       [](Stream&, Collision&, Body& b) { sort_moments(b, true); }},
      {"moments_descending", relation, "the moments descend", "a sort of the moments swaps the axes", true,
       [](const Collision&, const Body& b) {
         return b.principal_inertia[0] > b.principal_inertia[1] && b.principal_inertia[1] > b.principal_inertia[2];
       },
       [](Stream&, Collision&, Body& b) { sort_moments(b, false); }},
      {"flat", relation, "one moment is the sum of the other two",
       "a thin plate; solvers that check the triangle inequality", true,
       [](const Collision&, const Body& b) { return is_flat(b.principal_inertia); },
       [](Stream& stream, Collision&, Body& b) {
         V& i = b.principal_inertia;
         const int sum = stream.integer(0, 2);
         i[sum] = i[(sum + 1) % 3] + i[(sum + 2) % 3];
       }},
      {"immovable", special, "the body is immovable", "walls and floors (failure cases 25 to 27)", false,
       [](const Collision&, const Body& b) { return b.immovable; },
       [](Stream&, Collision& c, Body& b) {
         if (!(&b == &c.a ? c.b : c.a).immovable) {
           b.immovable = true;
           b.mass = 1;
           b.principal_inertia.setOnes();
           b.orientation = Quaternion<double>(1, 0, 0, 0);
         }
       },
       true},
  });
}

namespace {

using Q = Quaternion<double>;

Vector3<double> axis_of(const Body& body) { return body.orientation.tail<3>(); }

/// Rotates about one coordinate axis by the quaternion with `w` and one other component ±`other`.
void turn_about_axis(Stream& stream, Body& body, double w, double other) {
  Q q = Q::Zero();
  q[0] = w;
  const double component = stream.chance(2) ? other : -other;
  q[stream.integer(1, 3)] = component;
  body.orientation = q;
}

bool is_about_axis(const Body& body) { return nonzero_components(axis_of(body)) == 1; }

}  // namespace

std::vector<Feature> of_orientation() {
  constexpr auto special = FeatureKind::special_value;
  return for_both({
      {"orientation_identity", special, "the orientation is exactly 1, 0, 0, 0",
       "the most common orientation; a fast path may skip R", true,
       [](const Collision&, const Body& b) { return b.orientation == Q(1, 0, 0, 0); },
       [](Stream&, Collision&, Body& b) { b.orientation = Q(1, 0, 0, 0); }},
      {"orientation_long_identity", special, "the orientation is w, 0, 0, 0 with w > 0 and w ≠ 1",
       "a solver that assumes a unit quaternion fails here, although nothing is rotated (failure case 9)", true,
       [](const Collision&, const Body& b) {
         return is_zero(axis_of(b)) && b.orientation[0] > 0 && b.orientation[0] != 1;
       },
       [](Stream& stream, Collision&, Body& b) { b.orientation = Q(stream.chance(2) ? 2 : 0.75, 0, 0, 0); }},
      {"orientation_negated_identity", special, "the orientation is w, 0, 0, 0 with w < 0",
       "q and −q are the same rotation; a solver may test only for w = 1", true,
       [](const Collision&, const Body& b) { return is_zero(axis_of(b)) && b.orientation[0] < 0; },
       [](Stream& stream, Collision&, Body& b) { b.orientation = Q(stream.chance(2) ? -1 : -1.5, 0, 0, 0); }},
      {"orientation_half_turn_about_axis", special, "the orientation is a half turn about a coordinate axis",
       "R is diagonal, so two sign errors cancel; a division by w = 0", true,
       [](const Collision&, const Body& b) { return b.orientation[0] == 0 && is_about_axis(b); },
       [](Stream& stream, Collision&, Body& b) { turn_about_axis(stream, b, 0, 1); }},
      {"orientation_half_turn", special,
       "the orientation is a half turn about an axis with two or three nonzero components",
       "conversions to an angle and an axis, or by tan, divide by w = 0", true,
       [](const Collision&, const Body& b) { return b.orientation[0] == 0 && nonzero_components(axis_of(b)) > 1; },
       [](Stream& stream, Collision&, Body& b) {
         const double y = stream.unit();
         b.orientation << 0, 1, y, stream.chance(2) ? 0.5 : -0.5;
       }},
      {"orientation_quarter_turn", special, "the orientation is a quarter turn about a coordinate axis",
       "a box on another side: R is a permutation, and J is diagonal with permuted moments", true,
       [](const Collision&, const Body& b) {
         return is_about_axis(b) && std::abs(b.orientation[0]) == greatest(axis_of(b).cwiseAbs());
       },
       [](Stream& stream, Collision&, Body& b) { turn_about_axis(stream, b, stream.chance(2) ? 1 : -0.5, 1); }},
      {"orientation_about_axis", special,
       "the orientation is a turn about a coordinate axis, and neither a half nor a quarter turn",
       "scenes in a plane: J has one pair of off-diagonal entries", true,
       [](const Collision&, const Body& b) {
         return is_about_axis(b) && b.orientation[0] != 0 &&
                std::abs(b.orientation[0]) != greatest(axis_of(b).cwiseAbs());
       },
       [](Stream& stream, Collision&, Body& b) {
         const double angle = stream.between(0.125, 0.875);
         turn_about_axis(stream, b, stream.chance(2) ? 1 : -1, angle);
       }},
      {"orientation_negative", special, "the quaternion's w < 0",
       "q and −q are the same rotation; a solver may test the sign of w, or choose the shorter rotation", true,
       [](const Collision&, const Body& b) { return b.orientation[0] < 0; },
       [](Stream&, Collision&, Body& b) {
         if (b.orientation[0] == 0) {
           b.orientation[0] = -0.5;
         } else if (b.orientation[0] > 0) {
           b.orientation = negated(b.orientation);
         }
       }},
      {"orientation_unit", special, "the quaternion has length 1 except for rounding, and is not the identity",
       "engines store unit quaternions; other lengths hide errors that only unit quaternions show", true,
       [](const Collision&, const Body& b) {
         return std::abs(squared_length(b.orientation) - 1) <= 0x1p-50 && !is_zero(axis_of(b));
       },
       [](Stream& stream, Collision&, Body& b) {
         if (is_zero(axis_of(b))) {
           b.orientation = stream.quaternion();
           b.orientation[1] = 0.5;
         }
         b.orientation /= std::sqrt(squared_length(b.orientation));
       }},
  });
}

}  // namespace carom::properties::features
