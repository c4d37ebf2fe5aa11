// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>

#include <carom/oracles/laws/judge_error.hpp>
#include <carom/properties/gate/in_words.hpp>

namespace carom::tool {
namespace {

constexpr std::size_t sample_count = 400;
constexpr std::uint64_t events_of_a_check = 100'000;  // the most events that are kept for a check
/// The limit of the total rounding error relative to the scale of the energy, for a scene in binary64.
constexpr double rounding_limit_in_double = 1e-12;

/// The states are stored in binary64, so an impulse of a higher precision is judged as binary64.
Precision judged_precision(const scene::Scene& scene) { return std::min(scene.precision, Precision::binary64); }

bool turns(const scene::Change& change, bool is_polyhedron) {
  const Vector3<double>& before =
      is_polyhedron ? change.angular_velocity_before : change.before.turning.angular_velocity;
  return before != change.after.turning.angular_velocity || !change.before.turning.angular_acceleration.isZero(0);
}

}  // namespace

SceneRun::SceneRun(const scene::Scene& scene, const SceneOptions& options)
    : options_(options),
      simulation_(scene),
      first_(simulation_.state()),
      ledger_(first_),
      judge_(scene.law, judged_precision(scene), options.judge_every, oracles::Limits()),
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
    validity_->add(properties::check_validity(scene(), *history_));
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
    options_.on_progress(event.time);
  }
}

void SceneRun::run() {
  const auto begin = std::chrono::steady_clock::now();
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
    has_failed_ = true;
  } catch (const oracles::JudgeError& error) {
    ended_early_ = properties::in_words(error);
    ended_early_.pop_back();  // the line end
    has_failed_ = true;
  } catch (const std::bad_alloc&) {
    ended_early_ = "there is not enough memory";
    has_failed_ = true;
  }
  ledger_.close(simulation_.state());
  samples_.close(simulation_.time());
  check();
  history_.reset();
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::size_t SceneRun::spins_changed() const {
  return static_cast<std::size_t>(std::count(has_turned_.begin(), has_turned_.end(), true));
}

double SceneRun::relative_rounding() const {
  const long double scale = ledger_.scale();
  return scale > 0 ? static_cast<double>(std::abs(ledger_.energy(properties::Cause::rounding)) / scale) : 0;
}

double SceneRun::rounding_limit() const {
  return rounding_limit_in_double *
         std::max(1.0, unit_roundoff(scene().precision) / unit_roundoff(Precision::binary64));
}

bool SceneRun::holds() const { return judge_.violated() == 0 && is_closed() && (!validity_ || validity_->count == 0); }

}  // namespace carom::tool
