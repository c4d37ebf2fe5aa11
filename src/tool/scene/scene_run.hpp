// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <carom/properties/scenes/judged_impulses.hpp>
#include <carom/properties/scenes/ledger.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/report/results/run.hpp>
#include <carom/scene/event.hpp>
#include <carom/scene/polyhedra/scene_simulation.hpp>

namespace carom::tool {

/// The scene in a text. A scene without a title gets the name of the file. Throws UsageError, which names the file, the
/// place and the expected content.
[[nodiscard]] scene::Scene scene_of(const std::string& text, const std::string& file);

struct Sample {
  double time = 0;                       // [s]
  double translation = 0, rotation = 0;  // kinetic energy [J]
  double potential = 0;                  // −m g·x, relative to the start [J]
  Vector3<double> momentum{0, 0, 0};     // [N s]
  double mean_spin = 0;                  // mean of ‖w‖ over the bodies [rad/s]

  [[nodiscard]] double total() const { return translation + rotation + potential; }
};

/// Samples at equal intervals of time, for pictures.
class SceneSamples {
 public:
  /// Begins at the start of a scene. Precondition: the scene that the state refers to outlives this object.
  SceneSamples(const scene::SceneState& state, std::size_t count);

  void record(const scene::Event& event);
  /// Samples up to `time`. Precondition: no event happens until then.
  void close(double time);
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

 private:
  void sample_until(double time);
  [[nodiscard]] Vector3<double> spin_at(std::size_t body, double time) const;
  void go_on(const scene::Change& change);

  const scene::Scene* scene_;
  std::vector<scene::BodyState> bodies_;
  double step_;
  double first_potential_ = 0;
  std::vector<Sample> samples_;
};

struct SceneOptions {
  std::uint64_t judge_every = 1;  // every Nth impulse is judged; 0: none
  bool check = true;              // whether to check that nothing overlaps
  std::optional<std::uint64_t> most_events;
  std::uint64_t most_replayed = 100'000;  // the replay ends after this number of events; 0: no replay
  std::stop_token stop;
  std::function<void(const scene::Event&)> on_event;  // empty for none
  /// Called with the simulated time [s] and the number of events; empty for none.
  std::function<void(double, std::uint64_t)> on_progress;
};

/// The energy that the run itself may add, relative to the first energy.
inline constexpr double most_added_energy = 1e-6;

enum class SceneVerdict {
  holds,               // to the end of the duration
  violated,            // an impulse fails, bodies overlap, or the ledger does not close
  not_run_to_its_end,  // so far, nothing was found
  not_certified,       // the run itself added more than `most_added_energy`
};

/// The exit status of `carom scene`.
[[nodiscard]] constexpr int exit_status(SceneVerdict verdict) {
  if (verdict == SceneVerdict::violated) {
    return report::exit_violated;
  }
  return verdict == SceneVerdict::holds ? report::exit_all_hold : report::exit_usage;
}

/// A scene, and the result of its run. It cannot be moved, because its members refer to each other.
class SceneRun {
 public:
  /// Precondition: the scene is valid. Throws SceneError if bodies overlap at the start.
  SceneRun(const scene::Scene& scene, const SceneOptions& options);
  SceneRun(const SceneRun&) = delete;
  SceneRun& operator=(const SceneRun&) = delete;
  SceneRun(SceneRun&&) = delete;
  SceneRun& operator=(SceneRun&&) = delete;
  ~SceneRun() = default;

  /// Runs the scene to its end, or until it is stopped. If the simulation or the judge ends it, keeps the results so
  /// far. Call it once.
  void run();

  [[nodiscard]] const scene::Scene& scene() const { return simulation_.scene(); }
  [[nodiscard]] const scene::SceneSimulation& simulation() const { return simulation_; }
  [[nodiscard]] const properties::Ledger& ledger() const { return ledger_; }
  [[nodiscard]] const properties::ImpulseJudge& judge() const { return judge_; }
  /// Empty if overlaps were not checked.
  [[nodiscard]] const std::optional<properties::Validity>& validity() const { return validity_; }
  /// The time until which overlaps were checked [s]. It is before the present if the user stopped the check.
  [[nodiscard]] double checked_until() const { return checked_until_; }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_.samples(); }
  [[nodiscard]] const scene::SceneState& first() const { return first_; }
  /// The events of a replay; empty if there is no replay.
  [[nodiscard]] const std::optional<std::vector<scene::Event>>& replayed() const { return replayed_; }
  /// The time until which the replay has every event [s]: the present, or the time of the first event that the replay
  /// leaves out.
  [[nodiscard]] double replayed_until() const { return cut_ ? *cut_ : simulation_.time(); }
  [[nodiscard]] bool is_replay_cut() const { return cut_.has_value(); }
  /// The number of bodies whose angular velocity an event changed, even by one bit, or whose arc before an event had an
  /// angular acceleration.
  [[nodiscard]] std::size_t spins_changed() const;
  [[nodiscard]] double seconds() const { return seconds_; }  // wall time, including the judgement [s]
  /// The reason for an end before the duration; empty if the run reached the duration.
  [[nodiscard]] const std::string& ended_early() const { return ended_early_; }
  [[nodiscard]] SceneVerdict verdict() const;

 private:
  void note_turning(const scene::Change& change);
  void record(const scene::Event& event);
  void check();

  SceneOptions options_;
  scene::SceneSimulation simulation_;
  scene::SceneState first_;
  properties::Ledger ledger_;
  properties::ImpulseJudge judge_;
  std::optional<properties::History> history_;
  std::optional<properties::Validity> validity_;
  double checked_until_ = 0;
  SceneSamples samples_;
  std::optional<std::vector<scene::Event>> replayed_;
  std::optional<double> cut_;
  std::vector<bool> has_turned_;
  double seconds_ = 0;
  std::string ended_early_;
};

}  // namespace carom::tool
