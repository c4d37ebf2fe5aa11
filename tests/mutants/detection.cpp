// SPDX-License-Identifier: BSL-1.0
#include "detection.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include <carom/properties/features/feature.hpp>
#include <carom/properties/trial/unjudged.hpp>

#include "leaves_truth.hpp"

namespace carom::mutants {
namespace {

using properties::all_features;
using properties::JudgedCase;

/// The claims of a sound solver in binary64, without relations. `truth` holds the invariants `finite` and
/// `backward_error`, and is judged first because it is faster.
struct Claims {
  properties::Claim truth;
  properties::Claim laws;
};

Claims claims_of(Law law) {
  Subject subject;
  subject.law = law;
  Claims claims{properties::claim_of(subject, {}), {}};
  claims.laws = claims.truth;
  std::erase_if(claims.truth.invariants, [](const properties::Invariant* invariant) {
    return invariant->name != "finite" && invariant->name != "backward_error";
  });
  std::erase_if(claims.laws.invariants, [](const properties::Invariant* invariant) {
    return !std::holds_alternative<properties::AboutOutcome>(invariant->about) || invariant->name == "backward_error";
  });
  return claims;
}

/// The backward error is in ulps, and 0 if the outcome is rejected.
struct Judged {
  bool is_rejected;
  double backward_error;
};

Judged judged(const JudgedCase& one, const Claims& claims, const Outcome<double>& outcome) {
  const Answer answer(map_outcome<long double>(outcome, [](double x) { return static_cast<long double>(x); }));
  double backward_error = 0;
  for (const properties::Claim* claim : {&claims.truth, &claims.laws}) {
    const properties::Judgement judgement =
        properties::Trial(one, *claim, properties::lift(answer), properties::no_relations)
            .judge(std::span<const Answer>());
    for (const properties::NamedVerdict& named : judgement.verdicts) {
      if (named.verdict.status == properties::Status::violated) {
        return {true, 0};
      }
    }
    if (claim == &claims.truth && judgement.accuracy) {
      backward_error = judgement.accuracy->backward_error(claim->yardstick.unit_roundoff);
    }
  }
  return {false, backward_error};
}

std::size_t place_of(std::size_t law, Damage damage) {
  return law * all_damages.size() + static_cast<std::size_t>(damage);
}

/// The index of the pair (x, y) of features, x < y, or of the single feature x = y.
std::size_t place_of(std::size_t x, std::size_t y) { return y * (y + 1) / 2 + x; }

std::size_t places() { return place_of(0, all_features().size()); }

template <class F>
void for_each_place(const std::vector<std::size_t>& features, const F& f) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      f(place_of(features[j], features[i]));
    }
  }
}

std::vector<std::size_t> features_present(const Collision& collision) {
  std::vector<std::size_t> present;
  for (std::size_t i = 0; i < all_features().size(); ++i) {
    if (all_features()[i].is_present(collision)) {
      present.push_back(i);
    }
  }
  return present;
}

std::uint16_t saturated(unsigned count) {
  return static_cast<std::uint16_t>(std::min<unsigned>(count, std::numeric_limits<std::uint16_t>::max()));
}

}  // namespace

Seen& Seen::operator+=(const Seen& other) {
  backward_error = std::max(backward_error, other.backward_error);
  changed = saturated(static_cast<unsigned>(changed) + other.changed);
  sight = std::max(sight, other.sight);
  return *this;
}

Detection::Detection(std::vector<Law> laws)
    : laws_(std::move(laws)), seen_(laws_.size() * all_damages.size() * places()) {}

const Seen& Detection::seen(Law law, Damage damage, std::size_t x, std::size_t y) const {
  const auto index = static_cast<std::size_t>(std::find(laws_.begin(), laws_.end(), law) - laws_.begin());
  return seen_[place_of(index, damage) * places() + place_of(x, y)];
}

