// SPDX-License-Identifier: BSL-1.0
#include "plan/spelling.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <carom/subjects/catalogue.hpp>

namespace carom::tool::plan {
namespace {

using properties::plan::Candidate;
using properties::plan::Frame;

/// A scalar type as names of methods have it, as people do, and as C++ does.
struct Scalar {
  std::string_view in_name;
  const char* in_words;
  const char* in_code;
};
/// From the fewest bits on. The name of each is looked for at the end of a method's, those with two words first.
constexpr std::array scalars{Scalar{"float", "float", "float"}, Scalar{"double", "double", "double"},
                             Scalar{"long-double", "long double", "long double"},
                             Scalar{"double-double", "double-double", "carom::impulse::DoubleDouble"}};

/// A 3×3 solve of solve3.hpp or solve3_pivoting.hpp, from the one that is recommended on.
struct Solve {
  std::string_view in_name;  // of the method
  const char* in_words;
  const char* in_code;
};
constexpr std::array solves{Solve{"", "LDLᵀ", "Ldlt"},
                            Solve{"adjugate", "adjugate", "Adjugate"},
                            Solve{"llt", "LLT of Eigen", "EigenLlt"},
                            Solve{"ldlt-eigen", "LDLT of Eigen", "EigenLdlt"},
                            Solve{"partial-lu", "PartialPivLU of Eigen", "EigenPartialPivLu"},
                            Solve{"full-lu", "FullPivLU of Eigen", "EigenFullPivLu"},
                            Solve{"qr", "ColPivHouseholderQR of Eigen", "EigenColPivHouseholderQr"}};
constexpr std::string_view first_pivoting_solve = "partial-lu";

/// What a method's name says beside its law.
struct Name {
  std::string_view variant;  // "", "world", "llt", …
  std::size_t scalar;        // of `scalars`
};

Name name_parts(std::string_view name, std::string_view law) {
  std::optional<Name> found;
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    const std::string ending = '-' + std::string(scalars[i].in_name);
    if (name.size() >= law.size() + ending.size() && name.starts_with(law) && name.ends_with(ending)) {
      const std::string_view variant = name.substr(law.size(), name.size() - law.size() - ending.size());
      const Name parts{variant.empty() ? variant : variant.substr(1), i};
      // "…-long-double" ends in "-double" too: what leaves less is the name.
      found = !found || parts.variant.size() < found->variant.size() ? parts : *found;
    }
  }
  if (!found) {
    throw std::logic_error(fmt::format("{} is not the name of a method", name));
  }
  return *found;
}

/// Of the law in scalar type S, with this 3×3 solve.
std::string solver(Model law, const char* solve) {
  const bool has_solve = law != Model::frictionless && law != Model::coulomb;
  return fmt::format("carom::impulse::{}{}", name_of(law),
                     has_solve ? fmt::format("<carom::impulse::{}>", solve) : std::string());
}

std::string contact(const char* scalar, bool in_world) {
  return in_world
             ? fmt::format("carom::impulse::make_contact<{0}, carom::impulse::WorldInertia<{0}>>(collision)", scalar)
             : fmt::format("carom::impulse::make_contact<{}>(collision)", scalar);
}

std::string header(std::string_view name) { return fmt::format("carom/impulse/{}.hpp", name); }

/// How the rest of a method's name is spelt, beside how it solves.
void spell(SpelledCandidate& one, Model law, const Name& name) {
  Candidate& candidate = one.candidate;
  Spelling& spelling = one.spelling;
  const char* const scalar = scalars[name.scalar].in_code;
  if (name.variant == "batch") {
    candidate.is_batch = true;
    spelling = {
        {header("batch/solve")},
        fmt::format("const carom::impulse::ContactBatch<{0}>& contacts, carom::impulse::OutcomeBatch<{0}>& outcomes",
                    scalar),
        fmt::format("carom::impulse::solve(contacts, carom::Model::{}, outcomes)", name_of(law))};
    return;
  }
  const bool in_world = name.variant == "world";
  candidate.frame = in_world ? Frame::world : Frame::body;
  spelling.headers = {header(name_of(law))};
  spelling.reads = "const carom::Collision& collision";
  spelling.call = fmt::format("{}({})", solver(law, solves.front().in_code), contact(scalar, in_world));
  if (in_world) {
    spelling.headers.push_back(header("world_inertia"));
  } else if (name.variant == "guaranteed") {
    candidate.solve += ", the exact N·V⁺ never negative";
    candidate.solve_rank = static_cast<int>(solves.size()) + 2;
    spelling.headers.push_back(header("guaranteed"));
    spelling.call = fmt::format(
        "carom::impulse::guaranteed(collision, {}, [](const auto& contact, const auto&... approach) {{ return "
        "carom::impulse::{}_impulse{}(contact, approach...); }})",
        contact(scalar, false), name_of(law), law == Model::frictionless ? "" : "<carom::impulse::Ldlt>");
  } else if (name.variant == "in-stable-basis") {
    candidate.solve = "in the basis {N, T0, T1}";
    candidate.solve_rank = static_cast<int>(solves.size());
    spelling.headers = {header("reflection_in_basis")};
    spelling.call = fmt::format("carom::impulse::reflection_in_stable_basis({})", contact(scalar, false));
  } else if (!name.variant.empty()) {
    const auto* const solve = std::ranges::find(solves, name.variant, &Solve::in_name);
    if (solve == solves.end()) {
      throw std::logic_error(fmt::format("{} is not the name of a method", candidate.subject.name));
    }
    candidate.solve = solve->in_words;
    candidate.solve_rank = static_cast<int>(solve - solves.begin());
    spelling.call = fmt::format("{}({})", solver(law, solve->in_code), contact(scalar, false));
    if (candidate.solve_rank >= std::ranges::find(solves, first_pivoting_solve, &Solve::in_name) - solves.begin()) {
      spelling.headers.push_back(header("solve3_pivoting"));
    }
  }
  if (name.scalar + 1 == scalars.size()) {
    spelling.headers.push_back(header("numbers/double_double"));
  }
}

/// The system in float, one step of refinement in double.
SpelledCandidate refined(const Subject& subject) {
  const bool has_solve = subject.model != Model::frictionless;
  return {{subject, "float, refined in double", 1, has_solve ? "LDLᵀ, refined" : "scalar, refined",
           static_cast<int>(solves.size()) + 1, Frame::body, false},
          {{header("refined")},
           "const carom::Collision& collision",
           fmt::format("carom::impulse::{}_refined<float{}>({})", name_of(subject.model),
                       has_solve ? ", carom::impulse::Ldlt" : "", contact("double", false))}};
}

}  // namespace

std::optional<SpelledCandidate> spelled(const Subject& subject) {
  if (subject.name.ends_with("-refined")) {
    return refined(subject);
  }
  const Name name = name_parts(subject.name, name_of(subject.model));
  if (name.variant == "in-basis") {
    return std::nullopt;
  }
  SpelledCandidate one;
  one.candidate.subject = subject;
  one.candidate.scalar = scalars[name.scalar].in_words;
  one.candidate.scalar_rank = static_cast<int>(name.scalar);
  one.candidate.solve = subject.model == Model::frictionless ? "scalar" : solves.front().in_words;
  spell(one, subject.model, name);
  return one;
}

std::vector<SpelledCandidate> spelled_candidates() {
  std::vector<SpelledCandidate> all;
  for (const Subject& subject : subjects::built_in_subjects()) {
    if (std::optional<SpelledCandidate> one = spelled(subject)) {
      all.push_back(std::move(*one));
    }
  }
  return all;
}

}  // namespace carom::tool::plan
