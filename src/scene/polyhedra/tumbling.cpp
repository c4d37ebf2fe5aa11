// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <variant>

#include <Eigen/Geometry>

#include <carom/scene/least_speed.hpp>
#include <carom/scene/polyhedra/contact_impulse.hpp>
#include <carom/scene/polyhedra/contact_patch.hpp>
#include <carom/scene/polyhedra/time_of_contact.hpp>
#include <carom/scene/polyhedra/tumbling.hpp>

namespace carom::scene {
namespace {

/// Impacts at one time, more than any that ends by itself has been seen to need.
constexpr unsigned long long most_at_one_instant = 10'000;

/// How far a body is followed at first, and then twice as far each time [rad].
constexpr double first_turn = 4;

/// What a path of a free rotation can hold [rad] (free_rotation.hpp).
constexpr double most_turn = 1e5;

/// What touches is all that is as near as this many tolerances: those of a contact, and of an edge or a face that was
/// struck at this time before, and hangs back by less than it would have moved.
constexpr double flatness_in_tolerances = 4;

/// Beside the speeds that meet, a least one that rounding does not turn round: a gap's speed is known to 2⁻⁴⁷ of them
/// (time_of_contact.cpp). For where gravity gives none.
constexpr double least_speed_share = 0x1p-40;

RigidBody body_of(const Scene& scene, std::size_t index) {
  if (is_sphere(scene, index)) {
    return rigid_body(scene.spheres[index]);
  }
  auto body = rigid_body(polyhedron_of(scene, index));
  if (const auto* defect = std::get_if<ShapeDefect>(&body)) {
    throw SceneError(description_of(scene, index) + ": " + defect->text);
  }
  return std::get<RigidBody>(std::move(body));
}

/// A time up to which the balls about two bodies are certain not to overlap, of the gap between them.
double balls_touch_from(const UncertainQuadratic& gap, double now) {
  if (!(gap.c0 > gap.e0)) {
    return now;
  }
  const Crossing crossing = first_crossing(gap);
  switch (crossing.decision) {
    case Decision::none:
      return never;
    case Decision::bounded:
      return bounds_from(now, crossing).earliest;
    case Decision::undecided:
      break;
  }
  return now;
}

}  // namespace

Tumbling::Tumbling(Scene scene) : scene_(std::move(scene)) {
  const std::size_t count = body_count(scene_);
  for (const Plane& plane : scene_.planes) {
    const double length = plane.normal.norm();
    grounds_.push_back({plane.normal / length, plane.normal.dot(plane.point) / length});
  }
  bodies_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    RigidBody body = body_of(scene_, i);
    const Vector3<double> position = body.position;
    const Quaternion<double> orientation = body.orientation;
    const BodyVelocity<double> velocity{body.velocity, body.angular_velocity};
    bodies_.push_back({std::move(body), {{}, {}, {}, RotationPath(orientation)}, {}, {}, 0, {}});
    set_motion(i, position, orientation, velocity);
    for (const Plane& plane : scene_.planes) {
      reaches_.push_back({plane.normal, reach_of(plane.normal, plane.point, bodies_[i].path.radius)});
    }
  }
  pairs_.resize(count * (count - 1) / 2);
  outlooks_.resize(pairs_.size());
  of_planes_.resize(reaches_.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      outlook_of(k, i) = outlook(k, i);
    }
    for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
      of_planes_[i * scene_.planes.size() + plane] = outlook_of_plane(i, plane);
    }
  }
}

Arc Tumbling::arc(std::size_t body) const {
  Arc arc;
  arc.path = bodies_[body].path;
  arc.path.radius = bodies_[body].body.radius();
  arc.turning.angular_velocity = bodies_[body].angular_velocity;
  return arc;
}

SceneState Tumbling::state() const {
  SceneState state{&scene_, now_, {}, std::vector<std::optional<Level>>(scene_.planes.size())};
  for (std::size_t i = 0; i < size(); ++i) {
    const Moving& moving = bodies_[i];
    BodyState body;
    body.mass = moving.body.mass;
    body.principal_inertia = moving.body.principal_inertia;
    body.arc = arc(i);
    body.orientation_at_start = moving.orientation;
    Motion motion = moving.motion;
    if (moving.known_until < now_) {
      motion.rotation = RotationPath(moving.body.principal_inertia,
                                     rotation_state(moving.orientation, moving.angular_velocity), now_ - motion.start);
    }
    const RotationState now = rotation_at(motion, now_).state;
    body.orientation = now.orientation;
    body.angular_velocity = angular_velocity_of(i, now);
    state.bodies.push_back(body);
  }
  return state;
}

Vector3<double> Tumbling::angular_velocity_of(std::size_t body, const RotationState& now) const {
  const Moving& moving = bodies_[body];
  return is_sphere(scene_, body) || now_ == moving.motion.start ? moving.angular_velocity : world_rate(now);
}

