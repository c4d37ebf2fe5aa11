// SPDX-License-Identifier: BSL-1.0
// Every form of the report of one run: text, page, JUnit, summary, annotations, JSON.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <carom/collision/law.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/report.schema.json";

/// A run of the gate with all of its files.
struct Forms {
  TemporaryDirectory directory;
  RunResult run;
  std::string page;
  std::string xml;
  std::string summary;
  pugi::xml_document html;
  pugi::xml_document junit;
  json report;

  explicit Forms(std::vector<std::string> arguments) {
    const std::string file = directory.write("summary.md", "what was there\n");
    arguments.insert(arguments.begin(), "gate");
    run = run_carom(arguments, {"--out", directory.path().string(), "--summary", file, "--annotations", "github"});
    page = content_of(directory.path() / "report.html");
    xml = content_of(directory.path() / "junit.xml");
    summary = content_of(file);
    report = json::parse(content_of(directory.path() / "report.json"));
    EXPECT_TRUE(html.load_string(page.c_str(), pugi::parse_full)) << page;
    EXPECT_TRUE(junit.load_string(xml.c_str(), pugi::parse_full)) << xml;
    EXPECT_TRUE(summary.starts_with("what was there\n## Carom: ")) << summary;
  }

  [[nodiscard]] std::string text_of(const char* path) const { return html.select_node(path).node().text().get(); }
};

/// The elements that a generated page may contain. None of them loads or runs anything.
const std::set<std::string> elements{
    "html",    "head",    "meta",       "title",   "style",   "body",   "header", "main",  "footer",  "nav",
    "section", "article", "h1",         "h2",      "h3",      "h4",     "p",      "a",     "ul",      "li",
    "dl",      "dt",      "dd",         "div",     "span",    "small",  "pre",    "table", "caption", "thead",
    "tbody",   "tr",      "th",         "td",      "figure",  "svg",    "desc",   "path",  "circle",  "ellipse",
    "text",    "math",    "figcaption", "mrow",    "mi",      "mn",     "mo",     "mtext", "mspace",  "mfrac",
    "mover",   "msub",    "msup",       "msubsup", "details", "summary"};

void expect_harmless_page(const Forms& forms) {
  std::set<std::string> names;
  for (const pugi::xpath_node& found : forms.html.select_nodes("//*")) {
    const pugi::xml_node node = found.node();
    EXPECT_TRUE(elements.contains(node.name())) << node.name();
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const std::string name = attribute.name();
      EXPECT_FALSE(name.starts_with("on") || name == "src" || name == "style") << node.name() << ' ' << name;
      EXPECT_TRUE(name != "href" || attribute.value()[0] == '#') << attribute.value();
      EXPECT_TRUE(name != "id" || names.insert(attribute.value()).second) << attribute.value() << " stands twice";
    }
  }
  for (const pugi::xpath_node& found : forms.html.select_nodes("//a[@href]")) {
    EXPECT_TRUE(names.contains(found.node().attribute("href").value() + 1)) << found.node().attribute("href").value();
  }
  for (const char* raw : {"<script", "<img", "<b ", "\x1b", "url(", "@import"}) {
    EXPECT_EQ(forms.page.find(raw), std::string::npos) << raw;
  }
}

