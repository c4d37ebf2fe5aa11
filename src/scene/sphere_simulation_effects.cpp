// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/scene/least_speed.hpp>
#include <carom/scene/placing.hpp>
#include <carom/scene/sphere_simulation.hpp>

namespace carom::scene {
namespace {

bool has_friction(Law law) { return law != Law::frictionless && law != Law::reflection; }

}  // namespace

StruckSphere SphereSimulation::struck_sphere(Index sphere, const Vector3<double>& position, const Arc& before) const {
  const SphereType& type = spheres_.type(sphere);
  return {type.mass,
          type.moment,
          before.path.radius,
          position,
          velocity_at(before.path, now_),
          angular_velocity_at(before, now_)};
}

void SphereSimulation::begin_change(Change& change, Index sphere) const {
  change.body = sphere;
  change.before = arc(sphere);
}

void SphereSimulation::set_arc(Index sphere, const Arc& arc) {
  spheres_.set_arc(sphere, arc);
  ++agenda_[sphere].version;
}

void SphereSimulation::set_flying(Index sphere, const Arc& arc, const BodyVelocity<double>& velocity) {
  Arc flying;
  flying.path.start = now_;
  flying.path.position = arc.path.position;
  flying.path.velocity = velocity.velocity;
  flying.path.acceleration = scene_.gravity;
  flying.path.radius = arc.path.radius;
  measure(flying.path);
  flying.turning.angular_velocity = velocity.angular_velocity;
  set_arc(sphere, flying);
}

Arc SphereSimulation::moved_on(Index sphere, const Vector3<double>& away) const {
  Arc moved = arc(sphere);
  moved.path.position = rounded_away(moved.path, now_, away);
  moved.path.start = now_;
  return moved;
}

void SphereSimulation::strike(Index a, Index b) {
  event_.kind = EventKind::impact;
  event_.b.emplace();
  begin_change(event_.a, a);
  begin_change(*event_.b, b);
  const Vector3<double> away = position_at(event_.a.before.path, now_) - position_at(event_.b->before.path, now_);
  const Arc moved_a = moved_on(a, away);
  const Arc moved_b = moved_on(b, -away);
  const StruckSphere struck_a = struck_sphere(a, moved_a.path.position, event_.a.before);
  const StruckSphere struck_b = struck_sphere(b, moved_b.path.position, event_.b->before);
  MaterialPair pair = scene_.pairs.of(spheres_.type(a).material, spheres_.type(b).material);
  const Vector3<double> normal = (struck_a.position - struck_b.position).normalized();
  const double slow =
      least_speed(scene_, scene_.gravity.norm(), std::min(struck_a.radius, struck_b.radius), pair.restitution);
  event_.was_slow = -normal.dot(struck_a.velocity - struck_b.velocity) < slow;
  if (event_.was_slow) {
    pair.restitution = 1;
  }
  event_.collision = collision_of(struck_a, struck_b, pair);
  event_.outcome = struck(scene_.law, scene_.precision, event_.collision);
  event_.has_impulse = true;
  Outcome<double> stored = event_.outcome;
  if (event_.was_slow) {
    ++counts_.slow;
    const double missing = std::max(0.0, slow - normal.dot(stored.a.velocity - stored.b.velocity));
    const double impulse = missing / (1 / mass(a) + 1 / mass(b));
    stored.a.velocity += (impulse / mass(a)) * normal;
    stored.b.velocity -= (impulse / mass(b)) * normal;
  }
  keep_apart(struck_a.position, struck_b.position, stored.a.velocity, stored.b.velocity);
  if (!event_.was_slow) {
    event_.outcome = stored;
  }
  set_flying(a, moved_a, stored.a);
  set_flying(b, moved_b, stored.b);
  place_and_plan(a);
  place_and_plan(b);
  event_.a.after = arc(a);
  event_.b->after = arc(b);
  ++counts_.impacts;
}

void SphereSimulation::strike_plane(Index sphere, Index plane) {
  event_.kind = EventKind::plane_impact;
  event_.plane = plane;
  begin_change(event_.a, sphere);
  const Vector3<double>& normal = scene_.planes[plane].normal;
  const Arc moved = moved_on(sphere, normal);
  const StruckSphere struck_one = struck_sphere(sphere, moved.path.position, event_.a.before);
  MaterialPair pair = scene_.pairs.of(spheres_.type(sphere).material, scene_.planes[plane].material);
  const double approach = -normal.dot(struck_one.velocity) / normal.norm();
  const double slow = least_speed(scene_, scene_.gravity.norm(), struck_one.radius, pair.restitution);
  const std::optional<Level>& level = levels_[plane];
  const bool stays = level && pair.restitution * approach <= slow;
  event_.was_slow = !level && approach < slow;
  if (stays) {
    pair.restitution = 0;
    event_.kind = EventKind::capture;
  } else if (event_.was_slow) {
    pair.restitution = 1;
  }
  event_.collision = collision_with_plane(struck_one, normal, pair);
  event_.has_impulse = approach > 0;
  event_.outcome =
      event_.has_impulse ? struck(scene_.law, scene_.precision, event_.collision) : unchanged(event_.collision);
  BodyVelocity<double> stored = event_.outcome.a;
  if (event_.was_slow) {
    ++counts_.slow;
    const double missing = std::max(0.0, slow - normal.dot(stored.velocity) / normal.norm());
    stored.velocity += normal * (missing / normal.norm());
  }
  if (stays) {
    ++counts_.captures;
    const MaterialPair& own = scene_.pairs.of(spheres_.type(sphere).material, scene_.planes[plane].material);
    set_arc(sphere, level_arc(*level, plane, own, has_friction(scene_.law), struck_one.radius, now_,
                              moved.path.position, stored.velocity, stored.angular_velocity));
  } else {
    ++counts_.plane_impacts;
    keep_apart(normal, stored.velocity);
    if (!event_.was_slow) {
      event_.outcome.a = stored;
    }
    set_flying(sphere, moved, stored);
  }
  place_and_plan(sphere);
  event_.a.after = arc(sphere);
}

void SphereSimulation::end_phase(Index sphere) {
  event_.kind = EventKind::phase;
  begin_change(event_.a, sphere);
  const std::uint32_t plane = spheres_.plane(sphere);
  event_.plane = plane;
  const MaterialPair& pair = scene_.pairs.of(spheres_.type(sphere).material, scene_.planes[plane].material);
  const Arc moved = moved_on(sphere, Vector3<double>::Zero());
  set_arc(sphere,
          after_end(*levels_[plane], pair, has_friction(scene_.law), event_.a.before, now_, moved.path.position));
  place_and_plan(sphere);
  event_.a.after = arc(sphere);
  ++counts_.phases;
}

}  // namespace carom::scene
