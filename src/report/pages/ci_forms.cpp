// SPDX-License-Identifier: BSL-1.0
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include <carom/collision/json/text.hpp>
#include <carom/properties/diagnosis/where.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/pages/parts.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::in_words;

std::string failure_text(const properties::Witness& witness) {
  return std::string(witness.invariant->statement) + '\n' + in_words(witness.shrunk.collision, "  ") +
         in_words(witness.verdict);
}

pugi::xml_node add_test(pugi::xml_node suite, const std::string& subject, std::string_view name) {
  // The gate does not time invariants, but programs that read the file require a number.
  return add(suite, "testcase", {{"classname", subject}, {"name", name}, {"time", "0"}});
}

/// How a violation counts: as a failure, as expected of this subject, or as known from the baseline.
enum class Standing { failure, expected, known };

Standing standing_of(const Run& run, std::size_t subject, const properties::Invariant& invariant) {
  if (!run.counts[subject]) {
    return Standing::expected;
  }
  const bool known = run.baseline && is_known(*run.baseline, run.results[subject].subject.name, invariant);
  return known ? Standing::known : Standing::failure;
}

const char* said_of(Standing standing) {
  switch (standing) {
    case Standing::expected:
      return "; expected to fail";
    case Standing::known:
      return "; known from the baseline";
    case Standing::failure:
      break;
  }
  return "";
}

void add_case(pugi::xml_node suite, const properties::SubjectResult& result, const properties::Invariant& invariant,
              Standing standing) {
  const pugi::xml_node test = add_test(suite, result.subject.name, invariant.name);
  const properties::Count count = result.count(invariant);
  if (count.violated == 0) {
    if (count.holds == 0) {
      add(test, "skipped", {{"message", "no case judged it"}});
    }
    return;
  }
  for (const properties::Witness& witness : result.witnesses) {
    if (witness.invariant == &invariant) {
      const std::string message = fmt::format("{} violate it{}", violated_of_judged_cases(count), said_of(standing));
      if (standing == Standing::failure) {
        add(test, "failure", {{"message", message}, {"type", "violated"}}, failure_text(witness));
      } else {
        add(test, "skipped", {{"message", message}}, failure_text(witness));
      }
      add(test, "system-out", {}, "witness: " + witness_path("", result.subject, invariant));
    }
  }
}

double seconds_of(const properties::SubjectResult& result) {
  constexpr double nanosecond = 1e-9;
  return result.nanoseconds_per_solve * nanosecond * static_cast<double>(result.cases());
}

/// JUnit requires properties before the tests, and none if there is no property.
void add_properties(pugi::xml_node suite, const Run& run, std::size_t subject) {
  const properties::SubjectResult& result = run.results[subject];
  const pugi::xml_node list = add(suite, "properties");
  const auto add_property = [&](const std::string& name, const std::string& value) {
    add(list, "property", {{"name", name}, {"value", value}});
  };
  for (const properties::diagnosis::Fault& fault : run.diagnoses[subject].faults) {
    add_property("fault", properties::diagnosis::in_one_sentence(fault.what, fault.where));
  }
  for (const std::string& way : ways_on(run, subject)) {
    add_property("way on", way);
  }
  if (const std::string energy = energy_in_words(run, subject); !energy.empty()) {
    add_property("energy", energy);
  }
  for (std::size_t f = 0; f < result.beyond_domain.size(); ++f) {
    add_property(fmt::format("beyond the claimed domain, {}", run.options.beyond_domain[f]->name),
                 boundary_in_words(result.beyond_domain[f]));
  }
  if (!list.first_child()) {
    suite.remove_child(list);
  }
}

/// Returns the time in which the subject answered [s].
double add_judged(pugi::xml_node root, const Run& run, std::size_t subject) {
  const properties::SubjectResult& result = run.results[subject];
  const bool counts = run.counts[subject];
  const pugi::xml_node suite = add(root, "testsuite", {{"name", result.subject.name}});
  add_properties(suite, run, subject);
  for (const properties::Invariant* invariant : properties::claim_of(result.subject, run.options.limits).invariants) {
    add_case(suite, result, *invariant, standing_of(run, subject, *invariant));
  }
  const pugi::xml_node session = add_test(suite, result.subject.name, "session");
  if (const std::string& why = why_not_judged(run.results[subject]); !why.empty()) {
    const char* const message = result.error.empty() ? "not judged" : "could not be judged to the end";
    if (counts) {
      add(session, "error", {{"message", message}, {"type", "session"}}, why);
    } else {
      add(session, "skipped", {{"message", message}}, why);
    }
  }
  return seconds_of(result);
}

