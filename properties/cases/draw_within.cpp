// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace {

/// The largest number of binades below the nearest end of a range that values are spread over.
constexpr int most_binades = 20;

/// A number in the range, away from its ends if the range has a width.
double inside(Stream& stream, const Range& range) {
  const double width = range.most - range.least;
  return range.least + width * stream.between(0.25, 0.75);
}

/// A factor that brings x into the range: a power of two if one does. Precondition: x is positive and finite, and
/// outside of the range.
double factor_into(Stream& stream, double x, const Range& range) {
  const int step = x > range.most ? -1 : 1;
  int exponent = 0;
  while (step * (std::ldexp(x, exponent) - (step < 0 ? range.most : range.least)) < 0) {
    exponent += step;
  }
  if (!range.contains(std::ldexp(x, exponent))) {
    return inside(stream, range) / x;
  }
  int further = 0;
  while (further < most_binades && range.contains(std::ldexp(x, exponent + step * (further + 1)))) {
    ++further;
  }
  return std::ldexp(1.0, exponent + step * stream.integer(0, further, 0));
}

/// Whether each movable body can be a uniform ball that holds the contact: J ≥ 2/5 m ‖r‖², but for rounding.
bool are_uniform_balls(const Collision& c) {
  const auto is_ball = [&](const Body& body) {
    const Vector3<double>& moments = body.principal_inertia;
    const double least = 0.4 * body.mass * squared_length(features::lever_arm(c, body));
    return body.immovable ||
           (moments[0] == moments[1] && moments[1] == moments[2] && moments[0] >= least * (1 - 0x1p-40));
  };
  return is_ball(c.a) && is_ball(c.b);
}

class Fit {
 public:
  Fit(const Domain& domain, std::optional<LimitedQuantity> keeps, Stream& stream, Case& one)
      : domain_(&domain),
        keeps_(keeps),
        stream_(&stream),
        one_(&one),
        c_(&one.collision),
        overreach_of_a_(std::max(1.0, features::overreach(*c_, c_->a))),
        overreach_of_b_(std::max(1.0, features::overreach(*c_, c_->b))) {}

  /// Whether the domain contains the collision, and no contact lies further outside of a body than before. Contacts far
  /// outside make K so ill-conditioned that every solver loses all digits.
  [[nodiscard]] bool is_done() const {
    // The overreach of a scaled contact has fewer than 2⁷ roundings of 2⁻⁵³. If cancellation makes them matter more,
    // the case is drawn again.
    constexpr double rounding = 1 + 0x1p-46;
    return contains(*domain_, *c_) && features::overreach(*c_, c_->a) <= overreach_of_a_ * rounding &&
           features::overreach(*c_, c_->b) <= overreach_of_b_ * rounding;
  }

  void round() {
    if (put_into(domain_->kinds, *stream_, *c_)) {
      one_->convex_uniform = one_->convex_uniform && are_uniform_balls(*c_);
    }
    coefficient(LimitedQuantity::restitution, c_->restitution);
    coefficient(LimitedQuantity::friction, c_->friction);
    coefficient(LimitedQuantity::tangential_restitution, c_->tangential_restitution);
    masses();
    moments();
    sizes();
    distance();
    speeds();
    spins();
    approach();
  }

 private:
  [[nodiscard]] const Range& range(LimitedQuantity quantity) const { return domain_->ranges[quantity]; }

  /// The factor for x; 1 if x is in the range, or zero.
  [[nodiscard]] double factor(LimitedQuantity quantity, double x) {
    return x == 0 || !std::isfinite(x) || range(quantity).contains(x) ? 1 : factor_into(*stream_, x, range(quantity));
  }

  void coefficient(LimitedQuantity quantity, double& number) {
    const Range& permitted = range(quantity);
    if (permitted.contains(number) || keeps_ == quantity) {
      return;
    }
    const bool has_end = std::isfinite(permitted.most);
    if (stream_->chance(4)) {
      number = has_end && stream_->chance(2) ? permitted.most : permitted.least;
    } else {
      number = has_end ? inside(*stream_, permitted) : permitted.least * (1 + stream_->unit());
    }
  }

