// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>
#include <tuple>

#include <carom/scene/placing.hpp>
#include <carom/scene/sphere_simulation.hpp>

namespace carom::scene {
namespace {

/// Up to this distance from the origin, in cells, the error of a position is below 2⁻²⁰ cells. This error is a
/// sixteenth of the margin in the width of a cell (cell_grid.hpp).
constexpr double most_cells_away = 0x1p30;

}  // namespace

void SphereSimulation::keep(Index sphere, const Planned& planned) {
  Agenda& agenda = agenda_[sphere];
  agenda.when = planned.when;
  agenda.kind = planned.kind;
  agenda.partner = planned.partner;
  agenda.partner_version = planned.kind == Kind::sphere ? agenda_[planned.partner].version : 0;
  queue_.set(sphere, planned.when.earliest);
}

const Reach& SphereSimulation::reach(Index sphere, std::size_t plane) const {
  return reaches_[spheres_.type_index(sphere) * scene_.planes.size() + plane];
}

void SphereSimulation::find_planes_in_reach(Index sphere) {
  // A sphere's centre may be outside its cell by 10⁻⁶ of the width. This margin is larger.
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
void SphereSimulation::for_planes_in_reach(Index sphere, const Use& use) const {
  const unsigned in_reach = agenda_[sphere].planes_in_reach;
  const auto planes = static_cast<Index>(scene_.planes.size());
  for (Index plane = 0; plane < planes && in_reach >> std::min<Index>(plane, 7) != 0; ++plane) {
    if ((in_reach >> std::min<Index>(plane, 7) & 1U) != 0) {
      use(plane);
    }
  }
}

void SphereSimulation::plan(Index sphere) { static_cast<void>(plan_or_doubt(sphere)); }

void SphereSimulation::place_and_plan(Index sphere) {
  if (plan_or_doubt(sphere)) {
    return;
  }
  if (!is_clear(sphere)) {
    move_clear(sphere);
    plan(sphere);
  }
}

void SphereSimulation::keep_first(Index sphere, const Planned& planned, Planned& best) {
  if (planned.when.earliest > best.when.latest) {
    return;
  }
  if (planned.when.latest < best.when.earliest) {
    best = planned;
    return;
  }
  // The order is needed now, because a sphere keeps only one event.
  ++counts_.exact.orders;
  const auto order = exact_time(sphere, planned) <=> exact_time(sphere, best);
  counts_.exact.ties += order == std::strong_ordering::equal ? 1 : 0;
  if (order == std::strong_ordering::less ||
      (order == std::strong_ordering::equal &&
       std::tuple(planned.kind, planned.partner) < std::tuple(best.kind, best.partner))) {
    best = planned;
  }
}

std::size_t SphereSimulation::leave_out_apart(const QuickLook& look, bool flies, std::size_t count) {
  std::size_t left = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Index other = neighbours_[k];
    const bool fly = flies & spheres_.is_flying(other);
    const bool apart = look.stays_apart(spheres_.track(other), spheres_.type(other).radius);
    neighbours_[left] = other;
    left += (fly & apart) ? 0 : 1;
  }
  return left;
}

bool SphereSimulation::plan_or_doubt(Index sphere) {
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
  const PathState here = state_at(path, now_);
  if (!(here.position.cwiseAbs().maxCoeff() < most_cells_away * grid_.width()) || !here.velocity.allFinite()) {
    throw SceneError("at t = " + std::to_string(now_) + " sphere " + std::to_string(sphere) + " (" +
                     scene_.spheres[sphere].name +
                     ") is too far from the origin for the grid; end the run earlier, or use a shorter duration");
  }
  const bool flies = spheres_.is_flying(sphere);
  const QuickLook look(here, path.radius, scene_.gravity, spheres_.extent(now_), now_,
                       std::min(own_horizon, best.when.latest));
  const std::size_t left = leave_out_apart(look, flies, neighbours);
  for (std::size_t k = 0; k < left; ++k) {
    const Index other = neighbours_[k];
    const Path its = spheres_.path(other);
    const double horizon = std::min({own_horizon, spheres_.track(other).until, best.when.latest});
    const RelativeState pair(here, state_at(its, now_), path.radius + its.radius);
    is_clear = is_clear && pair.squared_gap() > pair.squared_gap_error();
    if (stay_apart(path, its, pair, now_, horizon)) {
      continue;
    }
    const TimeBounds when = contact_between(path, its, pair, now_, horizon, counts_.exact);
    if (when.earliest < never) {
      keep_first(sphere, {when, Kind::sphere, other}, best);
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
      keep_first(sphere, {when, Kind::plane, plane}, best);
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

ExactTime SphereSimulation::exact_time(Index sphere, const Planned& planned) const {
  const auto found = [](std::optional<ExactTime> time) {
    if (!time) {
      throw std::logic_error("SphereSimulation: a predicted event does not exist");
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

bool SphereSimulation::comes_before(Index left, Index right) {
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

bool SphereSimulation::is_clear(Index sphere) {
  const Path path = spheres_.path(sphere);
  bool clear = true;
  for_planes_in_reach(
      sphere, [&](Index plane) { clear = clear && !overlap(path, reach(sphere, plane), now_, counts_.exact.gaps); });
  grid_.for_neighbours(
      sphere, [&](Index other) { clear = clear && !overlap(path, spheres_.path(other), now_, counts_.exact.gaps); });
  return clear;
}

void SphereSimulation::move_clear(Index sphere) {
  ++counts_.moved_clear;
  const Vector3<double> position = spheres_.track(sphere).position;
  for (int k = 1; k < moves; ++k) {
    spheres_.set_position(sphere, moved_by_ulps(position, k));
    if (is_clear(sphere)) {
      ++agenda_[sphere].version;  // invalidates plans made from the old position
      return;
    }
  }
  throw SceneError("at t = " + std::to_string(now_) + " no position within 3 ulps is free of overlaps for sphere " +
                   std::to_string(sphere) + " (" + scene_.spheres[sphere].name + ")");
}

}  // namespace carom::scene