/// The geometric attributes of drawings contain only numbers and path commands. Each picture has a title, a
/// description, and sides of 100 to 700 pixels.
void expect_sane_drawings(const Forms& forms) {
  std::size_t drawings = 0;
  for (const pugi::xpath_node& found : forms.html.select_nodes("//svg//*")) {
    for (const char* name : {"d", "cx", "cy", "rx", "ry", "r", "x", "y", "transform"}) {
      const std::string value = found.node().attribute(name).value();
      EXPECT_EQ(value.find_first_not_of("MLZrotate() ,.-0123456789"), std::string::npos) << value;
      EXPECT_EQ(value.find("e+"), std::string::npos) << value;
    }
  }
  for (const pugi::xpath_node& found : forms.html.select_nodes("//svg[@role='img']")) {
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
  EXPECT_FALSE(forms.html.select_nodes("//math").empty());
}

struct Command {
  std::string name;
  std::string title;
  std::string message;
};

std::string unescaped(std::string text) {
  for (const auto& [written, letter] :
       std::map<std::string, std::string>{{"%0A", "\n"}, {"%0D", "\r"}, {"%2C", ","}, {"%3A", ":"}}) {
    for (std::size_t at = text.find(written); at != std::string::npos; at = text.find(written)) {
      text.replace(at, written.size(), letter);
    }
  }
  for (std::size_t at = text.find("%25"); at != std::string::npos; at = text.find("%25", at + 1)) {
    text.replace(at, 3, "%");
  }
  return text;
}

/// GitHub's interpretation of a log. A line that begins with "::", after optional blanks, is a command, unless the log
/// has stopped commands.
std::vector<Command> commands_in(const std::string& log) {
  std::vector<Command> commands;
  std::string token;
  for (std::size_t begin = 0; begin < log.size();) {
    const std::size_t end = std::min(log.find('\n', begin), log.size());
    std::string line = log.substr(begin, end - begin);
    begin = end + 1;
    line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
    const std::size_t second = line.find("::", 2);
    if (!line.starts_with("::") || second == std::string::npos) {
      continue;
    }
    std::string head = line.substr(2, second - 2);
    const std::string tail = line.substr(second + 2);
    if (!token.empty()) {
      token = head == token ? "" : token;
    } else if (head == "stop-commands") {
      token = tail;
    } else {
      const std::size_t blank = head.find(" title=");
      const std::string title = blank == std::string::npos ? "" : head.substr(blank + 7);
      EXPECT_EQ(title.find_first_of(",:"), std::string::npos) << line;
      commands.push_back({head.substr(0, blank), unescaped(title), unescaped(tail)});
    }
  }
  EXPECT_TRUE(token.empty()) << "commands are read again at the end";
  return commands;
}

/// A run with a sound subject, a faulty one, and one that cannot be started. All tests share it.
const Forms& forms() {
  static const Forms shared({"frictionless-double", "reflection-in-basis-double", "exec:/no/such '100 %: a,b'",
                             "--families", "head_on,near_head_on,invalid", "--cases", "60", "--seed", "4", "--deviates",
                             std::string("energy@head_on,") + few_families_judge_no});
  return shared;
}

const json& violations() { return forms().report.at("subjects").at(1).at("violations"); }

TEST(FormsOfARun, ReportJsonFitsItsSchemaAndASchemaErrorIsFound) {
  EXPECT_EQ(forms().run.exit_status, 2) << forms().run.errors;
  const TemporaryDirectory directory;
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes{
      {"the report as it is", [](json&) {}},
      {"no environment", [](json& r) { r.erase("environment"); }},
      {"no date", [](json& r) { r.at("environment").erase("date"); }},
      {"flags of no library", [](json& r) { r.at("environment")["compiler_flags"] = json::object(); }},
      {"an unknown field", [](json& r) { r["mood"] = "good"; }},
      {"an unknown field of a subject", [](json& r) { r.at("subjects").at(0)["mood"] = "good"; }},
      {"an unknown status", [](json& r) { r.at("subjects").at(0)["status"] = "fine"; }},
      {"an error without a reason", [](json& r) { r.at("subjects").at(2)["error"] = ""; }},
      {"violated by nothing", [](json& r) { r.at("subjects").at(1)["violations"] = json::array(); }},
      {"a number as text", [](json& r) { r["seed"] = "1"; }},
      {"a negative count", [](json& r) { r.at("families").at(0).at("coverage")["cases"] = -1; }},
      {"an exit status that there is not", [](json& r) { r["exit_status"] = 3; }},
  };
  std::vector<std::string> files;
  for (const auto& [name, change] : changes) {
    json changed = forms().report;
    change(changed);
    files.push_back(directory.write(name, changed.dump()));
  }
  EXPECT_EQ(accepted_by(schema, files), std::vector<std::string>{files[0]});
}

TEST(FormsOfARun, PageHasEveryPartAndRunsNothing) {
  const Forms& page = forms();
  expect_harmless_page(page);
  expect_sane_drawings(page);
  EXPECT_EQ(page.page.substr(0, 15), "<!DOCTYPE html>");
  unit::expect_in(page.page, {"Content-Security-Policy"});
  EXPECT_EQ(page.text_of("//section[@id='summary']/p"),
            "Of 3 subjects that count, 1 is sound, 1 violates an invariant, and 1 could not be judged to the end.");
  EXPECT_EQ(page.text_of("//dt[text()='exit status']/../dd"), "2: some subjects could not be judged");
  EXPECT_EQ(page.text_of("//section[@id='environment']//dt[text()='seed']/../dd"), "4");
  EXPECT_EQ(page.text_of("//section[@id='subjects']//tr[th='frictionless-double']/td[1]"), "sound");
  unit::expect_in(page.text_of("//section[@class='error']/pre"), {"/no/such"});
  for (const char* part : {"subjects", "invariants", "families", "generated"}) {
    const std::string table = std::string("//section[@id='") + part + "']//table";
    EXPECT_TRUE(page.html.select_node((table + "/caption").c_str())) << part;
    EXPECT_TRUE(page.html.select_node((table + "/thead//th[@scope='col']").c_str())) << part;
    EXPECT_TRUE(page.html.select_node((table + "/tbody//th[@scope='row']").c_str())) << part;
  }
  EXPECT_EQ(page.text_of("//section[@id='invariants']//tr[th='frictionless-double']/td[1]/span[@class='spoken']"),
            "holds in ");
  const pugi::xml_node witness =
      page.html.select_node("//article[h4='reflection-in-basis-double violates restitution']").node();
  ASSERT_TRUE(witness);
  unit::expect_in(std::string(witness.select_node("pre").node().text().get()), {"carom replay "});
  EXPECT_TRUE(witness.select_node(".//tr[th='velocity of A']/td[2]")) << "what is exact beside what was computed";
  unit::expect_in(page.page, {"energy@head_on"});
  unit::expect_in(page.run.output, {"not judged because of\n    --deviates: energy@head_on, "});
}

TEST(FormsOfARun, JunitHasASuiteForEachSubjectAndAFailureForEachViolation) {
  const pugi::xml_node root = forms().junit.child("testsuites");
  ASSERT_TRUE(root);
  for (const char* total : {"tests", "failures", "errors", "skipped"}) {
    int sum = 0;
    for (const pugi::xml_node suite : root.children("testsuite")) {
      sum += suite.attribute(total).as_int();
    }
    EXPECT_EQ(root.attribute(total).as_int(-1), sum) << total;
  }
  EXPECT_EQ(root.attribute("errors").as_int(), 1);
  EXPECT_EQ(root.attribute("failures").as_uint(), violations().size());
  for (const pugi::xml_node suite : root.children("testsuite")) {
    EXPECT_GE(suite.attribute("time").as_double(-1), 0);
    for (const pugi::xml_node test : suite.children("testcase")) {
      EXPECT_STREQ(test.attribute("classname").value(), suite.attribute("name").value());
      EXPECT_STRNE(test.attribute("name").value(), "");
      EXPECT_GE(test.attribute("time").as_double(-1), 0);
    }
  }
  for (const pugi::xpath_node& found : root.select_nodes("//failure")) {
    const std::string output = found.node().parent().child("system-out").text().get();
    const std::string prefix = "witness: ";
    ASSERT_EQ(output.substr(0, prefix.size()), prefix);
    EXPECT_TRUE(std::filesystem::exists(forms().directory.path() / output.substr(prefix.size()))) << output;
  }
}

TEST(FormsOfARun, SummaryHasATableOfSubjectsAndTheFirstWitnessWithItsReplay) {
  ASSERT_GE(violations().size(), 2U);
  const std::string telling = forms().report.at("subjects").at(1).at("diagnosis").at("telling");
  const std::string witness = "witnesses/reflection-in-basis-double." + telling + ".json";
  const std::string count = std::to_string(violations().size()) + " violated";
  unit::expect_in(forms().summary, {"## Carom: " + count + "\n", "| `frictionless-double` | sound | ",
                                    "| " + count + " |", "### `reflection-in-basis-double`\n",
                                    "\n    Replay: carom replay " + (forms().directory.path() / witness).string(),
                                    "\n### `exec:/no/such '100 %: a,b'`\n\n    could not be judged: "});
  EXPECT_EQ(forms().summary.find("### `frictionless-double`"), std::string::npos) << forms().summary;
  for (const json& violation : violations()) {
    unit::expect_in(forms().summary, {violation.at("invariant").get<std::string>() + " in"});
  }
}

TEST(FormsOfARun, AnnotationsAreAnErrorForEachViolationAndEachSubjectNotJudged) {
  const std::vector<Command> commands = commands_in(forms().run.output);
  std::map<std::string, std::size_t> count;
  for (const Command& command : commands) {
    ++count[command.name];
    if (command.title.find(" violates ") != std::string::npos) {
      EXPECT_TRUE(command.title.starts_with("reflection-in-basis-double violates ")) << command.title;
      unit::expect_in(command.message, {"carom replay " + forms().directory.path().string()});
    }
  }
  EXPECT_EQ(count["error"], violations().size() + 1);
  ASSERT_GT(commands.size(), 3U);
  EXPECT_EQ(commands.front().title, "diagnosis of reflection-in-basis-double");
  EXPECT_EQ(commands[commands.size() - 2].title, "exec:/no/such '100 %: a,b' could not be judged");
  EXPECT_EQ(commands.back().name, "notice");
  EXPECT_EQ(commands.back().title, "carom: " + std::to_string(violations().size()) + " violated");
  EXPECT_TRUE(commands.back().message.starts_with("1 of 3 subjects that count are sound; 60 cases of each of "));
}

/// The subjects write markup of each form, control characters, invalid UTF-8, and a character that XML excludes.
TEST(FormsOfAHostileSubject, HaveItsTextAsTextOnly) {
  const TemporaryDirectory programs;
  const std::string program =
      programs.write("program.sh", "printf 'a line\\n::error title=planted::\\n' >&2; exit 3\n");
  const Forms forms({std::string("exec:") + CAROM_MISBEHAVING + " markup",
                     "exec:/no/such '\x01\x1b[31m\xff\xc3 \xef\xbf\xbf \xc2\x9b|`<b>@who\n## planted <&\">'",
                     "exec:sh " + program, "--families", "generic,invalid", "--cases", "20"});
  expect_harmless_page(forms);
  unit::expect_in(forms.page, {"&lt;script&gt;alert(1)&lt;/script&gt;&amp;",
                               "&lt;b onclick=alert(3)&gt;"});  // the name and the reason
  for (const char* banned : {"\x01", "\x1b", "\xef\xbf\xbf", "\xc2\x9b", "<script"}) {
    EXPECT_EQ(forms.xml.find(banned), std::string::npos) << banned;
  }
  EXPECT_TRUE(forms.junit.select_node("//testsuite[contains(@name, '<&\">')]")) << forms.xml;
  EXPECT_EQ(forms.summary.find("\n## planted"), std::string::npos) << forms.summary;
  unit::expect_in(forms.summary, {"\\|'<b>@who ## planted"});
  unit::expect_in(forms.run.output, {" ::error title=planted::\n"});
  for (const Command& command : commands_in(forms.run.output)) {
    EXPECT_NE(command.title, "planted");
  }
}

/// How many subjects are violated and do not count. Each has its faults in the record.
std::size_t explained_without_counting(const json& record) {
  std::size_t explained = 0;
  for (const json& subject : record.at("subjects")) {
    if (subject.at("status") == "violated" && !subject.at("counts").get<bool>()) {
      ++explained;
      EXPECT_FALSE(subject.at("diagnosis").at("faults").empty()) << subject.at("name");
    }
  }
  return explained;
}

/// A default run that prints text alone shows no cause of a subject that does not count.
TEST(FormsOfTheDefaultRun, HaveTheFaultsOfSubjectsThatDoNotCountInPrintedJson) {
  const RunResult run = run_carom({"gate", "--families", "near_head_on", "--cases", "5", "--format", "json"});
  EXPECT_GT(explained_without_counting(json::parse(run.output)), 0U);
}

/// Only subjects that count are in the summary and in the annotations. The subjects that are kept because they fail are
/// in the report, with their faults.
TEST(FormsOfTheDefaultRun, LeaveOutWhatIsExpectedToFail) {
  const Forms forms({"--families", "near_head_on", "--deviates", few_families_judge_no, "--cases", "5"});
  EXPECT_EQ(forms.run.exit_status, 0) << forms.run.output;
  EXPECT_GT(explained_without_counting(forms.report), 0U);
  unit::expect_in(forms.run.output, {"Kept because they fail, not counted"});
  const std::vector<Command> commands = commands_in(forms.run.output);
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].title, "carom: sound");
  unit::expect_in(forms.summary, {"## Carom: sound\n", "`frictionless-double`"});
  EXPECT_EQ(forms.summary.find("reflection-in-basis-double"), std::string::npos) << forms.summary;
}

