// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/features/feature.hpp>

/// The groups of the catalogue, one file each.
namespace carom::properties::features {

[[nodiscard]] std::vector<Feature> of_orientation();
[[nodiscard]] std::vector<Feature> of_inertia();
[[nodiscard]] std::vector<Feature> of_velocities();
[[nodiscard]] std::vector<Feature> of_lever_arm();
[[nodiscard]] std::vector<Feature> of_normal();
[[nodiscard]] std::vector<Feature> of_coefficients();
[[nodiscard]] std::vector<Feature> of_both_bodies();
[[nodiscard]] std::vector<Feature> of_approach();
[[nodiscard]] std::vector<Feature> magnitudes();

/// A special value of the contact.
[[nodiscard]] Feature special_value(std::string name, std::string statement, std::string why,
                                    std::function<bool(const Collision&)> is_present,
                                    std::function<void(Stream&, Collision&)> make);

/// A relation between the bodies, or between both bodies and the contact.
[[nodiscard]] Feature pair_relation(const char* name, const char* statement, const char* why,
                                    std::function<bool(const Collision&)> is_present,
                                    std::function<void(Stream&, Collision&)> make);

/// A feature of one body, listed for A and for B.
struct BodyFeature {
  const char* name;
  FeatureKind kind;
  const char* statement;
  const char* why;
  bool of_movable_bodies;  // `make` first makes the body movable
  bool (*is_present)(const Collision&, const Body&);
  void (*make)(Stream&, Collision&, Body&);
  bool makes_immovable = false;
};

[[nodiscard]] std::vector<Feature> for_both(const std::vector<BodyFeature>& features);

/// x / y, and 0 if y is 0.
[[nodiscard]] inline double ratio(double x, double y) { return y == 0 ? 0 : x / y; }

/// A feature that nearly holds. `of` names it: "masses_equal", or "moments_equal" for that of A and that of B. The
/// functions get that body, or A if the feature belongs to none.
struct Near {
  const char* of;  // nullptr if the catalogue has no such feature
  /// The relative distance from the feature; 0 if the feature holds, or if the collision cannot have it.
  std::function<double(const Collision&, const Body&)> distance;
  /// Moves a collision that has the feature away from it, by about this distance.
  std::function<void(Stream&, Collision&, Body&, double)> move;
  const char* name = nullptr;       // if it is not "near_" and `of`
  const char* statement = nullptr;  // if `of` is nullptr
};

[[nodiscard]] std::vector<Near> near_orientations();
[[nodiscard]] std::vector<Near> near_inertia();    // masses and moments
[[nodiscard]] std::vector<Near> near_vectors();    // directions, components and lengths, except for normals
[[nodiscard]] std::vector<Near> near_normals();    // also the normal against V⁻
[[nodiscard]] std::vector<Near> near_zeros();      // vectors that are nearly zero
[[nodiscard]] std::vector<Near> near_pairs();      // fields of A and B that nearly agree
[[nodiscard]] std::vector<Near> near_relations();  // other fields that nearly agree

/// The near features of these features.
[[nodiscard]] std::vector<Feature> near_features(std::span<const Feature> exact);

}  // namespace carom::properties::features
