// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
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
