// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <carom/scene/event.hpp>
#include <carom/scene/scene.hpp>

namespace carom::scene {

/// Ends a simulation if a stop is requested, or if simulated time does not advance for ten seconds of wall time.
class Patience {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Patience(Clock::duration longest = std::chrono::seconds(10)) : longest_(longest) {}
  void stop_on(std::stop_token stop) { stop_ = std::move(stop); }
  [[nodiscard]] const std::stop_token& stop() const { return stop_; }

  /// Whether a stop was requested. `time` is the simulated time [s]. Throws SceneError if `time` does not advance.
  [[nodiscard]] bool is_over(double time) {
    if (stop_.stop_requested()) {
      return true;
    }
    if (++looks_ % looks_for_each_clock != 0) {
      return false;
    }
    const auto now = Clock::now();
    if (time > latest_ * (1 + 0x1p-40) || since_ == Clock::time_point()) {
      latest_ = time;
      since_ = now;
    } else if (now - since_ > longest_) {
      throw SceneError(text_of("at t = ", time, " s the simulation makes no progress for ",
                               std::chrono::duration<double>(longest_).count(), " s of wall time"));
    }
    return false;
  }

 private:
  /// An event takes a microsecond, so the clock would cost some percent of it.
  static constexpr unsigned looks_for_each_clock = 256;

  Clock::duration longest_;
  std::stop_token stop_;
  unsigned looks_ = 0;
  double latest_ = 0;
  Clock::time_point since_;
};

/// Notices bodies that would have to rest on each other. Such a body has one slow contact after the other, until the
/// time between them is too short to follow.
class SlowContacts {
 public:
  explicit SlowContacts(std::size_t bodies = 0) : bodies_(bodies) {}

  /// Records an impact or a capture. `is_slow`: whether the body would rise by at most the capture height, so that its
  /// next contact follows within the time `hop` [s].
  void record(const Event& event, bool is_slow, double hop) {
    std::uint32_t least = count(event.a.body, event.time, is_slow, hop);
    if (event.b) {
      least = std::min(least, count(event.b->body, event.time, is_slow, hop));
    }
    // A sphere that stays on a plane between its contacts with another body has a capture for each of them.
    rests_ = least >= (event.kind == EventKind::capture ? 2 * most : most);
  }

  /// Throws SceneError if the bodies of the last contact, the present event, have had only slow contacts for so long
  /// that they would have to rest on each other.
  void require_no_rest(const Scene& scene, const Event& event) const {
    if (rests_) {
      const std::string other = event.b ? description_of(scene, event.b->body)
                                        : text_of("plane ", event.plane, " (", scene.planes[event.plane].name, ')');
      throw SceneError(text_of("at t = ", event.time, " s ", description_of(scene, event.a.body), " and ", other,
                               " would have to rest on each other, which this simulation cannot follow"));
    }
  }

 private:
  /// A contact that ends in time, such as that of a ball that rolls past another, has fewer slow impacts in a row.
  static constexpr std::uint32_t most = 1024;

  struct Streak {
    std::uint32_t count = 0;
    double last = 0;  // [s]
  };

  std::uint32_t count(std::uint32_t body, double time, bool is_slow, double hop) {
    Streak& streak = bodies_[body];
    // After twice the time of a hop, the body has left the other.
    const bool follows = is_slow && time - streak.last <= 2 * hop;
    streak = {follows ? streak.count + 1 : 0, time};
    return streak.count;
  }

  std::vector<Streak> bodies_;
  bool rests_ = false;
};

}  // namespace carom::scene
