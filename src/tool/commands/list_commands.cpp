// SPDX-License-Identifier: BSL-1.0
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/properties/cases/family.hpp>
#include <carom/properties/features/feature.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/report/results/lists.hpp>
#include <carom/subjects/catalogue.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;
using properties::in_words;

std::string joined(const std::vector<Law>& laws) {
  std::string text;
  for (const Law law : laws) {
    text += (text.empty() ? "" : ", ") + std::string(name_of(law));
  }
  return text;
}

/// The theorems of an invariant, each as `spelled`, separated by commas.
template <class Spelled>
std::string theorems_in_text(const properties::Invariant& invariant, const Spelled& spelled) {
  std::string text;
  for (const properties::Theorem& theorem : invariant.proof.theorems) {
    text += (text.empty() ? "" : ", ") + spelled(theorem);
  }
  return text;
}

/// The laws for which the invariant is proved: " of rough". Empty if these are all laws that claim the invariant.
std::string proved_of(const properties::Invariant& invariant) {
  const std::vector<Law> proved = invariant.proved_laws();
  return proved.size() == invariant.laws.size() ? "" : " of " + joined(proved);
}

std::string shown_in_text(const properties::Invariant& invariant) {
  const std::string theorems =
      theorems_in_text(invariant, [](const properties::Theorem& t) { return fmt::format("{} ({})", t.name, t.file); });
  return theorems.empty() ? "tested, not proved" : fmt::format("proved{}: {}", proved_of(invariant), theorems);
}

std::string shown_in_markdown(const properties::Invariant& invariant) {
  const std::string theorems = theorems_in_text(invariant, [](const properties::Theorem& t) {
    return fmt::format("[`{}`](../../properties/proofs/{})", t.name, t.file);
  });
  return theorems.empty() ? "Tested" : fmt::format("Proved{}, and tested: {}", proved_of(invariant), theorems);
}

std::string expectation(const Subject& subject) {
  if (!subject.absent.empty()) {
    return "absent: " + subject.absent;
  }
  return subject.expected_to_pass ? "expected to pass" : "expected to fail";
}

void print_json(const json& value) { fmt::print("{}\n", value.dump(2)); }

void print_markdown() {
  fmt::print(
      "# The invariants\n\nPrinted by `carom invariants --format markdown`; a test fails if this page "
      "differs.\n\nNotation: bodies A and B, masses m, world inertia J, lever arms r = P − X, velocities v, angular "
      "velocities w, before (−) and after (+) the impulse. V = V_A − V_B is the relative velocity of the material "
      "points at the contact. N is the normal, which points from B to A. F is the impulse on A, ε the restitution, and "
      "u the unit roundoff. *The note* is D. Eberly, \"Computing Impulse Forces for Colliding Contact\".\n\nAn "
      "equation g = 0 holds if it is exactly true for some inputs and outputs that differ from the given ones by at "
      "most the limit: |g| ≤ limit · u · (Σ ‖∂g/∂q‖ ‖q‖ + Σ ‖∂g/∂y⁺‖ (‖y⁺‖ + ‖y⁻‖)). The sums run over the quantities "
      "q of the input and the vectors y⁺ of the outcome; g is evaluated exactly. An output is the sum of the velocity "
      "before and a change, so its rounding error is u times the larger of both. An inequality has the same allowance "
      "on one side. A relation between two collisions has a rounding allowance for each outcome. Under `coulomb`, a "
      "relation is judged where friction cannot lead to several answers, as for spheres. "
      "[yardstick.md](yardstick.md) defines the quantities.\n\nTests check every invariant on solvers that round. "
      "*Proved* means that theorems prove it for exact laws, and that Coq checks these theorems. For a law that "
      "determines one outcome, they prove it for this outcome. For `coulomb` and for `any`, they prove it for every "
      "possible impulse. [proofs.md](../internals/proofs.md) lists the assumptions of the theorems.\n\n| invariant | "
      "statement | claimed for | domain | shown by |\n| --- | --- | --- | --- | --- |\n");
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    fmt::print("| [`{0}`](#{0}) | {1} | {2} | {3} | {4} |\n", invariant.name, invariant.statement,
               joined(invariant.laws), invariant.applies_to,
               invariant.proved_laws().empty() ? "test" : fmt::format("proof{}, and test", proved_of(invariant)));
  }
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    fmt::print("\n## {}\n\n{}\n\n$$ {} $$\n\n- Source: {}.\n- Claimed for: {}.\n- Domain: {}.\n- {}.\n", invariant.name,
               invariant.statement, invariant.formula, invariant.source, joined(invariant.laws), invariant.applies_to,
               shown_in_markdown(invariant));
  }
}

