# SPDX-License-Identifier: BSL-1.0
# ThreadSanitizer, and all assertions.
include(${CMAKE_CURRENT_LIST_DIR}/everything.cmake)
set(CAROM_SANITIZE thread CACHE STRING "")
set(CMAKE_BUILD_TYPE Debug CACHE STRING "")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1" CACHE STRING "")
set(CAROM_CHECK_PRECONDITIONS ON CACHE BOOL "")
