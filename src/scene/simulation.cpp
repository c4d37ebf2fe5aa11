// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include <carom/scene/grid_around.hpp>
#include <carom/scene/placing.hpp>
#include <carom/scene/quick_look.hpp>
#include <carom/scene/simulation.hpp>

namespace carom::scene {
namespace {

/// Impacts at one time, more than any that ends by itself has been seen to need.
constexpr unsigned long long most_at_one_instant = 100'000;

/// How often it is looked whether to stop, where nothing happens but that spheres leave cells.
constexpr unsigned long long crossings_between_looks = 4096;

/// From the origin. Up to there places are known to a sixteenth of the margin of a cell (cell_grid.hpp).
constexpr double most_cells_away = 0x1p30;

/// An elastic rebound is worth following further down: it keeps its energy.
constexpr double elastic_capture_share = 1e-6;

bool has_friction(Model law) { return law != Model::frictionless && law != Model::reflection; }

std::optional<Level> level_of(const Plane& plane, const Vector3<double>& gravity) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_along_axis = plane.normal[(axis + 1) % 3] == 0 && plane.normal[(axis + 2) % 3] == 0 &&
                               gravity[(axis + 1) % 3] == 0 && gravity[(axis + 2) % 3] == 0;
    if (is_along_axis && plane.normal[axis] * gravity[axis] < 0) {
      return Level{axis, plane.normal[axis] > 0 ? 1.0 : -1.0, std::abs(gravity[axis])};
    }
  }
  return std::nullopt;
}

}  // namespace

std::string_view name_of(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::plane_impact:
      return "plane_impact";
    case EventKind::capture:
      return "capture";
    case EventKind::phase:
      break;
  }
  return "phase";
}

Simulation::Simulation(Scene scene) : scene_(std::move(scene)), spheres_(scene_) {
  const std::size_t count = scene_.spheres.size();
  agenda_.resize(count);
  neighbours_.resize(count);
  for (const Plane& plane : scene_.planes) {
    levels_.push_back(level_of(plane, scene_.gravity));
  }
  for (const Make& make : spheres_.makes()) {
    for (const Plane& plane : scene_.planes) {
      reaches_.push_back({plane.normal, reach_of(plane.normal, plane.point, make.radius)});
    }
  }
  std::vector<Path> paths;
  for (std::size_t i = 0; i < count; ++i) {
    paths.push_back(spheres_.path(i));
  }
  grid_ = grid_around(paths);
  queue_ = EventQueue(count);
  for (Index i = 0; i < count; ++i) {
    grid_.put(i, paths[i].position);
    find_planes_in_reach(i);
  }
  for (Index i = 0; i < count; ++i) {
    if (!is_clear(i)) {
      throw SceneError("sphere " + std::to_string(i) + " (" + scene_.spheres[i].name +
                       ") overlaps another body at the beginning");
    }
  }
  for (Index i = 0; i < count; ++i) {
    plan(i);
  }
}

std::size_t Simulation::bytes_per_sphere() const {
  const std::size_t count = std::max<std::size_t>(size(), 1);
  return spheres_.bytes_per_sphere() + sizeof(Agenda) + (grid_.bytes() + queue_.bytes()) / count;
}

bool Simulation::is_stale(const Agenda& agenda) const {
  return agenda.kind == Kind::sphere && agenda_[agenda.partner].version != agenda.partner_version;
}

void Simulation::keep(Index sphere, const Planned& planned) {
  Agenda& agenda = agenda_[sphere];
  agenda.when = planned.when;
  agenda.kind = planned.kind;
  agenda.partner = planned.partner;
  agenda.partner_version = planned.kind == Kind::sphere ? agenda_[planned.partner].version : 0;
  queue_.set(sphere, planned.when.earliest);
}

const Reach& Simulation::reach(Index sphere, std::size_t plane) const {
  return reaches_[spheres_.make_index(sphere) * scene_.planes.size() + plane];
}

void Simulation::find_planes_in_reach(Index sphere) {
  // While it is in the cell the centre is within a millionth of its width: more is taken.
  const double margin = 0x1p-10 * grid_.width();
  const Vector3<double> centre = grid_.centre_of_cell(sphere);
  const double half = 0.5 * grid_.width() + margin;
  std::uint8_t in_reach = 0;
  for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
    const Reach& its = reach(sphere, plane);
    const double size = its.normal.cwiseAbs().sum();
    if (!(its.normal.dot(centre) - its.reach > half * size)) {
      in_reach |= static_cast<std::uint8_t>(1U << std::min<std::size_t>(plane, 7));
    }
  }
  agenda_[sphere].planes_in_reach = in_reach;
}

