// SPDX-License-Identifier: BSL-1.0
#pragma once

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
  MethodForm form = MethodForm::law;
};

/// A method in S. `lay_out` makes an input from a collision. `solve` maps the input and an observer of the collision
/// matrix to an Outcome<S>.
template <class S, class LayOut, class Solve>
[[nodiscard]] Method method_of(MethodFacts facts, LayOut lay_out, Solve solve) {
  Method method;
  Subject& subject = method.subject;
  subject.name = std::move(facts.name) + '-' + std::string(scalar_type<S>.in_name);
  method.form = facts.form;
  method.scalar = scalar_type<S>;
  subject.summary = std::move(facts.summary);
  subject.law = facts.law;
  subject.precision = claimed_precision<S>;
  subject.open = [lay_out, solve] {
    return session_of([lay_out, solve](const Collision& collision, ReportedOutcome& into) {
      write_reported<S>(
          solve(lay_out(collision),
                [&](const auto& matrix) { into.collision_matrix.emplace(matrix.template cast<long double>()); }),
          into);
    });
  };
  subject.shows_collision_matrix = facts.forms_matrix;
  method.prepare = [lay_out, solve](std::span<const Collision> collisions) -> Kernel {
    std::vector<decltype(lay_out(collisions[0]))> inputs;
    inputs.reserve(collisions.size());
    for (const Collision& collision : collisions) {
      inputs.push_back(lay_out(collision));
    }
    return [outcomes = std::vector<Outcome<S>>(inputs.size()), inputs = std::move(inputs), solve]() mutable {
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        outcomes[i] = solve(inputs[i], impulse::UnseenMatrix());
      }
    };
  };
  return method;
}

/// A method whose solver maps a Contact<S, Inertia> and an observer of the collision matrix to an Outcome<S>.
template <class S, class Inertia = impulse::PrincipalInertia<S>, class Solve>
[[nodiscard]] Method solver_method(MethodFacts facts, Solve solve) {
  return method_of<S>(std::move(facts), impulse::make_contact<S, Inertia, double>, solve);
}

[[nodiscard]] inline Method expected_to_fail(Method method, const std::string& why) {
  method.subject.expected_to_pass = false;
  method.subject.summary += "; " + why;
  return method;
}

}  // namespace carom::subjects
