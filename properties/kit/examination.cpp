// SPDX-License-Identifier: BSL-1.0
#include <ctime>
#include <exception>
#include <span>
#include <stop_token>
#include <utility>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/properties/kit/examination.hpp>

namespace carom::conformance {
namespace {

using properties::AnswerKind;
using properties::Case;
using properties::JudgedCase;
using properties::Judgement;
using properties::Status;
using properties::Verdict;
using properties::ViolationKind;

/// The subject threw. It is no std::exception, so nothing else catches it.
struct SubjectEnded {
  Verdict how;
};

Verdict skipped(std::string why) { return {.status = Status::skipped, .detail = std::move(why)}; }

/// The fault of an answer to a valid collision that is no outcome of finite numbers. Empty if it is one.
std::string why_no_outcome(const Answer& answer) {
  switch (properties::kind_of(answer)) {
    case AnswerKind::not_finite:
      return "the answer contains infinities or NaN";
    case AnswerKind::refused:
      return "the subject refused a valid collision: " + std::get<Refused>(answer).why;
    case AnswerKind::failed:
      return "the subject " + std::get<Failed>(answer).why;
    case AnswerKind::skipped:
      return "the subject skipped the case: " + std::get<Skipped>(answer).why;
    case AnswerKind::outcome:
      break;
  }
  return {};
}

Verdict single_verdict(const Judgement& judgement) {
  if (judgement.unjudged) {
    return skipped("not judged: " + std::string(in_words(*judgement.unjudged)));
  }
  return judgement.verdicts.empty() ? skipped("the invariant does not apply to this case")
                                    : judgement.verdicts.front().verdict;
}

/// A hint needs few cases. A relation multiplies the questions to a subject, and explains nothing that others do not.
constexpr std::uint64_t cases_of_each_family = 100;
constexpr std::uint64_t relations_every = 10;
constexpr std::clock_t longest =
    4 * CLOCKS_PER_SEC;                // of processor time, so that other programs do not shorten the run
constexpr std::size_t most_lines = 9;  // after the heading

/// The diagnosis of the suite's subject by a short run of the gate, in at most ten lines. Empty if the run finds no
/// violation. The run takes at most about four seconds of processor time. A fault of the run costs the diagnosis, and
/// nothing else.
std::string gate_diagnosis(const Suite& suite) {
  std::stop_source stop;
  properties::GateOptions options;
  options.cases = cases_of_each_family;
  options.families = suite.families;
  options.within = suite.within;
  options.limits = suite.yardstick.limits();
  options.relations_every = relations_every;
  options.shrinks = false;
  options.stop = stop.get_token();
  options.progress = [&, start = std::clock()](std::uint64_t, std::uint64_t) {
    if (std::clock() - start > longest) {
      stop.request_stop();
    }
  };
  try {
    const properties::GateReport report = properties::run_gate({suite.subject}, options);
    const properties::SubjectResult& result = report.results.front();
    if (result.violated_invariants().empty()) {
      return {};
    }
    const properties::diagnosis::Diagnosis diagnosis = properties::diagnosis::diagnose(result, report);
    return "  The gate's diagnosis, of " + std::to_string(result.cases()) + " cases:\n" +
           properties::diagnosis::in_words(diagnosis.faults, "    ", most_lines);
  } catch (const std::exception& error) {
    return std::string("  No diagnosis: ") + error.what() + '\n';
  }
}

}  // namespace

Examination::Examination(const Statement& statement)
    : statement_(statement), claim_(statement.claim()), session_(statement.suite->subject.open()) {}

Answer Examination::ask(const Collision& collision) {
  try {
    return session_(std::span(&collision, 1)).at(0);
  } catch (const SessionFailure& failure) {
    throw SubjectEnded{properties::violation(ViolationKind::subject_failed, std::string(": ") + failure.what())};
  } catch (const std::exception& exception) {
    throw SubjectEnded{properties::violation(ViolationKind::subject_threw, std::string(": ") + exception.what())};
  } catch (...) {
    throw SubjectEnded{properties::violation(ViolationKind::subject_threw, ": an object that is no std::exception")};
  }
}

bool Examination::holds(const Case& one) {
  if (has_failed_ || error_of_judge_) {
    return true;
  }
  Verdict verdict;
  try {
    verdict = verdict_on(one);
  } catch (...) {
    error_of_judge_ = std::current_exception();
    return true;
  }
  was_judged_ = was_judged_ || verdict.status != Status::skipped;
  if (verdict.status == Status::skipped) {
    why_outside_ = why_outside_.empty() ? verdict.detail : why_outside_;
    if (why_no_outcome_.empty() && validate(one.collision).empty()) {
      why_no_outcome_ = why_no_outcome(answer_);
    }
  }
  if (verdict.status != Status::violated) {
    return true;
  }
  if (first_ && !properties::is_as_bad(verdict, one.collision, first_->verdict, first_->one.collision)) {
    return true;
  }
  last_ = {one, std::move(verdict), answer_, has_thrown_};
  first_ = first_ ? std::move(first_) : last_;
  return false;
}

Verdict Examination::verdict_of_session(const properties::AboutSession& about, const Collision& collision) {
  answer_ = ask(collision);
  Collision invalid = collision;
  invalid.a = Body{};
  invalid.a.mass = -1;
  static_cast<void>(ask(invalid));
  return about.check(answer_, ask(collision), properties::sameness_of_answers(statement_.suite->subject));
}

Verdict Examination::verdict_on(const Case& one) {
  answer_ = ReportedOutcome();
  has_thrown_ = false;
  if (const auto outside = properties::name_outside(claim_.within, one.collision)) {
    return skipped("the collision is outside of the domain, by its " + std::string(*outside));
  }
  bool is_first = true;
  const auto solve = [&](const Collision& collision) {
    const Answer answer = ask(collision);
    if (is_first) {
      answer_ = answer;
      is_first = false;
    }
    return properties::lift(answer);
  };
  const JudgedCase judged_case(one, claim_.yardstick.filtered(), claim_.effects);
  try {
    const auto* const about = std::get_if<properties::AboutSession>(&statement_.invariant->about);
    return about != nullptr ? verdict_of_session(*about, one.collision)
                            : single_verdict(properties::try_case(judged_case, claim_, solve));
  } catch (const SubjectEnded& ended) {
    answer_ = Skipped{ended.how.detail};
    has_thrown_ = true;
    has_failed_ = ended.how.kind == ViolationKind::subject_failed;  // the session cannot answer another collision
    return ended.how;
  }
}

Finding Examination::finding(const std::string& test) {
  Suite& suite = *statement_.suite;
  if (was_judged_) {
    suite.judged.insert(statement_.invariant);
  }
  if (!last_ && error_of_judge_) {
    std::rethrow_exception(error_of_judge_);
  }
  if (!last_) {
    return was_judged_ ? Finding{Status::holds, ""} : Finding{Status::skipped, why_skipped()};
  }
  const std::string family(statement_.family->name);
  if (has_ended()) {
    suite.ended = last_->verdict.detail + (test.empty() ? "" : " (in the test " + test + ")");
    return {Status::violated, suite.subject.name + " ends in " + family + "; shrunk:\n" + violation()};
  }
  std::string text = suite.subject.name + " violates " + std::string(statement_.invariant->name) + " in " + family +
                     "; shrunk:\n  " + std::string(statement_.invariant->statement) + '\n' + violation();
  if (!suite.diagnosed_in) {
    suite.diagnosed_in = test;
    text += gate_diagnosis(suite);
  } else if (!suite.diagnosed_in->empty()) {
    text += "  The diagnosis stands in the message of " + *suite.diagnosed_in + ".\n";
  }
  return {Status::violated, text};
}

std::string Examination::violation() {
  const auto& [one, found, found_answer, has_ended] = *last_;
  std::optional<Verdict> verdict;
  if (!has_failed_) {
    claim_.yardstick = claim_.yardstick.with_filters(false);  // the report shows numbers from exact arithmetic
    try {
      verdict = verdict_on(one);
    } catch (...) {
      verdict = found;  // the judge failed
      answer_ = found_answer;
    }
    claim_.yardstick = statement_.suite->yardstick;
  }
  std::string text;
  if (verdict && verdict->status == Status::violated) {
    text = properties::violation_in_words(one.collision, answer_, *verdict);
  } else {
    text = properties::violation_in_words(one.collision, found_answer, found);
    text += verdict
                ? "  the subject gives another answer if it is asked again: it keeps state from earlier collisions\n"
                : "";
  }
  if (JudgedCase(one).is_valid()) {
    text += "  for `carom replay FILE`: " + collision_to_json(one.collision).dump() + '\n';
  }
  return text;
}

std::string Examination::why_skipped() const {
  const std::string family(statement_.family->name);
  const std::string invariant(statement_.invariant->name);
  return why_no_outcome_.empty() ? "no case of " + family + " is in the domain of " + invariant + " (" +
                                       std::string(statement_.invariant->applies_to) + "); first case: " + why_outside_
                                 : invariant + " judged no case of " + family + ": " + why_no_outcome_;
}

std::optional<Finding> finding_without_test(const Statement& statement) {
  const Suite& suite = *statement.suite;
  if (!suite.subject.absent.empty()) {
    return Finding{Status::skipped, suite.subject.name + " is absent: " + suite.subject.absent};
  }
  return suite.ended ? std::optional(Finding{Status::skipped, "not judged: " + *suite.ended}) : std::nullopt;
}

Finding finding_of_judged(const std::vector<Statement>& statements, const std::string& test) {
  constexpr std::uint64_t seed = 1;
  constexpr std::uint64_t cases = 100;  // of each family, as many as RapidCheck draws
  std::string unjudged;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    const Statement& statement = statements[i];
    Suite& suite = *statement.suite;
    if (const auto without_test = finding_without_test(statement)) {
      return *without_test;
    }
    if (suite.judged.contains(statement.invariant)) {
      continue;
    }
    Examination examination(statement);
    for (std::uint64_t index = 0; index < cases && !examination.was_judged_ && !examination.error_of_judge_; ++index) {
      static_cast<void>(examination.holds(properties::drawn_case_within(suite.within, *statement.family, seed, index)));
    }
    if (examination.has_ended() || examination.error_of_judge_) {
      return examination.finding(test);
    }
    const bool is_last = i + 1 == statements.size() || statements[i + 1].invariant != statement.invariant;
    if (examination.was_judged_) {
      suite.judged.insert(statement.invariant);
    } else if (is_last) {
      unjudged += "  " + examination.why_skipped() + '\n';
    }
  }
  if (unjudged.empty()) {
    return {Status::holds, ""};
  }
  return {Status::violated, "Some invariants are judged on no case of any family:\n" + unjudged +
                                "Choose other families or a wider domain, or leave these invariants out by "
                                "Options::deviates.\n"};
}

}  // namespace carom::conformance
