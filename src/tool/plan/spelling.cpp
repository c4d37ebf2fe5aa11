// SPDX-License-Identifier: BSL-1.0
#include "plan/spelling.hpp"

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

bool has_solve(Model law) { return law != Model::frictionless && law != Model::coulomb; }

std::string contact(const Method& method) {
  return method.keeps_inertia_in_world
             ? fmt::format("carom::impulse::make_contact<{0}, carom::impulse::WorldInertia<{0}>>(collision)",
                           method.scalar.in_code)
             : fmt::format("carom::impulse::make_contact<{}>(collision)", method.scalar.in_code);
}

std::string header(std::string_view name) { return fmt::format("carom/impulse/{}.hpp", name); }

/// Spells the call of the law in the method's scalar type, with its 3×3 solve.
void spell_law(const Method& method, Spelling& spelling) {
  const Model law = method.subject.model;
  spelling.call = fmt::format(
      "carom::impulse::{}{}({})", name_of(law),
      has_solve(law) ? fmt::format("<carom::impulse::{}>", method.solve.in_code) : std::string(), contact(method));
  if (method.keeps_inertia_in_world) {
    spelling.headers.push_back(header("world_inertia"));
  }
  if (method.solve.pivots) {
    spelling.headers.push_back(header("solve3_pivoting"));
  }
}

/// Spells the call of a method's form. The forms with another solve rank after all 3×3 solves.
void spell(const Method& method, SpelledCandidate& one) {
  Candidate& candidate = one.candidate;
  Spelling& spelling = one.spelling;
  const Model law = method.subject.model;
  switch (method.form) {
    case MethodForm::law:
    case MethodForm::in_basis:
      spell_law(method, spelling);
      break;
    case MethodForm::in_stable_basis:
      candidate.solve = "in the basis {N, T0, T1}";
      candidate.solve_rank = subjects::solve_count;
      spelling.headers = {header("reflection_in_basis")};
      spelling.call = fmt::format("carom::impulse::reflection_in_stable_basis({})", contact(method));
      break;
    case MethodForm::refined:
      candidate.scalar = "float, refined in double";
      candidate.solve += ", refined";
      candidate.solve_rank = subjects::solve_count + 1;
      spelling.headers = {header("refined")};
      spelling.call = fmt::format("carom::impulse::{}_refined<float{}>({})", name_of(law),
                                  has_solve(law) ? ", carom::impulse::Ldlt" : "", contact(method));
      break;
    case MethodForm::guaranteed:
      candidate.solve += ", exact N·V⁺ never negative";
      candidate.solve_rank = subjects::solve_count + 2;
      spelling.headers.push_back(header("guaranteed"));
      spelling.call = fmt::format(
          "carom::impulse::guaranteed(collision, {}, [](const auto& contact, const auto&... approach) {{ return "
          "carom::impulse::{}_impulse{}(contact, approach...); }})",
          contact(method), name_of(law), has_solve(law) ? "<carom::impulse::Ldlt>" : "");
      break;
    case MethodForm::batch:
      candidate.is_batch = true;
      spelling = {
          {header("batch/solve")},
          fmt::format("const carom::impulse::ContactBatch<{0}>& contacts, carom::impulse::OutcomeBatch<{0}>& outcomes",
                      method.scalar.in_code),
          fmt::format("carom::impulse::solve(contacts, carom::Model::{}, outcomes)", name_of(law))};
      break;
  }
}

std::optional<SpelledCandidate> spelled(const Method& method) {
  if (method.form == MethodForm::in_basis) {
    return std::nullopt;
  }
  const Subject& subject = method.subject;
  SpelledCandidate one{{subject, std::string(method.scalar.in_words), method.scalar.rank,
                        subject.model == Model::frictionless ? "scalar" : std::string(method.solve.in_words),
                        method.solve.rank, method.keeps_inertia_in_world ? Frame::world : Frame::body, false},
                       {{header(name_of(subject.model))}, "const carom::Collision& collision", {}}};
  spell(method, one);
  if (method.scalar.in_code.ends_with("DoubleDouble")) {
    one.spelling.headers.push_back(header("numbers/double_double"));
  }
  return one;
}

}  // namespace

std::optional<SpelledCandidate> spelled(const Subject& subject) {
  const std::vector<Method> methods = subjects::methods();
  const auto found =
      std::ranges::find_if(methods, [&](const Method& method) { return method.subject.name == subject.name; });
  if (found == methods.end()) {
    throw std::logic_error(fmt::format("{} is not the name of a method", subject.name));
  }
  return spelled(*found);
}

std::vector<SpelledCandidate> spelled_candidates() {
  std::vector<SpelledCandidate> all;
  for (const Method& method : subjects::methods()) {
    if (std::optional<SpelledCandidate> one = spelled(method)) {
      all.push_back(std::move(*one));
    }
  }
  return all;
}

}  // namespace carom::tool::plan
