// SPDX-License-Identifier: BSL-1.0
#include "chart/exactness.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/accuracy.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/trial/declared_effects.hpp>
#include <carom/properties/trial/trial.hpp>
#include <carom/properties/trial/unjudged.hpp>

namespace carom::tool::chart {
namespace {

/// At most this many cases are drawn for each wanted case.
constexpr std::size_t cases_drawn_for_each = 20;

template <class Generate>
std::vector<Collision> colliding(const Generate& generate, std::size_t count) {
  std::vector<Collision> found;
  for (std::size_t index = 0; found.size() < count && index < cases_drawn_for_each * count; ++index) {
    Collision collision = generate(index);
    if (validate(collision).empty() && oracles::ExactCase(collision).approach() == oracles::Approach::colliding) {
      found.push_back(std::move(collision));
    }
  }
  return found;
}

oracles::Yardstick yardstick_of(const Subject& subject, double limit_ulps) {
  oracles::Yardstick yardstick;
  yardstick.limit_ulps = limit_ulps;
  return yardstick.in(subject.precision);
}

void add_result(report::ExactnessBuilder& builder, const oracles::ExactCase& posed, const Subject& subject,
                const Answer& answer, double limit_ulps) {
  if (std::holds_alternative<Skipped>(answer)) {
    return;
  }
  const oracles::Yardstick yardstick = yardstick_of(subject, limit_ulps);
  std::optional<properties::JudgedCase> without_effects;
  if (subject.effects != DeclaredEffects{}) {
    without_effects.emplace(properties::Case{posed.collision(), false}, true, subject.effects);
  }
  const oracles::ExactCase& judged = without_effects ? without_effects->exact() : posed;
  if (without_effects ? without_effects->reason_unjudged_by(yardstick)
                      : properties::reason_unjudged(posed, yardstick)) {
    return;
  }
  if (judged.approach() != oracles::Approach::colliding) {
    return;
  }
  properties::ExactAnswer lifted = properties::lift(answer);
  properties::take_out_effects(lifted, subject.effects, judged, subject.law, yardstick.allowance());
  const auto* const outcome = std::get_if<oracles::LiftedOutcome>(&lifted);
  if (outcome == nullptr) {
    builder.add(std::numeric_limits<double>::infinity(), 0, false);
    return;
  }
  if (judged.is_open(subject.law, yardstick.allowance())) {
    return;
  }
  const oracles::Accuracy accuracy = oracles::accuracy(judged, subject.law, *outcome, yardstick);
  if (!accuracy.is_decided) {  // an undecided outcome counts as a failure
    builder.add(std::numeric_limits<double>::infinity(), 0, false);
    return;
  }
  builder.add(accuracy.backward_error(yardstick.unit_roundoff), accuracy.digits(), accuracy.is_allowed());
}

struct CoulombCase {
  CoulombCase(const Collision& collision, AnswersOfCoulomb asked)
      : judged({collision, false}),
        answers(asked == AnswersOfCoulomb::found ? oracles::coulomb_answers(judged.exact())
                                                 : std::vector<oracles::CoulombAnswer>()) {}

  properties::JudgedCase judged;
  std::vector<oracles::CoulombAnswer> answers;  // empty if they were left out

  void add_to(report::ExactnessBuilder& builder, double digits, bool holds) const {
    if (answers.empty()) {
      builder.add(holds);
    } else {
      builder.add(digits, holds);
    }
  }
};

/// The subject's claim without the invariants that compare the answers to two collisions.
properties::Claim claim_about_outcome(const Subject& subject, double limit_ulps) {
  oracles::Yardstick yardstick;
  yardstick.limit_ulps = limit_ulps;
  properties::Claim claim = properties::claim_of(subject, yardstick);
  std::erase_if(claim.invariants, [](const properties::Invariant* invariant) { return invariant->asks(); });
  return claim;
}

void add_coulomb_result(report::ExactnessBuilder& builder, const CoulombCase& one, const Subject& subject,
                        const Answer& answer, double limit_ulps) {
  if (properties::reason_unjudged(one.judged.exact(), yardstick_of(subject, limit_ulps))) {
    return;
  }
  const auto* const outcome = std::get_if<ReportedOutcome>(&answer);
  if (outcome == nullptr || !oracles::is_finite(*outcome)) {
    one.add_to(builder, 0, false);
    return;
  }
  const properties::Judgement judgement = properties::try_case(
      one.judged, claim_about_outcome(subject, limit_ulps),
      [&](const Collision&) -> properties::ExactAnswer { return oracles::LiftedOutcome(*outcome); });
  const bool is_violated = std::any_of(
      judgement.verdicts.begin(), judgement.verdicts.end(),
      [](const properties::NamedVerdict& named) { return named.verdict.status == properties::Status::violated; });
  one.add_to(builder, oracles::nearest_answer(one.judged.exact(), one.answers, *outcome).digits, !is_violated);
}

}  // namespace

std::vector<Collision> colliding_cases(const properties::Family& family, std::uint64_t seed, std::size_t count) {
  return colliding([&](std::size_t index) { return properties::drawn_case(family, seed, index).collision; }, count);
}

std::vector<Collision> colliding_cases(const properties::Sweep& sweep, double quantity, std::uint64_t seed,
                                       std::size_t count) {
  const std::string name = fmt::format("{} {}", sweep.name, quantity);
  return colliding(
      [&](std::size_t index) {
        properties::Stream stream = properties::case_stream(seed, name, index);
        return sweep.generate(stream, quantity);
      },
      count);
}

std::vector<report::Exactness> measured_exactness(ChartedSubjects& charted, std::span<const Collision> collisions,
                                                  double limit_ulps, const properties::Workers& workers,
                                                  AnswersOfCoulomb answers_of_coulomb) {
  const std::span<const Subject> subjects = charted.subjects();
  const std::vector<std::vector<Answer>> answers = charted.answers_to(collisions);
  // The cases are the outer loop, so that the truth of a case is computed once.
  std::vector<std::vector<report::ExactnessBuilder>> parts(std::max(1U, workers.count),
                                                           std::vector<report::ExactnessBuilder>(subjects.size()));
  std::atomic<std::size_t> next = 0;
  workers.run(parts.size(), [&](std::size_t worker) {
    std::vector<report::ExactnessBuilder>& part = parts[worker];
    for (std::size_t i = next++; i < collisions.size(); i = next++) {
      const oracles::ExactCase exact_case(collisions[i]);
      std::optional<CoulombCase> coulomb_case;
      for (std::size_t s = 0; s < subjects.size(); ++s) {
        if (subjects[s].law == Law::coulomb) {
          if (!coulomb_case) {
            coulomb_case.emplace(collisions[i], answers_of_coulomb);
          }
          add_coulomb_result(part[s], *coulomb_case, subjects[s], answers[s][i], limit_ulps);
        } else {
          add_result(part[s], exact_case, subjects[s], answers[s][i], limit_ulps);
        }
      }
    }
  });
  std::vector<report::Exactness> result;
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    for (std::size_t part = 1; part < parts.size(); ++part) {
      parts[0][s] += parts[part][s];
    }
    result.push_back(parts[0][s].built());
    result.back().has_backward_error = determines_outcome(subjects[s].law);
  }
  return result;
}

}  // namespace carom::tool::chart
