// SPDX-License-Identifier: GPL-3.0-or-later
#include "junit.hpp"

#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "words.hpp"

namespace carom::tool {
namespace {

/// XML 1.0 has no place for most control characters, escaped or not.
std::string printable(std::string text) {
  for (char& letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20 && letter != '\t' && letter != '\n') {
      letter = '?';
    }
  }
  return text;
}

std::string failure_text(const properties::Witness& witness) {
  return printable(std::string(properties::invariant_named(witness.invariant)->statement) + '\n' +
                   in_words(witness.shrunk.collision, "  ") + in_words(witness.verdict));
}

void add_case(pugi::xml_node suite, const properties::SubjectResult& result, const std::string& invariant,
              bool counts) {
  pugi::xml_node test = suite.append_child("testcase");
  test.append_attribute("classname") = printable(result.subject.name).c_str();
  test.append_attribute("name") = invariant.c_str();
  const properties::Count count = result.count(invariant);
  if (count.violated == 0) {
    if (count.holds == 0) {
      test.append_child("skipped").append_attribute("message") = "no case in its domain";
    }
    return;
  }
  for (const properties::Witness& witness : result.witnesses) {
    if (witness.invariant == invariant) {
      const std::string message = fmt::format("{} of {} cases violate it{}", count.violated,
                                              count.violated + count.holds, counts ? "" : "; expected to fail");
      pugi::xml_node node = test.append_child(counts ? "failure" : "skipped");
      node.append_attribute("message") = message.c_str();
      node.append_child(pugi::node_pcdata).set_value(failure_text(witness).c_str());
    }
  }
}

void set_totals(pugi::xml_node suite) {
  int tests = 0;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
  for (const pugi::xml_node test : suite.children("testcase")) {
    ++tests;
    failures += test.child("failure") ? 1 : 0;
    errors += test.child("error") ? 1 : 0;
    skipped += test.child("skipped") ? 1 : 0;
  }
  suite.append_attribute("tests") = tests;
  suite.append_attribute("failures") = failures;
  suite.append_attribute("errors") = errors;
  suite.append_attribute("skipped") = skipped;
}

}  // namespace

std::string junit_xml(const GateRun& run) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = "carom";
  for (std::size_t s = 0; s < run.report.results.size(); ++s) {
    const properties::SubjectResult& result = run.report.results[s];
    pugi::xml_node suite = root.append_child("testsuite");
    suite.append_attribute("name") = printable(result.subject.name).c_str();
    for (const properties::Invariant* invariant :
         properties::claim_of(result.subject, run.report.options.yardstick).invariants) {
      add_case(suite, result, std::string(invariant->name), run.counts[s]);
    }
    if (!result.error.empty()) {
      pugi::xml_node test = suite.append_child("testcase");
      test.append_attribute("classname") = printable(result.subject.name).c_str();
      test.append_attribute("name") = "session";
      test.append_child(run.counts[s] ? "error" : "skipped").append_attribute("message") =
          printable(result.error).c_str();
    }
    set_totals(suite);
  }
  for (const Subject& subject : run.absent) {
    pugi::xml_node suite = root.append_child("testsuite");
    suite.append_attribute("name") = printable(subject.name).c_str();
    pugi::xml_node test = suite.append_child("testcase");
    test.append_attribute("classname") = printable(subject.name).c_str();
    test.append_attribute("name") = "session";
    test.append_child("skipped").append_attribute("message") = printable("absent: " + subject.absent).c_str();
    set_totals(suite);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace carom::tool
