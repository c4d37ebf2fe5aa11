// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace carom::links {
namespace {

namespace fs = std::filesystem;

const fs::path top = CAROM_SOURCE_DIR;

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string without_blocks(const std::string& text) {
  std::istringstream lines(text);
  std::string rest;
  bool is_code = false;
  for (std::string line; std::getline(lines, line);) {
    const bool is_fence = line.starts_with("```");
    is_code = is_code != is_fence;
    if (!is_code && !is_fence && !line.starts_with("    ")) {
      rest += line + '\n';
    }
  }
  return rest;
}

/// The relative targets of links and pictures, such as "../x.md#part".
std::vector<std::string> links_of(const std::string& text) {
  static const std::regex link(R"re((?:\]\(|src(?:set)?=")([^()\s"]+)[)"])re");
  const std::string prose = std::regex_replace(without_blocks(text), std::regex("`[^`\n]*`"), "");
  std::vector<std::string> targets;
  for (std::sregex_iterator found(prose.begin(), prose.end(), link), none; found != none; ++found) {
    const std::string target = (*found)[1];
    if (target.find("://") == std::string::npos && !target.starts_with("mailto:")) {
      targets.push_back(target);
    }
  }
  return targets;
}

std::set<std::string> anchors_of(const std::string& text) {
  std::set<std::string> anchors;
  std::istringstream lines(without_blocks(text));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of('#');
    if (begin == 0 || begin == std::string::npos || line[begin] != ' ') {
      continue;
    }
    std::string anchor;
    for (const char letter : line.substr(begin + 1)) {
      const auto byte = static_cast<unsigned char>(letter);
      if (letter == ' ') {
        anchor += '-';
      } else if (byte >= 0x80 || std::isalnum(byte) != 0 || letter == '-' || letter == '_') {
        anchor += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
      }
    }
    anchors.insert(anchor);
  }
  return anchors;
}

/// The reason why the link is broken; empty if the link works.
std::string offence_of(const fs::path& page, const std::string& target) {
  const std::size_t hash = target.find('#');
  const fs::path file = hash == 0 ? page : page.parent_path() / target.substr(0, hash);
  if (!fs::exists(file)) {
    return target + " is not there";
  }
  if (hash != std::string::npos && file.extension() == ".md" &&
      !anchors_of(read(file)).contains(target.substr(hash + 1))) {
    return target + " is no heading";
  }
  return {};
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  auto walk = fs::recursive_directory_iterator(top);
  for (auto entry = fs::begin(walk); entry != fs::end(walk); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() &&
        (name.starts_with(".") || name == "node_modules" || (entry.depth() == 0 && name.starts_with("build")))) {
      entry.disable_recursion_pending();
    } else if (entry->path().extension() == ".md") {
      found.push_back(entry->path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(LinkChecker, ReadsLinksAndPicturesButNoCode) {
  EXPECT_EQ(links_of("[a](b.md), ![c](../d.svg) and [e](f.md#g), [h](#i)\n"
                     "[web](https://example.org/x) `[no](code.md)`\n\n    "
                     "[no](block.md)\n```\n[no](fence.md)\n```\n[j](k)<img src=\"l.png\">"),
            (std::vector<std::string>{"b.md", "../d.svg", "f.md#g", "#i", "k", "l.png"}));
}

TEST(LinkChecker, SpellsAnchorsAsHeadingsDo) {
  EXPECT_EQ(anchors_of("# One text, many `arithmetics`\n\ntext\n## cannon-es\n#no heading\n"),
            (std::set<std::string>{"one-text-many-arithmetics", "cannon-es"}));
}

TEST(LinkChecker, FindsAPlantedLinkThatLeadsNowhere) {
  const fs::path page = top / "README.md";
  EXPECT_EQ(offence_of(page, "docs/guide/plug-in.md"), "");
  EXPECT_EQ(offence_of(page, "#two-commands"), "");
  EXPECT_EQ(offence_of(page, "docs/guide/no-such.md"), "docs/guide/no-such.md is not there");
  EXPECT_EQ(offence_of(page, "#no-such"), "#no-such is no heading");
  EXPECT_EQ(offence_of(top / "docs" / "README.md", "../README.md#no-such"), "../README.md#no-such is no heading");
}

TEST(Links, LeadSomewhere) {
  int links = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& target : links_of(read(page))) {
      ++links;
      EXPECT_EQ(offence_of(page, target), "") << page;
    }
  }
  EXPECT_GT(links, 50);
}

TEST(Links, OfTheIndexLeadToEveryPage) {
  const fs::path index = top / "docs" / "README.md";
  std::set<fs::path> linked{index};
  for (const std::string& target : links_of(read(index))) {
    linked.insert((index.parent_path() / target.substr(0, target.find('#'))).lexically_normal());
  }
  for (const fs::path& page : pages()) {
    const fs::path inside = page.lexically_relative(top / "docs");
    if (!inside.string().starts_with("..")) {
      EXPECT_TRUE(linked.contains(page)) << "docs/README.md does not lead to " << inside;
    }
  }
}

}  // namespace
}  // namespace carom::links