void add_absent(pugi::xml_node root, const Subject& subject) {
  const pugi::xml_node suite = add(root, "testsuite", {{"name", subject.name}});
  add(add_test(suite, subject.name, "session"), "skipped", {{"message", "absent: " + subject.absent}});
}

using properties::Witness;

constexpr std::size_t longest_title = 200;
constexpr std::size_t longest_message = 4000;

/// Escapes %, line ends and the letters in `ends` as % and two digits. Unescaped, they would end a command or one of
/// its fields.
std::string escaped(std::string_view text, std::string_view ends) {
  std::string result;
  for (const char letter : text) {
    if (letter == '%' || letter == '\r' || letter == '\n' || ends.find(letter) != std::string_view::npos) {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
    } else {
      result += letter;
    }
  }
  return result;
}

std::string command(std::string_view name, const std::string& title, const std::string& message) {
  using carom::printable;
  return fmt::format("::{} title={}::{}\n", name, escaped(printable_line(title, longest_title), ":,"),
                     escaped(printable(message, longest_message), ""));
}

std::string violation(const Run& run, const properties::SubjectResult& result, const Witness& witness,
                      const std::string& out_directory) {
  const std::string& name = result.subject.name;
  const properties::Invariant& invariant = *witness.invariant;
  std::string message = fmt::format("{}, most often in {}. {}\n{}", violated_of_judged_cases(result.count(invariant)),
                                    witness.family->name, invariant.statement, properties::in_words(witness.verdict));
  if (!out_directory.empty()) {
    message += '\n' + replay_line(run, result.subject, witness, out_directory);
  }
  const bool known = run.baseline && is_known(*run.baseline, name, invariant);
  return command(known ? "notice" : "error",
                 fmt::format("{} violates {}{}", name, invariant.name, known ? " (known from the baseline)" : ""),
                 message);
}

}  // namespace

void set_totals(pugi::xml_node node, double seconds) {
  for (const auto& [total, path] :
       {std::pair{"tests", ".//testcase"}, std::pair{"failures", ".//testcase/failure"},
        std::pair{"errors", ".//testcase/error"}, std::pair{"skipped", ".//testcase/skipped"}}) {
    node.append_attribute(total) = static_cast<unsigned>(node.select_nodes(path).size());
  }
  node.append_attribute("time") = fmt::format("{:.6f}", seconds).c_str();
}

std::string junit_xml(const Run& run) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = "carom";
  double all_seconds = 0;
  const auto close = [&](double seconds) {
    set_totals(root.last_child(), seconds);
    root.last_child().append_attribute("timestamp") = run.environment.date.c_str();
    all_seconds += seconds;
  };
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    close(add_judged(root, run, s));
  }
  for (const Subject& subject : run.absent) {
    add_absent(root, subject);
    close(0);
  }
  if (run.judge_error) {
    const pugi::xml_node suite = add(root, "testsuite", {{"name", "carom"}});
    add(add_test(suite, "carom", "judge"), "error", {{"message", "the judge failed"}, {"type", "judge"}},
        in_words(*run.judge_error));
    close(0);
  }
  set_totals(root, all_seconds);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

std::string github_annotations(const Run& run, const std::string& out_directory) {
  std::string text;
  if (run.judge_error) {
    text += command("error", "the judge failed", properties::in_words(*run.judge_error));
  }
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    if (!run.counts[s]) {
      continue;
    }
    const properties::SubjectResult& result = run.results[s];
    const std::string& name = result.subject.name;
    for (const properties::diagnosis::Fault& fault : run.diagnoses[s].faults) {
      std::vector<std::string> lines = properties::diagnosis::lines_of(fault);
      if (&fault == &run.diagnoses[s].faults.front()) {
        const std::vector<std::string> ways = ways_on(run, s);
        lines.insert(lines.end(), ways.begin(), ways.end());
      }
      text += command("notice", "diagnosis of " + name, fmt::format("{}", fmt::join(lines, "\n")));
    }
    for (const Witness* witness : witnesses_by_telling(run, s)) {
      text += violation(run, result, *witness, out_directory);
    }
    if (!why_not_judged(result).empty()) {
      text += command("error", fmt::format("{} could not be judged", name), why_not_judged(result));
    }
  }
  const Overall overall = overall_of(run);
  return text +
         command("notice", "carom: " + in_words(overall),
                 fmt::format("{} of {} subjects that count are sound; {}, seed {}{}", overall.sound, overall.subjects,
                             extent_of(run), run.options.seed, overall.interrupted ? "; interrupted" : "") +
                     (run.baseline ? "; against the baseline " + baseline_verdict(*run.baseline) : ""));
}

}  // namespace carom::report
