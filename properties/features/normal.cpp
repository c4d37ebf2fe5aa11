// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

constexpr const char* axis_names[] = {"x", "y", "z"};

/// Whether the angle between the normal and this half-axis is at most about 2⁻¹⁰ rad, but not zero.
bool is_near(const V& n, int axis, double sign) {
  const double squared_rest = squared_length(n) - n[axis] * n[axis];
  return !is_zero(n) && n[axis] * sign > 0 && squared_rest > 0 && squared_rest <= 0x1p-20 * n[axis] * n[axis];
}

V near_axis(Stream& stream, double size, int axis, double sign) {
  V n;
  n[axis] = sign * size;
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
    n[other] = size * stream.power_of_two(-40, -12);
  }
  return n;
}

Feature along_axis(int axis, double sign) {
  return {std::string("normal_") + (sign > 0 ? "plus_" : "minus_") + axis_names[axis],
          FeatureKind::special_value,
          std::string("the normal is exactly along ") + (sign > 0 ? "+" : "−") + axis_names[axis],
          "floors and walls; some tangent bases divide by zero here (Frisvad's basis of 2012 at −z)",
          {},
          0,
          [=](const Collision& c) { return nonzero_components(c.normal) == 1 && c.normal[axis] * sign > 0; },
          [=](Stream&, Collision& c) {
            const double size = size_of(c.normal);
            c.normal = V::Unit(axis) * (sign * size);
          }};
}

Feature near_axis(int axis, double sign) {
  return {std::string("normal_near_") + (sign > 0 ? "plus_" : "minus_") + axis_names[axis],
          FeatureKind::special_value,
          std::string("the normal is within 0.001 of ") + (sign > 0 ? "+" : "−") + axis_names[axis] +
              ", and not exactly along it",
          "tangent bases have their thresholds here",
          {},
          0,
          [=](const Collision& c) { return is_near(c.normal, axis, sign); },
          [=](Stream& stream, Collision& c) { c.normal = near_axis(stream, size_of(c.normal), axis, sign); }};
}

Feature of_length(const char* name, const char* statement, const char* why, double low, double high, int low_exponent,
                  int high_exponent) {
  return {name,
          FeatureKind::special_value,
          statement,
          why,
          {},
          0,
          [=](const Collision& c) { return length(c.normal) >= low && length(c.normal) < high; },
          [=](Stream& stream, Collision& c) {
            c.normal *= stream.power_of_two(low_exponent, high_exponent) / size_of(c.normal);
          }};
}

std::vector<Feature> of_components() {
  constexpr auto special = FeatureKind::special_value;
  return {{"normal_in_plane",
           special,
           "exactly one component of the normal is zero",
           "scenes in a plane; some terms of r × N vanish",
           {},
           0,
           [](const Collision& c) { return nonzero_components(c.normal) == 2; },
           [](Stream& stream, Collision& c) {
             const int zero = stream.integer(0, 2);
             for (int i = 0; i < 3; ++i) {
               c.normal[i] = i == zero ? 0 : (c.normal[i] == 0 ? size_of(c.normal) : c.normal[i]);
             }
           }},
          {"normal_ties",
           special,
           "exactly two components of the normal have the same nonzero magnitude",
           "the least or the largest component is not unique, and tangent bases choose an axis by it",
           {},
           0,
           [](const Collision& c) {
             const V n = c.normal.cwiseAbs();
             return has_ties(c.normal) && !(n[0] == n[1] && n[1] == n[2]);
           },
           [](Stream& stream, Collision& c) {
             const int from = stream.integer(0, 2);
             if (c.normal[from] == 0) {
               c.normal[from] = size_of(c.normal);
             }
             c.normal[(from + 1) % 3] = stream.chance(2) ? c.normal[from] : -c.normal[from];
             if (std::abs(c.normal[(from + 2) % 3]) == std::abs(c.normal[from])) {
               c.normal[(from + 2) % 3] *= 0.5;
             }
           }},
          {"normal_diagonal",
           special,
           "the three components of the normal have the same magnitude",
           "no component is the largest; the test |n| ≥ 1/√3 depends on rounding",
           {},
           0,
           [](const Collision& c) {
             const V n = c.normal.cwiseAbs();
             return n[0] == n[1] && n[1] == n[2];
           },
           [](Stream& stream, Collision& c) {
             const double size = size_of(c.normal);
             for (int i = 0; i < 3; ++i) {
               c.normal[i] = stream.chance(2) ? size : -size;
             }
           }},
          {"normal_unit",
           special,
           "the normal has length 1 except for rounding, and is not along an axis",
           "the normals of most engines",
           {},
           0,
           [](const Collision& c) {
             return std::abs(squared_length(c.normal) - 1) <= 0x1p-50 && nonzero_components(c.normal) > 1;
           },
           [](Stream& stream, Collision& c) {
             if (nonzero_components(c.normal) == 1) {
               c.normal = stream.direction();
               c.normal[0] = 0.5;
               c.normal[1] += c.normal[1] == 0 ? 1 : 0;
             }
             c.normal /= length(c.normal);
           }}};
}

std::vector<Feature> of_lengths() {
  return {
      of_length("normal_long", "the normal is 10 to 10⁶ long", "a solver may assume ‖N‖ = 1 (failure case 11)", 10, 1e6,
                5, 18),
      of_length("normal_very_long", "the normal is 10¹⁰ long or longer", "N·N, N·K N overflow in binary32", 1e10, 1e300,
                40, 100),
      of_length("normal_short", "the normal is 10⁻⁶ to 0.1 long", "thresholds for a zero normal", 1e-6, 0.1, -18, -5),
      of_length("normal_very_short", "the normal is shorter than 10⁻¹⁰", "thresholds for a zero normal", 1e-300, 1e-10,
                -100, -40)};
}

}  // namespace

std::vector<Feature> of_normal() {
  std::vector<Feature> features;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      features.push_back(along_axis(axis, sign));
      features.push_back(near_axis(axis, sign));
    }
  }
  for (const std::vector<Feature>& more : {of_components(), of_lengths()}) {
    features.insert(features.end(), more.begin(), more.end());
  }
  return features;
}

}  // namespace carom::properties::features
