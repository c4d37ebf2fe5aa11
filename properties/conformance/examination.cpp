// SPDX-License-Identifier: BSL-1.0
#include <exception>
#include <span>
#include <utility>

#include <carom/collision/json/json.hpp>
#include <carom/properties/conformance/examination.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/properties/trial/in_words.hpp>

namespace carom::conformance {
namespace {

using properties::Case;
using properties::JudgedCase;
using properties::Judgement;
using properties::Status;
using properties::Verdict;

Verdict single_verdict(const Judgement& judgement) {
  if (judgement.skipped) {
    return {.status = Status::skipped, .detail = "the subject skipped the case: " + judgement.skipped->why};
  }
  if (judgement.unjudged) {
    return {.status = Status::skipped, .detail = "not judged: " + std::string(in_words(*judgement.unjudged))};
  }
  if (judgement.verdicts.empty()) {
    return {.status = Status::skipped, .detail = "the invariant does not apply to this case"};
  }
  return judgement.verdicts.front().verdict;
}

}  // namespace

Examination::Examination(const Statement& statement)
    : statement_(&statement), claim_(statement.claim()), session_(statement.subject->open()) {}

bool Examination::holds(const Case& one) {
  if (has_failed_) {
    return true;
  }
  Verdict verdict = verdict_on(one);
  was_in_domain_ = was_in_domain_ || verdict.status != Status::skipped;
  if (verdict.status == Status::skipped && why_skipped_.empty()) {
    why_skipped_ = verdict.detail;
  }
  if (verdict.status != Status::violated) {
    return true;
  }
  if (first_ && !properties::is_as_bad(verdict, one.collision, first_->verdict, first_->one.collision)) {
    return true;
  }
  last_ = {one, std::move(verdict), answer_};
  first_ = first_ ? std::move(first_) : last_;
  return false;
}

Verdict Examination::verdict_on(const Case& one) {
  answer_ = Skipped{"the subject threw"};
  bool is_first = true;
  const auto solve = [&](const Collision& collision) {
    const Answer answer = session_(std::span(&collision, 1)).at(0);
    if (is_first) {
      answer_ = answer;
      is_first = false;
    }
    return properties::lift(answer);
  };
  const JudgedCase judged_case(one, claim_.yardstick.filtered, claim_.effects);
  try {
    if (const auto* about = std::get_if<properties::AboutSession>(&statement_->invariant->about)) {
      answer_ = session_(std::span(&one.collision, 1)).at(0);
      Collision invalid = one.collision;
      invalid.a = Body{};
      invalid.a.mass = -1;
      static_cast<void>(session_(std::span(&invalid, 1)));
      return about->check(answer_, session_(std::span(&one.collision, 1)).at(0),
                          properties::sameness_of_answers(*statement_->subject));
    }
    return single_verdict(properties::try_case(judged_case, claim_, solve));
  } catch (const SessionFailure& failure) {
    has_failed_ = true;
    return {.status = Status::violated, .detail = std::string("the subject failed: ") + failure.what()};
  } catch (const std::exception& exception) {
    return {.status = Status::violated, .detail = std::string("the subject threw: ") + exception.what()};
  }
}

std::string Examination::violation() {
  const auto& [one, found, found_answer] = *last_;
  if (has_failed_) {
    return properties::in_words(one.collision, "    ") + "  " + found.detail + '\n';
  }
  claim_.yardstick.filtered = false;  // the report shows numbers from exact arithmetic
  const Verdict verdict = verdict_on(one);
  claim_.yardstick = statement_->yardstick;
  std::string text;
  if (verdict.status == Status::violated) {
    text = properties::violation_in_words(one.collision, answer_, verdict);
  } else {
    text = properties::violation_in_words(one.collision, found_answer, found) +
           "  the subject gives another answer if it is asked again: it keeps state from earlier collisions\n";
  }
  if (JudgedCase(one).is_valid()) {
    text += "  for `carom replay FILE`: " + collision_to_json(one.collision).dump() + '\n';
  }
  return text;
}

}  // namespace carom::conformance