  /// Moves the centre so that the lever arm is r: exactly if the lever arm is parallel to the normal or the spin,
  /// because rounding would undo this. An exact lever arm may need the contact at the origin.
  void set_arm(Body& body, const Vector3<double>& r) {
    if (features::are_parallel(r, c_->normal) || features::are_parallel(r, body.angular_velocity)) {
      features::set_exact_lever_arm(*c_, body, r);
    } else {
      features::set_lever_arm(*c_, body, r);
    }
  }

  void set_point(const Vector3<double>& point) {
    const std::array arms{features::lever_arm(*c_, c_->a), features::lever_arm(*c_, c_->b)};
    c_->point = point;
    features::set_lever_arm(*c_, c_->b, arms[1]);
    set_arm(c_->a, arms[0]);
    set_arm(c_->b, arms[1]);
  }

  /// Scales the body about the contact.
  void scale_size(Body& body, double by) {
    if (by != 1) {
      body.principal_inertia *= by * by;
      set_arm(body, features::lever_arm(*c_, body) * by);
    }
  }

  template <class Use>
  void for_each_movable(const Use& use) {
    for (Body* body : {&c_->a, &c_->b}) {
      if (!body->immovable) {
        use(*body);
      }
    }
  }

  template <class Use>
  void for_each_wall(const Use& use) {
    for (Body* body : {&c_->a, &c_->b}) {
      if (body->immovable) {
        use(*body);
      }
    }
  }

  /// Brings the ratio of `of` the two bodies into its range. `scale(body, factor)` multiplies `of` the body.
  template <class Of, class Scale>
  void ratio(LimitedQuantity quantity, const Of& of, const Scale& scale) {
    if (c_->a.immovable || c_->b.immovable) {
      return;
    }
    Body& greater = of(c_->a) < of(c_->b) ? c_->b : c_->a;
    const Body& lesser = &greater == &c_->a ? c_->b : c_->a;
    if (const double by = factor(quantity, of(greater) / of(lesser)); by != 1) {
      scale(greater, by);
    }
  }

  void masses() {
    for_each_movable([&](Body& body) {
      if (const double by = factor(LimitedQuantity::mass, body.mass); by != 1) {
        features::scale_mass(body, by);
        if (range(LimitedQuantity::mass).least == range(LimitedQuantity::mass).most) {
          body.mass = range(LimitedQuantity::mass).least;
        }
      }
    });
    ratio(
        LimitedQuantity::mass_ratio, [](const Body& body) { return body.mass; }, &features::scale_mass);
  }

  /// Raises the lesser moments if the ratio is too great. If it is too small, makes two moments equal and the third
  /// less.
  void moments() {
    for_each_movable([&](Body& body) {
      const double largest = greatest(body.principal_inertia);
      const double before = largest / least(body.principal_inertia);
      const double by = factor(LimitedQuantity::moment_ratio, before);
      if (by == 1) {
        return;
      }
      const double lesser = largest / (before * by);
      one_->convex_uniform = false;
      if (by < 1) {
        body.principal_inertia = body.principal_inertia.cwiseMax(lesser);
      } else {
        const int place = place_of_least(body.principal_inertia);
        body.principal_inertia.setConstant(largest);
        body.principal_inertia[place] = lesser;
      }
    });
  }

  void sizes() {
    // The contact moves with the body that is scaled most, so that it stays about as far from the origin.
    double least = Range().most;
    for_each_movable([&](Body& body) {
      const double by = factor(LimitedQuantity::size, features::radius_of_gyration(body));
      scale_size(body, by);
      least = std::min(least, by);
    });
    if (std::isfinite(least) && least != 1) {
      set_point(c_->point * least);
    }
    ratio(
        LimitedQuantity::size_ratio, [](const Body& body) { return features::radius_of_gyration(body); },
        [&](Body& body, double by) { scale_size(body, by); });
    for_each_movable([&](Body& body) {
      const Vector3<double> arm = features::lever_arm(*c_, body);
      if (const double by = factor(LimitedQuantity::size, length(arm)); by != 1) {
        set_arm(body, arm * by);
        one_->convex_uniform = false;
      }
    });
    for_each_wall([&](Body& wall) {
      const Vector3<double> arm = features::lever_arm(*c_, wall);
      if (length(arm) < features::least_radius_of_gyration(*c_)) {
        set_arm(wall, arm * factor(LimitedQuantity::size, length(arm)));
      }
    });
    keep_contact_on(c_->a, overreach_of_a_);
    keep_contact_on(c_->b, overreach_of_b_);
  }

