# SPDX-License-Identifier: BSL-1.0
# cmake -DSOURCE=… -DWORK=… -DCONSUMER=… -DCOMPILER=… -P solvers_alone.cmake: builds and installs the solvers into WORK,
# and uses them. CMake can find no package but Eigen.

include(${CMAKE_CURRENT_LIST_DIR}/commands.cmake)

# The build that runs this test compiles all instruction sets.
set(nothing_else -DCMAKE_CXX_COMPILER=${COMPILER} -DCAROM_ALL_INSTRUCTION_SETS=OFF)
foreach(package Boost CGAL CLI11 GTest PkgConfig Threads benchmark fmt nlohmann_json pugixml rapidcheck)
  list(APPEND nothing_else -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build --preset solvers ${nothing_else})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${WORK}/installed)
file(GLOB folders RELATIVE ${WORK}/installed/include/carom ${WORK}/installed/include/carom/*)
foreach(page BSL-1.0.txt README.md)
  if(NOT EXISTS ${WORK}/installed/share/doc/carom/licences/${page})
    message(FATAL_ERROR "licences/${page} is not installed")
  endif()
endforeach()
if(NOT folders STREQUAL "collision;impulse")
  message(FATAL_ERROR "installed: ${folders}")
endif()

function(configure_consumer expected components)
  run_expecting(${expected} ${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/consumer -G Ninja ${nothing_else}
                -DCMAKE_PREFIX_PATH=${WORK}/installed -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= -DCOMPONENTS=${components})
  set(output "${output}" PARENT_SCOPE)
endfunction()
configure_consumer(1 kit)
expect_output("its component kit is not installed here")
configure_consumer(0 impulse)
configure_consumer(0 "")
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/solve)
run(${WORK}/consumer/batch)
