// SPDX-License-Identifier: BSL-1.0
#include <filesystem>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

struct Junit {
  TemporaryDirectory directory;
  pugi::xml_document document;

  explicit Junit(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--out", directory.path().string()});
    static_cast<void>(run_carom(arguments));
    const auto parsed = document.load_file((directory.path() / "junit.xml").c_str(), pugi::parse_full);
    EXPECT_TRUE(parsed) << parsed.description();
  }
};

void expect_well_formed(const std::filesystem::path& file) {
  constexpr const char* python = "/usr/bin/python3";
  if (!std::filesystem::exists(python)) {
    return;
  }
  const RunResult result =
      run_program(python, {"-c", "import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])", file.string()});
  EXPECT_EQ(result.exit_status, 0) << file << '\n' << result.errors;
}

int sum_of(pugi::xml_node root, const char* attribute) {
  int sum = 0;
  for (const pugi::xml_node suite : root.children("testsuite")) {
    sum += suite.attribute(attribute).as_int();
  }
  return sum;
}

TEST(Junit, HasWhatReadersOfItLookFor) {
  const Junit junit({"gate", "frictionless-double", "reflection-in-basis-double", "exec:/no/such", "--families",
                     "head_on", "--cases", "30", "--deviates", few_families_judge_no});
  const pugi::xml_node root = junit.document.child("testsuites");
  ASSERT_TRUE(root);
  for (const char* total : {"tests", "failures", "errors", "skipped"}) {
    EXPECT_EQ(root.attribute(total).as_int(-1), sum_of(root, total)) << total;
  }
  EXPECT_EQ(root.attribute("errors").as_int(), 1);
  EXPECT_GT(root.attribute("failures").as_int(), 0);
  for (const pugi::xml_node suite : root.children("testsuite")) {
    EXPECT_TRUE(suite.attribute("name"));
    EXPECT_GE(suite.attribute("time").as_double(-1), 0);
    for (const pugi::xml_node test : suite.children("testcase")) {
      EXPECT_STREQ(test.attribute("classname").value(), suite.attribute("name").value());
      EXPECT_STRNE(test.attribute("name").value(), "");
      EXPECT_GE(test.attribute("time").as_double(-1), 0);
    }
  }
  for (const pugi::xpath_node& found : root.select_nodes("//failure")) {
    const pugi::xml_node failure = found.node();
    EXPECT_NE(std::string(failure.attribute("message").value()).find(" judged cases violate it"), std::string::npos);
    EXPECT_STREQ(failure.attribute("type").value(), "violated");
    const std::string output = failure.parent().child("system-out").text().get();
    const std::string prefix = "witness: ";
    ASSERT_EQ(output.substr(0, prefix.size()), prefix);
    EXPECT_TRUE(std::filesystem::exists(junit.directory.path() / output.substr(prefix.size()))) << output;
  }
}

TEST(Junit, IsWellFormedWhateverASubjectIsCalled) {
  // Control characters, invalid UTF-8, and a character that XML excludes.
  const Junit junit({"gate", "exec:/no/such '\x01\x1b[31m\xff\xc3 \xef\xbf\xbf \xc2\x9b <&\">'", "--families",
                     "head_on", "--cases", "2"});
  const std::string name = junit.document.child("testsuites").child("testsuite").attribute("name").value();
  EXPECT_NE(name.find("<&\">"), std::string::npos) << name;
  for (const char* banned : {"\x01", "\x1b", "\xef\xbf\xbf", "\xc2\x9b"}) {
    EXPECT_EQ(name.find(banned), std::string::npos) << name;
  }
  expect_well_formed(junit.directory.path() / "junit.xml");
  expect_well_formed(junit.directory.path() / "report.html");
}

}  // namespace
}  // namespace carom::tests
