# SPDX-License-Identifier: BSL-1.0
# The tests that tests/mutation/mutate.py runs, in the least time, and with assertions: they notice a change that reads
# beyond the end of an array. A change may well make a warning.
set(CAROM_BUILD_TESTS ON CACHE BOOL "")
set(CAROM_UNITY ON CACHE BOOL "")
set(CMAKE_CXX_FLAGS "-w" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O1 -D_GLIBCXX_ASSERTIONS" CACHE STRING "")