template <class Use>
void Simulation::for_planes_in_reach(Index sphere, const Use& use) const {
  const unsigned in_reach = agenda_[sphere].planes_in_reach;
  const auto planes = static_cast<Index>(scene_.planes.size());
  for (Index plane = 0; plane < planes && in_reach >> std::min<Index>(plane, 7) != 0; ++plane) {
    if ((in_reach >> std::min<Index>(plane, 7) & 1U) != 0) {
      use(plane);
    }
  }
}

void Simulation::plan(Index sphere) { static_cast<void>(plan_or_doubt(sphere)); }

void Simulation::place_and_plan(Index sphere) {
  if (plan_or_doubt(sphere)) {
    return;
  }
  if (!is_clear(sphere)) {
    move_clear(sphere);
    plan(sphere);
  }
}

bool Simulation::plan_or_doubt(Index sphere) {
  const Path path = spheres_.path(sphere);
  std::size_t neighbours = 0;
  grid_.for_neighbours(sphere, [&](Index other) {
    spheres_.prefetch(other);
    neighbours_[neighbours++] = other;
  });
  queue_.prefetch(sphere);
  const CellGrid::Leaving leaving = grid_.leaving(sphere, path, now_);
  agenda_[sphere].leaving_axis = static_cast<std::int8_t>(leaving.axis);
  agenda_[sphere].leaving_step = static_cast<std::int8_t>(leaving.step);
  spheres_.set_until(sphere, std::min(path.end, leaving.time));
  const double own_horizon = std::min({path.end, leaving.time, scene_.duration});
  Planned best{{path.end, path.end}, path.end < never ? Kind::phase : Kind::none, 0};
  bool is_clear = true;
  const auto consider = [&](const Planned& planned) {
    if (planned.when.earliest > best.when.latest) {
      return;
    }
    if (planned.when.latest < best.when.earliest) {
      best = planned;
      return;
    }
    // Which of this sphere's own events is first cannot wait: only one of them is kept.
    ++counts_.exact.orders;
    const auto order = exact_time(sphere, planned) <=> exact_time(sphere, best);
    counts_.exact.ties += order == std::strong_ordering::equal ? 1 : 0;
    if (order == std::strong_ordering::less ||
        (order == std::strong_ordering::equal &&
         std::tuple(planned.kind, planned.partner) < std::tuple(best.kind, best.partner))) {
      best = planned;
    }
  };
  const Placed here = placed(path, now_);
  if (!(here.position.cwiseAbs().maxCoeff() < most_cells_away * grid_.width())) {
    throw SceneError("at t = " + std::to_string(now_) + " sphere " + std::to_string(sphere) + " (" +
                     scene_.spheres[sphere].name + ") is so far away that its place is no longer known to a cell");
  }
  const bool flies = spheres_.is_flying(sphere);
  const QuickLook look(here, path.radius, scene_.gravity, spheres_.extent(now_), now_,
                       std::min(own_horizon, best.when.latest));
  std::size_t left = 0;
  for (std::size_t k = 0; k < neighbours; ++k) {
    const Index other = neighbours_[k];
    const bool fly = flies & spheres_.is_flying(other);
    const bool apart = look.stays_apart(spheres_.track(other), spheres_.make(other).radius);
    neighbours_[left] = other;
    left += (fly & apart) ? 0 : 1;
  }
  for (std::size_t k = 0; k < left; ++k) {
    const Index other = neighbours_[k];
    const Path its = spheres_.path(other);
    // What comes later than the first that was found is not asked for.
    const double horizon = std::min({own_horizon, spheres_.track(other).until, best.when.latest});
    const Beside pair(here, placed(its, now_), path.radius + its.radius);
    is_clear = is_clear && pair.squared_gap() > pair.squared_gap_error();
    if (stay_apart(path, its, pair, now_, horizon)) {
      continue;
    }
    const TimeBounds when = contact_between(path, its, pair, now_, horizon, counts_.exact);
    if (when.earliest < never) {
      consider({when, Kind::sphere, other});
    }
  }
  for_planes_in_reach(sphere, [&](Index plane) {
    if (!flies && spheres_.plane(sphere) == plane) {
      return;
    }
    const Reach& its = reach(sphere, plane);
    is_clear = is_clear && (path.start != now_ || !overlap(path, its, now_, counts_.exact.gaps));
    const TimeBounds when = contact_between(path, its, now_, own_horizon, counts_.exact);
    if (when.earliest < never) {
      consider({when, Kind::plane, plane});
    }
  });
  if (leaving.time < best.when.earliest) {
    best = {{leaving.time, leaving.time}, Kind::crossing, 0};
  }
  keep(sphere, best);
  if (best.kind == Kind::sphere && best.when.earliest < agenda_[best.partner].when.earliest) {
    keep(best.partner, {best.when, Kind::sphere, sphere});
  }
  return is_clear;
}

