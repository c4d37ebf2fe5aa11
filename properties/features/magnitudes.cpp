// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/feature_groups.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

using V = Vector3<double>;

/// A positive number of a collision; 0 if the collision does not have it. Each decade from `first` to `last` is a
/// feature.
struct Quantity {
  std::string name;
  std::string statement;  // "the mass of A [kg]"
  std::string why;
  int first;  // decade
  int last;
  std::function<double(const Collision&)> measure;
  std::function<void(Stream&, Collision&, double)> set;
  int set_once_in = 1;
  bool is_seldom_with_others = false;
  DrawnBy drawn_by = DrawnBy::itself;
  char body = 0;
};

/// Sets masses so that the radii of gyration of two bodies with the same moments have this ratio. Returns false if the
/// moments differ, or if the masses would leave their domain.
bool set_size_ratio_by_masses(Collision& c, double ratio) {
  const double lighter = least_mass * 1.5;
  if (c.a.principal_inertia != c.b.principal_inertia || lighter * ratio * ratio >= largest_mass) {
    return false;
  }
  for (Body* b : {&c.a, &c.b}) {
    const double size = radius_of_gyration(*b);
    b->mass = b == &c.a ? lighter * ratio * ratio : lighter;
    set_lever_arm(c, *b, lever_arm(c, *b) * (radius_of_gyration(*b) / size));
  }
  return true;
}

/// Scales the body and its lever arm to this radius of gyration.
void set_size(Collision& c, Body& b, double size) {
  const double ratio = size / radius_of_gyration(b);
  b.principal_inertia *= ratio * ratio;
  set_lever_arm(c, b, lever_arm(c, b) * ratio);
}

/// Makes the greatest moment about `ratio` times the least. Integers stay integers, equal moments stay equal, and the
/// moments of a flat body stay those of a flat body. No moment exceeds the sum of the others.
void set_moment_ratio(V& moments, double ratio) {
  const auto is_whole = [](double x) { return x == std::floor(x); };
  const bool is_of_whole = is_whole(moments[0]) && is_whole(moments[1]) && is_whole(moments[2]);
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return moments[i] < moments[j] || (moments[i] == moments[j] && i < j); });
  double& least = moments[order[0]];
  double& middle = moments[order[1]];
  double& greatest = moments[order[2]];
  if (least + middle == greatest) {
    constexpr double least_ratio_of_flat = 2.5;
    const double wanted = std::max(ratio, least_ratio_of_flat);
    least = is_of_whole ? 1 : middle / (wanted - 1);
    middle = is_of_whole ? std::round(wanted) - 1 : middle;
    greatest = least + middle;
    return;
  }
  const bool has_equal = least == middle || middle == greatest;
  if (is_of_whole) {
    least = 1;
    greatest = std::max(std::round(ratio), 2.0);
    middle = greatest;
    return;
  }
  least = greatest / ratio;
  middle = has_equal ? greatest : (std::max(least, greatest - least) + greatest) / 2;
}

void set_length(V& v, double value) {
  if (is_zero(v)) {
    v = V{0.5, -0.75, 0.25};
  }
  v *= value / length(v);
}

double ratio_of(double x, double y) { return x == 0 || y == 0 ? 0 : std::max(x, y) / std::min(x, y); }

