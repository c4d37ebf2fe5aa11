// SPDX-License-Identifier: BSL-1.0
#include <cstddef>
#include <optional>
#include <vector>

#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/report/pages/case_drawing.hpp>
#include <carom/report/pictures/contact_drawing.hpp>
#include <carom/report/pictures/markup.hpp>

namespace carom::report {
namespace {

template <class T>
Motion motion_of(const Collision& collision, const Outcome<T>& outcome) {
  const auto exact = map_numbers<T>(collision, [](double x) { return T(x); });
  const Vector3<T> relative = oracles::relative_velocity<T>(exact, outcome);
  Motion motion{map_outcome<double>(outcome, [](const T& x) { return oracles::nearest_double(x); }), {}};
  for (int i = 0; i < 3; ++i) {
    motion.relative_velocity[i] = oracles::nearest_double(relative[i]);
  }
  return motion;
}

}  // namespace

void add_case_drawing(pugi::xml_node section, const properties::JudgedCase& judged_case, const Answer& answer,
                      Law claimed, const std::string& anchor, const std::string& title) {
  if (!judged_case.is_valid()) {
    add(section, "p", {}, "The collision is invalid, so there is no drawing.");
    return;
  }
  const oracles::ExactCase& exact_case = judged_case.exact();
  const Collision& collision = judged_case.generated().collision;
  ContactPicture picture{collision, motion_of(collision, unchanged(exact_case.exact())), std::nullopt, std::nullopt};
  const auto* computed = std::get_if<ReportedOutcome>(&answer);
  if (computed != nullptr && oracles::is_finite(*computed)) {
    picture.computed = motion_of(collision, oracles::lift(*computed));
  }
  if (claimed == Law::coulomb) {
    const std::vector<oracles::CoulombAnswer> answers = oracles::coulomb_answers(exact_case);
    const bool is_finite = computed != nullptr && oracles::is_finite(*computed);
    const std::size_t nearest = is_finite ? oracles::nearest_answer(exact_case, answers, *computed).number : 0;
    picture.exact = motion_of(collision, answers[nearest].truth.outcome);
  } else if (determines_outcome(claimed)) {
    exact_case.with_truth(claimed, exact_case.approach(),
                          [&](const auto& truth) { picture.exact = motion_of(collision, truth.outcome); });
  }
  add_contact_figure(section, picture, anchor, title);
}

}  // namespace carom::report
