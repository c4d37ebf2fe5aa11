// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <carom/properties/features/feature_groups.hpp>

namespace carom::properties::features {
namespace {

/// A distance is 10⁻ᵏ times 1/4 to 5/2, with k from 1 to 15.
constexpr int last_decade = 15;
constexpr double least_share = 0.25;
constexpr double greatest_share = 2.5;

double drawn_distance(Stream& stream) {
  const double decade = power_of_ten(-stream.integer(1, last_decade));
  return decade * (stream.plainly() ? 1 : stream.between(least_share, greatest_share));
}

enum class Side { below, above, either };

Near of_coefficient(const char* of, double Collision::*coefficient, double value, Side side) {
  return {of, [=](const Collision& c, const Body&) { return std::abs(c.*coefficient - value); },
          [=](Stream& stream, Collision& c, Body&, double distance) {
            const bool is_above = side == Side::above || (side == Side::either && stream.chance(2));
            c.*coefficient = is_above ? value + distance : value - distance;
          }};
}

std::vector<Near> near_coefficients() {
  constexpr auto restitution = &Collision::restitution;
  constexpr auto friction = &Collision::friction;
  constexpr auto tangential = &Collision::tangential_restitution;
  return {
      of_coefficient("restitution_zero", restitution, 0, Side::above),
      of_coefficient("restitution_one", restitution, 1, Side::below),
      of_coefficient("restitution_half", restitution, 0.5, Side::either),
      of_coefficient("friction_zero", friction, 0, Side::above),
      of_coefficient("friction_one", friction, 1, Side::either),
      of_coefficient("tangential_restitution_zero", tangential, 0, Side::either),
      of_coefficient("tangential_restitution_one", tangential, 1, Side::below),
      of_coefficient("tangential_restitution_minus_one", tangential, -1, Side::above),
      {"restitution_equals_friction",
       [](const Collision& c, const Body&) { return std::abs(c.restitution - c.friction); },
       [](Stream& stream, Collision& c, Body&, double distance) {
         c.friction = c.restitution * (stream.chance(2) ? 1 + distance : 1 - distance);
       }},
  };
}

Body& body_of(Collision& c, char letter) { return letter == 'b' ? c.b : c.a; }
const Body& body_of(const Collision& c, char letter) { return letter == 'b' ? c.b : c.a; }

/// `prefix` is "a." or "b." for a feature of one body, and otherwise empty.
Feature feature_of(const Near& near, const Feature* exact, const std::string& prefix) {
  const char letter = prefix.empty() ? 0 : prefix[0];
  Feature feature;
  feature.name = prefix + (near.name != nullptr ? near.name : std::string("near_") + near.of);
  feature.kind = FeatureKind::near;
  feature.statement = std::string(nearly) + (near.statement != nullptr ? near.statement : exact->statement);
  feature.why = "a solver may take a nearly special value for the special one";
  feature.body = letter;
  feature.measure = [distance = near.distance, letter](const Collision& c) { return distance(c, body_of(c, letter)); };
  const std::function<bool(const Collision&)> is_exact = exact == nullptr ? nullptr : exact->is_present;
  feature.is_present = [measure = feature.measure, is_exact](const Collision& c) {
    const double distance = measure(c);
    const bool is_near =
        distance >= least_share * power_of_ten(-last_decade) && distance <= greatest_share * power_of_ten(-1);
    return is_near && !(is_exact && is_exact(c));
  };
  feature.make = [exact_make = exact == nullptr ? nullptr : exact->make, move = near.move, letter](Stream& stream,
                                                                                                   Collision& c) {
    const double distance = drawn_distance(stream);
    if (exact_make) {
      exact_make(stream, c);
    }
    move(stream, c, body_of(c, letter), distance);
  };
  return feature;
}

}  // namespace

std::vector<Feature> near_features(std::span<const Feature> exact) {
  const auto named = [&](const std::string& name) {
    const auto found = std::find_if(exact.begin(), exact.end(), [&](const Feature& f) { return f.name == name; });
    return found == exact.end() ? nullptr : &*found;
  };
  std::vector<Feature> all;
  for (const auto group : {near_orientations, near_inertia, near_vectors, near_normals, near_zeros, near_pairs,
                           near_relations, near_coefficients}) {
    for (const Near& near : group()) {
      if (near.of == nullptr) {
        all.push_back(feature_of(near, nullptr, ""));
        continue;
      }
      const std::size_t before = all.size();
      for (const char* prefix : {"", "a.", "b."}) {
        if (const Feature* feature = named(std::string(prefix) + near.of)) {
          all.push_back(feature_of(near, feature, prefix));
        }
      }
      if (all.size() == before) {
        throw std::logic_error("no feature has the name \"" + std::string(near.of) + '"');
      }
    }
  }
  return all;
}

}  // namespace carom::properties::features