  /// Shortens the lever arm, or moves the contact onto the long axis if the lever arm would be too short.
  void keep_contact_on(Body& body, double limit) {
    const double overreach = features::overreach(*c_, body);
    if (overreach <= limit) {
      return;
    }
    const Vector3<double> arm = features::lever_arm(*c_, body);
    constexpr double margin = 1 - 0x1p-10;  // for the rounding of the position
    const Vector3<double> shortened = arm * (margin * limit / overreach);
    const bool is_in_range = range(LimitedQuantity::size).contains(length(shortened));
    set_arm(body, is_in_range ? shortened : features::long_axis(body) * length(arm));
    one_->convex_uniform = false;
  }

  void distance() {
    const double radius = features::least_radius_of_gyration(*c_);
    if (radius == 0) {
      return;
    }
    const double by = factor(LimitedQuantity::distance, length(c_->point) / radius);
    if (by != 1) {
      set_point(c_->point * by);
    }
    const Range& permitted = range(LimitedQuantity::distance);
    for_each_wall([&](Body& wall) {
      const double x = length(wall.position) / radius;
      if (x != 0 && !permitted.contains(x)) {
        bring_near_point(
            wall, std::min(permitted.most * radius - length(c_->point), length(c_->point) - permitted.least * radius));
      }
    });
  }

  /// Shortens the lever arm of a wall to at most `most`, by a power of two.
  void bring_near_point(Body& wall, double most) {
    const Vector3<double> arm = features::lever_arm(*c_, wall);
    const double by = most > 0 ? std::exp2(std::floor(std::log2(most / length(arm)))) : 0;
    set_arm(wall, arm * std::min(by, 1.0));
  }

  void speeds() {
    // One factor for all motion keeps the directions of relative velocities.
    const double greater = std::max(length(c_->a.velocity), length(c_->b.velocity));
    if (const double by = factor(LimitedQuantity::speed, greater); by != 1) {
      for (Body* body : {&c_->a, &c_->b}) {
        body->velocity *= by;
        body->angular_velocity *= by;
      }
    }
    for (Body* body : {&c_->a, &c_->b}) {
      if (const double by = factor(LimitedQuantity::speed, length(body->velocity)); by != 1) {
        body->velocity *= by;
      }
    }
    for_each_wall([&](Body& wall) {
      wall.angular_velocity *= factor(LimitedQuantity::speed, length(wall.angular_velocity) * reach_of_wall(*c_, wall));
    });
  }

  void spins() {
    const double speed = std::max(length(c_->a.velocity), length(c_->b.velocity));
    for_each_movable([&](Body& body) {
      const double spin = length(body.angular_velocity) * features::radius_of_gyration(body);
      body.angular_velocity *=
          speed == 0 ? factor(LimitedQuantity::speed, spin) : factor(LimitedQuantity::spin, spin / speed);
    });
  }

  void approach() {
    const double along = dot(c_->normal, relative_velocity(*c_));
    if (along >= 0) {
      return;
    }
    const double by = factor(LimitedQuantity::approach, -along / length(c_->normal));
    if (by != 1) {
      const double more = along * (by - 1) / squared_length(c_->normal);
      set_relative_velocity(*c_, plus(relative_velocity(*c_), c_->normal, more));
    }
  }

  const Domain* domain_;
  std::optional<LimitedQuantity> keeps_;
  Stream* stream_;
  Case* one_;
  Collision* c_;
  double overreach_of_a_;
  double overreach_of_b_;
};

constexpr int draws = 64;

}  // namespace