ExactTime Simulation::exact_time(Index sphere, const Planned& planned) const {
  const auto found = [](std::optional<ExactTime> time) {
    if (!time) {
      throw std::logic_error("Simulation: an event within its bounds does not exist");
    }
    return *std::move(time);
  };
  switch (planned.kind) {
    case Kind::sphere:
      return found(exact_contact(spheres_.path(sphere), spheres_.path(planned.partner), now_));
    case Kind::plane:
      return found(exact_contact(spheres_.path(sphere), reach(sphere, planned.partner), now_));
    case Kind::phase:
    case Kind::crossing:
    case Kind::none:
      break;
  }
  return ExactTime::at(planned.when.earliest);
}

bool Simulation::comes_before(Index left, Index right) {
  ++counts_.exact.orders;
  const Planned of_left = agenda_[left].planned();
  const Planned of_right = agenda_[right].planned();
  const auto order = exact_time(left, of_left) <=> exact_time(right, of_right);
  if (order != std::strong_ordering::equal) {
    return order == std::strong_ordering::less;
  }
  ++counts_.exact.ties;
  const auto rank = [](Index sphere, const Planned& planned) {
    const bool is_pair = planned.kind == Kind::sphere;
    return std::tuple(planned.kind, is_pair ? std::min(sphere, planned.partner) : sphere,
                      is_pair ? std::max(sphere, planned.partner) : planned.partner);
  };
  return rank(left, of_left) < rank(right, of_right);
}

void Simulation::leave_cell(Index sphere) {
  const Agenda& agenda = agenda_[sphere];
  now_ = std::max(now_, agenda.when.earliest);
  grid_.move(sphere, {now_, agenda.leaving_axis, agenda.leaving_step});
  find_planes_in_reach(sphere);
  ++counts_.crossings;
  plan(sphere);
}

std::optional<Simulation::Index> Simulation::next_sphere() {
  for (;;) {
    const Index first = queue_.first();
    if (agenda_.empty() || queue_.time_of(first) > scene_.duration || queue_.time_of(first) == never) {
      return std::nullopt;
    }
    const Agenda planned = agenda_[first];
    if (planned.kind == Kind::crossing) {
      leave_cell(first);
      if (counts_.crossings % crossings_between_looks == 0 && stop_.stop_requested()) {
        return std::nullopt;
      }
      continue;
    }
    if (is_stale(planned)) {
      plan(first);
      continue;
    }
    Index chosen = first;
    std::optional<Index> unsettled;
    std::optional<Index> leaves;  // its cell, first of those within the bounds
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
      // Before anything can happen: a fast sphere would be far out of its cell by then.
      leave_cell(*leaves);
    } else {
      return chosen;
    }
  }
}

