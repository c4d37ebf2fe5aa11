// SPDX-License-Identifier: BSL-1.0
#include "header_licences.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/program.hpp"

namespace carom::header_licences {
namespace {

namespace fs = std::filesystem;

using Offences = std::vector<std::string>;

/// Targets of test programs that use a GPL part of CGAL. No test program is installed.
const std::set<std::string> gpl_test_programs{};

constexpr const char* listing =
    "oracles/CMakeFiles/carom_rational.dir/exact/rational.cpp.o: #deps 3, deps mtime 1700000000000000000 (VALID)\n"
    "    ../oracles/exact/rational.cpp\n"
    "    /usr/include/CGAL/Gmpq.h\n"
    "    /usr/include/CGAL/Planted.h\n"
    "\n"
    "tests/oracles/CMakeFiles/planted_test.dir/exact/planted_test.cpp.o: #deps 1, deps mtime 1700000000000000000 "
    "(STALE)\n"
    "    /usr/include/CGAL/Other.h\n"
    "\n";

std::string planted_text(const std::string& header) {
  const std::string licence = header == "/usr/include/CGAL/Gmpq.h" ? "LGPL-3.0-or-later" : "GPL-3.0-or-later";
  return "// Copyright (c) 2001\n// SPDX-License-Identifier: " + licence + " OR LicenseRef-Commercial\n#pragma once\n";
}

TEST(HeaderLicenceChecker, ReadsTheListingOfNinja) {
  const std::vector<CompiledObject> objects = objects_of(listing);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].file, "oracles/CMakeFiles/carom_rational.dir/exact/rational.cpp.o");
  EXPECT_EQ(objects[0].sources, (std::vector<std::string>{"../oracles/exact/rational.cpp", "/usr/include/CGAL/Gmpq.h",
                                                          "/usr/include/CGAL/Planted.h"}));
  EXPECT_EQ(objects[1].sources, std::vector<std::string>{"/usr/include/CGAL/Other.h"});
  EXPECT_EQ(target_of(objects[0].file), "carom_rational");
  EXPECT_EQ(target_of(objects[1].file), "planted_test");
  EXPECT_EQ(target_of("rational.o"), "");
}

TEST(HeaderLicenceChecker, ReadsTags) {
  for (const char* licence : {"LGPL-3.0-or-later OR LicenseRef-Commercial", "LGPL-3.0-only", "BSL-1.0"}) {
    EXPECT_EQ(licence_offence(std::string(" * SPDX-License-Identifier: ") + licence + "\n"), "") << licence;
  }
  for (const char* licence :
       {"GPL-3.0-or-later OR LicenseRef-Commercial", "( GPL-3.0-or-later OR LicenseRef-Commercial ) AND MIT",
        "(GPL-3.0-or-later OR LicenseRef-Commercial) AND MIT", "LGPL-3.0-or-later AND GPL-3.0-or-later",
        "GPL-2.0-or-later", "AGPL-3.0-only"}) {
    EXPECT_NE(licence_offence(std::string(" * SPDX-License-Identifier: ") + licence + "\n"), "") << licence;
  }
  EXPECT_NE(licence_offence("// SPDX-License-Identifier: BSL-1.0\n// SPDX-License-Identifier: GPL-3.0-or-later\n"), "");
  EXPECT_EQ(licence_offence("#pragma once\n"), "names no licence");
}

TEST(HeaderLicenceChecker, FindsAPlantedGplHeader) {
  const Offences of_rational{
      "/usr/include/CGAL/Planted.h is under GPL-3.0-or-later, and "
      "oracles/CMakeFiles/carom_rational.dir/exact/rational.cpp.o includes it"};
  EXPECT_EQ(header_offences(objects_of(listing), {"planted_test"}, planted_text), of_rational);
  EXPECT_EQ(header_offences(objects_of(listing), {}, planted_text).size(), 2U) << "no test program is listed";
  EXPECT_EQ(header_offences(objects_of(listing), {"planted_test", "carom_rational"}, planted_text), of_rational)
      << "what is outside of tests/ is judged though it is listed";
}

TEST(HeaderLicences, OfCgalAllowBsl) {
  const std::string ninja = CAROM_NINJA;
  if (ninja.empty()) {
    GTEST_SKIP() << "the generator is not Ninja: nothing lists the headers that were included";
  }
  const fs::path build = CAROM_BUILD_DIR;
  const tests::RunResult run = tests::run_program(ninja, {"-C", build.string(), "-t", "deps"});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  const std::vector<CompiledObject> objects = objects_of(run.output);
  EXPECT_TRUE(std::any_of(objects.begin(), objects.end(), [](const CompiledObject& object) {
    return target_of(object.file) == "carom_rational" &&
           std::any_of(object.sources.begin(), object.sources.end(), is_of_cgal);
  })) << "the listing has no header of CGAL in rational.cpp";
  EXPECT_EQ(header_offences(objects, gpl_test_programs,
                            [&](const std::string& header) { return tests::content_of(build / header); }),
            Offences{});
}

TEST(HeaderLicences, OfTestProgramsReachNoUser) {
  int files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(CAROM_SOURCE_DIR) / "tests")) {
    if (entry.path().filename() == "CMakeLists.txt") {
      ++files;
      EXPECT_EQ(tests::content_of(entry.path()).find("install("), std::string::npos)
          << entry.path() << " installs something";
    }
  }
  EXPECT_GT(files, 10);
}

}  // namespace
}  // namespace carom::header_licences