std::vector<Quantity> of_body(const std::string& letter, Body Collision::*body) {
  return {
      {letter + ".mass", "the mass of " + letter + " [kg]",
       "thresholds for zero masses, limits on masses, units other than SI", -9, 9,
       [=](const Collision& c) { return (c.*body).immovable ? 0 : (c.*body).mass; },
       [=](Stream& stream, Collision& c, double value) {
         make_movable(stream, c, c.*body);
         set_mass(c.*body, value);
       }},
      {letter + ".size", "the radius of gyration of " + letter + " [m]",
       "tiny moments treated as zero (failure case 64), thresholds in metres", -9, 9,
       [=](const Collision& c) { return radius_of_gyration(c.*body); },
       [=](Stream& stream, Collision& c, double value) {
         make_movable(stream, c, c.*body);
         set_size(c, c.*body, value);
       },
       1, false, DrawnBy::size_of_body},
      {letter + ".lever_arm", "the length of the lever arm of " + letter + " [m]", "small lever arms treated as zero",
       -9, 9, [=](const Collision& c) { return length(lever_arm(c, c.*body)); },
       [=](Stream&, Collision& c, double value) {
         Body& b = c.*body;
         V r = is_zero(lever_arm(c, b)) ? V{0.5, -0.75, 0.25} : lever_arm(c, b);
         set_length(r, value);
         set_lever_arm(c, b, r);
         if (!b.immovable && value > 2 * radius_of_gyration(b)) {
           const double ratio = value / radius_of_gyration(b);
           b.principal_inertia *= ratio * ratio;
         }
       },
       1, false, DrawnBy::lever_arm},
      {letter + ".moment_ratio", "the greatest moment of " + letter + " over its least moment",
       "rods and needles: J⁻¹ in world coordinates loses the spin about the long axis", 0, 8,
       [=](const Collision& c) {
         const V& moments = (c.*body).principal_inertia;
         return (c.*body).immovable ? 0 : greatest(moments) / least(moments);
       },
       [=](Stream& stream, Collision& c, double value) {
         Body& b = c.*body;
         make_movable(stream, c, b);
         const bool are_alike = c.a.principal_inertia == c.b.principal_inertia && are_movable(c);
         set_moment_ratio(b.principal_inertia, value);
         if (are_alike) {
           c.a.principal_inertia = c.b.principal_inertia = V(b.principal_inertia);
         }
         const double beyond = overreach(c, b);
         if (beyond > 1) {
           const V r = lever_arm(c, b);
           set_lever_arm(c, b, stream.chance(4) ? V(r / beyond) : V(long_axis(b) * length(r)));
         }
       },
       4, true},
      {letter + ".speed", "the speed of " + letter + " [m/s]", "sleeping bodies, limits on the speed", -9, 9,
       [=](const Collision& c) { return length((c.*body).velocity); },
       [=](Stream&, Collision& c, double value) { set_length((c.*body).velocity, value); }},
      {letter + ".spin", "the angular speed of " + letter + " [rad/s]", "small spins set to zero, limits on the spin",
       -9, 9, [=](const Collision& c) { return length((c.*body).angular_velocity); },
       [=](Stream&, Collision& c, double value) { set_length((c.*body).angular_velocity, value); }},
  };
}

