# SPDX-License-Identifier: GPL-3.0-or-later
# Which lines the tests run.
include(${CMAKE_CURRENT_LIST_DIR}/everything.cmake)
set(CAROM_COVERAGE ON CACHE BOOL "")
set(CMAKE_BUILD_TYPE Debug CACHE STRING "")
set(CMAKE_CXX_FLAGS_DEBUG -O1 CACHE STRING "")
