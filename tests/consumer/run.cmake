# SPDX-License-Identifier: BSL-1.0
# cmake -DBUILD=… -DWORK=… -DCONSUMER=… -P run.cmake: installs into WORK, builds the consumers against that
# installation, and runs them.

include(${CMAKE_CURRENT_LIST_DIR}/commands.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)

set(pages ${CONSUMER}/../..)
lines_of(${pages}/docs/guide/use-from-cpp.md "    #include <carom/impulse/reflection.hpp>\n" "\n    }\n" example)
file(WRITE ${WORK}/page_example.cpp "${example}")
lines_of(${pages}/docs/guide/use-from-cpp.md "    -1.5" "\n" printed)

# The solvers and the gate need neither GoogleTest nor RapidCheck. Preconditions are checked, but nobody debugs.
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/installed
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= -DPAGE_EXAMPLE=${WORK}/page_example.cpp
    -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON)
# solvers_alone.cmake runs the programs `solve` and `batch`.
run(${CMAKE_COMMAND} --build ${WORK}/build --target page_example judge report builtin scene)
run(${WORK}/build/page_example)
if(NOT output STREQUAL printed)
  message(FATAL_ERROR "docs/guide/use-from-cpp.md says that its example prints\n${printed}it prints\n${output}")
endif()
run(${WORK}/build/judge)
run(${WORK}/build/report)
run(${WORK}/build/builtin)
run(${WORK}/build/scene)

# Every library is a component. The headers of oracles and scenes contain error bounds, which hold only if the compiler
# rounds each product separately. Libraries that include these headers pass -ffp-contract=off to their users. No other
# library passes an option.
set(components collision impulse batch collision_json messages oracles properties judge report protocol subjects plan scene scene_json
               scene_polyhedra scene_properties kit conformance)
list(JOIN components "," names)
run(${CMAKE_COMMAND} -S ${CONSUMER}/components -B ${WORK}/components -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/installed
    -DCOMPONENTS=${names})
foreach(component IN LISTS components)
  file(READ ${WORK}/components/${component}.options options)
  set(expected "")
  if(component MATCHES "^(scene.*|oracles|properties|judge|report|plan)$")
    set(expected "-ffp-contract=off")
  endif()
  list(REMOVE_DUPLICATES options)
  list(FILTER options EXCLUDE REGEX "^-D") # definitions of GoogleTest
  if(NOT "${options}" STREQUAL "${expected}")
    message(FATAL_ERROR "carom::${component} asks its users for the options: ${options}")
  endif()
endforeach()
run_expecting(1 ${CMAKE_COMMAND} -S ${CONSUMER}/components -B ${WORK}/unknown -G Ninja
              -DCMAKE_PREFIX_PATH=${WORK}/installed -DCOMPONENTS=juggling)
expect_output("its component juggling is not installed here" "scene_polyhedra" "kit")

