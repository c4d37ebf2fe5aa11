// SPDX-License-Identifier: BSL-1.0
#include "report/html_witness.hpp"

#include <array>

#include <fmt/format.h>

#include <carom/oracles/judge/coulomb_case.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/trial/in_words.hpp>

#include "report/contact_drawing.hpp"
#include "report/findings_text.hpp"
#include "report/formula.hpp"
#include "report/html_tables.hpp"
#include "report/markup.hpp"

namespace carom::tool {
namespace {

using oracles::Rational;
using properties::in_words;
using properties::Witness;

/// A table whose rows begin with their header.
class Rows {
 public:
  Rows(pugi::xml_node section, const std::string& caption, const std::vector<std::string>& columns)
      : table_(add_table(section, caption, "numbers")) {
    add_column_headers(table_, columns);
    body_ = add(table_, "tbody");
  }

  void add_row(const std::string& name, const std::vector<std::string>& cells) {
    const pugi::xml_node row = add(body_, "tr");
    add(row, "th", {{"scope", "row"}}, name);
    for (const std::string& cell : cells) {
      add(row, "td", {}, cell);
    }
  }

 private:
  pugi::xml_node table_;
  pugi::xml_node body_;
};

std::string vector_text(const Quaternion<double>& q) {
  return fmt::format("({}, {}, {}, {})", in_words(q[0]), in_words(q[1]), in_words(q[2]), in_words(q[3]));
}

void add_collision(pugi::xml_node section, const Collision& c) {
  Rows bodies(section, "Both bodies before the impulse", {"", "A", "B"});
  const auto row = [&](const char* name, bool of_movable, const auto& text) {
    const auto cell = [&](const Body& body) { return of_movable && body.immovable ? std::string("–") : text(body); };
    bodies.add_row(name, {cell(c.a), cell(c.b)});
  };
  row("mass", false, [](const Body& b) { return b.immovable ? std::string("immovable") : in_words(b.mass); });
  row("principal inertia", true, [](const Body& b) { return in_words(b.principal_inertia); });
  row("orientation", true, [](const Body& b) { return vector_text(b.orientation); });
  row("position", false, [](const Body& b) { return in_words(b.position); });
  row("velocity", false, [](const Body& b) { return in_words(b.velocity); });
  row("angular velocity", false, [](const Body& b) { return in_words(b.angular_velocity); });

  Rows contact(section, "The contact", {"", "value"});
  contact.add_row("point P", {in_words(c.point)});
  contact.add_row("normal N", {in_words(c.normal)});
  contact.add_row("restitution ε", {in_words(c.restitution)});
  if (c.friction != 0 || c.tangential_restitution != 0) {
    contact.add_row("friction μ", {in_words(c.friction)});
    contact.add_row("tangential restitution", {in_words(c.tangential_restitution)});
  }
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

/// A column of velocities that an outcome can be compared with.
struct Column {
  std::string title;
  PerVector<std::string> velocities;
};

/// What is exact for a subject of this model: the truth, all answers of a law that may have several, or where no law is
/// claimed the truth of each.
std::vector<Column> exact_columns(const oracles::ExactCase& exact_case, Model claimed) {
  std::vector<Column> columns;
  if (claimed == Model::coulomb) {
    for (const oracles::CoulombAnswer& answer : oracles::coulomb_answers(exact_case)) {
      columns.push_back({fmt::format("answer, {}", name_of(answer.kind)), velocities_in_words(answer.truth.outcome)});
    }
    return columns;
  }
  for (const Model model : models_with_truth) {
    if (claimed == model || claimed == Model::any) {
      exact_case.with_truth(model, exact_case.approach(), [&](const auto& truth) {
        columns.push_back({claimed == model ? "exact" : fmt::format("exact, {}", name_of(model)),
                           velocities_in_words(truth.outcome)});
      });
    }
  }
  return columns;
}

void add_outcome(pugi::xml_node section, const Witness& witness, const properties::JudgedCase& judged_case,
                 Model claimed) {
  if (const auto* refused = std::get_if<Refused>(&witness.answer)) {
    add(section, "p", {}, "The subject refused it:");
    add(section, "pre", {{"tabindex", "0"}}, refused->why);
  }
  if (const auto* failed = std::get_if<Failed>(&witness.answer); failed != nullptr && !failed->said.empty()) {
    add(section, "p", {}, "What it was asked, and what it wrote on standard error:");
    add(section, "pre", {{"tabindex", "0"}}, failed->said);
  }
  const auto* computed = std::get_if<ReportedOutcome>(&witness.answer);
  std::vector<std::string> columns{""};
  std::vector<Column> exact;
  if (computed != nullptr) {
    columns.emplace_back("computed");
  }
  if (judged_case.is_valid()) {
    exact = exact_columns(judged_case.exact(), claimed);
    for (const Column& column : exact) {
      columns.push_back(column.title);
    }
  }
  if (columns.size() == 1) {
    return;
  }
  Rows rows(section, "Both bodies after the impulse", columns);
  constexpr PerVector<const char*> names{"velocity of A", "angular velocity of A", "velocity of B",
                                         "angular velocity of B"};
  for (const OutcomeVector k : all_outcome_vectors) {
    std::vector<std::string> cells;
    if (computed != nullptr) {
      cells.push_back(in_words(*vectors(*computed)[k]));
    }
    for (const Column& column : exact) {
      cells.push_back(column.velocities[k]);
    }
    rows.add_row(names[k], cells);
  }
}

void add_sides(pugi::xml_node section, const properties::Verdict& verdict) {
  if (verdict.left.empty()) {
    add(section, "p", {{"class", "sides"}}, verdict.detail);
    return;
  }
  Rows rows(section, "What was compared: " + verdict.detail, {"", "value"});
  rows.add_row("left side", {in_words(verdict.left)});
  rows.add_row("right side", {in_words(verdict.right)});
  rows.add_row("apart by", {fmt::format("{:.3g}", verdict.residual)});
  rows.add_row("allowed", {fmt::format("{:.3g}", verdict.allowed)});
}

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

void add_drawing(pugi::xml_node section, const Witness& witness, const properties::JudgedCase& judged_case,
                 Model claimed, const std::string& anchor, const std::string& title) {
  if (!judged_case.is_valid()) {
    add(section, "p", {}, "The collision is invalid: there is nothing to draw.");
    return;
  }
  const oracles::ExactCase& exact_case = judged_case.exact();
  const Collision& collision = witness.shrunk.collision;
  ContactPicture picture{collision, motion_of(collision, unchanged(exact_case.exact())), std::nullopt, std::nullopt};
  const auto* computed = std::get_if<ReportedOutcome>(&witness.answer);
  if (computed != nullptr && oracles::is_finite(*computed)) {
    picture.computed = motion_of(collision, oracles::lift(*computed));
  }
  if (claimed == Model::coulomb) {
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

/// The case that the family drew, which the witness was shrunk from.
void add_drawn_case(pugi::xml_node article, const Witness& witness, const std::string& replay) {
  const pugi::xml_node details = add(article, "details");
  add(details, "summary", {},
      fmt::format("As drawn: case {} of the family {}, before it was shrunk", witness.index, witness.family));
  add_collision(details, witness.original.collision);
  add_sides(details, witness.verdict_as_found);
  add(details, "pre", {{"tabindex", "0"}}, replay + " --drawn");
}

void add_witness(pugi::xml_node section, const GateRun& run, std::size_t subject, const Witness& witness,
                 const std::filesystem::path& out_directory) {
  const properties::SubjectResult& result = run.report.results[subject];
  const properties::Invariant& invariant = *properties::invariant_named(witness.invariant);
  const properties::Count count = result.count(witness.invariant);
  const std::string anchor = witness_anchor(subject, witness.invariant);
  const std::string title = result.subject.name + " violates " + witness.invariant;
  const pugi::xml_node article = add(section, "article", {{"id", anchor}, {"aria-labelledby", anchor + "-heading"}});
  add(article, "h4", {{"id", anchor + "-heading"}}, title);
  add(article, "p", {},
      fmt::format("{} Violated in {} of {} cases; this one comes from the family {}.", invariant.statement,
                  count.violated, count.violated + count.holds, witness.family));
  add_formula(add(article, "div", {{"class", "formula"}, {"tabindex", "0"}}), invariant.formula);
  const properties::JudgedCase judged_case(witness.shrunk);
  const pugi::xml_node columns = add(article, "div", {{"class", "columns"}});
  const pugi::xml_node numbers = add(columns, "div", {{"class", "witness-numbers"}});
  add_collision(numbers, witness.shrunk.collision);
  add_outcome(numbers, witness, judged_case, result.subject.model);
  add_sides(numbers, witness.verdict);
  const pugi::xml_node pictures = add(columns, "div", {{"class", "pictures"}});
  add_drawing(pictures, witness, judged_case, result.subject.model, anchor, title);
  const std::filesystem::path file = witness_path(out_directory, result.subject, witness);
  add(article, "p", {}, "To replay it:");
  add(article, "pre", {{"tabindex", "0"}}, replay_command(file, result.subject, run.report.options.yardstick));
  add_drawn_case(article, witness, replay_command(file, result.subject, run.report.options.yardstick));
}

}  // namespace

void add_witnesses(pugi::xml_node section, const GateRun& run, const std::filesystem::path& out_directory) {
  bool any = false;
  for (const bool counts : {true, false}) {
    for (std::size_t s = 0; s < run.report.results.size(); ++s) {
      const properties::SubjectResult& result = run.report.results[s];
      if (run.counts[s] != counts || result.witnesses.empty()) {
        continue;
      }
      any = true;
      const pugi::xml_node of_subject = add(section, "section");
      add(of_subject, "h3", {}, result.subject.name + (counts ? "" : " (kept because it fails)"));
      for (const Witness* witness : witnesses_by_telling(run, s)) {
        add_witness(of_subject, run, s, *witness, out_directory);
      }
    }
  }
  if (!any) {
    add(section, "p", {}, "Nothing was violated: there is no witness.");
  }
}

}  // namespace carom::tool
