// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <carom/collision/expects.hpp>
#include <carom/scene/placing.hpp>
#include <carom/scene/sphere_simulation.hpp>
#include <carom/scene/valid_scene.hpp>

namespace carom::scene {
namespace {

/// The limit of impacts at one instant. Observed sequences that end by themselves need fewer.
constexpr unsigned long long most_at_one_instant = 100'000;

/// Cells become wider after this number of crossings of each sphere without an event.
constexpr std::size_t crossings_for_wider_cells = 64;

}  // namespace

SphereSimulation::SphereSimulation(Scene scene) : scene_(std::move(scene)), spheres_(scene_) {
  CAROM_EXPECTS(has_valid_fields(scene_));
  if (!scene_.polyhedra.empty()) {
    throw std::logic_error("SphereSimulation: this class does not support polyhedra; use PolyhedronSimulation");
  }
  const std::size_t count = scene_.spheres.size();
  agenda_.resize(count);
  neighbours_.resize(count);
  for (const Plane& plane : scene_.planes) {
    supports_.push_back(support_of(plane.normal, scene_.gravity));
  }
  for (const SphereType& type : spheres_.types()) {
    for (const Plane& plane : scene_.planes) {
      reaches_.push_back({plane.normal, reach_of(plane.normal, plane.point, type.radius)});
    }
  }
  std::vector<Path> paths;
  for (std::size_t i = 0; i < count; ++i) {
    paths.push_back(spheres_.path(i));
  }
  grid_ = grid_around(paths);
  queue_ = EventQueue(count);
  slow_contacts_ = SlowContacts(count);
  for (Index i = 0; i < count; ++i) {
    grid_.put(i, paths[i].position);
    find_planes_in_reach(i);
  }
  for (Index i = 0; i < count; ++i) {
    if (!is_clear(i)) {
      throw SceneError("sphere " + std::to_string(i) + " (" + scene_.spheres[i].name +
                       ") overlaps another body at t = 0; move one of them");
    }
  }
  for (Index i = 0; i < count; ++i) {
    plan(i);
  }
}

std::size_t SphereSimulation::bytes_per_sphere() const {
  const std::size_t count = std::max<std::size_t>(size(), 1);
  return spheres_.bytes_per_sphere() + sizeof(Agenda) + (grid_.bytes() + queue_.bytes()) / count;
}

SceneState SphereSimulation::state() const {
  SceneState state{&scene_, now_, {}};
  state.bodies.reserve(size());
  for (std::size_t sphere = 0; sphere < size(); ++sphere) {
    BodyState body;
    body.mass = mass(sphere);
    body.principal_inertia = Vector3<double>::Constant(moment(sphere));
    body.arc = arc(sphere);
    body.angular_velocity = angular_velocity_at(body.arc, now_);
    state.bodies.push_back(body);
  }
  return state;
}

bool SphereSimulation::is_stale(const Agenda& agenda) const {
  return agenda.kind == Kind::sphere && agenda_[agenda.partner].version != agenda.partner_version;
}

void SphereSimulation::leave_cell(Index sphere) {
  const Agenda& agenda = agenda_[sphere];
  now_ = std::max(now_, agenda.when.earliest);
  grid_.move(sphere, {now_, agenda.leaving_axis, agenda.leaving_step});
  find_planes_in_reach(sphere);
  ++counts_.crossings;
  plan(sphere);
  if (++crossings_without_event_ > crossings_for_wider_cells * (size() + 16)) {
    widen_cells();
  }
}

void SphereSimulation::widen_cells() {
  crossings_without_event_ = 0;
  std::vector<Path> paths;
  for (std::size_t i = 0; i < size(); ++i) {
    paths.push_back(spheres_.path(i));
    paths[i].position = position_at(paths[i], now_);
  }
  grid_ = grid_around(paths, 4 * grid_.width());
  for (Index i = 0; i < size(); ++i) {
    grid_.put(i, paths[i].position);
    find_planes_in_reach(i);
  }
  for (Index i = 0; i < size(); ++i) {
    plan(i);
  }
}

std::optional<SphereSimulation::Index> SphereSimulation::next_sphere() {
  while (!patience_.is_over(now_)) {
    const Index first = queue_.first();
    if (agenda_.empty() || queue_.time_of(first) > scene_.duration || queue_.time_of(first) == never) {
      return std::nullopt;
    }
    const Agenda planned = agenda_[first];
    if (planned.kind == Kind::crossing) {
      leave_cell(first);
      continue;
    }
    if (is_stale(planned)) {
      plan(first);
      continue;
    }
    Index chosen = first;
    std::optional<Index> unsettled;
    std::optional<Index> leaves;  // the first sphere to leave its cell before `planned.when.latest`
    queue_.for_each_until(planned.when.latest, [&](Index other) {
      const Agenda& its = agenda_[other];
      if (other == first || unsettled) {
        return;
      }
      if (its.kind == Kind::crossing) {
        if (!leaves || its.when.earliest < agenda_[*leaves].when.earliest) {
          leaves = other;
        }
        return;
      }
      if (is_stale(its)) {
        unsettled = other;
        return;
      }
      const Agenda& best = agenda_[chosen];
      const bool is_same =
          its.kind == Kind::sphere && best.kind == Kind::sphere && its.partner == chosen && best.partner == other;
      if (!is_same && comes_before(other, chosen)) {
        chosen = other;
      }
    });
    if (unsettled) {
      plan(*unsettled);
    } else if (leaves && agenda_[*leaves].when.earliest < agenda_[chosen].when.earliest) {
      // The sphere leaves its cell first, because a fast sphere would be far outside the cell at the event of `chosen`.
      leave_cell(*leaves);
    } else {
      return chosen;
    }
  }
  return std::nullopt;
}

const Event* SphereSimulation::advance() {
  slow_contacts_.require_no_rest(scene_, event_);
  const std::optional<Index> next = next_sphere();
  if (!next) {
    now_ = patience_.stop().stop_requested() ? now_ : scene_.duration;
    return nullptr;
  }
  const Planned planned = agenda_[*next].planned();
  const double time = std::max(now_, planned.when.earliest);
  at_this_instant_ = time == event_.time && counts_.events > 0 ? at_this_instant_ + 1 : 1;
  now_ = time;
  crossings_without_event_ = 0;
  event_.time = time;
  event_.has_impulse = false;
  event_.was_slow = false;
  event_.b.reset();
  ++counts_.events;
  switch (planned.kind) {
    case Kind::sphere:
      count_instant("spheres", *next);
      strike(std::min(*next, planned.partner), std::max(*next, planned.partner));
      break;
    case Kind::plane:
      count_instant("a plane", *next);
      strike_plane(*next, planned.partner);
      break;
    case Kind::phase:
    case Kind::crossing:
    case Kind::none:
      end_phase(*next);
      break;
  }
  return &event_;
}

void SphereSimulation::count_instant(const char* what, Index sphere) {
  counts_.at_one_instant = std::max(counts_.at_one_instant, at_this_instant_);
  if (at_this_instant_ > most_at_one_instant) {
    throw SceneError("more than " + std::to_string(most_at_one_instant) +
                     " impacts at the instant t = " + std::to_string(now_) + "; the last is of sphere " +
                     std::to_string(sphere) + " (" + scene_.spheres[sphere].name + ") with " + what);
  }
}

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
  const double radius = std::min(struck_a.radius, struck_b.radius);
  const double slow = least_speed(scene_, scene_.gravity.norm(), radius, pair.restitution);
  event_.was_slow = -normal.dot(struck_a.velocity - struck_b.velocity) < slow;
  slow_contacts_.record(event_, event_.was_slow, 2 * slow / scene_.gravity.norm());
  if (event_.was_slow) {
    pair.restitution = 1;
  }
  event_.collision = collision_of(struck_a, struck_b, pair);
  event_.outcome = struck(scene_.law, scene_.precision, event_.collision);
  event_.has_impulse = true;
  Outcome<double> stored = event_.outcome;
  if (event_.was_slow) {
    ++counts_.slow;
    const double least = least_speed(scene_, scene_.gravity.norm(), radius, 1);
    const double missing = std::max(0.0, least - normal.dot(stored.a.velocity - stored.b.velocity));
    const double impulse = missing / (1 / mass(a) + 1 / mass(b));
    stored.a.velocity += (impulse / mass(a)) * normal;
    stored.b.velocity -= (impulse / mass(b)) * normal;
  }
  // A change of the lighter sphere changes the energy less.
  if (mass(a) <= mass(b)) {
    keep_apart(struck_a.position, struck_b.position, stored.a.velocity, stored.b.velocity);
  } else {
    keep_apart(struck_b.position, struck_a.position, stored.b.velocity, stored.a.velocity);
  }
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
  const std::optional<Support>& support = supports_[plane];
  const double pressing = support ? support->pressing : scene_.gravity.norm();
  const double slow = least_speed(scene_, pressing, struck_one.radius, pair.restitution);
  const bool stays = support && pair.restitution * approach <= slow;
  event_.was_slow = !support && approach < slow;
  if (stays) {
    pair.restitution = 0;
    event_.kind = EventKind::capture;
  } else if (event_.was_slow) {
    pair.restitution = 1;
  }
  slow_contacts_.record(event_, stays || event_.was_slow, 2 * slow / pressing);
  event_.collision = collision_with_plane(struck_one, normal, pair);
  event_.has_impulse = approach > 0;
  event_.outcome =
      event_.has_impulse ? struck(scene_.law, scene_.precision, event_.collision) : unchanged(event_.collision);
  BodyVelocity<double> stored = event_.outcome.a;
  if (event_.was_slow) {
    ++counts_.slow;
    const double least = least_speed(scene_, pressing, struck_one.radius, 1);
    const double missing = std::max(0.0, least - normal.dot(stored.velocity) / normal.norm());
    stored.velocity += normal * (missing / normal.norm());
  }
  if (stays) {
    ++counts_.captures;
    const MaterialPair& own = scene_.pairs.of(spheres_.type(sphere).material, scene_.planes[plane].material);
    set_arc(sphere, supported_arc(*support, plane, own, has_friction(scene_.law), struck_one.radius, now_,
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
  const Arc moved = moved_on(sphere, scene_.planes[plane].normal);
  set_arc(sphere,
          after_end(*supports_[plane], pair, has_friction(scene_.law), event_.a.before, now_, moved.path.position));
  place_and_plan(sphere);
  event_.a.after = arc(sphere);
  ++counts_.phases;
}

}  // namespace carom::scene
