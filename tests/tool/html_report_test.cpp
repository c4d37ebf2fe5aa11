// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <memory>
#include <set>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

/// The elements that a generated page may contain. None of them loads or runs anything.
const std::set<std::string> elements{
    "html",    "head",    "meta",       "title",   "style",   "body",   "header", "main",  "footer",  "nav",
    "section", "article", "h1",         "h2",      "h3",      "h4",     "p",      "a",     "ul",      "li",
    "dl",      "dt",      "dd",         "div",     "span",    "small",  "pre",    "table", "caption", "thead",
    "tbody",   "tr",      "th",         "td",      "figure",  "svg",    "desc",   "path",  "circle",  "ellipse",
    "text",    "math",    "figcaption", "mrow",    "mi",      "mn",     "mo",     "mtext", "mspace",  "mfrac",
    "mover",   "msub",    "msup",       "msubsup", "details", "summary"};

struct Page {
  TemporaryDirectory directory;
  std::string text;
  pugi::xml_document document;
  pugi::xml_parse_result parsed;

  [[nodiscard]] pugi::xml_node body() const { return document.child("html").child("body"); }
  [[nodiscard]] std::string text_of(const char* path) const { return document.select_node(path).node().text().get(); }
};

std::unique_ptr<Page> page_of(std::vector<std::string> arguments) {
  auto page = std::make_unique<Page>();
  arguments.insert(arguments.end(), {"--out", page->directory.path().string()});
  static_cast<void>(run_carom(arguments));
  page->text = content_of(page->directory.path() / "report.html");
  page->parsed = page->document.load_string(page->text.c_str(), pugi::parse_full);
  EXPECT_TRUE(page->parsed) << page->parsed.description() << " at " << page->parsed.offset;
  return page;
}

void expect_harmless(const Page& page) {
  std::set<std::string> names;
  for (const pugi::xpath_node& found : page.document.select_nodes("//*")) {
    const pugi::xml_node node = found.node();
    EXPECT_TRUE(elements.contains(node.name())) << node.name();
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const std::string name = attribute.name();
      EXPECT_FALSE(name.starts_with("on") || name == "src" || name == "style") << node.name() << ' ' << name;
      EXPECT_TRUE(name != "href" || attribute.value()[0] == '#') << attribute.value();
      EXPECT_TRUE(name != "id" || names.insert(attribute.value()).second) << attribute.value() << " stands twice";
    }
  }
  for (const pugi::xpath_node& found : page.document.select_nodes("//a[@href]")) {
    EXPECT_TRUE(names.contains(found.node().attribute("href").value() + 1)) << found.node().attribute("href").value();
  }
  for (const char* raw : {"<script", "<img", "<b ", "\x1b", "url(", "@import"}) {
    EXPECT_EQ(page.text.find(raw), std::string::npos) << raw;
  }
}

/// The geometric attributes of drawings contain only numbers and path commands. Each picture has a title, a
/// description, and sides of 100 to 700 pixels.
void expect_sane_drawings(const Page& page) {
  std::size_t drawings = 0;
  for (const pugi::xpath_node& found : page.document.select_nodes("//svg//*")) {
    for (const char* name : {"d", "cx", "cy", "rx", "ry", "r", "x", "y", "transform"}) {
      const std::string value = found.node().attribute(name).value();
      EXPECT_EQ(value.find_first_not_of("MLZrotate() ,.-0123456789"), std::string::npos) << value;
      EXPECT_EQ(value.find("e+"), std::string::npos) << value;
    }
  }
  for (const pugi::xpath_node& found : page.document.select_nodes("//svg[@role='img']")) {
    ++drawings;
    const pugi::xml_node drawing = found.node();
    EXPECT_STRNE(drawing.child("title").text().get(), "");
    EXPECT_STRNE(drawing.child("desc").text().get(), "");
    for (const char* arrow : {"before", "computed", "exact", "normal"}) {
      const auto count = [&](const std::string& path) { return drawing.select_nodes(path.c_str()).size(); };
      EXPECT_EQ(count(std::string("text[@class='") + arrow + "']"),
                count(std::string("path[@class='") + arrow + " head']"))
          << "each arrow has its name: " << arrow;
    }
    for (const char* size : {"width", "height"}) {
      EXPECT_GE(drawing.attribute(size).as_double(), 100);
      EXPECT_LE(drawing.attribute(size).as_double(), 700);
    }
  }
  EXPECT_GT(drawings, 0U);
}