void Tumbling::set_motion(std::size_t index, const Vector3<double>& position, const Quaternion<double>& orientation,
                          const BodyVelocity<double>& velocity) {
  Moving& moving = bodies_[index];
  moving.angular_velocity = velocity.angular_velocity;
  moving.orientation = orientation;
  moving.motion = {position, velocity.velocity, scene_.gravity, RotationPath(orientation), now_};
  moving.known_until = velocity.angular_velocity.isZero(0) ? never : now_;
  Path path;
  path.start = now_;
  path.position = position;
  path.velocity = velocity.velocity;
  path.acceleration = scene_.gravity;
  // Wider by what a contact is found at, and by far more than rounding moves the ball.
  path.radius = moving.body.radius() * (1 + 2 * contact_tolerance);
  measure(path);
  moving.path = path;
}

void Tumbling::know_until(std::size_t index, double time) {
  Moving& moving = bodies_[index];
  while (moving.known_until <= time && moving.known_until < scene_.duration) {
    const double rest = scene_.duration - moving.motion.start;
    const double rate = moving.angular_velocity.norm();
    const double known = moving.known_until - moving.motion.start;
    double span = known > 0 ? 2 * known : first_turn / rate;
    if (!(span < rest)) {
      span = rest;
    }
    if (rate * span > most_turn) {
      throw SceneError(
          "at t = " + std::to_string(time) + " " + description_of(scene_, index) +
          " has turned by more than 100,000 rad since its last impact: its rotation is not followed further");
    }
    moving.motion.rotation =
        RotationPath(moving.body.principal_inertia, rotation_state(moving.orientation, moving.angular_velocity), span);
    moving.known_until = span == rest ? never : moving.motion.start + span;
  }
}

double Tumbling::tolerance_of(const Where& where) const {
  const double radius = bodies_[where.first].body.radius();
  return contact_tolerance * (where.is_plane ? radius : std::min(radius, bodies_[where.second].body.radius()));
}

std::string Tumbling::text_of(const Where& where) const {
  return description_of(scene_, where.first) + " and " +
         (where.is_plane ? "plane " + std::to_string(where.second) + " (" + scene_.planes[where.second].name + ")"
                         : description_of(scene_, where.second));
}

Tumbling::Outlook& Tumbling::outlook_of(std::size_t a, std::size_t b) {
  const auto [low, high] = std::minmax(a, b);
  return outlooks_[high * (high - 1) / 2 + low];
}

template <class TimeOfContactFrom>
Tumbling::Outlook Tumbling::outlook_from(double begin, double known_until, const Where& where,
                                         const TimeOfContactFrom& time_of_contact_from) {
  const double horizon = std::min(scene_.duration, known_until);
  if (begin >= horizon) {
    return {horizon < scene_.duration ? begin : never, false};
  }
  const TimeOfContact found = time_of_contact_from(horizon);
  counts_.advances += static_cast<unsigned long long>(found.advances);
  switch (found.approach) {
    case Approach::touches:
      return {found.time, true};
    case Approach::misses:
      return {horizon < scene_.duration ? horizon : never, false};
    case Approach::overlaps:
      throw SceneError("at t = " + std::to_string(begin) + " " + text_of(where) + " are not certain to be apart: " +
                       std::to_string(found.separation.gap) + " m is what lies between them, but for rounding");
    case Approach::undecided:
      break;
  }
  // Apart until then. Nearer than can be told, or where it takes too long, they count as touching.
  return {found.time, found.time == begin};
}

Tumbling::Outlook Tumbling::outlook(std::size_t a, std::size_t b) {
  const Path& of_a = bodies_[a].path;
  const Path& of_b = bodies_[b].path;
  const Beside balls(placed(of_a, now_), placed(of_b, now_), of_a.radius + of_b.radius);
  const UncertainQuadratic gap = squared_gap(balls);
  // Balls that overlap may well recede, and the bodies in them meet.
  if (gap.c0 > gap.e0 && stay_apart(of_a, of_b, balls, now_, scene_.duration)) {
    return {};
  }
  const double begin = balls_touch_from(gap, now_);
  if (begin == never) {
    return {};
  }
  know_until(a, begin);
  know_until(b, begin);
  std::optional<ShapePair>& pair = pairs_[b * (b - 1) / 2 + a];
  if (!pair) {
    pair.emplace(bodies_[a].body.shape, bodies_[b].body.shape);
  }
  const Where where{a, b, false};
  return outlook_from(begin, std::min(bodies_[a].known_until, bodies_[b].known_until), where, [&](double horizon) {
    return time_of_contact(*pair, bodies_[a].motion, bodies_[b].motion, begin, horizon, tolerance_of(where));
  });
}