/// An impulse on the friction cone makes exact velocities with square roots. The domain keeps the shrinker from a
/// collision without friction.
TEST(Page, DrawsWitnessesOfEveryLawAndSize) {
  struct Shown {
    std::vector<std::string> run;
    const char* path;
  };
  for (const auto& [run, path] : std::vector<Shown>{
           {{"rough-double", "--families", "sliding,generic", "--cases", "60", "--limit-ulps", "0.001", "--within",
             "friction=0.1:0.5"},
            "//article//td[contains(text(), '√')]"},
           {{"coulomb-double", "--families", "chung_ooi", "--cases", "200", "--limit-ulps", "0.001"},
            "//article//th[text()='answer, slips']"},
           {{"reflection-in-basis-float", "reflection-adjugate-float", "--families",
             "mass_scale,long_normal,far_from_origin,fast_spin,slow,head_on,driven_wall", "--cases", "150",
             "--limit-ulps", "0.01", std::string("exec:") + CAROM_MISBEHAVING + " nan-as-text"},
            "//article//svg"},
       }) {
    const Forms forms(run);
    EXPECT_TRUE(forms.html.select_node(path)) << path;
    expect_harmless_page(forms);
    expect_sane_drawings(forms);
  }
}

/// The name of a subject that is not installed; none if all are.
std::vector<std::string> absent_subject() {
  for (const json& subject : json::parse(run_carom({"subjects", "--format", "json"}).output)) {
    if (!subject.at("absent").get<std::string>().empty()) {
      return {subject.at("name")};
    }
  }
  return {};
}

