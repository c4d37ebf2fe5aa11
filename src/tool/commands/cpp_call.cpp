// SPDX-License-Identifier: BSL-1.0
#include "commands/cpp_call.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/subjects/methods.hpp>

namespace carom::tool::plan {
namespace {

using properties::plan::Candidate;
using properties::plan::Frame;
using subjects::Method;
using subjects::MethodForm;

bool has_solve(Law law) { return law != Law::frictionless && law != Law::coulomb; }

std::string contact(const Method& method) {
  return method.keeps_inertia_in_world
             ? fmt::format("carom::impulse::make_contact<{0}, carom::impulse::WorldInertia<{0}>>(collision)",
                           method.scalar.in_code)
             : fmt::format("carom::impulse::make_contact<{}>(collision)", method.scalar.in_code);
}

std::string header(std::string_view name) { return fmt::format("carom/impulse/{}.hpp", name); }

void write_call_of_law(const Method& method, CppCall& code) {
  const Law law = method.subject.law;
  code.call = fmt::format("carom::impulse::{}{}({})", name_of(law),
                          has_solve(law) ? fmt::format("<carom::impulse::{}>", method.solve.in_code) : std::string(),
                          contact(method));
  if (method.keeps_inertia_in_world) {
    code.headers.push_back(header("world_inertia"));
  }
  if (method.solve.pivots) {
    code.headers.push_back(header("solve3_pivoting"));
  }
}

/// Writes the C++ call of a method by its form. A form without a plain 3×3 solve gets a greater `solve_rank` than any
/// 3×3 solve.
void write_call(const Method& method, CallableCandidate& one) {
  Candidate& candidate = one.candidate;
  CppCall& code = one.code;
  const Law law = method.subject.law;
  switch (method.form) {
    case MethodForm::law:
    case MethodForm::in_basis:
      write_call_of_law(method, code);
      break;
    case MethodForm::in_stable_basis:
      candidate.solve = "in the basis {N, T0, T1}";
      candidate.solve_rank = subjects::solve_count;
      code.headers = {header("reflection_in_basis")};
      code.call = fmt::format("carom::impulse::reflection_in_stable_basis({})", contact(method));
      break;
    case MethodForm::refined:
      candidate.scalar = "float, refined in double";
      candidate.solve += ", refined";
      candidate.solve_rank = subjects::solve_count + 1;
      code.headers = {header("refined")};
      code.call = fmt::format("carom::impulse::{}_refined<float{}>({})", name_of(law),
                              has_solve(law) ? ", carom::impulse::Ldlt" : "", contact(method));
      break;
    case MethodForm::guaranteed:
      candidate.solve += ", exact N·V⁺ never negative";
      candidate.solve_rank = subjects::solve_count + 2;
      code.headers.push_back(header("guaranteed"));
      code.call = fmt::format(
          "carom::impulse::guaranteed(collision, {}, [](const auto& contact, const auto&... approach) {{ return "
          "carom::impulse::{}_impulse{}(contact, approach...); }})",
          contact(method), name_of(law), has_solve(law) ? "<carom::impulse::Ldlt>" : "");
      break;
    case MethodForm::batch:
      candidate.is_batch = true;
      code = {
          {header("batch/solve")},
          fmt::format("const carom::impulse::ContactBatch<{0}>& contacts, carom::impulse::OutcomeBatch<{0}>& outcomes",
                      method.scalar.in_code),
          fmt::format("carom::impulse::solve(contacts, carom::Law::{}, outcomes)", name_of(law))};
      break;
  }
}

std::optional<CallableCandidate> candidate_of(const Method& method) {
  if (method.form == MethodForm::in_basis) {
    return std::nullopt;
  }
  const Subject& subject = method.subject;
  CallableCandidate one{{subject, std::string(method.scalar.in_words), method.scalar.rank,
                         subject.law == Law::frictionless ? "scalar" : std::string(method.solve.in_words),
                         method.solve.rank, method.keeps_inertia_in_world ? Frame::world : Frame::body, false},
                        {{header(name_of(subject.law))}, "const carom::Collision& collision", {}}};
  write_call(method, one);
  if (method.scalar.in_code.ends_with("DoubleDouble")) {
    one.code.headers.push_back(header("numbers/double_double"));
  }
  return one;
}

}  // namespace

std::optional<CallableCandidate> callable_candidate(const Subject& subject) {
  const std::vector<Method> methods = subjects::methods();
  const auto found =
      std::ranges::find_if(methods, [&](const Method& method) { return method.subject.name == subject.name; });
  if (found == methods.end()) {
    throw std::logic_error(fmt::format("{} is not the name of a method", subject.name));
  }
  return candidate_of(*found);
}

std::vector<CallableCandidate> callable_candidates() {
  std::vector<CallableCandidate> all;
  for (const Method& method : subjects::methods()) {
    if (std::optional<CallableCandidate> one = candidate_of(method)) {
      all.push_back(std::move(*one));
    }
  }
  return all;
}

}  // namespace carom::tool::plan
