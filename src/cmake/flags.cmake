# SPDX-License-Identifier: BSL-1.0
# How Carom's own code is compiled. All of it is said of targets: what the user says by CMAKE_CXX_FLAGS and
# CMAKE_BUILD_TYPE, and what a project that contains this one says, stays as it is.

# Every target of Carom's links this.
add_library(carom_flags INTERFACE)
target_compile_options(carom_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                             $<$<BOOL:${CAROM_WARNINGS_AS_ERRORS}>:-Werror>)
# gcc that seldom collects its garbage takes a tenth less time, and a tenth more memory.
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
  # A target says that it is not to be checked by its property CAROM_NOT_SANITIZED.
  set(carom_is_sanitized $<NOT:$<BOOL:$<TARGET_PROPERTY:CAROM_NOT_SANITIZED>>>)
  foreach(option IN ITEMS ${carom_sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_options(carom_flags INTERFACE "$<${carom_is_sanitized}:${option}>")
  endforeach()
  target_link_options(carom_flags INTERFACE ${carom_sanitizers})
  # gcc 12 finds std::regex uninitialised under the sanitizers (GCC bug 105562).
  target_compile_options(carom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # Boost.Asio has a fence that ThreadSanitizer does not see; what it orders has locks as well.
  target_compile_options(carom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
endif()
if(CAROM_BUILD_FUZZERS AND NOT LIB_FUZZING_ENGINE)
  # The fuzzer sees which branches are taken in everything that is Carom's.
  target_compile_options(carom_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(CAROM_COVERAGE)
  target_compile_options(carom_flags INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(carom_flags INTERFACE --coverage)
endif()

# carom_optimise(TARGET LEVEL): in a Release build, LEVEL in place of CMake's -O3, for what would compile for longer and be
# no faster; or -O3 where that has to be said. Where the user has chosen a level, that one is kept.
string(STRIP "${CMAKE_CXX_FLAGS_RELEASE}" carom_release_flags)
string(STRIP "${CMAKE_CXX_FLAGS_RELEASE_INIT}" carom_default_release_flags)
if(carom_release_flags STREQUAL carom_default_release_flags AND NOT CMAKE_CXX_FLAGS MATCHES "(^| )-O")
  set(carom_chooses_levels TRUE)
else()
  set(carom_chooses_levels FALSE)
endif()
function(carom_optimise target level)
  if(carom_chooses_levels)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
  endif()
endfunction()
