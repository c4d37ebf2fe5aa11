# SPDX-License-Identifier: BSL-1.0
# Which lines the tests run.
include(${CMAKE_CURRENT_LIST_DIR}/everything.cmake)
set(CAROM_COVERAGE ON CACHE BOOL "")
set(CMAKE_BUILD_TYPE Debug CACHE STRING "")
set(CMAKE_CXX_FLAGS_DEBUG -O1 CACHE STRING "")
