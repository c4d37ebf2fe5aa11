// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace features {

Feature special_value(std::string name, std::string statement, std::string why,
                      std::function<bool(const Collision&)> is_present, std::function<void(Stream&, Collision&)> make) {
  return {
      std::move(name), FeatureKind::special_value, std::move(statement), std::move(why), {}, 0, std::move(is_present),
      std::move(make)};
}

Feature pair_relation(const char* name, const char* statement, const char* why,
                      std::function<bool(const Collision&)> is_present, std::function<void(Stream&, Collision&)> make) {
  return {name, FeatureKind::relation, statement, why, {}, 0, std::move(is_present), std::move(make)};
}

std::vector<Feature> for_both(const std::vector<BodyFeature>& features) {
  std::vector<Feature> both;
  for (const auto& [letter, body] : {std::pair{"a", &Collision::a}, std::pair{"b", &Collision::b}}) {
    for (const BodyFeature& f : features) {
      both.push_back({std::string(letter) + '.' + f.name,
                      f.kind,
                      f.statement,
                      f.why,
                      {},
                      0,
                      [body = body, f](const Collision& c) {
                        return (!f.of_movable_bodies || !(c.*body).immovable) && f.is_present(c, c.*body);
                      },
                      [body = body, f](Stream& stream, Collision& c) {
                        if (f.of_movable_bodies) {
                          make_movable(stream, c, c.*body);
                        }
                        f.make(stream, c, c.*body);
                      },
                      *letter,
                      f.makes_immovable});
    }
  }
  return both;
}

}  // namespace features

namespace {

std::vector<Feature> catalogue() {
  std::vector<Feature> all;
  for (const auto group : {features::of_orientation, features::of_inertia, features::of_lever_arm,
                           features::of_velocities, features::of_normal, features::of_coefficients,
                           features::of_both_bodies, features::of_approach, features::magnitudes}) {
    std::vector<Feature> of_group = group();
    std::move(of_group.begin(), of_group.end(), std::back_inserter(all));
  }
  std::vector<Feature> near = features::near_features(all);
  std::move(near.begin(), near.end(), std::back_inserter(all));
  return all;
}

}  // namespace

std::string_view name_of(FeatureKind kind) {
  constexpr std::array<std::string_view, 4> names{"special value", "relation", "near", "magnitude"};
  return names[static_cast<std::size_t>(kind)];
}

std::span<const Feature> all_features() {
  static const std::vector<Feature> all = catalogue();
  return all;
}

const Feature* feature_named(std::string_view name) {
  for (const Feature& feature : all_features()) {
    if (feature.name == name) {
      return &feature;
    }
  }
  return nullptr;
}

}  // namespace carom::properties