const Event* Simulation::advance() {
  const std::optional<Index> next = next_sphere();
  if (!next) {
    now_ = stop_.stop_requested() ? now_ : scene_.duration;
    return nullptr;
  }
  const Planned planned = agenda_[*next].planned();
  const double time = std::max(now_, planned.when.earliest);
  at_this_instant_ = time == event_.time && counts_.events > 0 ? at_this_instant_ + 1 : 1;
  now_ = time;
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

void Simulation::count_instant(const char* what, Index sphere) {
  counts_.at_one_instant = std::max(counts_.at_one_instant, at_this_instant_);
  if (at_this_instant_ > most_at_one_instant) {
    throw SceneError("more than " + std::to_string(most_at_one_instant) +
                     " impacts at the instant t = " + std::to_string(now_) + ", the last of sphere " +
                     std::to_string(sphere) + " (" + scene_.spheres[sphere].name + ") with " + what);
  }
}

double Simulation::slow_speed(double radius, double restitution) const {
  const double height = scene_.capture_height * radius * (restitution < 1 ? 1 : elastic_capture_share);
  return std::sqrt(2 * scene_.gravity.norm() * height);
}

StruckSphere Simulation::struck_sphere(Index sphere, const Vector3<double>& position, const Arc& before) const {
  const Make& make = spheres_.make(sphere);
  return {make.mass,
          make.moment,
          before.path.radius,
          position,
          velocity_at(before.path, now_),
          angular_velocity_at(before, now_)};
}

void Simulation::begin_change(Change& change, Index sphere) const {
  change.sphere = sphere;
  change.before = arc(sphere);
}

void Simulation::set_arc(Index sphere, const Arc& arc) {
  spheres_.set_arc(sphere, arc);
  ++agenda_[sphere].version;
}

void Simulation::set_flying(Index sphere, const Arc& arc, const BodyVelocity<double>& velocity) {
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

Arc Simulation::moved_on(Index sphere, const Vector3<double>& away) const {
  Arc moved = arc(sphere);
  moved.path.position = rounded_away(moved.path, now_, away);
  moved.path.start = now_;
  return moved;
}

bool Simulation::is_clear(Index sphere) {
  const Path path = spheres_.path(sphere);
  bool clear = true;
  for_planes_in_reach(
      sphere, [&](Index plane) { clear = clear && !overlap(path, reach(sphere, plane), now_, counts_.exact.gaps); });
  grid_.for_neighbours(
      sphere, [&](Index other) { clear = clear && !overlap(path, spheres_.path(other), now_, counts_.exact.gaps); });
  return clear;
}

void Simulation::move_clear(Index sphere) {
  ++counts_.moved_clear;
  const Vector3<double> position = spheres_.track(sphere).position;
  for (int k = 1; k < moves; ++k) {
    spheres_.set_position(sphere, moved_by_ulps(position, k));
    if (is_clear(sphere)) {
      ++agenda_[sphere].version;  // what was planned from the former place holds no longer
      return;
    }
  }
  throw SceneError("at t = " + std::to_string(now_) + " there is no place within 3 ulps for sphere " +
                   std::to_string(sphere) + " (" + scene_.spheres[sphere].name + ") that overlaps nothing");
}

void Simulation::strike(Index a, Index b) {
  event_.kind = EventKind::impact;
  event_.b.emplace();
  begin_change(event_.a, a);
  begin_change(*event_.b, b);
  const Vector3<double> away = position_at(event_.a.before.path, now_) - position_at(event_.b->before.path, now_);
  const Arc moved_a = moved_on(a, away);
  const Arc moved_b = moved_on(b, -away);
  const StruckSphere struck_a = struck_sphere(a, moved_a.path.position, event_.a.before);
  const StruckSphere struck_b = struck_sphere(b, moved_b.path.position, event_.b->before);
  MaterialPair pair = scene_.pairs.of(spheres_.make(a).material, spheres_.make(b).material);
  const Vector3<double> normal = (struck_a.position - struck_b.position).normalized();
  const double slow = slow_speed(std::min(struck_a.radius, struck_b.radius), pair.restitution);
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

void Simulation::strike_plane(Index sphere, Index plane) {
  event_.kind = EventKind::plane_impact;
  event_.plane = plane;
  begin_change(event_.a, sphere);
  const Vector3<double>& normal = scene_.planes[plane].normal;
  const Arc moved = moved_on(sphere, normal);
  const StruckSphere struck_one = struck_sphere(sphere, moved.path.position, event_.a.before);
  MaterialPair pair = scene_.pairs.of(spheres_.make(sphere).material, scene_.planes[plane].material);
  const double approach = -normal.dot(struck_one.velocity) / normal.norm();
  const double slow = slow_speed(struck_one.radius, pair.restitution);
  const std::optional<Level>& level = levels_[plane];
  const bool stays = level && pair.restitution * approach <= slow;
  event_.was_slow = !level && approach < slow;
  if (stays) {
    pair.restitution = 0;
    event_.kind = EventKind::capture;
  } else if (event_.was_slow) {
    pair.restitution = 1;
  }
  BodyVelocity<double> stored{struck_one.velocity, struck_one.angular_velocity};
  if (approach > 0) {
    event_.collision = collision_with_plane(struck_one, normal, pair);
    event_.outcome = struck(scene_.law, scene_.precision, event_.collision);
    event_.has_impulse = true;
    stored = event_.outcome.a;
  }
  if (event_.was_slow) {
    ++counts_.slow;
    const double missing = std::max(0.0, slow - normal.dot(stored.velocity) / normal.norm());
    stored.velocity += normal * (missing / normal.norm());
  }
  if (stays) {
    ++counts_.captures;
    const MaterialPair& own = scene_.pairs.of(spheres_.make(sphere).material, scene_.planes[plane].material);
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

void Simulation::end_phase(Index sphere) {
  event_.kind = EventKind::phase;
  begin_change(event_.a, sphere);
  const std::uint32_t plane = spheres_.plane(sphere);
  event_.plane = plane;
  const MaterialPair& pair = scene_.pairs.of(spheres_.make(sphere).material, scene_.planes[plane].material);
  const Arc moved = moved_on(sphere, Vector3<double>::Zero());
  set_arc(sphere,
          after_end(*levels_[plane], pair, has_friction(scene_.law), event_.a.before, now_, moved.path.position));
  place_and_plan(sphere);
  event_.a.after = arc(sphere);
  ++counts_.phases;
}

}  // namespace carom::scene
