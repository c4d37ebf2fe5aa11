# SPDX-License-Identifier: BSL-1.0
# AddressSanitizer, UndefinedBehaviorSanitizer, and all assertions.
include(${CMAKE_CURRENT_LIST_DIR}/everything.cmake)
set(CAROM_SANITIZE address CACHE STRING "")
set(CMAKE_BUILD_TYPE Debug CACHE STRING "")
set(CMAKE_CXX_FLAGS_DEBUG -O1 CACHE STRING "")
set(CAROM_CHECK_PRECONDITIONS ON CACHE BOOL "")
