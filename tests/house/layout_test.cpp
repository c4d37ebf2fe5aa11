// SPDX-License-Identifier: BSL-1.0
#include "layout.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace carom::layout {
namespace {

using Offences = std::vector<std::string>;

const std::filesystem::path top = CAROM_SOURCE_DIR;

std::string joined(const Offences& offences) {
  std::string text;
  for (const std::string& offence : offences) {
    text += offence + '\n';
  }
  return text;
}

std::string offence_of(const std::string& path, const std::string& include) {
  return joined(include_offences(path, "// SPDX\n#pragma once\n\n#include <vector>\n" + include + "\nint x;\n"));
}

TEST(LayoutChecker, FindsAPlantedIncludeInEachFolder) {
  struct Planted {
    const char* path;
    const char* name;
  };
  for (const Planted& planted : std::vector<Planted>{
           {"src/collision/collision.hpp", "carom/impulse/contact.hpp"},
           {"src/collision/collision.hpp", "nlohmann/json.hpp"},
           {"src/collision/collision.hpp", "fmt/format.h"},
           {"src/collision/json/json.cpp", "carom/oracles/models/superposition.hpp"},
           {"src/impulse/contact.hpp", "CGAL/Gmpq.h"},
           {"properties/gate/gate.cpp", "thread"},
           {"properties/gate/gate.cpp", "carom/properties/scenes/ledger.hpp"},
           {"oracles/judge/compare.cpp", "fstream"},
           {"src/impulse/contact.hpp", "carom/oracles/exact/rational.hpp"},
           {"src/impulse/contact.hpp", "carom/subjects/catalogue.hpp"},
           {"src/impulse/contact.hpp", "nlohmann/json.hpp"},
           {"src/subjects/catalogue.cpp", "carom/oracles/models/superposition.hpp"},
           {"src/subjects/catalogue.cpp", "carom/properties/gate/gate.hpp"},
           {"src/subjects/engines/ode.cpp", "CGAL/Gmpq.h"},
           {"src/subjects/engines/ode.cpp", "carom/tool/table.hpp"},
           {"oracles/models/superposition.hpp", "carom/impulse/contact.hpp"},
           {"oracles/models/superposition.hpp", "carom/properties/gate/gate.hpp"},
           {"oracles/models/superposition.hpp", "fmt/format.h"},
           {"oracles/exact/rational.hpp", "CGAL/Gmpq.h"},
           {"oracles/exact/rational.cpp", "CGAL/Gmpq.h"},
           {"oracles/models/coulomb.cpp", "carom/oracles/exact/gmpq.hpp"},
           {"oracles/exact/roots.hpp", "CGAL/Algebraic_kernel_d_1.h"},
           {"oracles/exact/radical.cpp", "CGAL/Algebraic_kernel_d_1.h"},
           {"oracles/models/superposition.hpp", "CGAL/Gmpq.h"},
           {"oracles/laws/equations.hpp", "carom/oracles/exact/rational.hpp"},
           {"oracles/laws/certify.hpp", "carom/oracles/models/models.hpp"},
           {"oracles/exact/definiteness.cpp", "carom/oracles/numbers/enclosure.hpp"},
           {"oracles/exact/elimination.cpp", "carom/oracles/models/superposition.hpp"},
           {"oracles/exact/rational.cpp", "carom/oracles/numbers/enclosure.hpp"},
           {"oracles/numbers/enclosure.hpp", "carom/oracles/filters/stage.hpp"},
           {"oracles/models/sensitivity.cpp", "carom/oracles/filters/moderate.hpp"},
           {"oracles/filters/slopes.cpp", "carom/oracles/judge/exact_case.hpp"},
           {"oracles/flat.hpp", "carom/oracles/laws/equations.hpp"},
           {"properties/families/body_pairs.cpp", "carom/oracles/judge/exact_case.hpp"},
           {"properties/families/body_pairs.cpp", "carom/oracles/models/models.hpp"},
           {"properties/families/body_pairs.cpp", "carom/properties/trial/trial.hpp"},
           {"properties/gate/gate.cpp", "carom/subjects/catalogue.hpp"},
           {"properties/gate/gate.cpp", "carom/impulse/reflection.hpp"},
           {"properties/families/body_pairs.cpp", "nlohmann/json.hpp"},
           {"properties/gate/gate.cpp", "carom/tool/table.hpp"},
           {"properties/gate/gate.cpp", "carom/impulse/contact.hpp"},
           {"properties/gate/gate.cpp", "gtest/gtest.h"},
           {"properties/gate/gate.cpp", "rapidcheck.h"},
           {"properties/conformance/suite.hpp", "carom/impulse/frictionless.hpp"},
           {"properties/conformance/suite.hpp", "carom/subjects/session.hpp"},
           {"properties/conformance/suite.hpp", "carom/tool/table.hpp"},
           {"src/subjects/catalogue.cpp", "carom/report/model/run.hpp"},
           {"properties/gate/gate.cpp", "carom/report/model/run.hpp"},
           {"src/report/document/html.cpp", "carom/report/model/run.hpp"},
           {"src/report/document/html.cpp", "carom/properties/gate/gate.hpp"},
           {"src/report/drawing/plot.cpp", "carom/report/pages/pages.hpp"},
           {"src/report/model/run.cpp", "carom/report/document/document.hpp"},
           {"src/report/model/run.cpp", "carom/subjects/catalogue.hpp"},
           {"src/report/model/run.cpp", "unistd.h"},
           {"src/report/pages/run_text.cpp", "carom/report/chart/diagrams.hpp"},
           {"src/report/pages/run_text.cpp", "CLI/CLI.hpp"},
           {"src/report/chart/diagrams.hpp", "carom/report/pages/pages.hpp"},
           {"src/report/flat.hpp", "carom/report/model/run.hpp"},
           {"tests/oracles/some_test.cpp", "carom/tool/table.hpp"},
           {"tests/oracles/some_test.cpp", "CGAL/Gmpq.h"},
           {"oracles/models/superposition.hpp", "carom/oracles/../impulse/contact.hpp"},
       }) {
    EXPECT_EQ(offence_of(planted.path, std::string("#include <") + planted.name + ">"),
              std::string(planted.path) + ": includes <" + planted.name + ">\n");
  }
}

TEST(LayoutChecker, FindsAnIncludeHoweverItIsSpaced) {
  for (const char* line : {"#include <CGAL/Gmpq.h>", "  #  include   <CGAL/Gmpq.h>  // why", "#include<CGAL/Gmpq.h>"}) {
    EXPECT_EQ(offence_of("src/impulse/contact.hpp", line), "src/impulse/contact.hpp: includes <CGAL/Gmpq.h>\n") << line;
  }
}

TEST(LayoutChecker, FindsQuotesThatLeaveTheFolders) {
  EXPECT_NE(offence_of("oracles/models/superposition.hpp", "#include \"kinematics.hpp\""), "");
  EXPECT_NE(offence_of("src/tool/main.cpp", "#include \"../impulse/contact.hpp\""), "");
  EXPECT_EQ(offence_of("src/tool/main.cpp", "#include \"commands/commands.hpp\""), "");
  EXPECT_EQ(offence_of("tests/oracles/some_test.cpp", "#include \"cases.hpp\""), "");
}

TEST(LayoutChecker, FindsARoomOfTheProgramThatNamesOneAboveIt) {
  for (const auto& [path, name] :
       std::vector<std::pair<std::string, std::string>>{{"src/tool/io/output.cpp", "commands/commands.hpp"},
                                                        {"src/tool/io/output.cpp", "plan/clock.hpp"},
                                                        {"src/tool/chart/timing.cpp", "scene/scene_file.hpp"},
                                                        {"src/tool/scene/scene_file.cpp", "plan/clock.hpp"},
                                                        {"src/tool/plan/clock.cpp", "commands/options.hpp"},
                                                        {"src/tool/main.cpp", "plan/clock.hpp"}}) {
    EXPECT_EQ(offence_of(path, "#include \"" + name + '"'), path + ": includes \"" + name + "\"\n");
  }
  EXPECT_EQ(offence_of("src/tool/commands/plan_command.cpp", "#include \"plan/clock.hpp\""), "");
  EXPECT_EQ(offence_of("src/tool/plan/clock.cpp", "#include \"io/output.hpp\""), "");
}

TEST(LayoutChecker, AcceptsWhatTheArrowsPermit) {
  EXPECT_EQ(offence_of("src/collision/json/json.hpp", "#include <nlohmann/json.hpp>"), "");
  EXPECT_EQ(offence_of("src/impulse/contact.hpp", "#include <Eigen/Geometry>"), "");
  EXPECT_EQ(offence_of("src/impulse/contact.hpp", "#include <carom/collision/outcome.hpp>"), "");
  EXPECT_EQ(offence_of("src/impulse/numbers/pack.hpp", "#include <experimental/simd>"), "");
  EXPECT_EQ(offence_of("src/subjects/engines/ode.cpp", "#include <ode/ode.h>"), "");
  EXPECT_EQ(offence_of("oracles/exact/gmpq.hpp", "#include <CGAL/Gmpq.h>"), "");
  EXPECT_EQ(offence_of("oracles/exact/roots.cpp", "#include <CGAL/Algebraic_kernel_d_1.h>"), "");
  EXPECT_EQ(offence_of("properties/gate/gate.cpp", "#include <carom/oracles/judge/accuracy.hpp>"), "");
  EXPECT_EQ(offence_of("properties/conformance/subject.hpp", "#include <carom/impulse/contact.hpp>"), "");
  EXPECT_EQ(offence_of("properties/conformance/suite.hpp", "#include <gtest/gtest.h>"), "");
  EXPECT_EQ(offence_of("properties/conformance/finding.hpp", "#include <rapidcheck.h>"), "");
  EXPECT_EQ(offence_of("src/tool/main.cpp", "#include <carom/properties/gate/gate.hpp>"), "");
  EXPECT_EQ(offence_of("src/impulse/contact.hpp", "// #include <CGAL/Gmpq.h>"), "");
}

TEST(LayoutChecker, FindsAMissingOrWrongLicence) {
  const std::string bsl = " SPDX-License-Identifier: BSL-1.0\n";
  const std::string gpl = " SPDX-License-Identifier: GPL-3.0-or-later\n";
  EXPECT_EQ(licence_offences("oracles/x.cpp", "//" + bsl), Offences{});
  EXPECT_EQ(licence_offences("src/impulse/x.hpp", "//" + bsl), Offences{});
  EXPECT_EQ(licence_offences("tests/x.sh", "#!/bin/sh\n#" + bsl), Offences{});
  EXPECT_EQ(licence_offences("tests/CMakeLists.txt", "#" + bsl), Offences{});
  EXPECT_EQ(licence_offences("src/cmake/x.cmake", "#" + bsl), Offences{});
  EXPECT_EQ(licence_offences("docs/x.md", "no source file"), Offences{});
  for (const auto& [path, text] : std::vector<std::pair<std::string, std::string>>{
           {"oracles/x.cpp", "//" + gpl},
           {"src/impulse/x.hpp", "//" + gpl},
           {"tests/CMakeLists.txt", "#" + gpl},
           {"oracles/x.cpp", ""},
           {"oracles/x.cpp", "#" + bsl},
           {"oracles/x.cpp", "\n//" + bsl},
           {"oracles/x.cpp", "// SPDX-License-Identifier: BSL-1.0-or-not\n"},
           {"tests/x.sh", "#!/bin/sh\necho\n#" + bsl},
           {"src/cmake/x.cmake", ""},
       }) {
    EXPECT_EQ(licence_offences(path, text).size(), 1U) << path << '\n' << text;
  }
}

TEST(LayoutChecker, FindsWhatIsMissingOrTooMuchAtTheTop) {
  const std::vector<std::string> house{"CMakeLists.txt", "CMakePresets.json", "README.md", "docs",
                                       "oracles",        "properties",        "src",       "tests"};
  std::vector<std::string> names = house;
  EXPECT_EQ(top_level_offences(names), Offences{});
  names.insert(names.end(), {".github", ".clang-format", "build", "build-asan"});
  EXPECT_EQ(top_level_offences(names), Offences{});
  names.emplace_back("scripts");
  EXPECT_EQ(top_level_offences(names), Offences{"scripts should not be there"});
  for (const std::string& missing : house) {
    std::vector<std::string> rest = house;
    std::erase(rest, missing);
    EXPECT_EQ(top_level_offences(rest), Offences{missing + " is missing"});
  }
}

TEST(Layout, IsReadAtAll) {
  std::vector<std::string> seen;
  for (const SourceFile& file : source_files(top)) {
    EXPECT_FALSE(file.text.empty()) << file.path;
    seen.push_back(file.path);
  }
  for (const char* path : {"CMakeLists.txt", "oracles/models/superposition.hpp", "properties/gate/gate.cpp",
                           "src/collision/collision.hpp", "src/impulse/reflection.hpp", "src/subjects/engines/ode.cpp",
                           "src/tool/main.cpp", "tests/house/layout_test.cpp"}) {
    EXPECT_NE(std::find(seen.begin(), seen.end(), path), seen.end()) << path;
  }
}

TEST(Layout, KeepsTheArrowsBetweenTheFolders) {
  Offences offences;
  for (const SourceFile& file : source_files(top)) {
    const Offences more = include_offences(file.path, file.text);
    offences.insert(offences.end(), more.begin(), more.end());
  }
  EXPECT_EQ(joined(offences), "");
}

TEST(Layout, NamesTheLicenceOfEveryFile) {
  Offences offences;
  for (const SourceFile& file : source_files(top)) {
    const Offences more = licence_offences(file.path, file.text);
    offences.insert(offences.end(), more.begin(), more.end());
  }
  EXPECT_EQ(joined(offences), "");
}

TEST(Layout, HasNothingElseAtTheTop) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(top)) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_EQ(joined(top_level_offences(names)), "");
}

}  // namespace
}  // namespace carom::layout
