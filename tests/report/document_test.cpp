// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <carom/report/pages/document.hpp>

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

TEST(Document, AlignsATableInTextWithItsNotesBelow) {
  const Table table{"",
                    {{"name"}, {.name = "law", .is_in_text = false}, {"count", true}},
                    {{{"a", "any", "1"}, {"below"}}, {{"größer", "any", "100"}, {"below", "alone"}}}};
  EXPECT_EQ(in_text({table}), "name    count\na           1\ngrößer    100\n  a, größer: below\n  größer: alone\n");
}

TEST(Document, HasNoControlCharactersInText) {
  const std::string text = in_text(everything());
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("A paragraph"), std::string::npos);
  EXPECT_EQ(text.find("on demand"), std::string::npos);
}

TEST(Document, EscapesMarkdown) {
  const std::string text = in_markdown(everything());
  EXPECT_NE(text.find("## Title\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| &lt;b>\\|\\`\\*\\_[x\\](y)\\\\"), std::string::npos) << text;
  EXPECT_NE(text.find("\n    line 1\n    # line 2\n"), std::string::npos) << "code is moved in:\n" << text;
  EXPECT_NE(text.find("| --- | ---: |"), std::string::npos) << text;
  EXPECT_EQ(in_markdown({Paragraph{"# no heading"}}), "\\# no heading\n");
  EXPECT_EQ(in_markdown({Paragraph{"head_on in [ulps]"}}), "head_on in [ulps]\n");
  EXPECT_EQ(in_markdown({List{{name_cell("`@who|")}}}), "- `'@who\\|`\n");
}

TEST(Document, IsWellFormedHtml) {
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

}  // namespace
}  // namespace carom::report