bool fit_into(const Domain& domain, std::optional<LimitedQuantity> keeps, Stream& stream, Case& one) {
  // A later quantity may take an earlier one out of its range, so the changes are repeated.
  constexpr int rounds = 6;
  if (contains(domain, one.collision)) {
    return true;
  }
  // The sign of N·V⁻, rounded.
  const auto direction = [&] {
    const double along = dot(one.collision.normal, relative_velocity(one.collision));
    return along > 0 ? 1 : along < 0 ? -1 : 0;
  };
  const int drawn = direction();
  Fit fit(domain, keeps, stream, one);
  for (int i = 0; i < rounds; ++i) {
    if (fit.is_done()) {
      return direction() == drawn;
    }
    fit.round();
    if (!validate(one.collision).empty()) {
      return false;
    }
    if (drawn != 0 && direction() == -drawn) {
      for (Body* body : {&one.collision.a, &one.collision.b}) {
        body->velocity = negated(body->velocity);
        body->angular_velocity = negated(body->angular_velocity);
      }
      stream.note(Adjustment::reversed);
    }
  }
  return fit.is_done() && direction() == drawn;
}

bool draw_into(const Domain& domain, const Family& family, Stream& stream, Case& one) {
  // The vectors that families choose across a normal (`orthogonal`) lie in the plane xy, so every plane is first this
  // one.
  Domain first = domain;
  const Plane plane = domain.kinds.plane;
  first.kinds.plane = plane == Plane::any ? plane : Plane::xy;
  bool has_changed_shapes = false;
  if (!is_any(first.kinds)) {
    stream.settle_by([&](Stream& of_family, Collision& c) {
      has_changed_shapes = (validate(c).empty() && put_into(first.kinds, of_family, c)) || has_changed_shapes;
    });
  }
  one = family.generate(stream);
  stream.settle(one.collision);
  stream.settle_by({});
  one.convex_uniform = one.convex_uniform && (!has_changed_shapes || are_uniform_balls(one.collision));
  Case fitted = one;
  if (!fit_into(first, family.keeps, stream, fitted)) {
    return false;
  }
  for (int i = plane == Plane::yz ? 1 : plane == Plane::zx ? 2 : 0; i > 0; --i) {
    rename_axes(fitted.collision);
  }
  const bool is_still = is_any(domain.kinds) || family.is_still == nullptr || family.is_still(fitted.collision);
  if (!is_still || !contains(domain, fitted.collision)) {
    return false;
  }
  one = fitted;
  return true;
}

std::optional<Case> drawn_within(const Domain& domain, const Family& family, Stream& stream) {
  for (int i = 0; i < draws; ++i) {
    if (Case one; draw_into(domain, family, stream, one)) {
      return one;
    }
    stream.note_drawn_again();
  }
  return std::nullopt;
}

namespace {

std::optional<Case> numbered(const Domain& domain, const Family& family, std::uint64_t seed, std::uint64_t index) {
  Stream stream = case_stream(seed, family.name, index);
  std::optional<Case> drawn = drawn_within(domain, family, stream);
  if (drawn) {
    drawn->adjusted = stream.adjusted();
  }
  return drawn;
}

/// The first case of the family that fits, among the numbers 0 to 7.
std::optional<Case> first_case(const Domain& domain, const Family& family, std::uint64_t seed) {
  constexpr std::uint64_t tried = 8;
  for (std::uint64_t index = 0; index < tried; ++index) {
    if (std::optional<Case> drawn = numbered(domain, family, seed, index)) {
      return drawn;
    }
  }
  return std::nullopt;
}

}  // namespace

Case drawn_case_within(const Domain& domain, const Family& family, std::uint64_t seed, std::uint64_t index) {
  if (domain.is_everything()) {
    return drawn_case(family, seed, index);
  }
  for (const Family* tried : {&family, family_named("generic")}) {
    if (std::optional<Case> drawn = numbered(domain, *tried, seed, index)) {
      return *drawn;
    }
  }
  if (std::optional<Case> first = first_case(domain, family, seed)) {
    return *first;
  }
  throw std::invalid_argument(fmt::format("no case of `{}` lies within {}", family.name, to_text(domain)));
}

bool has_cases_within(const Domain& domain, const Family& family, std::uint64_t seed) {
  return first_case(domain, family, seed).has_value();
}

}  // namespace carom::properties
