// SPDX-License-Identifier: BSL-1.0
#include "scene/replay_html.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/expect_in.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;

json replay(const std::string& name = "cue") {
  return {{"title", name},
          {"law", "rough"},
          {"duration", 0.1 + 0.2},
          {"gravity", {0, 0, -9.81}},
          {"bodies", {{{"name", name}, {"kind", "sphere"}, {"radius", 0.03}}}},
          {"planes", {{{"name", name}, {"normal", {0, 0, 1}}, {"point", {0, 0, 0}}}}},
          {"room", nullptr},
          {"arcs", {{{0, 0, 0, 5e-324, 0, 0, 1.0 / 3, 0, 0, -9.81, 0, 0, 1e308, 0, 0, 0, "flying"}}}},
          {"impacts", json::array()},
          {"series", {{"t", {0}}, {"kinetic", {0}}, {"potential", {0}}, {"lost", {0}}, {"spin", {0}}}}};
}

std::size_t count(std::string_view text, std::string_view what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + what.size())) {
    ++found;
  }
  return found;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin) + begin.size();
  return text.substr(at, text.find(end, at) - at);
}

json embedded(const std::string& page) {
  return json::parse(between(page, "<script type=\"application/json\" id=\"replay\">", "</script>"));
}

class ReplayHtml : public testing::Test {
  void SetUp() override {
    if (!has_replay()) {
      GTEST_SKIP() << "built without replays";
    }
  }
};

TEST(ReplayHtmlWithoutItsPage, SaysSo) {
  if (has_replay()) {
    GTEST_SKIP() << "built with replays";
  }
  EXPECT_THROW(static_cast<void>(replay_html("title", replay())), std::logic_error);
}

TEST_F(ReplayHtml, IsOnePageWithTheReplayTheTitleAndTheNoticeOfThreeJs) {
  const std::string page = replay_html("Balls & walls", replay());
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_EQ(between(page, "<title>", "</title>"), "Balls &amp; walls");
  EXPECT_EQ(page.find("{{"), std::string::npos) << "a mark that nothing stands for";
  EXPECT_EQ(embedded(page), replay()) << "every digit is kept";
  unit::expect_in(page, {"Three.js Authors", "SPDX-License-Identifier: MIT"});
}

TEST_F(ReplayHtml, IsBrokenOutOfByNoName) {
  const std::string harmless = replay_html("title", replay());
  for (const std::string nasty : {"</script><script>alert(1)</script>", "<!--", "<!-- <script>", "</SCRIPT >",
                                  "</title><img src=x onerror=alert(1)>", "]]>", "\\u003c/script>", "{{replay}}",
                                  "{{title}}", "\xe2\x80\xa8 \"quoted\" \\ \n \x01"}) {
    const std::string page = replay_html(nasty, replay(nasty));
    // In HTML, only the character `<` begins elements and comments.
    EXPECT_EQ(count(page, "<"), count(harmless, "<")) << nasty;
    EXPECT_EQ(embedded(page), replay(nasty)) << nasty;
  }
}

TEST_F(ReplayHtml, TakesWhatIsNoUtf8) {
  const std::string page = replay_html("a\xff", replay("b\xff"));
  EXPECT_EQ(between(page, "<title>", "</title>"), "a\xef\xbf\xbd");
  EXPECT_EQ(embedded(page).at("title"), "b\xef\xbf\xbd");
}

TEST_F(ReplayHtml, LoadsNothingAndRunsWhatItContainsAlone) {
  const std::string page = replay_html("title", replay());
  const std::string policy = between(page, "http-equiv=\"Content-Security-Policy\" content=\"", "\"");
  EXPECT_TRUE(policy.starts_with("default-src 'none'; script-src 'sha256-")) << policy;
  for (const char* permitted : {"unsafe", "http", "*", "data:", "blob:", "self"}) {
    EXPECT_EQ(policy.find(permitted), std::string::npos) << policy;
  }
  // The page's own elements, without the content of the script.
  const std::string markup = page.substr(0, page.rfind("<script>"));
  for (const char* loading : {" src=", " href=", " style=", " onload=", "url(", "@import"}) {
    EXPECT_EQ(markup.find(loading), std::string::npos) << loading;
  }
  EXPECT_EQ(count(markup, "<link"), 0U);
  EXPECT_EQ(count(page, "</script>"), 2U);
}

}  // namespace
}  // namespace carom::tool