TEST(HtmlReport, HoldsEveryPart) {
  const auto page = page_of({"gate", "frictionless-double", "reflection-in-basis-double", "exec:/no/such", "--families",
                             "head_on,invalid", "--cases", "60", "--seed", "4", "--deviates", few_families_judge_no});
  expect_harmless(*page);
  expect_sane_drawings(*page);
  EXPECT_EQ(page->text.substr(0, 15), "<!DOCTYPE html>");
  EXPECT_STREQ(page->document.child("html").attribute("lang").value(), "en");
  EXPECT_EQ(page->text_of("//section[@id='summary']/p"),
            "Of 3 subjects that count, 1 is sound, 1 violates an invariant, and 1 could not be judged to the end.");
  EXPECT_EQ(page->text_of("//dt[text()='exit status']/../dd"), "2: some subjects could not be judged");
  EXPECT_EQ(page->text_of("//section[@id='environment']//dt[text()='seed']/../dd"), "4");
  EXPECT_EQ(page->text_of("//section[@id='subjects']//tr[th='frictionless-double']/td[1]"), "sound");
  EXPECT_NE(page->text_of("//section[@class='error']/pre").find("/no/such"), std::string::npos);
  for (const char* part : {"subjects", "invariants", "families", "generated"}) {
    const std::string table = std::string("//section[@id='") + part + "']//table";
    EXPECT_TRUE(page->document.select_node((table + "/caption").c_str())) << part;
    EXPECT_TRUE(page->document.select_node((table + "/thead//th[@scope='col']").c_str())) << part;
    EXPECT_TRUE(page->document.select_node((table + "/tbody//th[@scope='row']").c_str())) << part;
  }
  EXPECT_EQ(page->text_of("//section[@id='invariants']//tr[th='frictionless-double']/td[1]/span[@class='spoken']"),
            "holds in ");
  EXPECT_EQ(page->text_of("//section[@id='families']//tr[th='exec:/no/such']/td[1]/span[@class='spoken']"),
            "no outcome to compare with");
  const pugi::xml_node witness =
      page->document.select_node("//article[h4='reflection-in-basis-double violates restitution']").node();
  ASSERT_TRUE(witness);
  EXPECT_NE(std::string(witness.select_node("pre").node().text().get()).find("carom replay "), std::string::npos);
  EXPECT_TRUE(witness.select_node(".//math"));
  EXPECT_TRUE(witness.select_node(".//tr[th='velocity of A']/td[2]")) << "what is exact beside what was computed";
}

/// If the impulse lies on the friction cone, the exact velocities contain square roots. The domain keeps the shrinker
/// from a collision without friction.
TEST(HtmlReport, ShowsExactVelocitiesThatAreIrrational) {
  const auto page = page_of({"gate", "rough-double", "--families", "sliding,generic", "--cases", "60", "--limit-ulps",
                             "0.001", "--within", "friction=0.1:0.5"});
  EXPECT_NE(page->text.find("√"), std::string::npos);
  EXPECT_NE(page->text.find("violated"), std::string::npos);
}

TEST(HtmlReport, ShowsTheAnswersOfCoulomb) {
  const auto page =
      page_of({"gate", "coulomb-double", "--families", "chung_ooi", "--cases", "200", "--limit-ulps", "0.001"});
  EXPECT_TRUE(page->document.select_node("//article//th[text()='answer, slips']"));
  expect_sane_drawings(*page);
}

TEST(HtmlReport, EveryFormulaIsUnderstood) {
  const auto page =
      page_of({"gate", "ode-double-as-shipped", "reflection-in-basis-float", "--cases", "30", "--limit-ulps", "0.001"});
  EXPECT_FALSE(page->document.select_nodes("//math").empty());
  for (const pugi::xpath_node& found : page->document.select_nodes("//math//mtext")) {
    EXPECT_EQ(std::string(found.node().text().get()).find('\\'), std::string::npos) << found.node().text().get();
  }
}

TEST(HtmlReport, DrawsWhateverTheNumbersAre) {
  const auto page = page_of({"gate", "reflection-in-basis-float", "reflection-adjugate-float", "--families",
                             "mass_scale,long_normal,far_from_origin,fast_spin,slow,head_on,driven_wall", "--cases",
                             "150", "--limit-ulps", "0.01", std::string("exec:") + CAROM_MISBEHAVING + " nan-as-text"});
  expect_harmless(*page);
  expect_sane_drawings(*page);
}

TEST(Markup, OfASubjectIsText) {
  const auto page = page_of(
      {"gate", std::string("exec:") + CAROM_MISBEHAVING + " markup", "--families", "generic,invalid", "--cases", "20"});
  expect_harmless(*page);
  EXPECT_NE(page->text.find("&lt;script&gt;alert(1)&lt;/script&gt;&amp;"), std::string::npos) << "the name is shown";
  EXPECT_NE(page->text.find("&lt;b onclick=alert(3)&gt;"), std::string::npos) << "so is the reason";

  pugi::xml_document junit;
  const std::string xml = content_of(page->directory.path() / "junit.xml");
  ASSERT_TRUE(junit.load_string(xml.c_str()));
  EXPECT_EQ(xml.find('\x1b'), std::string::npos);
  EXPECT_EQ(xml.find("<script"), std::string::npos);
}

}  // namespace
}  // namespace carom::tests