Tumbling::Outlook Tumbling::outlook_of_plane(std::size_t body, std::size_t plane) {
  const Path& path = bodies_[body].path;
  const Reach& reach = reaches_[body * scene_.planes.size() + plane];
  const double begin = balls_touch_from(height_over(path, reach, now_), now_);
  if (begin == never) {
    return {};
  }
  know_until(body, begin);
  const Where where{body, plane, true};
  return outlook_from(begin, bodies_[body].known_until, where, [&](double horizon) {
    return time_of_contact(bodies_[body].body.shape, bodies_[body].motion, grounds_[plane], begin, horizon,
                           tolerance_of(where));
  });
}

void Tumbling::look_around(std::size_t body) {
  for (std::size_t other = 0; other < size(); ++other) {
    if (other != body) {
      outlook_of(body, other) = outlook(std::min(body, other), std::max(body, other));
    }
  }
  for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
    of_planes_[body * scene_.planes.size() + plane] = outlook_of_plane(body, plane);
  }
}

std::pair<Tumbling::Where, Tumbling::Outlook> Tumbling::next() const {
  std::pair<Where, Outlook> first;
  const auto rank = [](const Where& where) { return std::tuple(where.is_plane, where.first, where.second); };
  const auto consider = [&](const Where& where, const Outlook& outlook) {
    const double least = first.second.time;
    if (outlook.time < least || (outlook.time == least && least < never && rank(where) < rank(first.first))) {
      first = {where, outlook};
    }
  };
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      consider({k, i, false}, outlooks_[i * (i - 1) / 2 + k]);
    }
    for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
      consider({i, plane, true}, of_planes_[i * scene_.planes.size() + plane]);
    }
  }
  return first;
}

void Tumbling::look_again(const Where& where) {
  if (where.is_plane) {
    of_planes_[where.first * scene_.planes.size() + where.second] = outlook_of_plane(where.first, where.second);
  } else {
    outlook_of(where.first, where.second) = outlook(where.first, where.second);
  }
}

const Event* Tumbling::advance() {
  for (;;) {
    const auto [where, outlook] = next();
    if (stop_.stop_requested()) {
      return nullptr;
    }
    if (outlook.time > scene_.duration) {
      now_ = scene_.duration;
      return nullptr;
    }
    const bool is_later = outlook.time > now_;
    now_ = outlook.time;
    if (!outlook.touches) {
      look_again(where);
      continue;
    }
    at_this_instant_ = is_later ? 1 : at_this_instant_ + 1;
    counts_.at_one_instant = std::max(counts_.at_one_instant, at_this_instant_);
    if (at_this_instant_ > most_at_one_instant) {
      throw SceneError("more than " + std::to_string(most_at_one_instant) +
                       " impacts at the instant t = " + std::to_string(now_) + ", the last of " + text_of(where));
    }
    strike(where);
    return &event_;
  }
}

Body Tumbling::struck_body(std::size_t index, const Placement& placement, const Vector3<double>& point) const {
  const Moving& moving = bodies_[index];
  Body body;
  body.mass = moving.body.mass;
  body.principal_inertia = moving.body.principal_inertia;
  body.orientation = placement.orientation;
  body.position = placement.position - point;
  body.velocity = velocity_at(moving.path, now_);
  body.angular_velocity = angular_velocity_of(index, rotation_at(moving.motion, now_).state);
  return body;
}

Collision Tumbling::collision_at(const Where& where, const Vector3<double>& normal,
                                 const Vector3<double>& point) const {
  const Moving& a = bodies_[where.first];
  Collision collision;
  collision.a = struck_body(where.first, placement_at(a.motion, now_), point);
  collision.normal = normal;
  // The lever arm of a ball lies along the normal, exactly.
  if (is_sphere(scene_, where.first)) {
    collision.a.position = normal * (a.body.shape.margin / normal.norm());
    collision.normal = collision.a.position;
  }
  MaterialPair pair;
  if (where.is_plane) {
    collision.b.immovable = true;
    pair = scene_.pairs.of(material_of(scene_, where.first), scene_.planes[where.second].material);
  } else {
    const Moving& b = bodies_[where.second];
    collision.b = struck_body(where.second, placement_at(b.motion, now_), point);
    if (is_sphere(scene_, where.second)) {
      collision.b.position = collision.normal * (-b.body.shape.margin / collision.normal.norm());
      collision.normal = is_sphere(scene_, where.first) ? collision.normal : -collision.b.position;
    }
    pair = scene_.pairs.of(material_of(scene_, where.first), material_of(scene_, where.second));
  }
  collision.restitution = pair.restitution;
  collision.friction = pair.friction;
  collision.tangential_restitution = pair.tangential_restitution;
  return collision;
}

