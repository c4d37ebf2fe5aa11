// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <carom/properties/invariants/invariant.hpp>
#include <carom/report/pages/document.hpp>
#include <carom/report/pictures/markup.hpp>
#include <carom/report/results/words.hpp>

#include "support/expect_in.hpp"

/// Text of third parties is safe in every format.
namespace carom::report {
namespace {

const std::string hostile = "<b>|`*_[x](y)\\\x1b[31m\xff";

Document everything() {
  Table table{"caption", {{"name"}, {"count", true}}, {{{hostile, "7"}, {"a note"}}}};
  return {Section{
      "Title",
      {Paragraph{"A paragraph of " + hostile}, List{{"an item"}}, Code{"line 1\n# line 2\n"},
       Facts{{{"fact", "value"}, {"none", ""}}}, std::move(table), Box{"look", {Paragraph{"boxed"}}},
       Details{"on demand", {Paragraph{"detail"}}}, Picture{[](pugi::xml_node node) { node.append_child("svg"); }}},
      "anchor"}};
}

TEST(Table, InTextIsAlignedWithItsNotesBelow) {
  const Table table{"",
                    {{"name"}, {.name = "law", .is_in_text = false}, {"count", true}},
                    {{{"a", "any", "1"}, {"below"}}, {{"größer", "any", "100"}, {"below", "alone"}}}};
  EXPECT_EQ(in_text({table}), "name    count\na           1\ngrößer    100\n  a, größer: below\n  größer: alone\n");
}

TEST(Table, InMarkdownHasNoMarkupOfAThirdParty) {
  const Table table{"", {{"name"}, {"count", true}}, {{{hostile, "7"}}, {{name_cell("`@who|"), "8"}}}};
  const std::string text = markdown_table(table);
  EXPECT_TRUE(text.starts_with("| name | count |\n| --- | ---: |\n| &lt;b>\\|\\`\\*\\_\\[x\\](y)\\\\")) << text;
  EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(" | 7 |\n| `'@who\\|` | 8 |\n")) << text;
}

TEST(Document, AsAPageIsWellFormedWithEveryBlock) {
  const std::string page = html_page({"t", "h", {{"anchor", "Title"}}, everything(), "f"});
  pugi::xml_document parsed;
  ASSERT_TRUE(parsed.load_string(page.c_str(), pugi::parse_full)) << page;
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  const pugi::xml_node section = parsed.select_node("//section[@id='anchor']").node();
  EXPECT_STREQ(section.child("h2").text().get(), "Title");
  for (const char* path : {".//table/tbody/tr/th", ".//details/summary", ".//pre", ".//svg", ".//ul/li",
                           ".//div[@class='look']/p", ".//dl/div/dd"}) {
    EXPECT_TRUE(section.select_node(path)) << path;
  }
  EXPECT_EQ(section.select_nodes(".//dd").size(), 1U) << "a fact without a value is left out";
}

TEST(Formula, OfEveryInvariantHasNoCommandThatIsNotUnderstood) {
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    pugi::xml_document document;
    add_formula(document.append_child("p"), invariant.formula);
    EXPECT_TRUE(document.select_node("//math")) << invariant.name;
    EXPECT_FALSE(document.select_node("//*[contains(text(), '\\')]")) << invariant.name;
  }
}

using namespace std::chrono_literals;

TEST(Duration, IsReadFromANumberAndItsUnit) {
  EXPECT_EQ(duration_from("500ms"), 500ms);
  EXPECT_EQ(duration_from("10s"), 10s);
  EXPECT_EQ(duration_from("2m"), 2min);
  EXPECT_EQ(duration_from("1h"), 1h);
  EXPECT_EQ(duration_from("1.5s"), 1500ms);
  EXPECT_EQ(duration_from("1ms"), 1ms);
  EXPECT_EQ(duration_from("1000h"), 1000h);
}

TEST(Duration, IsReadFromNoOtherText) {
  for (const char* text :
       {"",   "s",   "10",   "10 s", " 10s", "10s ",    "-1s",  "+1s",   "0s",    "0.5ms",
        "5d", "10S", "1e3s", "nans", "infs", "1s500ms", "1,5s", "0x10s", "1001h", "99999999999999999999h"}) {
    EXPECT_FALSE(duration_from(text)) << text;
  }
}

TEST(Duration, IsWrittenInTheLargestUnitThatLeavesNoFraction) {
  EXPECT_EQ(in_words(500ms), "500 ms");
  EXPECT_EQ(in_words(10s), "10 s");
  EXPECT_EQ(in_words(90s), "90 s");
  EXPECT_EQ(in_words(120s), "2 m");
  EXPECT_EQ(in_words(1500ms), "1500 ms");
  EXPECT_EQ(in_words(2h), "2 h");
  EXPECT_EQ(in_words(5us), "0 ms");
}

}  // namespace

}  // namespace carom::report
