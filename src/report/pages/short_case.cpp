// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/collision/json/text.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/document.hpp>
#include <carom/report/pages/short_case.hpp>

namespace carom::report {
namespace {

using properties::Verdict;

constexpr const char* further_line = "             ";

/// The first number of digits is for the eye. The others show smaller differences.
constexpr std::array numbers_of_digits{4, 8, 12, 17};

std::string rounded(double x, int digits) { return fmt::format("{:.{}g}", x + 0.0, digits); }  // −0 + 0 is 0

std::string rounded(const Vector3<double>& v, int digits = numbers_of_digits[0]) {
  return fmt::format("({}, {}, {})", rounded(v[0], digits), rounded(v[1], digits), rounded(v[2], digits));
}

std::string line_of(const char* name, const Body& body) {
  constexpr int digits = numbers_of_digits[0];
  std::string text = fmt::format("{}: ", name);
  if (body.immovable) {
    text += "immovable";
  } else {
    const Vector3<double>& moments = body.principal_inertia;
    const bool is_sphere = moments[0] == moments[1] && moments[1] == moments[2];
    text += fmt::format("mass {}, moments {}", rounded(body.mass, digits),
                        is_sphere ? rounded(moments[0], digits) : rounded(moments));
    if (const Quaternion<double>& q = body.orientation; q != Quaternion<double>{1, 0, 0, 0}) {
      text += fmt::format(", orientation ({}, {}, {}, {})", rounded(q[0], digits), rounded(q[1], digits),
                          rounded(q[2], digits), rounded(q[3], digits));
    }
  }
  text += ", at " + rounded(body.position);
  const bool moves = !body.velocity.isZero(0);
  const bool turns = !body.angular_velocity.isZero(0);
  text += moves ? ", velocity " + rounded(body.velocity) : "";
  text += turns ? ", spin " + rounded(body.angular_velocity) : "";
  return text + (moves || turns ? "" : ", at rest");
}

std::string line_of_contact(const Collision& c) {
  constexpr int digits = numbers_of_digits[0];
  std::string text = fmt::format("contact at {}, normal {}, restitution {}", rounded(c.point), rounded(c.normal),
                                 rounded(c.restitution, digits));
  text += c.friction == 0 ? "" : ", friction " + rounded(c.friction, digits);
  return text +
         (c.tangential_restitution == 0 ? "" : ", tangential restitution " + rounded(c.tangential_restitution, digits));
}

/// The answer of the law that the subject claims, and of several answers the nearest one.
struct LawAnswer {
  Outcome<double> outcome;
  std::size_t answers = 1;
};

/// None if the law determines no answer, or if the collision is invalid.
std::optional<LawAnswer> law_answer(const properties::JudgedCase& judged_case, Law law, const Answer& answer) {
  if (!judged_case.is_valid() || law == Law::any) {
    return std::nullopt;
  }
  const oracles::ExactCase& exact_case = judged_case.exact();
  if (law != Law::coulomb) {
    return LawAnswer{exact_case.nearest_truth(law)};
  }
  const std::vector<oracles::CoulombAnswer> answers = oracles::coulomb_answers(exact_case);
  const auto* outcome = std::get_if<ReportedOutcome>(&answer);
  const bool is_finite = outcome != nullptr && oracles::is_finite(*outcome);
  const std::size_t nearest = is_finite ? oracles::nearest_answer(exact_case, answers, *outcome).number : 0;
  return LawAnswer{
      map_outcome<double>(answers[nearest].truth.outcome, [](const auto& x) { return oracles::nearest_double(x); }),
      answers.size()};
}

constexpr PerVector<const char*> short_names{"A velocity", "A spin", "B velocity", "B spin"};

/// The vectors in which two outcomes differ visibly, for each kind of vector by its longest vector. If none does, all
/// that differ at all.
PerVector<bool> differing(const Outcome<double>& x, const Outcome<double>& y) {
  // A share of the longest vector. Rounding stays below it unless a case amplifies it by 10⁷ ulps, and a wrong formula
  // shows far above it. It decides which vectors are printed first, and never a verdict.
  constexpr double visible = 1e-9;
  const auto of_x = vectors(x);
  const auto of_y = vectors(y);
  PerVector<bool> differ{};
  for (const double least : {visible, 0.0}) {
    for (const bool of_a : {true, false}) {
      const std::array<OutcomeVector, 2> kinds = vectors_of_body(of_a);
      const std::array<OutcomeVector, 2> others = vectors_of_body(!of_a);
      for (std::size_t i = 0; i < kinds.size(); ++i) {
        double longest = 0;
        for (const OutcomeVector k : {kinds[i], others[i]}) {
          longest = std::max({longest, of_x[k]->norm(), of_y[k]->norm()});
        }
        // A comparison with NaN is false.
        differ[kinds[i]] = !((*of_x[kinds[i]] - *of_y[kinds[i]]).norm() <= least * longest);
      }
    }
    if (std::ranges::any_of(all_outcome_vectors, [&](OutcomeVector k) { return differ[k]; })) {
      break;
    }
  }
  return differ;
}

/// The vectors of an outcome, without rounding errors of a component far below the length of the vector.
std::string in_digits(const Outcome<double>& outcome, const PerVector<bool>& told, int digits) {
  const auto parts = vectors(outcome);
  std::vector<std::string> words;
  for (const OutcomeVector k : all_outcome_vectors) {
    if (told[k]) {
      Vector3<double> v = *parts[k];
      constexpr double negligible = 1e-9;  // far below the four digits that are printed
      const double length = v.norm();
      for (int i = 0; i < 3 && digits == numbers_of_digits[0]; ++i) {
        v[i] = std::abs(v[i]) <= negligible * length ? 0 : v[i];
      }
      words.push_back(fmt::format("{} {}", short_names[k], rounded(v, digits)));
    }
  }
  return words.empty() ? "no change" : fmt::format("{}", fmt::join(words, ", "));
}

void add_answers(std::vector<std::string>& lines, const Outcome<double>& before, const std::optional<LawAnswer>& law,
                 const std::optional<Outcome<double>>& answered) {
  const std::string of_law = !law || law->answers == 1 ? "law gives: " : "nearest answer of the law: ";
  if (law && answered) {
    const PerVector<bool> told = differing(law->outcome, *answered);
    for (const int digits : numbers_of_digits) {
      const std::string right = in_digits(law->outcome, told, digits);
      const std::string wrong = in_digits(*answered, told, digits);
      if (right != wrong) {
        lines.push_back(of_law + right);
        lines.push_back("answered:  " + wrong);
        break;
      }
    }
    return;
  }
  const auto changed = [&](const Outcome<double>& outcome) {
    return in_digits(outcome, differing(before, outcome), numbers_of_digits[0]);
  };
  if (law) {
    lines.push_back(of_law + changed(law->outcome));
  }
  if (answered) {
    lines.push_back("answered:  " + changed(*answered));
  }
}

/// The last lines of what a program wrote, without the request, because the collision stands above.
void add_said(std::vector<std::string>& lines, const std::string& said) {
  constexpr std::size_t most_lines = 3;
  constexpr std::size_t longest = 90;
  std::istringstream stream(said);
  std::vector<std::string> written;
  for (std::string line; std::getline(stream, line);) {
    if (line.find_first_not_of(' ') != std::string::npos && !line.starts_with("request: ")) {
      written.push_back(further_line + printable_line(line, longest));
    }
  }
  const std::size_t first = written.size() - std::min(written.size(), most_lines);
  lines.insert(lines.end(), written.begin() + static_cast<std::ptrdiff_t>(first), written.end());
}

std::string in_short(const Verdict& verdict) {
  constexpr std::size_t most_numbers = 3;
  if (verdict.left.empty()) {
    return verdict.detail;
  }
  const auto side = [](const std::vector<double>& numbers) {
    std::vector<std::string> words;
    std::ranges::transform(numbers, std::back_inserter(words),
                           [](double x) { return rounded(x, numbers_of_digits[0]); });
    return words.size() == 1 ? words[0] : fmt::format("({})", fmt::join(words, ", "));
  };
  const std::string left = side(verdict.left);
  const std::string right = side(verdict.right);
  return verdict.left.size() <= most_numbers && left != right
             ? fmt::format("{}: {} and {}", verdict.detail, left, right)
             : fmt::format("{}: apart by {:.3g}, allowed {:.3g}", verdict.detail, verdict.residual, verdict.allowed);
}

}  // namespace

std::string short_case(const properties::Witness& witness, const Subject& subject) {
  const Collision& collision = witness.shrunk.collision;
  std::vector<std::string> lines{line_of("A", collision.a), line_of("B", collision.b), line_of_contact(collision)};
  const properties::JudgedCase judged_case(witness.shrunk, true, subject.effects);
  std::optional<LawAnswer> law;
  (void)properties::why_failed([&] { law = law_answer(judged_case, subject.law, witness.answer); });
  std::optional<Outcome<double>> answered;
  if (const auto* outcome = std::get_if<ReportedOutcome>(&witness.answer)) {
    answered =
        map_outcome<double>(Outcome<long double>(*outcome), [](long double x) { return static_cast<double>(x); });
  }
  if (!judged_case.is_valid()) {
    lines.push_back("to refuse: " + describe(validate(collision)));
  }
  add_answers(lines, unchanged(collision), law, answered);
  if (const auto* refused = std::get_if<Refused>(&witness.answer)) {
    lines.push_back("answered:  a refusal, " + refused->why);
  } else if (const auto* failed = std::get_if<Failed>(&witness.answer)) {
    lines.push_back("answered:  " + failed->why);
    add_said(lines, failed->said);
  }
  lines.push_back(fmt::format("It violates {}: {}", witness.invariant->name, in_short(witness.verdict)));
  std::string text;
  for (const std::string& line : lines) {
    text += wrapped("  " + line, further_line) + '\n';
  }
  return text;
}

}  // namespace carom::report
