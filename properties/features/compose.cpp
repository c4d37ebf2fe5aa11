// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/compose.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace {

using Features = std::vector<const Feature*>;

template <class Is>
Features features_if(const Is& is) {
  Features features;
  for (const Feature& feature : all_features()) {
    if (is(feature)) {
      features.push_back(&feature);
    }
  }
  return features;
}

const Features& values_and_relations() {
  static const Features chosen = features_if([](const Feature& feature) {
    return feature.kind == FeatureKind::special_value || feature.kind == FeatureKind::relation;
  });
  return chosen;
}

/// Features that seldom occur together unless `composed` chooses both.
const Features& ratios_and_relations() {
  static const Features chosen = features_if(
      [](const Feature& feature) { return feature.kind == FeatureKind::relation || feature.is_seldom_with_others; });
  return chosen;
}

/// The beginnings of the names of two groups of features. A feature of one group seldom occurs with a feature of the
/// other unless both are chosen. "?" stands for A, and then for B.
struct Beginnings {
  std::string_view first;
  std::string_view second;
};
constexpr Beginnings seldom_together[]{{"whole_numbers", "approach_1e-"},
                                       {"whole_numbers", "normal_near_"},
                                       {"whole_numbers", "?.size_1e-"},
                                       {"whole_numbers", "near_head_on"},
                                       {"whole_numbers", "?.orientation_"},
                                       {"lever_arms_opposite", "?.lever_arm_1e"},
                                       {"grazing", "approach_1e"},
                                       {"approach_1e", "?.speed_1e"},
                                       {"approach_1e", "?.lever_arm_1e"},
                                       {"?.rolling", "velocities_"},
                                       {"?.rolling", "momenta_"},
                                       {"?.rolling", "approach_along_axis"},
                                       {"?.rolling", "whole_numbers"},
                                       {"?.spin_equals_velocity", "head_on"},
                                       {"?.moments_one", "momenta_opposite"},
                                       {"?.moments_one", "whole_numbers"},
                                       {"centres_coincide", "?.lever_arm_1e"},
                                       {"whole_numbers", "momenta_"},
                                       {"whole_numbers", "velocities_"},
                                       {"whole_numbers", "lever_arms_opposite"},
                                       {"whole_numbers", "central"},
                                       {"a.rolling", "b.rolling"},
                                       {"a.rolling", "b.at_rest"},
                                       {"a.at_rest", "b.rolling"},
                                       {"moments_alike", "size_ratio_1e"},
                                       {"normal_unit", "approach_1e"},
                                       {"central", "velocities_"},
                                       {"planar", "normal_near_"},
                                       {"planar", "approach_1e"},
                                       {"distance_1e", "?.lever_arm_1e"},
                                       {"?.moments_one", "?.mass_"},
                                       {"bodies_alike", "?.moment_ratio_1e"},
                                       {"whole_numbers", "?.moment_ratio_1e"},
                                       {"?.lever_arm_1e", "?.moment_ratio_1e"}};

/// The features whose names begin with this text. Throws std::logic_error if there is none.
Features features_beginning(std::string beginning, char body) {
  std::replace(beginning.begin(), beginning.end(), '?', body);
  Features features = features_if([&](const Feature& feature) { return feature.name.starts_with(beginning); });
  if (features.empty()) {
    throw std::logic_error("no feature has a name that begins with \"" + beginning + '"');
  }
  return features;
}

struct SeldomPair {
  Features first;
  Features second;
};

const std::vector<SeldomPair>& seldom_pairs() {
  static const std::vector<SeldomPair> pairs = [] {
    std::vector<SeldomPair> resolved;
    for (const auto& [first, second] : seldom_together) {
      const bool is_of_each_body = first.starts_with('?') || second.starts_with('?');
      for (const char body : std::string_view(is_of_each_body ? "ab" : "a")) {
        resolved.push_back(
            {features_beginning(std::string(first), body), features_beginning(std::string(second), body)});
      }
    }
    return resolved;
  }();
  return pairs;
}

