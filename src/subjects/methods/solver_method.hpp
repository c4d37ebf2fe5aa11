// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/contact.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/impulse/numbers/double_double.hpp>
#include <carom/subjects/methods.hpp>
#include <carom/subjects/session.hpp>

namespace carom::subjects {

template <class S>
inline constexpr ScalarType scalar_type{"double", "double", 1};
template <>
inline constexpr ScalarType scalar_type<float>{"float", "float", 0};
template <>
inline constexpr ScalarType scalar_type<long double>{"long-double", "long double", 2};
template <>
inline constexpr ScalarType scalar_type<impulse::DoubleDouble>{"double-double", "double-double", 3};

/// The precision that a subject in S claims. DoubleDouble claims `extended`, whose significand is shorter.
template <class S>
inline constexpr Precision claimed_precision = precision_of<S>;
template <>
inline constexpr Precision claimed_precision<impulse::DoubleDouble> = Precision::extended;

/// Writes the outcome of `solve` into `into`, with the collision matrix if the solver formed one.
template <class S, class Solve, class Input>
void report_by(const Solve& solve, const Input& input, ReportedOutcome& into) {
  write_reported<S>(
      solve(input, [&](const auto& matrix) { into.collision_matrix.emplace(matrix.template cast<long double>()); }),
      into);
}

/// A kernel that calls `solve` with each input and an UnseenMatrix, and keeps the outcomes.
template <class S, class Input, class Solve>
[[nodiscard]] Kernel kernel_of(std::vector<Input> inputs, Solve solve) {
  struct Memory {
    std::vector<Input> inputs;
    std::vector<Outcome<S>> outcomes;
  };
  auto memory = std::make_shared<Memory>();
  memory->outcomes.resize(inputs.size());
  memory->inputs = std::move(inputs);
  return [memory, solve] {
    for (std::size_t i = 0; i < memory->inputs.size(); ++i) {
      memory->outcomes[i] = solve(memory->inputs[i], impulse::UnseenMatrix());
    }
  };
}

/// The solver of a law in words: "basis-free reflection by LDLᵀ".
[[nodiscard]] inline std::string description_in_words(Law law) {
  const impulse::Description description = impulse::description_of(law);
  return std::string(description.law) +
         (description.solve.empty() ? std::string() : " by " + std::string(description.solve));
}

struct MethodFacts {
  std::string name;
  std::string summary;
  Law law = Law::any;
  bool forms_matrix = true;  // whether it forms the collision matrix of a colliding contact
};

/// A method in S. `lay_out` makes an input from a collision. `solve` maps the input and an observer of the collision
/// matrix to an Outcome<S>.
template <class S, class LayOut, class Solve>
[[nodiscard]] Method method_of(MethodFacts facts, LayOut lay_out, Solve solve) {
  Method method;
  Subject& subject = method.subject;
  subject.name = std::move(facts.name) + '-' + std::string(scalar_type<S>.in_name);
  method.scalar = scalar_type<S>;
  subject.summary = std::move(facts.summary);
  subject.law = facts.law;
  subject.precision = claimed_precision<S>;
  subject.open = [lay_out, solve] {
    return session_of([lay_out, solve](const Collision& collision, ReportedOutcome& into) {
      report_by<S>(solve, lay_out(collision), into);
    });
  };
  subject.shows_collision_matrix = facts.forms_matrix;
  method.prepare = [lay_out, solve](std::span<const Collision> collisions) {
    std::vector<decltype(lay_out(collisions[0]))> inputs;
    inputs.reserve(collisions.size());
    for (const Collision& collision : collisions) {
      inputs.push_back(lay_out(collision));
    }
    return kernel_of<S>(std::move(inputs), solve);
  };
  return method;
}

/// A method whose solver maps a Contact<S, Inertia> and an observer of the collision matrix to an Outcome<S>.
template <class S, class Inertia = impulse::PrincipalInertia<S>, class Solve>
[[nodiscard]] Method solver_method(MethodFacts facts, Solve solve) {
  return method_of<S>(std::move(facts), impulse::make_contact<S, Inertia, double>, solve);
}

[[nodiscard]] inline Method with_form(Method method, MethodForm form) {
  method.form = form;
  return method;
}

[[nodiscard]] inline Method expected_to_fail(Method method, const std::string& why) {
  method.subject.expected_to_pass = false;
  method.subject.summary += "; " + why;
  return method;
}

}  // namespace carom::subjects
