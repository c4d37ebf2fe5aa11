# SPDX-License-Identifier: BSL-1.0
# Most of a unit's compile time is spent on headers. Therefore targets with the same flags share precompiled headers,
# and small files compile several at a time. Every file still includes what it needs, and compiles alone.

# ccache is used if it is installed and the user names no launcher. These settings let ccache accept precompiled
# headers. gcc must name such a header in the preprocessed text (-fpch-preprocess).
find_program(CAROM_CCACHE ccache)
if(PROJECT_IS_TOP_LEVEL AND CAROM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CAROM_CCACHE})
endif()

# gcc 12 does not treat a precompiled standard library as a system header. Its false alarms about std::string's
# operator+ then appear (GCC bug 105651).
set(carom_precompiled_options
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>)
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  list(APPEND carom_precompiled_options $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

# Most sources of the judge, the reports and the tests include these headers.
set(carom_frequent_headers <functional> <map> <string> <variant> <vector> <Eigen/Core> <Eigen/Geometry> <fmt/format.h>
                           <nlohmann/json.hpp>)

# carom_precompile(TARGET HEADER…): precompiles the headers for TARGET.
function(carom_precompile target)
  if(CAROM_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    target_compile_options(${target} PRIVATE "${carom_precompiled_options}")
  endif()
endfunction()

# carom_reuse_precompiled(TARGET FROM): TARGET reuses the precompiled headers of FROM. TARGET must be permitted to
# include them. It also takes the level of `carom_optimise` from FROM, because gcc compiles a unit at the level of its
# precompiled header, and ignores another level without a warning.
function(carom_reuse_precompiled target from)
  get_target_property(level ${from} CAROM_LEVEL)
  if(level)
    carom_optimise(${target} ${level})
  endif()
  if(CAROM_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${from})
    target_compile_options(${target} PRIVATE "${carom_precompiled_options}")
  endif()
endfunction()

# carom_unity(TARGET SIZE): compiles SIZE files at a time if CAROM_UNITY is on.
function(carom_unity target size)
  if(CAROM_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  endif()
endfunction()
