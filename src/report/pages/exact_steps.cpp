// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <fmt/format.h>

#include <carom/oracles/bounds/norm.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/exact_steps.hpp>

namespace carom::report {
namespace {

using oracles::Approach;
using oracles::Rational;
using properties::in_words;

const char* name_of(oracles::Branch branch) {
  switch (branch) {
    case oracles::Branch::inside_cone:
      return ", inside the friction cone";
    case oracles::Branch::on_cone:
      return ", on the friction cone";
    case oracles::Branch::only:
      break;
  }
  return "";
}

template <class T>
std::string truth_steps(const BasicCollision<T>& c, const oracles::Truth<T>& truth, Approach approach) {
  const Vector3<T> after = oracles::relative_velocity<T>(c, truth.outcome);
  std::string text = fmt::format("  F = {}\n", in_words(truth.impulse));
  const auto parts = vectors(truth.outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    text += fmt::format("  {}⁺ = {}\n", carom::name_of(k), in_words(*parts[k]));
  }
  text += fmt::format("  V⁺ = {}\n  N·V⁺ = {}\n", in_words(after), in_words(T(c.normal.dot(after))));
  if (approach != Approach::inert) {
    const auto energy = oracles::equation::Energy{}(c, truth.outcome);
    text += fmt::format("  E⁺ − E⁻ − W = {}\n", in_words(T(energy.left[0] - energy.right[0])));
  }
  return text;
}

}  // namespace

const char* in_words_of(Approach approach) {
  switch (approach) {
    case Approach::colliding:
      return "colliding";
    case Approach::resting:
      return "resting";
    case Approach::separating:
      return "separating";
    case Approach::inert:
      break;
  }
  return "both bodies are immovable";
}

std::string contact_steps(const oracles::ExactCase& exact_case) {
  const BasicCollision<Rational>& c = exact_case.exact();
  const Outcome<Rational> before = unchanged(c);
  const Matrix3<Rational>& k = exact_case.collision_matrix();
  std::string text =
      fmt::format("  r_A = P − X_A = {}\n  r_B = P − X_B = {}\n", in_words<Rational>(oracles::lever_arm(c.a, c.point)),
                  in_words<Rational>(oracles::lever_arm(c.b, c.point)));
  const Rational normal_velocity = oracles::normal_velocity_before(c);
  const double length = oracles::norm_of(exact_case.collision().normal);
  text += fmt::format(
      "  V⁻ = {}\n  N·V⁻ = {}: {}{}\n", in_words<Rational>(oracles::relative_velocity<Rational>(c, before)),
      in_words(normal_velocity), in_words_of(exact_case.approach()),
      length == 1 || normal_velocity == 0 ? ""
                                          : fmt::format(", at {:.3g} m/s along the normal",
                                                        std::abs(oracles::nearest_double(normal_velocity)) / length));
  if (exact_case.approach() != Approach::inert) {
    text += fmt::format("  λ = {}\n", in_words(oracles::inverse_mass(c)));
    for (int row = 0; row < 3; ++row) {
      text += fmt::format("  {} {}\n", row == 0 ? "K =" : "   ", in_words<Rational>(Vector3<Rational>(k.row(row))));
    }
  }
  return text;
}

std::string truth_steps(const oracles::ExactCase& exact_case, Law law) {
  const Approach approach = exact_case.approach();
  const bool collides = approach == Approach::colliding;
  return fmt::format("{}, exactly{}\n", carom::name_of(law), collides ? name_of(exact_case.branch(law)) : "") +
         exact_case.with_truth(law, approach, [&]<class T>(const oracles::Truth<T>& truth) {
           const auto lifted = [](double number) { return T(number); };
           return truth_steps<T>(map_numbers<T>(exact_case.collision(), lifted), truth, approach);
         });
}

std::string answers_steps(const oracles::ExactCase& exact_case, const std::vector<oracles::CoulombAnswer>& answers) {
  std::string text;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const oracles::CoulombAnswer& answer = answers[i];
    text += fmt::format("coulomb, answer {} of {}, {}{}\n{}", i + 1, answers.size(), name_of(answer.kind),
                        answer.is_exact() ? ", exactly" : ", with 36 digits of its resistance to slip",
                        truth_steps(exact_case.exact(), answer.truth, exact_case.approach()));
  }
  return text;
}

}  // namespace carom::report
