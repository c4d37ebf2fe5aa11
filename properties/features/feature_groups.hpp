// SPDX-License-Identifier: BSL-1.0
#pragma once

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

/// A relation between the bodies, or between both bodies and the contact.
[[nodiscard]] Feature pair_relation(const char* name, const char* statement, const char* why,
                                    bool (*is_present)(const Collision&), void (*make)(Stream&, Collision&));

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

}  // namespace carom::properties::features