/// The near features; that of A and that of B stand together.
const std::vector<Features>& near_features() {
  static const std::vector<Features> chosen = [] {
    std::vector<Features> features;
    for (const Feature& feature : all_features()) {
      if (feature.kind != FeatureKind::near) {
        continue;
      }
      if (feature.body == 'b') {
        features.back().push_back(&feature);
      } else {
        features.push_back({&feature});
      }
    }
    return features;
  }();
  return chosen;
}

const Feature& drawn_of(Stream& stream, const Features& features) { return *features[stream.below(features.size())]; }

void reverse_if_separating(Stream& stream, Collision& c) {
  if (properties::reverse_if_separating(c)) {
    stream.note(Adjustment::reversed);
  }
}

/// The limit of lengths [m], speeds [m/s] and angular speeds [rad/s]: ten times the greatest value that a feature sets.
constexpr double largest_number = 1e11;

/// At times, puts the contact 1 to 2 radii of gyration from the centre of the body.
void draw_surface(Stream& stream, Collision& c, Body& body) {
  const Vector3<double> r = features::lever_arm(c, body);
  if (!body.immovable && !features::is_zero(r) && stream.chance(4)) {
    const double reach = features::radius_of_gyration(body) * stream.between(1, 2);
    features::set_lever_arm(c, body, r * (reach / length(r)));
  }
}

/// Draws a decade for each quantity independently, but keeps lever arms within their bodies.
void draw_magnitudes(Stream& stream, Collision& c) {
  const std::span<const Feature> all = all_features();
  std::uint64_t size = 0;  // the place of the decade of the body's size
  // The features of one quantity are adjacent.
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(), [&](const Feature& f) { return f.quantity != first->quantity; });
    const auto count = static_cast<std::uint64_t>(last - first);
    if (!first->quantity.empty() && stream.chance(first->set_once_in)) {
      const int nearest_to_one = std::clamp(-first->decade, 0, static_cast<int>(count) - 1);
      std::uint64_t chosen = stream.below(count, static_cast<std::uint64_t>(nearest_to_one));
      if (first->drawn_by == DrawnBy::size_of_body) {
        size = chosen;
      } else if (first->drawn_by == DrawnBy::lever_arm) {
        // The decade of a lever arm is at most that of the body's size.
        chosen = stream.chance(2) ? size : chosen % (size + 1);
      }
      first[static_cast<std::ptrdiff_t>(chosen)].make(stream, c);
    }
    first = last;
  }
  if (!stream.chance(2)) {
    // Puts the contact about as far from the origin as the shorter lever arm is long, so binary32 holds both lever
    // arms.
    const double shortest =
        std::min(features::size_of(features::lever_arm(c, c.a)), features::size_of(features::lever_arm(c, c.b)));
    const Vector3<double> place = features::with_few_bits(c.point) * (shortest / features::size_of(c.point));
    features::move_point_to_origin(c);
    c.point += place;
    c.a.position += place;
    c.b.position += place;
  }
}

/// Prevents contacts far outside a body. They make the collision matrix so ill-conditioned that every solver loses all
/// digits.
void keep_contact_on_bodies(Stream& stream, Collision& c) {
  for (Body* body : {&c.a, &c.b}) {
    double overreach = features::overreach(c, *body);
    if (overreach > 1 && overreach * features::radius_of_gyration(*body) > largest_number) {
      // Moves the contact onto the long axis. Otherwise the enlarged moments would take a slender body out of the
      // domain.
      const double lever_arm = length(features::lever_arm(c, *body));
      features::set_lever_arm(c, *body, features::long_axis(*body) * lever_arm);
      overreach = features::overreach(c, *body);
    }
    if (overreach > 1) {
      body->principal_inertia *= overreach * overreach;
      stream.note(Adjustment::moments_enlarged);
    }
  }
}

}  // namespace

bool make_both(Stream& stream, Collision& collision, const Feature& first, const Feature& second) {
  constexpr int rounds = 4;
  for (int i = 0; i < rounds; ++i) {
    for (const Feature* feature : {&first, &second}) {
      if (!feature->is_present(collision)) {
        feature->make(stream, collision);
        stream.settle(collision);
      }
    }
  }
  return first.is_present(collision) && second.is_present(collision);
}