# The examples of README.md and of the guide to the kit test my_solver.hpp, which is right, or wrong if MY_SOLVER is set.
set(kit ${WORK}/kit)
set(guide ${pages}/docs/guide/conformance.md)
file(COPY ${CONSUMER}/my_solver.hpp DESTINATION ${kit})
lines_of(${pages}/README.md "    #include <carom/properties/three_properties.hpp>\n" "\n    }\n" property)
file(WRITE ${kit}/readme_property.cpp "${property}")
lines_of(${guide} "    #include <carom/properties/three_properties.hpp>\n" "\n    }\n" property)
lines_of(${guide} "    RC_GTEST_PROP(MySolver, NeverPenetratesHere" "\n    }\n" chosen)
lines_of(${guide} "carom::properties::momentum_conservation(my_solver, c, {.precision" "})" call)
lines_of(${guide} "return {outcome, matrix};" ";" shown)
file(WRITE ${kit}/guide_properties.cpp "${property}${chosen}
RC_GTEST_PROP(MySolver, ConservesMomentumInGames, (const carom::Collision& c)) {
  RC_ASSERT(${call});
}

#include <carom/impulse/collision_matrix.hpp>

// The wrong solver turns the signs of its matrix.
carom::SolvedOutcome<double> my_solver_with_matrix(const carom::Collision& c) {
  const carom::Outcome<double> outcome = my_solver(c);
  const double sign = std::getenv(\"MY_SOLVER\") == nullptr ? 1 : -1;
  const carom::Matrix3<double> matrix = sign * carom::impulse::collision_matrix(carom::impulse::make_contact<double>(c));
  ${shown}
}

RC_GTEST_PROP(MySolver, HasADefiniteMatrix, (const carom::Collision& c)) {
  RC_ASSERT(carom::properties::positive_definiteness(my_solver_with_matrix, c));
}
")
write_suite(${CONSUMER} ${kit}/my_test.cpp)
lines_of(${guide} "    CAROM_CONFORMANCE(MySolverInGames" ";\n" suite)
file(WRITE ${kit}/my_options.cpp "#include <carom/conformance.hpp>\n#include \"my_solver.hpp\"\n${suite}")
set(own_types ${pages}/docs/guide/my-own-types.md)
lines_of(${own_types} "    #pragma once\n" "turn_of_b, -impulse);\n    }\n" engine)
file(WRITE ${kit}/my_engine.hpp "${engine}")
lines_of(${own_types} "    #include <carom/conformance.hpp>\n" "});\n" engine_test)
file(WRITE ${kit}/my_engine_test.cpp "${engine_test}")
lines_of(${guide} "    cmake_minimum_required" "gtest_main)\n" project)
file(WRITE ${kit}/CMakeLists.txt "${project}
target_sources(my_test PRIVATE my_options.cpp)
foreach(name readme_property guide_properties my_engine_test)
  add_executable(\${name} \${name}.cpp)
  target_link_libraries(\${name} PRIVATE carom::kit GTest::gtest_main)
endforeach()
")
run(${CMAKE_COMMAND} -S ${kit} -B ${kit}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/installed -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=)
run(${CMAKE_COMMAND} --build ${kit}/build)

# Runs a program of the kit, which must end with the exit status `expected` if the solver is `solver`. `parameters` are
# those of RapidCheck. Further arguments are those of the program.
macro(run_kit solver expected parameters program)
  set(wrong)
  if("${solver}" STREQUAL "wrong")
    set(wrong MY_SOLVER=wrong)
  endif()
  run_expecting(${expected} ${CMAKE_COMMAND} -E env ${wrong} "RC_PARAMS=${parameters}" ${kit}/build/${program} ${ARGN})
endmacro()
# Expects the lines of the page from `first` to `last` in the last output. A line … stands for any lines.
function(expect_lines page first last)
  lines_of(${page} "${first}" "${last}" said)
  string(REPLACE "\n" ";" said "${said}")
  foreach(line IN LISTS said)
    string(REGEX REPLACE "…$" "" line "${line}")
    string(STRIP "${line}" line)
    expect_output("${line}")
  endforeach()
endfunction()

# Runs one property or suite alone. It must hold for the right solver, and fail for the wrong one.
function(tell_apart program parameters filter)
  run_kit(right 0 ${parameters} ${program} --gtest_filter=${filter})
  expect_output("[  PASSED  ] ")
  if(output MATCHES "Running 0 tests")
    message(FATAL_ERROR "${program} has no test ${filter}")
  endif()
  run_kit(wrong 1 ${parameters} ${program} --gtest_filter=${filter})
  expect_output("[  FAILED  ] ")
endfunction()
foreach(property ConservesMomentum NeverPenetratesHere ConservesMomentumInGames HasADefiniteMatrix)
  tell_apart(guide_properties seed=2 MySolver.${property})
endforeach()
tell_apart(readme_property seed=2 MySolver.NeverPenetrates)
tell_apart(my_test "seed=1 max_success=10" MySolver/*_in_generic)
tell_apart(my_test "seed=1 max_success=10" MySolverInGames/*_in_generic)
run_kit(right 0 seed=1 my_engine_test)
run_kit(wrong 1 seed=2 readme_property)
expect_lines(${pages}/README.md "      A: mass 1, " "allowed ")
# RapidCheck's string reproduces the same collision without shrinking.
if(NOT output MATCHES "RC_PARAMS=\"(reproduce=[^\"]*)\"")
  message(FATAL_ERROR "RapidCheck prints no string to reproduce the failure\n${output}")
endif()
run_kit(wrong 1 ${CMAKE_MATCH_1} readme_property)
expect_lines(${pages}/README.md "      A: mass 1, " "allowed ")
# A program has only the tests that it states.
run_kit(right 0 seed=2 readme_property --gtest_list_tests)
if(NOT output MATCHES "MySolver\\.\n  NeverPenetrates\n" OR output MATCHES "Conformance|GoogleTestVerification")
  message(FATAL_ERROR "the program of README.md has the tests\n${output}")
endif()

run_kit(right 0 "seed=1 max_success=10" my_test)
expect_output("[       OK ] MySolver/Conformance.Holds/restitution_in_near_head_on"
              "[       OK ] MySolverInGames/Conformance.Holds/restitution_in_generic"
              "[       OK ] MySolver/Conformance.JudgesEachInvariant")
run_kit(right 0 seed=1 my_test --gtest_list_tests "--gtest_filter=MySolver/*_in_generic")
expect_output("MySolver/Conformance.\n  Holds/" "Holds/restitution_in_generic  # GetParam() = restitution of my solver in generic\n")
run_kit(wrong 1 seed=1 my_test "--gtest_filter=MySolver/*_in_generic")
expect_lines(${guide} "    my solver violates restitution in generic" "restitution_in_generic\n")
expect_output("[  SKIPPED ] " " tests, each with its reason above." "RC_PARAMS=" "[       OK ] MySolver/Conformance.Holds/push_in_generic")
string(FIND "${output}" "[==========] " start REVERSE)
string(SUBSTRING "${output}" ${start} -1 closing)
string(REGEX REPLACE "\n+Some of your RapidCheck properties had failures.*" "\n" closing "${closing}")
if(NOT closing MATCHES "\\[  FAILED  \\] MySolver/Conformance.Holds/[a-z_]*\n$" OR closing MATCHES "SKIPPED \\] MySolver")
  message(FATAL_ERROR "the closing lines are\n${closing}")
endif()

run_expecting(1 ${CMAKE_COMMAND} -E env CAROM_EXACT=maybe ${kit}/build/my_test)
expect_output("CAROM_EXACT: expected" "[  FAILED  ] MySolver/Conformance.Holds/options")
run_kit(right 1 seed=x my_test)

# A user's file may be compiled with any flags. So it must not contain compiled code on which the error bounds of the
# judge rely.
find_program(nm nm REQUIRED)
file(GLOB_RECURSE objects ${kit}/*.o)
run(${nm} --demangle --defined-only ${objects})
if(NOT output MATCHES "carom::conformance::" OR output MATCHES "[WVu] [^\n]*carom::oracles::[A-Za-z_]*(<|\\()")
  message(FATAL_ERROR "a user's file defines functions of carom::oracles\n${CMAKE_MATCH_0}")
endif()
