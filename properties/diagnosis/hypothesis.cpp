// SPDX-License-Identifier: BSL-1.0
#include <iterator>

#include <carom/collision/expects.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

/// Whether the steps, further mistakes of `rest` and the fitted size give the answer.
bool explains_with(const Steps& steps, std::span<const Hypothesis* const> rest, const std::optional<FittedSize>& size,
                   const KnownCase& one) {
  if (rest.empty()) {
    if (size) {
      return gives_answer(*size, steps, one);
    }
    const std::optional<Impulses> impulses = impulses_by(steps, one);
    return impulses && is_explained_by(outcome_by(steps, *impulses, one), one);
  }
  const Hypothesis& first = *rest.front();
  // A limit of the impulse comes last in a solver, so it replaces other sizes.
  const bool replaces = first.size && (!size || first.size->fit == Fit::length_of_impulse);
  const std::optional<FittedSize>& kept = replaces ? first.size : size;
  if (first.mistakes.empty()) {
    return explains_with(steps, rest.subspan(1), kept, one);
  }
  for (const Mistake& mistake : first.mistakes) {
    Steps changed = steps;
    if (mistake(changed, one) && explains_with(changed, rest.subspan(1), kept, one)) {
      return true;
    }
  }
  return false;
}

std::vector<Hypothesis> other_laws() {
  std::vector<Hypothesis> all;
  for (const Law law : laws_with_truth) {
    all.push_back({"its law were " + std::string(name_of(law)),
                   "the claimed law: this answer is right for another `law` than the claimed one",
                   {[law](Steps& steps, const KnownCase& one) {
                     steps.law = law;
                     steps.has_right_impulse = false;
                     return law != one.law;
                   }}});
  }
  return all;
}

}  // namespace

std::span<const Hypothesis> all_hypotheses() {
  static const std::vector<Hypothesis> all = [] {
    std::vector<Hypothesis> joined;
    for (const auto group : {misused_impulses, misread_contacts, misread_bodies, other_laws}) {
      std::ranges::move(group(), std::back_inserter(joined));
    }
    return joined;
  }();
  return all;
}

std::optional<Outcome<double>> answer_of(const Hypothesis& hypothesis, const KnownCase& one) {
  CAROM_EXPECTS(!hypothesis.mistakes.empty() && !hypothesis.size, hypothesis.as_if);
  Steps steps = right_steps(one);
  if (!hypothesis.mistakes.front()(steps, one)) {
    return std::nullopt;
  }
  const std::optional<Impulses> impulses = impulses_by(steps, one);
  return impulses ? std::optional(outcome_by(steps, *impulses, one)) : std::nullopt;
}

bool explains(std::span<const Hypothesis* const> together, const KnownCase& one) {
  return explains_with(right_steps(one), together, {}, one);
}

bool explains(const Hypothesis& hypothesis, const KnownCase& one) {
  const Hypothesis* const alone = &hypothesis;
  return explains(std::span(&alone, 1), one);
}

}  // namespace carom::properties::diagnosis
