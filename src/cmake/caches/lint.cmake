# SPDX-License-Identifier: BSL-1.0
# For readers of compile_commands.json other than the compiler: a line for each file, without headers that only the compiler
# that precompiled them can read.
set(CAROM_BUILD_TESTS ON CACHE BOOL "")
set(CAROM_PRECOMPILED_HEADERS OFF CACHE BOOL "")
set(CMAKE_CXX_COMPILER clang++ CACHE STRING "")
