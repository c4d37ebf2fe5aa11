// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_run.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/oracles/laws/judge_error.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/scene/json/scene_json.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

constexpr std::size_t sample_count = 400;
using Clock = std::chrono::steady_clock;

/// The time for the last check for overlaps after a request to stop.
constexpr std::chrono::milliseconds time_after_stop{300};

constexpr std::uint64_t events_of_a_check = 100'000;  // the most events that are kept for a check

bool turns(const scene::Change& change, bool is_polyhedron) {
  const Vector3<double>& before =
      is_polyhedron ? change.angular_velocity_before : change.before.turning.angular_velocity;
  return before != change.after.turning.angular_velocity || !change.before.turning.angular_acceleration.isZero(0);
}

}  // namespace

scene::Scene scene_of(const std::string& text, const std::string& file) {
  try {
    scene::Scene scene = scene::scene_from_json(parse_json(text));
    if (scene.title.empty()) {
      scene.title = std::filesystem::path(file).stem().string();
    }
    return scene;
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", file, error.what()));
  }
}

SceneSamples::SceneSamples(const scene::SceneState& state, std::size_t count)
    : scene_(state.scene),
      bodies_(state.bodies),
      step_(state.scene->duration / static_cast<double>(std::max<std::size_t>(count, 1))) {}

Vector3<double> SceneSamples::spin_at(std::size_t body, double time) const {
  const scene::BodyState& state = bodies_[body];
  if (is_sphere(*scene_, body) || state.arc.turning.angular_velocity.isZero(0)) {
    return angular_velocity_at(state.arc, time);
  }
  const double elapsed = time - state.arc.path.start;
  const scene::RotationPath path(state.principal_inertia,
                                 scene::rotation_state(state.orientation_at_start, state.arc.turning.angular_velocity),
                                 elapsed);
  return scene::world_rate(path.at(elapsed).state);
}

void SceneSamples::sample_until(double time) {
  for (double next = static_cast<double>(samples_.size()) * step_; next <= time && (step_ > 0 || samples_.empty());
       next = static_cast<double>(samples_.size()) * step_) {
    Sample sample;
    sample.time = next;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      const scene::BodyState& state = bodies_[body];
      const scene::Arc& arc = state.arc;
      const Vector3<double> velocity = scene::velocity_at(arc.path, next);
      const Vector3<double> spin = spin_at(body, next);
      sample.translation += state.mass * velocity.squaredNorm() / 2;
      // The energy of a free rotation is constant between events, so it is computed at the start of the arc.
      const Vector3<double> rate =
          is_sphere(*scene_, body)
              ? spin
              : scene::rotation_state(state.orientation_at_start, arc.turning.angular_velocity).body_rate;
      sample.rotation += state.principal_inertia.dot(rate.cwiseAbs2()) / 2;
      sample.potential -= state.mass * scene_->gravity.dot(scene::position_at(arc.path, next));
      sample.momentum += state.mass * velocity;
      sample.mean_spin += spin.norm() / static_cast<double>(bodies_.size());
    }
    if (samples_.empty()) {
      first_potential_ = sample.potential;
    }
    sample.potential -= first_potential_;
    samples_.push_back(sample);
  }
}

void SceneSamples::go_on(const scene::Change& change) {
  bodies_[change.body].arc = change.after;
  bodies_[change.body].orientation_at_start = change.orientation;
}

void SceneSamples::record(const scene::Event& event) {
  sample_until(event.time);
  go_on(event.a);
  if (event.b) {
    go_on(*event.b);
  }
}

void SceneSamples::close(double time) { sample_until(time); }

SceneRun::SceneRun(const scene::Scene& scene, const SceneOptions& options)
    : options_(options),
      simulation_(scene),
      first_(simulation_.state()),
      ledger_(first_),
      judge_(scene.law, scene.precision, options.judge_every, oracles::Limits()),
      samples_(first_, sample_count),
      has_turned_(simulation_.size(), false) {
  simulation_.stop_on(options.stop);
  if (options.check) {
    history_.emplace(first_);
    validity_.emplace();
  }
  if (options.most_replayed > 0) {
    replayed_.emplace();
  }
}

void SceneRun::check() {
  if (history_) {
    history_->end_at(simulation_.time());
    // After a request to stop, the check has a part of a second.
    const auto stops = [this, since = std::optional<Clock::time_point>()]() mutable {
      if (!options_.stop.stop_requested()) {
        return false;
      }
      since = since.value_or(Clock::now());
      return Clock::now() - *since > time_after_stop;
    };
    validity_->add(properties::check_validity(scene(), *history_, stops));
    checked_until_ = validity_->is_complete ? simulation_.time() : checked_until_;
    history_.emplace(simulation_.state());
  }
}

void SceneRun::note_turning(const scene::Change& change) {
  has_turned_[change.body] = has_turned_[change.body] || turns(change, !is_sphere(scene(), change.body));
}

void SceneRun::record(const scene::Event& event) {
  samples_.record(event);
  ledger_.record(event);
  note_turning(event.a);
  if (event.b) {
    note_turning(*event.b);
  }
  if (history_) {
    history_->record(event);
    if (simulation_.counts().events % events_of_a_check == 0) {
      check();
    }
  }
  if (replayed_ && !cut_) {
    if (replayed_->size() < options_.most_replayed) {
      replayed_->push_back(event);
    } else {
      cut_ = event.time;
    }
  }
  if (options_.on_event) {
    options_.on_event(event);
  }
  judge_.record(event);  // last, because it may throw, and everything else must have the event
  if (options_.on_progress) {
    options_.on_progress(event.time, simulation_.counts().events);
  }
}

void SceneRun::run() {
  const auto begin = Clock::now();
  try {
    while (const scene::Event* event = simulation_.advance()) {
      record(*event);
      if (options_.stop.stop_requested()) {
        ended_early_ = "interrupted";
        break;
      }
      if (options_.most_events && simulation_.counts().events >= *options_.most_events) {
        ended_early_ = "the limit of --events was reached";
        break;
      }
    }
    if (ended_early_.empty() && options_.stop.stop_requested()) {
      ended_early_ = "interrupted";
    }
  } catch (const scene::SceneError& error) {
    ended_early_ = error.what();
  } catch (const oracles::JudgeError& error) {
    ended_early_ = properties::in_words(error);
    ended_early_.pop_back();  // the line end
  } catch (const std::bad_alloc&) {
    ended_early_ = "there is not enough memory";
  }
  ledger_.close(simulation_.state());
  samples_.close(simulation_.time());
  check();
  history_.reset();
  seconds_ = std::chrono::duration<double>(Clock::now() - begin).count();
}

std::size_t SceneRun::spins_changed() const {
  return static_cast<std::size_t>(std::count(has_turned_.begin(), has_turned_.end(), true));
}

SceneVerdict SceneRun::verdict() const {
  if (judge_.violated() > 0 || !ledger_.is_closed() || (validity_ && validity_->count > 0)) {
    return SceneVerdict::violated;
  }
  if (!ended_early_.empty()) {
    return SceneVerdict::not_run_to_its_end;
  }
  return ledger_.added() > most_added_energy ? SceneVerdict::not_certified : SceneVerdict::holds;
}

}  // namespace carom::tool