void Detection::add(const JudgedCase& one, const Collision& previous) {
  const Collision& collision = one.generated().collision;
  ++cases_;
  oracles::Yardstick yardstick;
  yardstick.unit_roundoff = unit_roundoff(Precision::binary64);
  // If `permitted_inputs` is not null, the judge accepts the law's answer to every permitted input. A damaged outcome
  // may be such an answer, so the case is left out.
  if (properties::reason_unjudged(one.exact(), yardstick) ||
      one.exact().permitted_inputs(yardstick.allowance()) != nullptr) {
    return;
  }
  ++judged_;
  const std::vector<std::size_t> present = features_present(collision);
  const oracles::ExactCase read(as_read(collision));
  for (std::size_t m = 0; m < laws_.size(); ++m) {
    const Claims claims = claims_of(laws_[m]);
    const Solution sound = solved(laws_[m], collision);
    const Judged of_sound = mutants::judged(one, claims, sound.outcome);
    if (of_sound.is_rejected) {
      ++sound_rejected_;
      continue;
    }
    const Outcome<double> last = solved(laws_[m], previous).outcome;
    for (const Damage damage : all_damages) {
      Seen* const seen = &seen_[place_of(m, damage) * places()];
      bool is_open = false;
      for_each_place(present, [&](std::size_t place) { is_open = is_open || seen[place].sight != Sight::killed; });
      if (!is_open) {
        continue;
      }
      const Outcome<double> outcome = damaged(damage, sound, last);
      const Judged judgement = differ(outcome, sound.outcome) ? mutants::judged(one, claims, outcome) : of_sound;
      Seen of_case;
      if (judgement.is_rejected) {
        of_case.sight = Sight::killed;
      } else if (leaves_truth(damage, read, laws_[m])) {
        of_case.sight = Sight::leaves_truth;
      } else {
        of_case = {static_cast<float>(judgement.backward_error), 1, Sight::within_rounding};
      }
      for_each_place(present, [&](std::size_t place) { seen[place] += of_case; });
    }
  }
}

Detection& Detection::operator+=(const Detection& other) {
  std::transform(seen_.begin(), seen_.end(), other.seen_.begin(), seen_.begin(),
                 [](Seen sum, const Seen& more) { return sum += more; });
  cases_ += other.cases_;
  judged_ += other.judged_;
  sound_rejected_ += other.sound_rejected_;
  return *this;
}

Detection detect(const DetectionOptions& options) {
  constexpr std::uint64_t cases_in_task = 50;
  struct Task {
    const properties::Family* family;
    std::uint64_t first;
    std::uint64_t last;
  };
  std::vector<Task> tasks;
  for (const properties::Family& family : properties::all_families()) {
    const std::uint64_t cases = options.cases * static_cast<std::uint64_t>(family.weight);
    for (std::uint64_t first = 0; first < cases; first += cases_in_task) {
      tasks.push_back({&family, first, std::min(first + cases_in_task, cases)});
    }
  }
  const auto generated = [&](const properties::Family& family, std::uint64_t index) {
    return properties::drawn_case(family, options.seed, index);
  };
  std::atomic<std::size_t> next = 0;
  const auto work = [&](Detection& detection) {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      const auto& [family, first, last] = tasks[i];
      // Each task also draws the case before its first case. So the previous answer does not depend on the division
      // into tasks.
      Collision previous = first == 0 ? Collision{} : generated(*family, first - 1).collision;
      for (std::uint64_t index = first; index < last; ++index) {
        const JudgedCase one(generated(*family, index));
        if (one.is_valid() && one.exact().approach() == oracles::Approach::colliding) {
          detection.add(one, previous);
        }
        previous = one.generated().collision;
      }
    }
  };
  std::vector<Detection> of_threads(std::max(1U, options.jobs), Detection(options.laws));
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < of_threads.size(); ++i) {
      threads.emplace_back([&, i] { work(of_threads[i]); });
    }
    work(of_threads[0]);
  }
  for (std::size_t i = 1; i < of_threads.size(); ++i) {
    of_threads[0] += of_threads[i];
  }
  return std::move(of_threads[0]);
}

}  // namespace carom::mutants
