// SPDX-License-Identifier: BSL-1.0

#include <fmt/format.h>

#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/pages/shown_case.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using oracles::Rational;
using properties::in_words;
using properties::Witness;

std::string vector_text(const Quaternion<double>& q) {
  return fmt::format("({}, {}, {}, {})", in_words(q[0]), in_words(q[1]), in_words(q[2]), in_words(q[3]));
}

Table numbers_table(std::string caption, const std::vector<std::string>& columns) {
  Table table{std::move(caption), {}, {}, "numbers"};
  for (const std::string& column : columns) {
    table.columns.push_back({column});
  }
  return table;
}

void add_collision(Document& document, const Collision& c) {
  Table bodies = numbers_table("Both bodies before the impulse", {"", "A", "B"});
  const auto row = [&](const char* name, bool of_movable, const auto& text) {
    const auto cell = [&](const Body& body) {
      return of_movable && body.immovable ? std::string(no_number) : text(body);
    };
    bodies.rows.push_back({{name, cell(c.a), cell(c.b)}});
  };
  row("mass", false, [](const Body& b) { return b.immovable ? std::string("immovable") : in_words(b.mass); });
  row("principal inertia", true, [](const Body& b) { return in_words(b.principal_inertia); });
  row("orientation", true, [](const Body& b) { return vector_text(b.orientation); });
  row("position", false, [](const Body& b) { return in_words(b.position); });
  row("velocity", false, [](const Body& b) { return in_words(b.velocity); });
  row("angular velocity", false, [](const Body& b) { return in_words(b.angular_velocity); });
  document.emplace_back(std::move(bodies));

  Table contact = numbers_table("The contact", {"", "value"});
  contact.rows = {{{"point P", in_words(c.point)}},
                  {{"normal N", in_words(c.normal)}},
                  {{"restitution ε", in_words(c.restitution)}}};
  if (c.friction != 0 || c.tangential_restitution != 0) {
    contact.rows.push_back({{"friction μ", in_words(c.friction)}});
    contact.rows.push_back({{"tangential restitution", in_words(c.tangential_restitution)}});
  }
  document.emplace_back(std::move(contact));
}

template <class T>
PerVector<std::string> velocities_in_words(const Outcome<T>& outcome) {
  PerVector<std::string> words;
  const auto of_bodies = vectors(outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    words[k] = in_words<T>(*of_bodies[k]);
  }
  return words;
}

/// A column of velocities, to compare an outcome with.
struct VelocityColumn {
  std::string title;
  PerVector<std::string> velocities;
};

/// The exact velocities for a subject that claims a law. A law that may have several answers has a column for each
/// answer. If the subject claims no law, there is a column for the exact outcome of each law.
std::vector<VelocityColumn> exact_columns(const oracles::ExactCase& exact_case, Law claimed) {
  std::vector<VelocityColumn> columns;
  if (claimed == Law::coulomb) {
    for (const oracles::CoulombAnswer& answer : oracles::coulomb_answers(exact_case)) {
      columns.push_back({fmt::format("answer, {}", name_of(answer.kind)), velocities_in_words(answer.truth.outcome)});
    }
    return columns;
  }
  for (const Law law : laws_with_truth) {
    if (claimed == law || claimed == Law::any) {
      exact_case.with_truth(law, exact_case.state(), [&](const auto& truth) {
        columns.push_back(
            {claimed == law ? "exact" : fmt::format("exact, {}", name_of(law)), velocities_in_words(truth.outcome)});
      });
    }
  }
  return columns;
}

void add_outcome(Document& document, const Witness& witness, const properties::JudgedCase& judged_case, Law claimed) {
  if (const auto* refused = std::get_if<Refused>(&witness.answer)) {
    document.emplace_back(Paragraph{"The subject refused it:"});
    document.emplace_back(Code{refused->why});
  }
  if (const auto* failed = std::get_if<Failed>(&witness.answer); failed != nullptr && !failed->said.empty()) {
    document.emplace_back(Paragraph{"More about the failure:"});
    document.emplace_back(Code{failed->said});
  }
  std::vector<VelocityColumn> columns;
  if (const auto* computed = std::get_if<ReportedOutcome>(&witness.answer)) {
    VelocityColumn of_subject{"computed", {}};
    for (const OutcomeVector k : all_outcome_vectors) {
      of_subject.velocities[k] = in_words(*vectors(*computed)[k]);
    }
    columns.push_back(std::move(of_subject));
  }
  if (judged_case.is_valid()) {
    const std::string why_missing = properties::why_failed([&] {
      for (VelocityColumn& exact : exact_columns(judged_case.exact(), claimed)) {
        columns.push_back(std::move(exact));
      }
    });
    if (!why_missing.empty()) {
      document.emplace_back(Paragraph{"The exact outcome is missing: " + why_missing});
    }
  }
  if (columns.empty()) {
    return;
  }
  Table table = numbers_table("Both bodies after the impulse", {""});
  for (const VelocityColumn& column : columns) {
    table.columns.push_back({column.title});
  }
  constexpr PerVector<const char*> names{"velocity of A", "angular velocity of A", "velocity of B",
                                         "angular velocity of B"};
  for (const OutcomeVector k : all_outcome_vectors) {
    Row row{{names[k]}};
    for (const VelocityColumn& column : columns) {
      row.cells.emplace_back(column.velocities[k]);
    }
    table.rows.push_back(std::move(row));
  }
  document.emplace_back(std::move(table));
}

