// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/subjects/methods.hpp>

#include "commands/chart.hpp"
#include "commands/plan.hpp"
#include "io/output.hpp"

namespace carom::tool::plan {
namespace {

using properties::plan::Candidate;
using properties::plan::Frame;
using subjects::Method;
using subjects::MethodForm;

const Method& method_named(const std::vector<Method>& methods, const std::string& name) {
  const auto found = std::ranges::find_if(methods, [&](const Method& method) { return method.subject.name == name; });
  if (found == methods.end()) {
    throw std::logic_error(name + " is not a built-in method");
  }
  return *found;
}

/// A form without a plain 3×3 solve gets a greater `solve_rank` than any 3×3 solve.
Candidate candidate_of(const Method& method) {
  const Subject& subject = method.subject;
  Candidate candidate{subject,
                      std::string(method.scalar.in_words),
                      method.scalar.rank,
                      subject.law == Law::frictionless ? "scalar" : std::string(method.solve.in_words),
                      method.solve.rank,
                      method.keeps_inertia_in_world ? Frame::world : Frame::body,
                      method.form == MethodForm::batch};
  switch (method.form) {
    case MethodForm::in_stable_basis:
      candidate.solve = "in the basis {N, T0, T1}";
      candidate.solve_rank = subjects::solve_count;
      break;
    case MethodForm::refined:
      candidate.scalar = "float, refined in double";
      candidate.solve += ", refined";
      candidate.solve_rank = subjects::solve_count + 1;
      break;
    case MethodForm::guaranteed:
      candidate.solve += ", exact N·V⁺ never negative";
      candidate.solve_rank = subjects::solve_count + 2;
      break;
    case MethodForm::law:
    case MethodForm::in_basis:
    case MethodForm::batch:
      break;
  }
  return candidate;
}

}  // namespace

std::vector<Candidate> candidates() {
  std::vector<Candidate> all;
  for (const Method& method : subjects::methods()) {
    if (method.form != MethodForm::in_basis) {
      all.push_back(candidate_of(method));
    }
  }
  return all;
}

std::string header_of(const std::string& method) {
  const std::vector<Method> methods = subjects::methods();
  const Method& named = method_named(methods, method);
  const auto header = [](std::string_view name) { return fmt::format("carom/impulse/{}.hpp", name); };
  switch (named.form) {
    case MethodForm::in_basis:
    case MethodForm::in_stable_basis:
      return header("reflection_in_basis");
    case MethodForm::refined:
      return header("refined");
    case MethodForm::guaranteed:
      return header("guaranteed");
    case MethodForm::batch:
      return header("batch/solve");
    case MethodForm::law:
      break;
  }
  return header(name_of(named.subject.law));
}

properties::plan::Clock clock_of(int repetitions) {
  CAROM_EXPECTS(repetitions > 0, repetitions);
  static_assert(properties::plan::contacts_timed == chart::contacts_in_kernel, "each sample is one kernel");
  return [repetitions](std::span<const properties::plan::Timing> timings) {
    const std::vector<Method> methods = subjects::methods();
    std::vector<chart::TimedKernel> kernels;
    for (const properties::plan::Timing& timing : timings) {
      kernels.push_back({&method_named(methods, timing.candidate->subject.name), timing.collisions});
    }
    std::vector<double> nanoseconds;
    for (const report::Spread& spread : chart::measured_times(kernels, repetitions, progress_line("timings"))) {
      nanoseconds.push_back(spread.median);
    }
    return nanoseconds;
  };
}

}  // namespace carom::tool::plan
