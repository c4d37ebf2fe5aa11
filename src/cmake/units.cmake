# SPDX-License-Identifier: BSL-1.0
# Headers take most of the time that a unit takes to compile. So those that most units include are compiled once for each
# group of targets that share their flags, and small files several at a time. Every file includes what it needs all the
# same, and builds by itself.

# A cache of compilations is used if it is installed and the user names no launcher. Its sloppiness lets it
# take precompiled headers, and gcc has to name that header in the text that it preprocesses.
find_program(CAROM_CCACHE ccache)
if(PROJECT_IS_TOP_LEVEL AND CAROM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CAROM_CCACHE})
endif()

# Precompiled, the standard library is no system header to gcc 12, whose false alarms about std::string's operator+ then
# show (GCC bug 105651).
set(carom_precompiled_options
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>)
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  list(APPEND carom_precompiled_options $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

# carom_precompile(TARGET HEADER…)
function(carom_precompile target)
  if(CAROM_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    target_compile_options(${target} PRIVATE "${carom_precompiled_options}")
  endif()
endfunction()

# carom_reuse_precompiled(TARGET FROM): only from what TARGET may include of.
function(carom_reuse_precompiled target from)
  if(CAROM_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${from})
    target_compile_options(${target} PRIVATE "${carom_precompiled_options}")
  endif()
endfunction()

# carom_unity(TARGET SIZE): so many files at a time, where that is asked for.
function(carom_unity target size)
  if(CAROM_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  endif()
endfunction()
