// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <carom/scene/polyhedra/distance.hpp>
#include <carom/scene/polyhedra/tumbling_body.hpp>
#include <carom/scene/scene.hpp>
#include <carom/scene/scene_state.hpp>
#include <carom/scene/simulation.hpp>

namespace carom::scene {

/// Runs a scene that has polyhedra, one event at a time. All bodies fly, spheres too: nothing slides, rolls or rests.
/// What approaches slower than least_speed.hpp says is met elastically and sent off at that speed, so what would lie
/// still hops, no higher than that.
///
/// A contact is where two bodies are within `contact_tolerance` and do not draw apart, found by conservative
/// advancement (time_of_contact.hpp): up to it, and at it, they are certain not to touch. Where a body has turned by
/// `longest_turn` it is stored as it is then, and goes on from there. Of events at one time renewals are first and
/// planes last, and of one kind that with the lower bodies. The impulse acts at the middle of what touches where all of
/// that approaches, else where it approaches fastest; what else of it approaches is an impact of its own, at the same
/// time.
class Tumbling {
 public:
  /// Precondition: the scene is valid (valid_polyhedra.hpp). Throws SceneError where bodies are not certain to be
  /// apart.
  explicit Tumbling(Scene scene);

  /// The next event, an impact or a renewal; nothing after the scene's duration. The reference holds until the next
  /// call. Throws SceneError where impacts at one instant do not end, or where bodies are no longer certain to be
  /// apart, or places no longer known to the tolerance; the last event stands.
  [[nodiscard]] const Event* advance();

  /// From now on `advance` ends early, with nothing, once a stop is requested.
  void stop_on(std::stop_token stop) { stop_ = std::move(stop); }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] double time() const { return now_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] SceneState state() const;

 private:
  /// What is known of two bodies, or of one and a plane.
  struct Outlook {
    double time = never;   // [s]
    bool touches = false;  // then; else they are apart until then, and have to be looked at again
  };
  /// What a time is of. At one time the first of these kinds comes first.
  enum class Kind : std::uint8_t { renewal, bodies, plane };
  struct Where {
    Kind kind = Kind::bodies;
    std::size_t first = 0, second = 0;  // the second a body or a plane
  };

  void look_around(std::size_t body);
  [[nodiscard]] Outlook outlook(std::size_t a, std::size_t b);
  [[nodiscard]] Outlook outlook_of_plane(std::size_t body, std::size_t plane);
  template <class TimeOfContactFrom>
  [[nodiscard]] Outlook outlook_from(double begin, double known_until, const Where& where,
                                     const TimeOfContactFrom& time_of_contact_from);
  [[nodiscard]] Outlook& outlook_of(std::size_t a, std::size_t b);
  [[nodiscard]] std::pair<Where, Outlook> next() const;
  void look_again(const Where& where);

  void renew(std::size_t body);
  void strike(const Where& where);
  [[nodiscard]] Body struck_body(std::size_t body, const Vector3<double>& point) const;
  [[nodiscard]] Collision collision_at(const Where& where, const Vector3<double>& normal,
                                       const Vector3<double>& point) const;
  [[nodiscard]] Collision fastest_approach(const Where& where) const;
  [[nodiscard]] double least_speed_of(const Where& where, double restitution) const;
  /// Whether the law's impulse is along the normal, exactly: then so is a ball's lever arm, and only rounding turns it.
  [[nodiscard]] bool is_along_normal(const Where& where) const;
  void keep_spins_of_balls(const Where& where, const Collision& before, Outcome<double>& outcome) const;
  void begin_change(Change& change, std::size_t body) const;
  /// Stores where the body is now, with these velocities; what that changes is looked for in the next step.
  void end_change(Change& change, const BodyVelocity<double>& velocity);
  [[nodiscard]] double tolerance_of(const Where& where) const;
  [[nodiscard]] std::string description_of(const Where& where) const;

  Scene scene_;
  std::stop_token stop_;
  double now_ = 0;
  std::vector<TumblingBody> bodies_;
  std::vector<std::size_t> changed_;             // bodies that are to be looked around anew
  std::vector<std::optional<ShapePair>> pairs_;  // of bodies i > k at i (i − 1)/2 + k; where they have come near
  std::vector<Outlook> outlooks_;                // the same
  std::vector<HalfSpace> grounds_;               // of each plane
  std::vector<Reach> reaches_;                   // of body i and plane k at i · planes + k
  std::vector<Outlook> of_planes_;               // the same
  Event event_;
  Counts counts_;
  unsigned long long at_this_instant_ = 0;
};

}  // namespace carom::scene
