// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <variant>

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/scene/impact.hpp>
#include <carom/scene/polyhedra/contact_patch.hpp>
#include <carom/scene/polyhedra/polyhedron_simulation.hpp>
#include <carom/scene/polyhedra/time_of_contact.hpp>
#include <carom/scene/scene.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::scene {
namespace {

/// The limit of impacts at one instant. Every observed sequence that ends by itself needs fewer.
constexpr unsigned long long most_at_one_instant = 10'000;

/// The `flatness` of a contact patch (contact_patch.hpp), in contact tolerances. With this value, the patch includes
/// corners struck earlier at the same instant.
constexpr double flatness_in_tolerances = 4;

/// The least speed after an impact, relative to the sum of the greatest speeds of the bodies. Rounding cannot reverse
/// this speed, because the speed of a gap is accurate to 2⁻⁴⁷ of the bodies' speeds.
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

/// A time up to which the bounding sphere of a body certainly overlaps neither another bounding sphere nor a plane.
/// `gap` is positive while the two are apart.
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

PolyhedronSimulation::PolyhedronSimulation(Scene scene) : scene_(std::move(scene)) {
  CAROM_EXPECTS(has_valid_fields(scene_));
  const std::size_t count = body_count(scene_);
  for (const Plane& plane : scene_.planes) {
    const double length = plane.normal.norm();
    grounds_.push_back({plane.normal / length, plane.normal.dot(plane.point) / length});
  }
  bodies_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const RigidBody body = body_of(scene_, i);
    bodies_.emplace_back(body, is_sphere(scene_, i));
    bodies_[i].set_motion(now_, body.position, body.orientation, {body.velocity, body.angular_velocity},
                          scene_.gravity);
    for (const Plane& plane : scene_.planes) {
      reaches_.push_back({plane.normal, reach_of(plane.normal, plane.point, bodies_[i].path().radius)});
    }
  }
  slow_contacts_ = SlowContacts(count);
  pairs_.resize(count * (count - 1) / 2);
  predictions_.resize(pairs_.size());
  plane_predictions_.resize(reaches_.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      prediction_of(k, i) = predict(k, i);
    }
    for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
      plane_predictions_[i * scene_.planes.size() + plane] = predict_plane(i, plane);
    }
  }
}

SceneState PolyhedronSimulation::state() const {
  SceneState state{&scene_, now_, {}};
  for (std::size_t i = 0; i < size(); ++i) {
    TumblingBody moving = bodies_[i];
    moving.know_beyond(now_);
    BodyState body;
    body.mass = moving.body().mass;
    body.principal_inertia = moving.body().principal_inertia;
    body.arc = moving.arc();
    body.orientation_at_start = moving.orientation_at_start();
    body.orientation = moving.placement_at(now_).orientation;
    body.angular_velocity = moving.angular_velocity_at(now_);
    state.bodies.push_back(body);
  }
  return state;
}

double PolyhedronSimulation::tolerance_of(const Where& where) const {
  const double radius = bodies_[where.first].body().radius();
  return contact_tolerance *
         (where.kind == Kind::plane ? radius : std::min(radius, bodies_[where.second].body().radius()));
}

std::string PolyhedronSimulation::description_of(const Where& where) const {
  return carom::scene::description_of(scene_, where.first) + " and " +
         (where.kind == Kind::plane
              ? "plane " + std::to_string(where.second) + " (" + scene_.planes[where.second].name + ")"
              : carom::scene::description_of(scene_, where.second));
}

PolyhedronSimulation::Prediction& PolyhedronSimulation::prediction_of(std::size_t a, std::size_t b) {
  const auto [low, high] = std::minmax(a, b);
  return predictions_[high * (high - 1) / 2 + low];
}