namespace {

/// Whether masses are from 10⁻⁹ to 10¹⁰ kg, and lengths, sizes and speeds at most `largest_number`.
bool is_in_domain(const Collision& c) {
  bool is_within = length(c.point) <= largest_number;
  for (const Body* body : {&c.a, &c.b}) {
    is_within = is_within && length(body->position) <= largest_number && length(body->velocity) <= largest_number &&
                length(body->angular_velocity) <= largest_number &&
                features::radius_of_gyration(*body) <= largest_number &&
                (body->immovable || (body->mass >= features::least_mass && body->mass < features::largest_mass));
  }
  return is_within;
}

/// Makes vectors that are parallel within rounding exactly parallel.
void make_parallels_exact(Stream& stream, Collision& c) {
  for (const Body* body : {&c.a, &c.b}) {
    const Vector3<double> r = features::lever_arm(c, *body);
    const bool is_parallel = features::are_parallel(r, c.normal) || features::are_parallel(r, body->angular_velocity);
    if (is_parallel && !features::is_exact_lever_arm(c, *body)) {
      features::move_point_to_origin(c);
      stream.note(Adjustment::moved_to_origin);
    }
  }
}

Collision composed(Stream& stream) {
  Collision c = general_collision(stream);
  draw_magnitudes(stream, c);
  draw_surface(stream, c, c.a);
  draw_surface(stream, c, c.b);
  stream.settle(c);
  const int count = stream.integer(0, 8);
  for (int i = 0; i < count; ++i) {
    drawn_of(stream, values_and_relations()).make(stream, c);
  }
  stream.settle(c);
  const SeldomPair& seldom = seldom_pairs()[stream.below(seldom_pairs().size())];
  const bool is_seldom = stream.chance(8);
  const Feature& first = drawn_of(stream, is_seldom ? seldom.first : values_and_relations());
  const Feature& second = is_seldom          ? drawn_of(stream, seldom.second)
                          : stream.chance(2) ? drawn_of(stream, values_and_relations())
                                             : drawn_of(stream, ratios_and_relations());
  constexpr int attempts = 3;
  for (int i = 0; i < attempts; ++i) {
    Collision tried = c;
    if (make_both(stream, tried, first, second) || i + 1 == attempts) {
      c = tried;
      break;
    }
  }
  keep_contact_on_bodies(stream, c);
  make_parallels_exact(stream, c);
  stream.settle(c);
  reverse_if_separating(stream, c);
  return c;
}

}  // namespace

Collision structured_collision(Stream& stream) {
  constexpr int attempts = 8;
  for (int i = 0; i < attempts; ++i) {
    Collision collision = composed(stream);
    if (is_in_domain(collision)) {
      return collision;
    }
    stream.note_drawn_again();
  }
  return general_collision(stream);
}

void make_several_near(Stream& stream, Collision& collision) {
  constexpr int attempts = 4;
  for (int i = 0; i < attempts; ++i) {
    Collision tried = collision;
    Features chosen;
    const int count = stream.integer(6, 14);
    for (int j = 0; j < count; ++j) {
      const auto& of_either = near_features()[stream.below(near_features().size())];
      chosen.push_back(&drawn_of(stream, of_either));
      chosen.back()->make(stream, tried);
    }
    stream.settle(tried);
    for (const Feature* feature : chosen) {
      if (!feature->is_present(tried)) {
        feature->make(stream, tried);
        stream.settle(tried);
      }
    }
    keep_contact_on_bodies(stream, tried);
    make_parallels_exact(stream, tried);
    stream.settle(tried);
    reverse_if_separating(stream, tried);
    if (is_in_domain(tried)) {
      collision = tried;
      return;
    }
    stream.note_drawn_again();
  }
}

void sprinkle(Stream& stream, Collision& collision) {
  if (!stream.chance(4)) {
    return;
  }
  const int count = stream.integer(1, 4);
  for (int i = 0; i < count; ++i) {
    const Feature& feature = drawn_of(stream, values_and_relations());
    if (!feature.makes_immovable) {
      feature.make(stream, collision);
    }
  }
  keep_contact_on_bodies(stream, collision);
  make_parallels_exact(stream, collision);
  stream.settle(collision);
  reverse_if_separating(stream, collision);
}

}  // namespace carom::properties
