// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <carom/collision/subject.hpp>
#include <carom/collision/validate.hpp>
#include <carom/impulse/contact.hpp>

namespace carom::conformance {

/// A callable const impulse::Contact<S>& → Outcome<S> or SolvedOutcome<S>.
template <class Solver, class S>
concept SolvesContacts = std::is_invocable_r_v<Outcome<S>, Solver&, const impulse::Contact<S>&>;

namespace detail {

template <class S>
S scalar_of(const Outcome<S>&);

template <class Solver>
using ScalarOfOutcome = decltype(scalar_of(std::declval<std::invoke_result_t<Solver&, const Collision&>>()));

/// The scalar type S of the solver, deduced from its signature.
template <class Solver>
[[nodiscard]] constexpr auto deduced_scalar() {
  constexpr int contacts = int{SolvesContacts<Solver, float>} + int{SolvesContacts<Solver, double>} +
                           int{SolvesContacts<Solver, long double>};
  static_assert(contacts <= 1,
                "the callable solves contacts of several scalar types: choose one, for example subject<double>(…)");
  if constexpr (SolvesContacts<Solver, float>) {
    return float{};
  } else if constexpr (SolvesContacts<Solver, double>) {
    return double{};
  } else if constexpr (SolvesContacts<Solver, long double>) {
    return static_cast<long double>(0);
  } else {
    static_assert(std::is_invocable_v<Solver&, const Collision&>,
                  "a subject is a callable const impulse::Contact<S>& → Outcome<S>, or const Collision& → Outcome<S>");
    return ScalarOfOutcome<Solver>{};
  }
}

template <class S, class Solver>
[[nodiscard]] Answer answer(Solver& solver, const Collision& collision) {
  const std::vector<InputError> errors = validate(collision);
  if (!errors.empty()) {
    return Refused{describe(errors)};
  }
  const auto solved = [&] {
    if constexpr (SolvesContacts<Solver, S>) {
      return solver(impulse::make_contact<S>(collision));
    } else {
      return solver(collision);
    }
  };
  return reported(SolvedOutcome<S>(solved()));
}

template <class Solver, class S>
[[nodiscard]] constexpr bool shows_matrix() {
  if constexpr (SolvesContacts<Solver, S>) {
    return std::is_same_v<std::invoke_result_t<Solver&, const impulse::Contact<S>&>, SolvedOutcome<S>>;
  } else {
    return std::is_same_v<std::invoke_result_t<Solver&, const Collision&>, SolvedOutcome<S>>;
  }
}

}  // namespace detail

/// Makes a subject of a callable. The callable solves contacts (const impulse::Contact<S>& → Outcome<S>) or collisions
/// (const Collision& → Outcome<S>). S is float, double or long double. Give S explicitly if the callable takes contacts
/// of any scalar type. Every session has a copy of the callable. The default precision is that of S.
///
/// If the callable returns SolvedOutcome<S>, its collision matrix is judged too. The kit itself refuses invalid
/// collisions, so the subject does not claim `invalid_refused`.
template <class S = void, class Solver>
[[nodiscard]] Subject subject(std::string name, Law law, Solver solver,
                              std::optional<Precision> precision = std::nullopt) {
  if constexpr (std::is_void_v<S>) {
    return subject<decltype(detail::deduced_scalar<Solver>())>(std::move(name), law, std::move(solver), precision);
  } else {
    static_assert(std::is_same_v<S, float> || std::is_same_v<S, double> || std::is_same_v<S, long double>);
    Subject made;
    made.name = std::move(name);
    made.law = law;
    made.precision = precision.value_or(precision_of<S>);
    made.deviates = {"invalid_refused"};
    made.shows_collision_matrix = detail::shows_matrix<Solver, S>();
    made.open = [solver = std::move(solver)]() -> Session {
      return [own = solver](std::span<const Collision> collisions) mutable {
        std::vector<Answer> answers;
        for (const Collision& collision : collisions) {
          answers.push_back(detail::answer<S>(own, collision));
        }
        return answers;
      };
    };
    return made;
  }
}

}  // namespace carom::conformance