template <class TimeOfContactFrom>
PolyhedronSimulation::Prediction PolyhedronSimulation::predict_from(double begin, double known_until,
                                                                    const Where& where,
                                                                    const TimeOfContactFrom& time_of_contact_from) {
  const double horizon = std::min(scene_.duration, known_until);
  if (begin >= horizon) {
    return {horizon < scene_.duration ? begin : never, false};
  }
  const TimeOfContact found = time_of_contact_from(horizon);
  counts_.advances += static_cast<unsigned long long>(found.advances);
  switch (found.status) {
    case ContactStatus::touches:
      return {found.time, true};
    case ContactStatus::misses:
      return {horizon < scene_.duration ? horizon : never, false};
    case ContactStatus::overlaps:
      throw SceneError(text_of("at t = ", begin, " ", description_of(where), " may overlap: ", found.separation.gap,
                               " m is the computed gap, with a rounding error of up to ",
                               found.separation.gap - found.separation.certified, " m"));
    case ContactStatus::undecided:
      break;
  }
  if (found.time > begin || patience_.stop().stop_requested()) {
    return {found.time, false};
  }
  const double gap = found.separation.gap;
  const double unknown = gap - found.separation.certified;
  if (gap > tolerance_of(where)) {
    const std::string who = text_of("at t = ", begin, " ", description_of(where), " are ", gap, " m apart, ");
    throw SceneError(unknown > tolerance_of(where) / 2
                         ? text_of(who, "with a rounding error of up to ", unknown, " m, which is too large")
                         : text_of(who, "and they approach by more than this within one ulp of the time"));
  }
  // A gap that is too small to be resolved counts as a contact.
  return {found.time, true};
}

PolyhedronSimulation::Prediction PolyhedronSimulation::predict(std::size_t a, std::size_t b) {
  const Path& of_a = bodies_[a].path();
  const Path& of_b = bodies_[b].path();
  const RelativeState balls(state_at(of_a, now_), state_at(of_b, now_), of_a.radius + of_b.radius);
  const UncertainQuadratic gap = squared_gap(balls);
  // Bounding spheres that overlap may recede while the bodies in them meet.
  if (gap.c0 > gap.e0 && stay_apart(of_a, of_b, balls, now_, scene_.duration)) {
    return {};
  }
  const double begin = balls_touch_from(gap, now_);
  if (begin == never) {
    return {};
  }
  bodies_[a].know_beyond(begin);
  bodies_[b].know_beyond(begin);
  std::optional<ShapePair>& pair = pairs_[b * (b - 1) / 2 + a];
  if (!pair) {
    pair.emplace(bodies_[a].body().shape, bodies_[b].body().shape);
  }
  const Where where{Kind::bodies, a, b};
  return predict_from(begin, std::min(bodies_[a].known_until(), bodies_[b].known_until()), where, [&](double horizon) {
    return time_of_contact(*pair, bodies_[a].motion(), bodies_[b].motion(), begin, horizon, tolerance_of(where),
                           patience_.stop());
  });
}

PolyhedronSimulation::Prediction PolyhedronSimulation::predict_plane(std::size_t body, std::size_t plane) {
  const Path& path = bodies_[body].path();
  const Reach& reach = reaches_[body * scene_.planes.size() + plane];
  const double begin = balls_touch_from(height_over(path, reach, now_), now_);
  if (begin == never) {
    return {};
  }
  bodies_[body].know_beyond(begin);
  const Where where{Kind::plane, body, plane};
  return predict_from(begin, bodies_[body].known_until(), where, [&](double horizon) {
    return time_of_contact(bodies_[body].body().shape, bodies_[body].motion(), grounds_[plane], begin, horizon,
                           tolerance_of(where), patience_.stop());
  });
}

void PolyhedronSimulation::look_around(std::size_t body) {
  for (std::size_t other = 0; other < size(); ++other) {
    if (other != body) {
      prediction_of(body, other) = predict(std::min(body, other), std::max(body, other));
    }
  }
  for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
    plane_predictions_[body * scene_.planes.size() + plane] = predict_plane(body, plane);
  }
}

std::pair<PolyhedronSimulation::Where, PolyhedronSimulation::Prediction> PolyhedronSimulation::next() const {
  std::pair<Where, Prediction> first;
  const auto rank = [](const Where& where) { return std::tuple(where.kind, where.first, where.second); };
  const auto consider = [&](const Where& where, const Prediction& prediction) {
    const double least = first.second.time;
    if (prediction.time < least || (prediction.time == least && least < never && rank(where) < rank(first.first))) {
      first = {where, prediction};
    }
  };
  for (std::size_t i = 0; i < size(); ++i) {
    consider({Kind::renewal, i, 0}, {bodies_[i].renewal(), true});
    for (std::size_t k = 0; k < i; ++k) {
      consider({Kind::bodies, k, i}, predictions_[i * (i - 1) / 2 + k]);
    }
    for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
      consider({Kind::plane, i, plane}, plane_predictions_[i * scene_.planes.size() + plane]);
    }
  }
  return first;
}