Collision Tumbling::fastest_approach(const Where& where) const {
  const Moving& a = bodies_[where.first];
  const double flatness = flatness_in_tolerances * tolerance_of(where);
  const Placement at_a = placement_at(a.motion, now_);
  ContactPatch patch;
  Vector3<double> normal;
  if (where.is_plane) {
    patch = contact_patch(a.body.shape, at_a, grounds_[where.second], flatness);
    normal = scene_.planes[where.second].normal;
  } else {
    const ShapePair& pair = *pairs_[where.second * (where.second - 1) / 2 + where.first];
    const Placement at_b = placement_at(bodies_[where.second].motion, now_);
    const Separation separation = pair.separation(at_a, at_b);
    patch = contact_patch(pair, at_a, at_b, separation, flatness);
    normal = separation.normal;
  }
  Collision fastest;
  double least = never;
  bool do_all_approach = true;
  for (const Vector3<double>& vertex : patch.vertices) {
    const Collision collision = collision_at(where, normal, vertex);
    const double speed = parting_speed(collision);
    do_all_approach = do_all_approach && speed < 0;
    if (speed < least) {
      least = speed;
      fastest = collision;
    }
  }
  return do_all_approach ? collision_at(where, normal, patch.point) : fastest;
}

double Tumbling::least_speed_of(const Where& where, double restitution) const {
  double radius = bodies_[where.first].body.radius();
  double acceleration = scene_.gravity.norm();
  double speeds = 0;
  const auto consider = [&](std::size_t index) {
    const Moving& moving = bodies_[index];
    const double own_radius = moving.body.radius();
    const double rate = moving.motion.rotation.greatest_rate();
    radius = std::min(radius, own_radius);
    acceleration += rate * rate * own_radius;
    speeds += velocity_at(moving.path, now_).norm() + rate * own_radius;
  };
  consider(where.first);
  if (!where.is_plane) {
    consider(where.second);
  }
  return std::max(least_speed(scene_, acceleration, radius, restitution), least_speed_share * speeds);
}

void Tumbling::begin_change(Change& change, std::size_t body) const {
  const Moving& moving = bodies_[body];
  change.body = static_cast<std::uint32_t>(body);
  change.before = arc(body);
  const RotationState turned = rotation_at(moving.motion, now_).state;
  change.orientation = turned.orientation;
  change.angular_velocity_before = angular_velocity_of(body, turned);
}

bool Tumbling::is_along_normal(const Where& where) const {
  return scene_.law == Model::frictionless || (scene_.law == Model::reflection && is_sphere(scene_, where.first) &&
                                               (where.is_plane || is_sphere(scene_, where.second)));
}

void Tumbling::keep_spins_of_balls(const Where& where, const Collision& before, Outcome<double>& outcome) const {
  if (is_sphere(scene_, where.first)) {
    outcome.a.angular_velocity = before.a.angular_velocity;
  }
  if (!where.is_plane && is_sphere(scene_, where.second)) {
    outcome.b.angular_velocity = before.b.angular_velocity;
  }
}

void Tumbling::strike(const Where& where) {
  event_.time = now_;
  event_.kind = where.is_plane ? EventKind::plane_impact : EventKind::impact;
  event_.plane = where.is_plane ? static_cast<std::uint32_t>(where.second) : 0;
  event_.b.reset();
  begin_change(event_.a, where.first);
  if (!where.is_plane) {
    begin_change(event_.b.emplace(), where.second);
  }
  Collision& collision = event_.collision;
  collision = fastest_approach(where);
  const double parting = parting_speed(collision);
  const double least = least_speed_of(where, collision.restitution);
  event_.was_slow = -parting < least;
  if (event_.was_slow) {
    collision.restitution = 1;
  }
  event_.has_impulse = parting < 0;
  event_.outcome = event_.has_impulse ? struck_bodies(scene_.law, scene_.precision, collision) : unchanged(collision);
  if (is_along_normal(where)) {
    keep_spins_of_balls(where, collision, event_.outcome);
  }
  Outcome<double> stored = event_.outcome;
  if (event_.was_slow) {
    ++counts_.slow;
    stored = sent_apart(with_velocities(collision, event_.outcome), least);
    keep_spins_of_balls(where, with_velocities(collision, event_.outcome), stored);
  }
  const auto set = [&](Change& change, const BodyVelocity<double>& velocity) {
    const Placement placement = placement_at(bodies_[change.body].motion, now_);
    set_motion(change.body, placement.position, placement.orientation, velocity);
    change.after = arc(change.body);
  };
  set(event_.a, stored.a);
  if (event_.b) {
    set(*event_.b, stored.b);
  }
  look_around(where.first);
  if (event_.b) {
    look_around(where.second);
  }
  ++counts_.events;
  ++(where.is_plane ? counts_.plane_impacts : counts_.impacts);
}

}  // namespace carom::scene
