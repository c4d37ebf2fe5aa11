// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <utility>

#include <carom/properties/scenes/judged_impulses.hpp>

namespace carom::properties {
namespace {

Subject solver_of_scene(Law law, Precision precision) {
  Subject subject;
  subject.name = "scene";
  subject.law = law;
  subject.precision = std::min(precision, Precision::binary64);
  return subject;
}

}  // namespace

ImpulseJudge::ImpulseJudge(Law law, Precision precision, std::uint64_t every, const oracles::Limits& limits)
    : subject_(solver_of_scene(law, precision)), claim_(claim_of(subject_, limits)), every_(every) {}

void ImpulseJudge::record(const scene::Event& event) {
  if (!event.has_impulse || every_ == 0 || impulses_++ % every_ != 0) {
    return;
  }
  ReportedOutcome outcome;
  const auto widen = [](const BodyVelocity<double>& body) -> BodyVelocity<long double> {
    return {body.velocity.cast<long double>(), body.angular_velocity.cast<long double>()};
  };
  outcome.a = widen(event.outcome.a);
  outcome.b = widen(event.outcome.b);
  // The bodies of a scene are convex and uniform, and the contacts are on their surfaces.
  const JudgedCase judged_case({event.collision, true});
  const Judgement judgement = judge_answer(judged_case, claim_, lift(Answer(outcome)), worst_backward_error_);
  ++judged_;
  bool is_bad = false;
  for (const NamedVerdict& named : judgement.verdicts) {
    if (named.verdict.status == Status::holds) {
      ++times_held_[named.invariant->name];
    } else if (named.verdict.status == Status::violated) {
      is_bad = true;
      if (!first_bad_) {
        first_bad_ = BadImpulse{event.time, named.invariant->name, event.collision, outcome};
      }
    }
  }
  violated_ += is_bad ? 1 : 0;
  if (judgement.accuracy) {
    worst_backward_error_ =
        std::max(worst_backward_error_, judgement.accuracy->backward_error(claim_.yardstick.unit_roundoff()));
  }
}

}  // namespace carom::properties