void PolyhedronSimulation::look_again(const Where& where) {
  if (where.kind == Kind::plane) {
    plane_predictions_[where.first * scene_.planes.size() + where.second] = predict_plane(where.first, where.second);
  } else {
    prediction_of(where.first, where.second) = predict(where.first, where.second);
  }
}

const Event* PolyhedronSimulation::advance() {
  slow_contacts_.require_no_rest(scene_, event_);
  // This search is not part of the previous event. So the previous event remains in effect even if the search fails.
  for (const std::size_t body : changed_) {
    look_around(body);
  }
  changed_.clear();
  for (;;) {
    const auto [where, prediction] = next();
    if (patience_.is_over(now_)) {
      return nullptr;
    }
    if (prediction.time > scene_.duration) {
      now_ = scene_.duration;
      return nullptr;
    }
    now_ = prediction.time;
    if (!prediction.touches) {
      look_again(where);
      continue;
    }
    if (where.kind == Kind::renewal) {
      renew(where.first);
      return &event_;
    }
    at_this_instant_ = counts_.events > 0 && event_.time == now_ ? at_this_instant_ + 1 : 1;
    counts_.at_one_instant = std::max(counts_.at_one_instant, at_this_instant_);
    if (at_this_instant_ > most_at_one_instant) {
      throw SceneError(text_of("more than ", most_at_one_instant, " impacts at the instant t = ", now_,
                               "; the last is of ", description_of(where)));
    }
    strike(where);
    return &event_;
  }
}

void PolyhedronSimulation::renew(std::size_t body) {
  event_ = {};
  event_.time = now_;
  event_.kind = EventKind::renewal;
  bodies_[body].know_beyond(now_);
  begin_change(event_.a, body);
  end_change(event_.a, {bodies_[body].velocity_at(now_), event_.a.angular_velocity_before});
  ++counts_.events;
  ++counts_.renewals;
}

Body PolyhedronSimulation::struck_body(std::size_t index, const Vector3<double>& point) const {
  const TumblingBody& moving = bodies_[index];
  const Placement placement = moving.placement_at(now_);
  Body body;
  body.mass = moving.body().mass;
  body.principal_inertia = moving.body().principal_inertia;
  body.orientation = placement.orientation;
  body.position = placement.position - point;
  body.velocity = moving.velocity_at(now_);
  body.angular_velocity = moving.angular_velocity_at(now_);
  return body;
}

Collision PolyhedronSimulation::collision_at(const Where& where, const Vector3<double>& normal,
                                             const Vector3<double>& point) const {
  const TumblingBody& a = bodies_[where.first];
  Collision collision;
  collision.a = struck_body(where.first, point);
  collision.normal = normal;
  if (is_sphere(scene_, where.first)) {
    collision.a.position = normal * (a.body().shape.margin / normal.norm());
    collision.normal = collision.a.position;
  }
  MaterialPair pair;
  if (where.kind == Kind::plane) {
    collision.b.immovable = true;
    pair = scene_.pairs.of(material_of(scene_, where.first), scene_.planes[where.second].material);
  } else {
    const TumblingBody& b = bodies_[where.second];
    collision.b = struck_body(where.second, point);
    if (is_sphere(scene_, where.second)) {
      collision.b.position = collision.normal * (-b.body().shape.margin / collision.normal.norm());
      collision.normal = is_sphere(scene_, where.first) ? collision.normal : -collision.b.position;
    }
    pair = scene_.pairs.of(material_of(scene_, where.first), material_of(scene_, where.second));
  }
  collision.restitution = pair.restitution;
  collision.friction = pair.friction;
  collision.tangential_restitution = pair.tangential_restitution;
  return collision;
}

