// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "layout.hpp"

namespace carom::layout {
namespace {

using Folders = std::set<std::string>;

std::string folder_of(const std::string& path) { return path.substr(0, path.find_last_of('/')); }

/// The other folders that each folder includes. <carom/NAME/…> means src/NAME/… or NAME/….
std::map<std::string, Folders> folders_included(const std::vector<SourceFile>& files) {
  static const std::regex include(R"re([ \t]*#[ \t]*include[ \t]*(?:<carom/|")([^>"]+)[>"])re");
  Folders paths;
  for (const SourceFile& file : files) {
    paths.insert(file.path);
  }
  std::map<std::string, Folders> included;
  for (const SourceFile& file : files) {
    const std::string folder = folder_of(file.path);
    for (std::sregex_iterator match(file.text.begin(), file.text.end(), include); match != std::sregex_iterator();
         ++match) {
      for (const std::string& root :
           {folder + '/', std::string("src/"), std::string(), std::string("src/tool/"), std::string("tests/")}) {
        const std::string path = root + (*match)[1].str();
        if (paths.contains(path)) {
          if (folder_of(path) != folder) {
            included[folder].insert(folder_of(path));
          }
          break;
        }
      }
    }
  }
  return included;
}

Folders reachable_from(const std::string& folder, const std::map<std::string, Folders>& included) {
  Folders reached;
  std::vector<std::string> open{folder};
  while (!open.empty()) {
    const auto next = included.find(open.back());
    open.pop_back();
    for (const std::string& one : next == included.end() ? Folders{} : next->second) {
      if (reached.insert(one).second) {
        open.push_back(one);
      }
    }
  }
  return reached;
}

/// The largest sets of folders that all include each other, directly or through others.
std::vector<Folders> cycles(const std::vector<SourceFile>& files) {
  const std::map<std::string, Folders> included = folders_included(files);
  std::map<std::string, Folders> reached;
  for (const auto& [folder, ignored] : included) {
    reached[folder] = reachable_from(folder, included);
  }
  std::set<Folders> found;
  for (const auto& [folder, targets] : reached) {
    Folders cycle;
    for (const std::string& target : targets) {
      if (reached.contains(target) && reached[target].contains(folder)) {
        cycle.insert(target);
      }
    }
    if (!cycle.empty()) {
      found.insert(cycle);
    }
  }
  return {found.begin(), found.end()};
}

SourceFile planted(const std::string& path, const std::string& include) {
  return {path, "// SPDX\n#include " + include + "\n"};
}

TEST(FolderCycles, AreFound) {
  EXPECT_EQ(cycles({planted("src/a/a.hpp", "<carom/b/b.hpp>"), planted("src/b/b.hpp", "<carom/c/x/c.hpp>"),
                    planted("c/x/c.hpp", "<carom/a/a.hpp>"), planted("src/d/d.hpp", "<carom/a/a.hpp>")}),
            (std::vector<Folders>{{"c/x", "src/a", "src/b"}}));
  EXPECT_EQ(cycles({planted("src/a/a.hpp", "<carom/a/in/b.hpp>"), planted("src/a/in/b.hpp", "<carom/a/c.hpp>"),
                    planted("src/a/c.hpp", "<vector>")}),
            (std::vector<Folders>{{"src/a", "src/a/in"}}));
  EXPECT_EQ(cycles({planted("src/tool/a/a.cpp", "\"b/b.hpp\""), planted("src/tool/b/b.hpp", "\"a/a.hpp\""),
                    planted("src/tool/a/a.hpp", "\"c.hpp\"")}),
            (std::vector<Folders>{{"src/tool/a", "src/tool/b"}}));
}

TEST(FolderCycles, AreNoneWithinAFolderOrOneWay) {
  EXPECT_TRUE(cycles({planted("src/a/a.hpp", "<carom/a/b.hpp>"), planted("src/a/b.hpp", "<carom/a/a.hpp>"),
                      planted("src/c/c.hpp", "<carom/a/a.hpp>"), planted("src/c/d/d.hpp", "<carom/c/c.hpp>")})
                  .empty());
}

TEST(Layout, HasNoCyclesBetweenFolders) { EXPECT_EQ(cycles(source_files(CAROM_SOURCE_DIR)), std::vector<Folders>{}); }

}  // namespace
}  // namespace carom::layout