std::vector<Quantity> quantities() {
  std::vector<Quantity> all;
  for (const auto& [letter, body] : {std::pair{'a', &Collision::a}, std::pair{'b', &Collision::b}}) {
    for (Quantity& quantity : of_body(std::string(1, letter), body)) {
      quantity.body = letter;
      all.push_back(std::move(quantity));
    }
  }
  all.push_back({"mass_ratio", "the larger mass over the smaller", "mass ratios beyond 100 (failure case 32)", 0, 9,
                 [](const Collision& c) { return c.a.immovable || c.b.immovable ? 0 : ratio_of(c.a.mass, c.b.mass); },
                 [](Stream& stream, Collision& c, double value) {
                   make_both_movable(stream, c);
                   Body& changed = stream.chance(2) ? c.a : c.b;
                   const Body& other = &changed == &c.a ? c.b : c.a;
                   set_mass(changed, other.mass > 1 ? other.mass / value : other.mass * value);
                 },
                 6, true});
  all.push_back({"size_ratio", "the larger radius of gyration over the smaller", "a marble on the earth", 0, 9,
                 [](const Collision& c) { return ratio_of(radius_of_gyration(c.a), radius_of_gyration(c.b)); },
                 [](Stream& stream, Collision& c, double value) {
                   make_both_movable(stream, c);
                   if (stream.chance(2) && set_size_ratio_by_masses(c, value)) {
                     return;
                   }
                   Body& changed = stream.chance(2) ? c.a : c.b;
                   const double other = radius_of_gyration(&changed == &c.a ? c.b : c.a);
                   set_size(c, changed, other > 1 ? other / value : other * value);
                 },
                 6, true});
  all.push_back({"distance", "the distance of the contact from the origin [m]",
                 "lever arms smaller than the rounding of the positions they are computed from (failure case 40)", -3,
                 9, [](const Collision& c) { return length(c.point); },
                 [](Stream& stream, Collision& c, double value) {
                   V of_a = lever_arm(c, c.a);
                   V of_b = lever_arm(c, c.b);
                   const bool along_axis = stream.chance(3);  // lever arms across the axis keep all their digits
                   const int axis = stream.integer(0, 2);
                   if (along_axis) {
                     c.point = V::Unit(axis);
                     of_a[axis] = 0;
                     of_b[axis] = 0;
                   }
                   set_length(c.point, value);
                   c.point = with_few_bits(c.point);
                   c.a.position = c.point - of_a;
                   c.b.position = c.point - of_b;
                 }});
  all.push_back({"approach", "the speed of approach [m/s]",
                 "thresholds below which bodies do not bounce (failure cases 38, 39, 50, 51)", -9, 9,
                 [](const Collision& c) { return std::abs(dot(c.normal, relative_velocity(c))) / length(c.normal); },
                 [](Stream& stream, Collision& c, double value) {
                   c.normal = with_few_bits(c.normal);
                   if (stream.chance(4)) {
                     c.normal = V::Unit(stream.integer(0, 2)) * size_of(c.normal);
                   }
                   for (Body* b : {&c.a, &c.b}) {
                     spin_along_lever_arm(c, *b);
                     if (!is_zero(b->velocity)) {
                       b->velocity = turned_across(stream, b->velocity, c.normal);
                     }
                   }
                   Body& quick = stream.chance(2) ? c.a : c.b;
                   quick.velocity = plus(quick.velocity, c.normal, value / length(c.normal));
                 },
                 2, true});
  all.push_back({"restitution", "ε", "thresholds below which ε is treated as 0", -9, -1,
                 [](const Collision& c) { return c.restitution < 1 ? c.restitution : 0; },
                 [](Stream&, Collision& c, double value) { c.restitution = std::min(value, 0.9375); }, 2});
  all.push_back({"loss", "1 − ε", "thresholds above which ε is treated as 1", -9, -1,
                 [](const Collision& c) { return c.restitution > 0 ? 1 - c.restitution : 0; },
                 [](Stream&, Collision& c, double value) { c.restitution = 1 - std::min(value, 0.9375); }, 2});
  return all;
}

Feature decade_of(const Quantity& quantity, int k) {
  // `make` chooses a value well inside the decade, so rounding cannot move it out.
  const double low = power_of_ten(k);
  const double high = power_of_ten(k + 1);
  return {fmt::format("{}_1e{}", quantity.name, k),
          FeatureKind::magnitude,
          fmt::format("{}: 10^{} to 10^{}", quantity.statement, k, k + 1),
          quantity.why,
          quantity.name,
          k,
          [measure = quantity.measure, low, high](const Collision& c) {
            const double value = measure(c);
            return value >= low && value < high;
          },
          [set = quantity.set, low](Stream& stream, Collision& c) {
            set(stream, c, low * (stream.plainly() ? 2 : stream.between(1.25, 9)));
          },
          quantity.body,
          false,
          quantity.measure,
          quantity.set_once_in,
          quantity.is_seldom_with_others,
          quantity.drawn_by};
}

}  // namespace

std::vector<Feature> magnitudes() {
  std::vector<Feature> features;
  for (const Quantity& quantity : quantities()) {
    for (int k = quantity.first; k <= quantity.last; ++k) {
      features.push_back(decade_of(quantity, k));
    }
  }
  return features;
}

}  // namespace carom::properties::features
