// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <carom/scene/event.hpp>
#include <carom/scene/patience.hpp>
#include <carom/scene/polyhedra/distance.hpp>
#include <carom/scene/polyhedra/free_flight.hpp>
#include <carom/scene/prediction.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// Runs a scene that has polyhedra, one event at a time. All bodies fly, including spheres: nothing slides, rolls or
/// rests. If an approach is slower than the least speed (scene.hpp), the impact is elastic. A body that would lie at
/// rest hops, until SceneError ends the run.
///
/// A contact is the first instant at which two bodies are within `contact_tolerance` of each other and do not draw
/// apart. Even then, the bodies certainly do not touch (time_of_contact.hpp). If the bodies approach at all corners of
/// the contact patch (contact_patch.hpp), the impulse acts at the centroid of the patch. If not, it acts at the corner
/// of the fastest approach. Other corners with an approach have their own impacts at the same time. When a body has
/// turned by `longest_turn`, a renewal stores its state. Of events at one time, renewals come first and impacts on
/// planes last; within one kind, lower body indices come first.
class PolyhedronSimulation {
 public:
  /// Precondition: the scene is valid (valid_polyhedra.hpp). Throws SceneError if bodies are not certain to be apart.
  explicit PolyhedronSimulation(Scene scene);

  /// The next event, an impact or a renewal; null after the scene's duration. The pointer is valid until the next call.
  /// Throws SceneError if the run cannot go on: bodies would have to rest on each other, impacts at one instant do not
  /// end, or bodies are not certain to be apart. It also throws if positions are not accurate to the tolerance, or if
  /// nothing advances for ten seconds. After an error, the last event remains in effect.
  [[nodiscard]] const Event* advance();

  /// Makes `advance` end early and return null once a stop is requested.
  void stop_on(std::stop_token stop) { patience_.stop_on(std::move(stop)); }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] double time() const { return now_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] SceneState state() const;

 private:
  /// The known future of two bodies, or of a body and a plane.
  struct Prediction {
    double time = never;   // [s]
    bool touches = false;  // if false, they stay apart up to `time`; the search continues from there
  };
  /// The kinds of events, in the order in which they happen at one time.
  enum class Kind : std::uint8_t { renewal, bodies, plane };
  struct Where {
    Kind kind = Kind::bodies;
    std::size_t first = 0, second = 0;  // `second` is a body or a plane
  };

  void look_around(std::size_t body);
  [[nodiscard]] Prediction predict(std::size_t a, std::size_t b);
  [[nodiscard]] Prediction predict_plane(std::size_t body, std::size_t plane);
  template <class TimeOfContactFrom>
  [[nodiscard]] Prediction predict_from(double begin, double known_until, const Where& where,
                                        const TimeOfContactFrom& time_of_contact_from);
  [[nodiscard]] Prediction& prediction_of(std::size_t a, std::size_t b);
  [[nodiscard]] std::pair<Where, Prediction> next() const;
  void look_again(const Where& where);

  void renew(std::size_t body);
  void strike(const Where& where);
  [[nodiscard]] Body struck_body(std::size_t body, const Vector3<double>& point) const;
  [[nodiscard]] Collision collision_at(const Where& where, const Vector3<double>& normal,
                                       const Vector3<double>& point) const;
  [[nodiscard]] Collision fastest_approach(const Where& where) const;
  struct LeastSpeed {
    double slow;     // a slower approach is elastic [m/s]
    double parting;  // of the bodies after a slow approach, at least [m/s]
    double hop;      // the time of a hop that begins with the speed `slow` [s]
  };
  [[nodiscard]] LeastSpeed least_speed_of(const Where& where, double restitution) const;
  /// Whether the law's impulse is exactly along the normal, so that only rounding would change the spin of a ball.
  [[nodiscard]] bool is_along_normal(const Where& where) const;
  void keep_spins_of_balls(const Where& where, const Collision& before, Outcome<double>& outcome) const;
  void begin_change(Change& change, std::size_t body) const;
  /// Stores the state of the body at the present time, with these velocities.
  void end_change(Change& change, const BodyVelocity<double>& velocity);
  [[nodiscard]] double tolerance_of(const Where& where) const;
  [[nodiscard]] std::string description_of(const Where& where) const;

  Scene scene_;
  Patience patience_;
  double now_ = 0;
  std::vector<TumblingBody> bodies_;
  std::vector<std::size_t> changed_;             // bodies whose predictions are outdated
  std::vector<std::optional<ShapePair>> pairs_;  // entry i (i − 1)/2 + k: bodies i > k; made when they come near
  std::vector<Prediction> predictions_;          // indexed like pairs_
  std::vector<HalfSpace> grounds_;               // one for each plane
  std::vector<Reach> reaches_;                   // entry i · planes + k: body i and plane k
  std::vector<Prediction> plane_predictions_;    // indexed like reaches_
  Event event_;
  Counts counts_;
  unsigned long long at_this_instant_ = 0;
  SlowContacts slow_contacts_;
};

}  // namespace carom::scene