int list_subjects(const std::string& format) {
  json list = json::array();
  for (const Subject& subject : subjects::known_subjects()) {
    if (format == "json") {
      list.push_back({{"name", subject.name},
                      {"model", name_of(subject.law)},
                      {"precision", name_of(subject.precision)},
                      {"summary", subject.summary},
                      {"expected_to_pass", subject.expected_to_pass},
                      {"absent", subject.absent}});
    } else {
      fmt::print("{:40} {:13} {:9} {}\n    {}\n", subject.name, name_of(subject.law), name_of(subject.precision),
                 expectation(subject), subject.summary);
    }
  }
  if (format == "json") {
    print_json(list);
  }
  return exit_all_hold;
}

int list_invariants(const std::string& format) {
  if (format == "markdown") {
    print_markdown();
    return exit_all_hold;
  }
  if (format == "json") {
    print_json(report::invariants_list());
    return exit_all_hold;
  }
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    fmt::print("{}\n    {}\n    claimed for {}; {}\n    {}\n", invariant.name, invariant.statement,
               joined(invariant.laws), invariant.applies_to, shown_in_text(invariant));
  }
  return exit_all_hold;
}

int list_families(const std::string& format, std::uint64_t seed) {
  if (format == "json") {
    print_json(report::families_list(seed));
    return exit_all_hold;
  }
  for (const auto kind : {properties::all_families(), properties::families_beyond_domain()}) {
    for (const properties::Family& family : kind) {
      fmt::print("{}\n    {}{}\n{}", family.name, family.is_beyond_domain() ? "beyond the claimed domain: " : "",
                 family.summary, in_words(properties::drawn_case(family, seed, 0).collision, "      "));
    }
  }
  return exit_all_hold;
}

int list_features(const std::string& format) {
  if (format == "json") {
    print_json(report::features_list());
    return exit_all_hold;
  }
  if (format == "markdown") {
    fmt::print(
        "# The features\n\nPrinted by `carom features --format markdown`; a test fails if this page "
        "differs.\n\nFeatures are properties that collisions in scenes often have and random collisions do not: "
        "special values, relations between fields, near values and relations, and magnitudes. A near feature holds at "
        "a relative distance of 10⁻ᵏ from the special value, with k from 1 to 15. Each feature is a predicate of a "
        "valid collision. Carom evaluates it in binary64, like a condition in a solver. A feature with the prefix "
        "`a.` or `b.` is about that body. The families `structured` and `near_special` combine features. The report of "
        "a gate counts the features and their pairs.\n\n| feature | kind | what holds | why it is here |\n| --- | --- "
        "| --- | --- |\n");
  }
  for (const properties::Feature& feature : properties::all_features()) {
    if (format == "markdown") {
      fmt::print("| `{}` | {} | {} | {} |\n", feature.name, name_of(feature.kind), feature.statement, feature.why);
    } else {
      fmt::print("{:36} {:14} {}\n    {}\n", feature.name, name_of(feature.kind), feature.statement, feature.why);
    }
  }
  return exit_all_hold;
}

void add_list(CLI::App& app, Chosen& chosen, const char* name, const char* summary, std::vector<std::string> formats,
              int (*print)(const std::string& format)) {
  const auto format = std::make_shared<std::string>("text");
  CLI::App* command = app.add_subcommand(name, summary);
  add_format(*command, *format, std::move(formats));
  command->callback([&chosen, format, print] { chosen = [format, print] { return print(*format); }; });
}

void add_families(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    std::string format = "text";
    std::uint64_t seed = 1;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("families", "List the families of cases, each with an example");
  add_seed(*command, arguments->seed, "Seed of the examples");
  add_format(*command, arguments->format, {"text", "json"});
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return list_families(arguments->format, arguments->seed); }; });
}

}  // namespace

void add_lists(CLI::App& app, Chosen& chosen) {
  add_list(app, chosen, "subjects", "List the built-in subjects and engines", {"text", "json"}, list_subjects);
  add_list(app, chosen, "invariants", "List the invariants with their statements", {"text", "markdown", "json"},
           list_invariants);
  add_families(app, chosen);
  add_list(app, chosen, "features", "List the features of cases", {"text", "markdown", "json"}, list_features);
}

}  // namespace carom::tool
