// SPDX-License-Identifier: BSL-1.0
#include "three_properties_page.hpp"

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/subjects/catalogue.hpp>

namespace carom::mutants {
namespace {

using nlohmann::json;
using properties::Property;

std::string page() {
  std::ifstream file(CAROM_THREE_PROPERTIES_PAGE);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ThreePropertiesPage, HasEachPropertyAsTheProgramPrintsIt) {
  for (const Property& property : properties::three_properties()) {
    const std::string name(property.name);
    EXPECT_NE(page().find("## " + std::string(property.title) + '\n'), std::string::npos) << name;
    EXPECT_EQ(section_of(page(), "facts " + name), facts_section(property));
    EXPECT_EQ(section_of(page(), "planted " + name), planted_section(property, {}))
        << "run build/tests/mutants/three_properties docs/reference/three-properties.md";
  }
}

TEST(ThreePropertiesPage, HasARowForEachEngineAndProperty) {
  for (const Property& property : properties::three_properties()) {
    std::istringstream table(section_of(page(), "engines " + std::string(property.name)));
    std::string head;
    std::getline(table, head);
    for (const std::string_view invariant : property.invariants) {
      EXPECT_NE(head.find(invariant), std::string::npos) << head;
    }
    std::string rows(std::istreambuf_iterator<char>(table), {});
    std::set<std::string> built_in;
    for (const Subject& subject : subjects::built_in_subjects()) {
      built_in.insert(subject.name);
    }
    for (const Subject& subject : subjects::known_subjects()) {
      EXPECT_NE(built_in.contains(subject.name), rows.find("\n| " + subject.name + ' ') != std::string::npos)
          << subject.name;
    }
  }
}

TEST(ThreePropertiesPage, CountsWhatAReportSaysOfAnEngine) {
  const auto counts = [](int violated, int holds) {
    return json{{"linear_momentum", {{"violated", violated}, {"holds", holds}, {"skipped", 9}}}};
  };
  const json engine{{"name", "engine"},
                    {"version", "1.2"},
                    {"model", "any"},
                    {"status", "violated"},
                    {"not_claimed", {"definite", "matrix_used"}},
                    {"families", {{{"invariants", counts(3, 4)}}, {{"invariants", counts(1, 2)}}}}};
  const json absent{{"name", "absent"}, {"status", "absent"}};
  const json report{{"subjects", {engine, absent}}};
  const auto all = properties::three_properties();
  EXPECT_EQ(engines_section(all[2], report),
            "| engine | law | `linear_momentum` | `angular_momentum` |\n| --- | --- | --- | --- |\n"
            "| engine 1.2 | any | 4 of 10 | not judged |\n");
  EXPECT_EQ(engines_section(all[1], report),
            "| engine | law | `definite` | `matrix_used` |\n| --- | --- | --- | --- |\n"
            "| engine 1.2 | any | shows no C | shows no C |\n");
}

TEST(ThreePropertiesPage, IsWrittenBetweenItsMarks) {
  const std::string text = "before\n<!-- begin x -->\nold\n<!-- end x -->\nafter\n";
  EXPECT_EQ(with_section(text, "x", "new\n"), "before\n<!-- begin x -->\nnew\n<!-- end x -->\nafter\n");
  EXPECT_EQ(section_of(text, "x"), "old\n");
  EXPECT_THROW((void)section_of(text, "y"), std::invalid_argument);
}

}  // namespace
}  // namespace carom::mutants