void add_sides(Document& document, const properties::Verdict& verdict) {
  if (verdict.left.empty()) {
    document.emplace_back(Paragraph{verdict.detail, "sides"});
    return;
  }
  Table table = numbers_table("The two sides: " + verdict.detail, {"", "value"});
  table.rows = {{{"left side", in_words(verdict.left)}},
                {{"right side", in_words(verdict.right)}},
                {{"difference", fmt::format("{:.3g}", verdict.residual)}},
                {{"allowed", fmt::format("{:.3g}", verdict.allowed)}}};
  document.emplace_back(std::move(table));
}

/// The case that the family drew, before it was shrunk to the witness.
Details drawn_case(const Witness& witness, const std::string& replay) {
  Details details{
      fmt::format("The original case before shrinking: case {} of the family {}", witness.index, witness.family->name),
      {}};
  add_collision(details.content, witness.original.collision);
  add_sides(details.content, witness.verdict_as_found);
  details.content.emplace_back(Code{replay + " --drawn"});
  return details;
}

Section witness_section(const Run& run, std::size_t s, const Witness& witness, const std::string& out_directory) {
  const properties::SubjectResult& result = run.results[s];
  const properties::Invariant& invariant = *witness.invariant;
  const std::string anchor = witness_anchor(s, invariant);
  const std::string title = fmt::format("{} violates {}", result.subject.name, invariant.name);
  const std::string replay = replay_line(run, result.subject, witness, out_directory);
  Document numbers;
  add_collision(numbers, witness.shrunk.collision);
  if (const std::string effects = properties::to_text(result.subject.effects); !effects.empty()) {
    numbers.emplace_back(Paragraph{"The subject declares " + effects +
                                   ". The exact outcome is the law's, before damping and limits of speeds."});
  }
  // The picture refers to the witness, so the page must be written while the run exists.
  const auto judged_case = std::make_shared<const properties::JudgedCase>(witness.shrunk, true, result.subject.effects);
  add_outcome(numbers, witness, *judged_case, result.subject.law);
  add_sides(numbers, witness.verdict);
  if (!witness.not_shrunk.empty()) {
    numbers.emplace_back(Paragraph{not_shrunk_in_words(witness)});
  }
  Picture picture{
      [&answer = witness.answer, judged_case, law = result.subject.law, anchor, title](pugi::xml_node node) {
        const std::string why_missing =
            properties::why_failed([&] { add_case_drawing(node, *judged_case, answer, law, anchor, title); });
        if (!why_missing.empty()) {
          add(node, "p", {}, "The drawing is missing: " + why_missing);
        }
      }};
  Document content{Paragraph{fmt::format("{} The subject violates this in {}. This witness comes from the family {}.",
                                         invariant.statement, violated_of_judged_cases(result.count(invariant)),
                                         witness.family->name)},
                   Picture{[formula = invariant.formula](pugi::xml_node node) {
                     add_formula(add(node, "div", {{"class", "formula"}, {"tabindex", "0"}}), formula);
                   }},
                   Box{"columns", {Box{"witness-numbers", std::move(numbers)}, Box{"pictures", {std::move(picture)}}}},
                   Paragraph{"To replay this witness:"},
                   Code{replay},
                   drawn_case(witness, replay)};
  return {title, std::move(content), anchor, "article"};
}

}  // namespace

std::string witness_anchor(std::size_t subject, const properties::Invariant& invariant) {
  return fmt::format("witness-{}-{}", subject, invariant.name);
}

Document witnesses_part(const Run& run, const std::string& out_directory) {
  Document document;
  for (const bool counts : {true, false}) {
    for (std::size_t s = 0; s < run.results.size(); ++s) {
      const properties::SubjectResult& result = run.results[s];
      if (run.counts[s] != counts || result.witnesses.empty()) {
        continue;
      }
      Section section{result.subject.name + (counts ? "" : " (kept because it fails)"), {}};
      for (const Witness* witness : witnesses_by_telling(run, s)) {
        section.content.emplace_back(witness_section(run, s, *witness, out_directory));
      }
      document.emplace_back(std::move(section));
    }
  }
  if (document.empty()) {
    document.emplace_back(Paragraph{"There are no violations, and so no witnesses."});
  }
  return document;
}

}  // namespace carom::report
