# SPDX-License-Identifier: BSL-1.0
# The components of Carom. Each component can be built and installed without the components that it does not need.

set(CAROM_COMPONENTS all CACHE STRING
    "What is built and installed: a list of impulse, judge, report, kit, program, scenes, web and proofs, or all but web and proofs")

# For each component: the components that it needs, the CMake packages of its build, and the CMake packages of its
# users.
set(carom_parts impulse judge report kit program scenes)
set(carom_impulse_packages "Eigen3 3.4")
set(carom_impulse_packages_of_users "Eigen3 3.4")
set(carom_judge_needs impulse)
set(carom_judge_packages CGAL fmt nlohmann_json)
set(carom_judge_packages_of_users CGAL fmt nlohmann_json)
set(carom_report_needs judge)
set(carom_report_packages pugixml)
set(carom_report_packages_of_users pugixml)
set(carom_kit_needs judge)
set(carom_kit_packages_of_users GTest rapidcheck)
set(carom_program_needs report)
set(carom_program_packages Boost CLI11 Threads PkgConfig benchmark)
set(carom_program_packages_of_users Boost Threads)
set(carom_scenes_needs program)
set(carom_scenes_packages fcl)
# Only emscripten builds this component. src/cmake/webassembly.cmake finds what it needs.
set(carom_web_needs report)
# The proofs contain no C++ and need no CMake package.

# The components to build. Each one follows the components that it needs.
set(CAROM_BUILT)
function(carom_build_component part)
  if(NOT part IN_LIST carom_parts AND NOT part MATCHES "^(web|proofs)$")
    list(JOIN carom_parts ", " names)
    message(FATAL_ERROR "CAROM_COMPONENTS is all, or a list of ${names}, web and proofs, not \"${CAROM_COMPONENTS}\"")
  endif()
  foreach(needed IN LISTS carom_${part}_needs)
    carom_build_component(${needed})
  endforeach()
  list(APPEND CAROM_BUILT ${part})
  list(REMOVE_DUPLICATES CAROM_BUILT)
  set(CAROM_BUILT ${CAROM_BUILT} PARENT_SCOPE)
endfunction()
if("all" IN_LIST CAROM_COMPONENTS)
  set(carom_wanted ${carom_parts})
else()
  set(carom_wanted ${CAROM_COMPONENTS})
endif()
foreach(part IN LISTS carom_wanted)
  carom_build_component(${part})
endforeach()

# carom_component(PART): the libraries that the folder installs after this call belong to PART. A program and the files
# that it reads belong to the install component `carom`.
macro(carom_component part)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME ${part})
endmacro()
