# SPDX-License-Identifier: BSL-1.0
# The targets of tests/fuzz for clang's libFuzzer, with AddressSanitizer, UndefinedBehaviorSanitizer, and all assertions.
set(CAROM_BUILD_FUZZERS ON CACHE BOOL "")
set(CAROM_BUILD_TESTS OFF CACHE BOOL "")
set(CAROM_WARNINGS_AS_ERRORS ON CACHE BOOL "")
set(CAROM_UNITY ON CACHE BOOL "")
set(CMAKE_CXX_COMPILER clang++ CACHE STRING "")
set(CMAKE_BUILD_TYPE Debug CACHE STRING "")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1" CACHE STRING "")
