// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <carom/collision/outcome.hpp>
#include <carom/scene/cell_grid.hpp>
#include <carom/scene/event_queue.hpp>
#include <carom/scene/impact.hpp>
#include <carom/scene/level_motion.hpp>
#include <carom/scene/prediction.hpp>
#include <carom/scene/scene.hpp>
#include <carom/scene/scene_state.hpp>
#include <carom/scene/sphere_store.hpp>

namespace carom::scene {

class QuickLook;

/// An error that ends a run early. For example, bodies overlap at the beginning, impacts at one instant do not end, or
/// a position is no longer accurate enough.
class SceneError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class EventKind : std::uint8_t {
  impact,        // of two bodies
  plane_impact,  // of a body and a plane
  capture,       // a sphere stays on a level plane
  phase,         // slipping, rolling or spinning has ended
  renewal,       // a polyhedron has turned so far that its state is stored again; its motion continues
};

[[nodiscard]] std::string_view name_of(EventKind kind);

/// The motion of a body before and after an event.
struct Change {
  std::uint32_t body = 0;  // spheres first, then polyhedra, each in the scene's order
  Arc before, after;
  /// If the scene has polyhedra: body axes to world axes at the event, and the angular velocity before it [rad/s].
  Quaternion<double> orientation{1, 0, 0, 0};
  Vector3<double> angular_velocity_before{0, 0, 0};
};

struct Event {
  double time = 0;  // [s]
  EventKind kind = EventKind::impact;
  Change a;
  std::optional<Change> b;   // only for an impact of two bodies
  std::uint32_t plane = 0;   // only for plane impacts, captures and phases
  bool has_impulse = false;  // of impacts and captures: whether the bodies approached
  Collision collision;       // of impacts and captures; its origin is the contact point
  Outcome<double> outcome;   // as the law gave it; `after` has the stored velocities
  /// The approach was slower than the least speed, and the body cannot rest. The impact is elastic by the law, and the
  /// body is then sent off at `least_speed`.
  bool was_slow = false;
};

/// Numbers that are counted during a run.
struct Counts {
  unsigned long long events = 0;
  unsigned long long impacts = 0;  // of two bodies
  unsigned long long plane_impacts = 0;
  unsigned long long captures = 0;
  unsigned long long phases = 0;
  unsigned long long renewals = 0;
  unsigned long long crossings = 0;       // of cells; these are not events of the scene
  unsigned long long slow = 0;            // impacts that were sent off at the least speed
  unsigned long long moved_clear = 0;     // stored positions that were moved by ulps because of a third body
  unsigned long long at_one_instant = 0;  // largest number of impacts at one time
  unsigned long long advances = 0;        // of conservative advancement
  ExactCounts exact;
};

/// Runs a scene that has only spheres, one event at a time, in certified order. If the bounds of prediction.hpp do not
/// decide, an exact method does. Of two events at one instant, the event with the lower sphere indices is first. An
/// event takes place at a double that is not after its exact time. The difference is within the width of the bounds. So
/// no bodies ever overlap, and stored positions are rounded so that none do (placing.hpp).
///
/// Each sphere keeps only its own next event, which is checked again when it is due. An event may no longer hold
/// because its partner has been struck. Such an event is too early and never too late (B. Lubachevsky 1991).
class Simulation {
 public:
  /// Precondition: the scene is valid (valid_scene.hpp). Throws SceneError if bodies overlap.
  explicit Simulation(Scene scene);

  /// The next event; null after the scene's duration. The pointer is valid until the next call. Throws SceneError if
  /// impacts at one instant do not end, or if a sphere is too far away for its cell to be known. Also throws it if no
  /// position within 3 ulps is free of overlap.
  [[nodiscard]] const Event* advance();

  /// Makes `advance` end early and return null once a stop is requested.
  void stop_on(std::stop_token stop) { stop_ = std::move(stop); }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] double time() const { return now_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] std::size_t size() const { return spheres_.size(); }
  [[nodiscard]] Arc arc(std::size_t sphere) const { return spheres_.arc(sphere); }
  [[nodiscard]] double mass(std::size_t sphere) const { return spheres_.make(sphere).mass; }
  [[nodiscard]] double moment(std::size_t sphere) const { return spheres_.make(sphere).moment; }
  /// How spheres rest on a plane; nothing if they cannot.
  [[nodiscard]] const std::optional<Level>& level(std::size_t plane) const { return levels_[plane]; }
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
  /// The loop's data of a sphere: half a cache line.
  struct alignas(32) Agenda {
    TimeBounds when;  // of the next event
    Index partner = 0;
    Index partner_version = 0;
    Index version = 0;  // of the sphere's path
    Kind kind = Kind::none;
    std::int8_t leaving_axis = 0, leaving_step = 0;
    std::uint8_t planes_in_reach =
        0;  // planes that can be touched from within the cell: bit k is plane k, bit 7 is any plane from 7 on

    [[nodiscard]] Planned planned() const { return {when, kind, partner}; }
  };
  static_assert(sizeof(Agenda) == 32);

  /// Finds and stores the next event of the sphere. False if the sphere may overlap another body.
  [[nodiscard]] bool plan_or_doubt(Index sphere);
  /// Finds and stores the next event of a sphere that is known to overlap nothing.
  void plan(Index sphere);
  /// Finds and stores the next event of a sphere with a new stored state. If it overlaps a body, it is first moved
  /// clear.
  void place_and_plan(Index sphere);
  void keep(Index sphere, const Planned& planned);
  /// Replaces `best` with the event if the event comes first. Precondition: both are events of the sphere.
  void keep_first(Index sphere, const Planned& planned, Planned& best);
  /// Moves those of the first `count` of neighbours_ that may come near to the front, in their order. Returns their
  /// number.
  [[nodiscard]] std::size_t leave_out_apart(const QuickLook& look, bool flies, std::size_t count);
  [[nodiscard]] bool is_stale(const Agenda& agenda) const;
  [[nodiscard]] ExactTime exact_time(Index sphere, const Planned& planned) const;
  [[nodiscard]] bool comes_before(Index left, Index right);
  void leave_cell(Index sphere);
  /// Finds the planes that the sphere can touch before it leaves its cell.
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
  std::stop_token stop_;
  double now_ = 0;
  SphereStore spheres_;
  std::vector<Agenda> agenda_;
  std::vector<Reach> reaches_;     // of make i and plane k at i · planes + k
  std::vector<Index> neighbours_;  // of the sphere that is being planned
  std::vector<std::optional<Level>> levels_;
  CellGrid grid_;
  EventQueue queue_;
  Event event_;
  Counts counts_;
  unsigned long long at_this_instant_ = 0;
};

}  // namespace carom::scene