Collision PolyhedronSimulation::fastest_approach(const Where& where) const {
  const TumblingBody& a = bodies_[where.first];
  const double flatness = flatness_in_tolerances * tolerance_of(where);
  const Placement at_a = a.placement_at(now_);
  ContactPatch patch;
  Vector3<double> normal;
  if (where.kind == Kind::plane) {
    patch = contact_patch(a.body().shape, at_a, grounds_[where.second], flatness);
    normal = scene_.planes[where.second].normal;
  } else {
    const ShapePair& pair = *pairs_[where.second * (where.second - 1) / 2 + where.first];
    const Placement at_b = bodies_[where.second].placement_at(now_);
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

PolyhedronSimulation::LeastSpeed PolyhedronSimulation::least_speed_of(const Where& where, double restitution) const {
  double radius = bodies_[where.first].body().radius();
  double acceleration = scene_.gravity.norm();
  double speeds = 0;
  const auto consider = [&](std::size_t index) {
    const TumblingBody& moving = bodies_[index];
    const double own_radius = moving.body().radius();
    const double rate = moving.motion().rotation.greatest_rate();
    radius = std::min(radius, own_radius);
    acceleration += rate * rate * own_radius;
    speeds += moving.velocity_at(now_).norm() + rate * own_radius;
  };
  consider(where.first);
  if (where.kind == Kind::bodies) {
    consider(where.second);
  }
  // A hop that stays within the tolerance would at once be a contact again.
  const double out_of_touch = std::sqrt(2 * acceleration * flatness_in_tolerances * tolerance_of(where));
  const double floor = std::max(out_of_touch, least_speed_share * speeds);
  const double slow = std::max(least_speed(scene_, acceleration, radius, restitution), floor);
  return {slow, std::max(least_speed(scene_, acceleration, radius, 1), floor), 2 * slow / scene_.gravity.norm()};
}

void PolyhedronSimulation::begin_change(Change& change, std::size_t body) const {
  const TumblingBody& moving = bodies_[body];
  change.body = static_cast<std::uint32_t>(body);
  change.before = moving.arc();
  change.orientation = moving.placement_at(now_).orientation;
  change.angular_velocity_before = moving.angular_velocity_at(now_);
}

void PolyhedronSimulation::end_change(Change& change, const BodyVelocity<double>& velocity) {
  TumblingBody& moving = bodies_[change.body];
  moving.set_motion(now_, moving.placement_at(now_).position, change.orientation, velocity, scene_.gravity);
  change.after = moving.arc();
  changed_.push_back(change.body);
}

bool PolyhedronSimulation::is_along_normal(const Where& where) const {
  return scene_.law == Law::frictionless || (scene_.law == Law::reflection && is_sphere(scene_, where.first) &&
                                             (where.kind == Kind::plane || is_sphere(scene_, where.second)));
}

void PolyhedronSimulation::keep_spins_of_balls(const Where& where, const Collision& before,
                                               Outcome<double>& outcome) const {
  if (is_sphere(scene_, where.first)) {
    outcome.a.angular_velocity = before.a.angular_velocity;
  }
  if (where.kind == Kind::bodies && is_sphere(scene_, where.second)) {
    outcome.b.angular_velocity = before.b.angular_velocity;
  }
}

void PolyhedronSimulation::strike(const Where& where) {
  event_.time = now_;
  event_.kind = where.kind == Kind::plane ? EventKind::plane_impact : EventKind::impact;
  event_.plane = where.kind == Kind::plane ? static_cast<std::uint32_t>(where.second) : 0;
  event_.b.reset();
  begin_change(event_.a, where.first);
  if (where.kind == Kind::bodies) {
    begin_change(event_.b.emplace(), where.second);
  }
  Collision& collision = event_.collision;
  collision = fastest_approach(where);
  const double parting = parting_speed(collision);
  const LeastSpeed least = least_speed_of(where, collision.restitution);
  event_.was_slow = -parting < least.slow;
  slow_contacts_.record(event_, event_.was_slow, least.hop);
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
    const Collision after = with_velocities(collision, event_.outcome);
    stored = parting_speed(after) < least.parting ? sent_apart(after, least.parting) : event_.outcome;
    keep_spins_of_balls(where, after, stored);
  }
  end_change(event_.a, stored.a);
  if (event_.b) {
    end_change(*event_.b, stored.b);
  }
  ++counts_.events;
  ++(where.kind == Kind::plane ? counts_.plane_impacts : counts_.impacts);
}

}  // namespace carom::scene
