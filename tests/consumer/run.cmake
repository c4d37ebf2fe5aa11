# SPDX-License-Identifier: BSL-1.0
# cmake -DBUILD=… -DWORK=… -DCONSUMER=… -P run.cmake: installs into WORK, builds the consumers against that
# installation, and runs them.

include(${CMAKE_CURRENT_LIST_DIR}/commands.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)

file(READ ${CONSUMER}/../../docs/guide/use-from-cpp.md page)
if(NOT page MATCHES "    (#include <carom/impulse/reflection.hpp>\n.*\n    }\n)\nIt prints\n\n    ([^\n]*\n)")
  message(FATAL_ERROR "docs/guide/use-from-cpp.md shows no C++ and what it prints")
endif()
set(printed "${CMAKE_MATCH_2}")
string(REPLACE "\n    " "\n" example "${CMAKE_MATCH_1}")
file(WRITE ${WORK}/page_example.cpp "${example}")

# The solvers and the gate need neither GoogleTest nor RapidCheck.
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/installed
    -DCMAKE_BUILD_TYPE=Debug -DPAGE_EXAMPLE=${WORK}/page_example.cpp -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/solve)
run(${WORK}/build/page_example)
if(NOT output STREQUAL printed)
  message(FATAL_ERROR "docs/guide/use-from-cpp.md says that its example prints\n${printed}it prints\n${output}")
endif()
run(${WORK}/build/batch)
run(${WORK}/build/judge)
run(${WORK}/build/report)
run(${WORK}/build/builtin)
run(${WORK}/build/scene)
run(${WORK}/installed/bin/carom subjects)

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

file(READ ${CONSUMER}/../../README.md readme)
if(NOT readme MATCHES "    (#include <carom/properties/three_properties.hpp>\n.*\n    }\n)\n[^\n]*RapidCheck prints[^\n]*\n\n((    [^\n]*\n)+)")
  message(FATAL_ERROR "README.md shows no property and what RapidCheck prints")
endif()
set(property "${CMAKE_MATCH_1}")
string(REPLACE "\n" ";" said "${CMAKE_MATCH_2}")
string(REPLACE "\n    " "\n" property "${property}")
file(WRITE ${WORK}/readme_property.cpp "${property}")

run(${CMAKE_COMMAND} -S ${CONSUMER}/conformance -B ${WORK}/conformance -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/installed
    -DCMAKE_BUILD_TYPE=Debug -DREADME_PROPERTY=${WORK}/readme_property.cpp)
run(${CMAKE_COMMAND} --build ${WORK}/conformance)
run_expecting(1 ${CMAKE_COMMAND} -E env RC_PARAMS=seed=2 ${WORK}/conformance/readme_property)
macro(expect_said)
  foreach(line IN LISTS said)
    string(STRIP "${line}" line)
    if(NOT line STREQUAL "…")
      expect_output("${line}")
    endif()
  endforeach()
endmacro()
expect_said()
# RapidCheck's string reproduces the same collision without shrinking.
if(NOT output MATCHES "RC_PARAMS=\"(reproduce=[^\"]*)\"")
  message(FATAL_ERROR "RapidCheck prints no string to reproduce the failure\n${output}")
endif()
run_expecting(1 ${CMAKE_COMMAND} -E env RC_PARAMS=${CMAKE_MATCH_1} ${WORK}/conformance/readme_property)
expect_said()

run(${CMAKE_COMMAND} -E env "RC_PARAMS=seed=1 max_success=10" ${WORK}/conformance/sound_test)
expect_output("[       OK ] Textbook/Conformance.Holds/restitution_in_near_head_on")
run_expecting(1 ${CMAKE_COMMAND} -E env RC_PARAMS=seed=1 ${WORK}/conformance/mutant_test)
expect_output("mutant violates restitution in generic" "The normal velocity is reversed and multiplied by ε."
              "A: mass 1, principal inertia (1, 1, 1)" "  answered" "N·V⁺ and −ε N·V⁻: 2 and 1, apart by 1, allowed"
              "RC_PARAMS=" "[       OK ] Mutant/Conformance.Holds/restitution_in_inelastic")
expect_output("[  SKIPPED ] " " tests, each with its reason above.")
string(FIND "${output}" "[==========] " start REVERSE)
string(SUBSTRING "${output}" ${start} -1 closing)
string(REGEX REPLACE "\n+Some of your RapidCheck properties had failures.*" "\n" closing "${closing}")
if(NOT closing MATCHES "\\[  FAILED  \\] Mutant/Conformance.Holds/[a-z_]*\n$" OR closing MATCHES "SKIPPED \\] Mutant")
  message(FATAL_ERROR "the closing lines are\n${closing}")
endif()

run_expecting(1 ${CMAKE_COMMAND} -E env CAROM_EXACT=maybe ${WORK}/conformance/sound_test)
expect_output("CAROM_EXACT: expected" "[  FAILED  ] Textbook/Conformance.Holds/options")
run_expecting(1 ${CMAKE_COMMAND} -E env RC_PARAMS=seed=x ${WORK}/conformance/sound_test)

# A user's file may be compiled with any flags. So it must not contain compiled code on which the error bounds of the
# judge rely.
find_program(nm nm REQUIRED)
file(GLOB_RECURSE objects ${WORK}/conformance/*.o)
run(${nm} --demangle --defined-only ${objects})
if(NOT output MATCHES "carom::conformance::" OR output MATCHES "[WVu] [^\n]*carom::oracles::[A-Za-z_]*(<|\\()")
  message(FATAL_ERROR "a user's file defines functions of carom::oracles\n${CMAKE_MATCH_0}")
endif()
