# SPDX-License-Identifier: BSL-1.0
# carom_flags: the compile options of Carom's own code. They are set on targets only, so CMAKE_CXX_FLAGS,
# CMAKE_BUILD_TYPE and the options of a containing project stay unchanged.

add_library(carom_flags INTERFACE)
target_compile_options(carom_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                             $<$<BOOL:${CAROM_WARNINGS_AS_ERRORS}>:-Werror>)
# If gcc collects garbage less often, it takes a tenth less time and a tenth more memory.
target_compile_options(carom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=400>
                                             $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=600000>)

if(CAROM_CHECK_PRECONDITIONS)
  target_compile_definitions(carom_flags INTERFACE CAROM_CHECK_PRECONDITIONS=1) # src/collision/expects.hpp
endif()

if(CAROM_SANITIZE STREQUAL "address")
  set(carom_sanitizers -fsanitize=address -fsanitize=undefined)
elseif(CAROM_SANITIZE STREQUAL "thread")
  set(carom_sanitizers -fsanitize=thread)
endif()
if(CAROM_SANITIZE)
  # The property CAROM_NOT_SANITIZED excludes a target.
  set(carom_is_sanitized $<NOT:$<BOOL:$<TARGET_PROPERTY:CAROM_NOT_SANITIZED>>>)
  foreach(option IN ITEMS ${carom_sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_options(carom_flags INTERFACE "$<${carom_is_sanitized}:${option}>")
  endforeach()
  target_link_options(carom_flags INTERFACE ${carom_sanitizers})
  # Under the sanitizers, gcc 12 reports std::regex as uninitialised (GCC bug 105562).
  target_compile_options(carom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # ThreadSanitizer does not see a fence of Boost.Asio. Locks protect the same data.
  target_compile_options(carom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
endif()
if(CAROM_BUILD_FUZZERS AND NOT LIB_FUZZING_ENGINE)
  # The fuzzer observes the branches of all of Carom's code.
  target_compile_options(carom_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(CAROM_COVERAGE)
  target_compile_options(carom_flags INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(carom_flags INTERFACE --coverage)
endif()

# carom_optimise(TARGET LEVEL): compiles TARGET at LEVEL in a Release build, in place of CMake's -O3. It does nothing if
# the user chose a level. Use a lower level for code that -O3 makes no faster. It is an error for a TARGET that reuses
# precompiled headers, which has their level (units.cmake).
string(STRIP "${CMAKE_CXX_FLAGS_RELEASE}" carom_release_flags)
string(STRIP "${CMAKE_CXX_FLAGS_RELEASE_INIT}" carom_default_release_flags)
if(carom_release_flags STREQUAL carom_default_release_flags AND NOT CMAKE_CXX_FLAGS MATCHES "(^| )-O")
  set(carom_chooses_levels TRUE)
else()
  set(carom_chooses_levels FALSE)
endif()
function(carom_optimise target level)
  get_target_property(shared ${target} PRECOMPILE_HEADERS_REUSE_FROM)
  if(shared)
    message(FATAL_ERROR "${target} has the level of ${shared}, whose precompiled headers it reuses")
  endif()
  set_target_properties(${target} PROPERTIES CAROM_LEVEL ${level})
  if(carom_chooses_levels)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
  endif()
endfunction()