TEST(ReportSchema, DescribesReportsOfEveryKindOfRun) {
  const TemporaryDirectory directory;
  std::vector<std::string> of_every_law{"gate", "--families", "head_on", "--cases", "2"};
  for (const Law law : all_laws) {
    if (law != Law::any) {
      of_every_law.push_back(std::string(name_of(law)) + "-double");
    }
  }
  for (const std::string& absent : absent_subject()) {
    of_every_law.push_back(absent);
  }
  std::vector<std::string> files;
  const auto report_of = [&](const std::vector<std::string>& arguments) {
    const std::string text = run_carom(arguments, {"--format", "json"}).output;
    files.push_back(directory.write("report" + std::to_string(files.size()) + ".json", text));
    return json::parse(text);
  };
  (void)report_of(of_every_law);
  const json within = report_of({"gate", "frictionless-double", "--cases", "2", "--within", "restitution=0.25:0.5"});
  EXPECT_EQ(within.at("without_case"), json({"inelastic", "elastic"}));
  const json cut_short = report_of({"gate", "frictionless-double", "reflection-in-basis-double", "--families",
                                    "head_on", "--budget", "100ms", "--fail-fast"});
  EXPECT_EQ(cut_short.at("budget_seconds"), 0.1);
  EXPECT_TRUE(cut_short.at("cases_of_each_family").is_null());
  EXPECT_EQ(cut_short.at("subjects").at(1).at("violations").size(), 1U) << "--fail-fast";
  EXPECT_EQ(run_carom({"compare", files.back(), files.back()}).exit_status, 0);
  const json shard = report_of({"gate", "frictionless-double", "coulomb-double", "--families", "head_on,invalid",
                                "--cases", "6", "--shard", "2/3"});
  EXPECT_EQ(shard.at("shard").at("digits").size(), 2U);
  const std::vector<std::string> faulty{"gate",       "frictionless-double",  "reflection-in-basis-double",
                                        "--families", "head_on,near_head_on", "--cases",
                                        "5"};
  json before = report_of(faulty);
  before.at("subjects").at(1).at("families").at(0).at("invariants").at("restitution") = {
      {"holds", 5}, {"violated", 0}, {"skipped", 0}};
  std::vector<std::string> later = faulty;
  later.insert(later.end(), {"--baseline", directory.write("before.json", before.dump()), "--relations-every", "2",
                             "--deviates", "restitution@near_head_on,energy"});
  const json baseline = report_of(later).at("baseline");
  for (const char* list : {"new", "known", "no_longer_judged", "differences"}) {
    EXPECT_FALSE(baseline.at(list).empty()) << list;
  }
  EXPECT_EQ(accepted_by(schema, files), files);
}

}  // namespace
}  // namespace carom::tests
