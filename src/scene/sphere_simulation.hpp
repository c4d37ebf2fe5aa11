// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include <carom/collision/outcome.hpp>
#include <carom/scene/cell_grid.hpp>
#include <carom/scene/event.hpp>
#include <carom/scene/event_queue.hpp>
#include <carom/scene/impact.hpp>
#include <carom/scene/patience.hpp>
#include <carom/scene/prediction.hpp>
#include <carom/scene/scene.hpp>
#include <carom/scene/sphere_store.hpp>
#include <carom/scene/supported_motion.hpp>

namespace carom::scene {

/// Runs a scene that has only spheres, one event at a time. If the bounds of prediction.hpp do not decide the order of
/// events, exact algebra does. Of events at one instant, impacts of spheres come first, then impacts on planes, then
/// ends of phases, each kind in the order of sphere indices. An event takes place at a double that is not after its
/// exact time, so spheres on their paths never overlap. Stored positions are rounded so that spheres do not overlap
/// (placing.hpp).
///
/// Each sphere stores only its own next event. A due event is checked before it takes place, because its partner may
/// have a new path. An outdated event is never later than the sphere's true next event (B. Lubachevsky 1991).
class SphereSimulation {
 public:
  /// Precondition: the scene is valid (valid_scene.hpp). Throws SceneError if bodies overlap.
  explicit SphereSimulation(Scene scene);

  /// The next event; null after the scene's duration. The pointer is valid until the next call. Throws SceneError if
  /// the run cannot go on: a sphere would have to rest on another body, impacts at one instant do not end, or no
  /// position within 3 ulps is free of overlap. It also throws if a sphere is too far from the origin for the grid, or
  /// if nothing advances for ten seconds. After an error, the last event remains in effect.
  [[nodiscard]] const Event* advance();

  /// Makes `advance` end early and return null once a stop is requested.
  void stop_on(std::stop_token stop) { patience_.stop_on(std::move(stop)); }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] double time() const { return now_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] std::size_t size() const { return spheres_.size(); }
  [[nodiscard]] Arc arc(std::size_t sphere) const { return spheres_.arc(sphere); }
  [[nodiscard]] double mass(std::size_t sphere) const { return spheres_.type(sphere).mass; }
  [[nodiscard]] double moment(std::size_t sphere) const { return spheres_.type(sphere).moment; }
  [[nodiscard]] std::size_t bytes_per_sphere() const;
  [[nodiscard]] SceneState state() const;

 private:
  using Index = std::uint32_t;
  enum class Kind : std::uint8_t { none, sphere, plane, phase, crossing };
  struct Planned {
    TimeBounds when;
    Kind kind = Kind::none;
    Index partner = 0;
  };
  struct alignas(32) Agenda {
    TimeBounds when;  // of the next event
    Index partner = 0;
    Index partner_version = 0;
    Index version = 0;  // of the sphere's path
    Kind kind = Kind::none;
    std::int8_t leaving_axis = 0, leaving_step = 0;
    std::uint8_t planes_in_reach = 0;  // bit k: plane k is in reach from within the cell; bit 7: any plane from 7 on

    [[nodiscard]] Planned planned() const { return {when, kind, partner}; }
  };
  static_assert(sizeof(Agenda) == 32);

  /// Finds and stores the next event of the sphere. False if the sphere may overlap another body.
  [[nodiscard]] bool plan_or_doubt(Index sphere);
  /// As plan_or_doubt, for a sphere that is known to overlap nothing.
  void plan(Index sphere);
  /// As plan, for a sphere with a new stored state. If the sphere overlaps a body, moves it clear first.
  void place_and_plan(Index sphere);
  void keep(Index sphere, const Planned& planned);
  /// Replaces `best` with `planned` if `planned` comes first. Precondition: both are events of the sphere.
  void keep_first(Index sphere, const Planned& planned, Planned& best);
  /// Moves the neighbours that may touch the sphere to the front of the first `count` of neighbours_. Returns their
  /// number.
  [[nodiscard]] std::size_t leave_out_apart(const QuickLook& look, bool flies, std::size_t count);
  [[nodiscard]] bool is_stale(const Agenda& agenda) const;
  [[nodiscard]] ExactTime exact_time(Index sphere, const Planned& planned) const;
  [[nodiscard]] bool comes_before(Index left, Index right);
  void leave_cell(Index sphere);
  /// Makes the cells wider, because spheres cross many cells and nothing happens.
  void widen_cells();
  void find_planes_in_reach(Index sphere);
  /// Calls use(k) for each plane k that the sphere can touch before it leaves its cell.
  template <class Use>
  void for_planes_in_reach(Index sphere, const Use& use) const;
  [[nodiscard]] const Reach& reach(Index sphere, std::size_t plane) const;
  [[nodiscard]] std::optional<Index> next_sphere();

  void strike(Index a, Index b);
  void strike_plane(Index sphere, Index plane);
  void end_phase(Index sphere);
  void count_instant(const char* what, Index sphere);

  [[nodiscard]] Arc moved_on(Index sphere, const Vector3<double>& away) const;
  void set_flying(Index sphere, const Arc& arc, const BodyVelocity<double>& velocity);
  void set_arc(Index sphere, const Arc& arc);
  [[nodiscard]] bool is_clear(Index sphere);
  void move_clear(Index sphere);
  [[nodiscard]] StruckSphere struck_sphere(Index sphere, const Vector3<double>& position, const Arc& before) const;
  void begin_change(Change& change, Index sphere) const;

  Scene scene_;
  Patience patience_;
  double now_ = 0;
  SphereStore spheres_;
  std::vector<Agenda> agenda_;
  std::vector<Reach> reaches_;                    // entry i · planes + k: sphere type i and plane k
  std::vector<Index> neighbours_;                 // of the sphere that is being planned
  std::vector<std::optional<Support>> supports_;  // one for each plane
  CellGrid grid_;
  EventQueue queue_;
  Event event_;
  Counts counts_;
  unsigned long long at_this_instant_ = 0;
  std::size_t crossings_without_event_ = 0;
  SlowContacts slow_contacts_;
};

}  // namespace carom::scene
