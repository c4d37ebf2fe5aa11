# SPDX-License-Identifier: BSL-1.0
# The user's options. CMakePresets.json has the values that bootstrap.sh uses.

option(CAROM_BUILD_TESTS "Build the tests, if all components are built" ${PROJECT_IS_TOP_LEVEL})
option(CAROM_WARNINGS_AS_ERRORS "Treat warnings in Carom's own code as errors" ${PROJECT_IS_TOP_LEVEL})
option(CAROM_UNITY "Compile small files several at a time: quicker, but no line for each in compile_commands.json" OFF)
option(CAROM_PRECOMPILED_HEADERS "Compile headers that most units include once" ON)
option(CAROM_CHECK_PRECONDITIONS "Check preconditions in a build that defines NDEBUG, too" OFF)
option(CAROM_ALL_INSTRUCTION_SETS "Compile the batch for every instruction set; OFF: the baseline alone" ON)
option(CAROM_COVERAGE "Count which lines are run" OFF)

set(CAROM_SANITIZE "" CACHE STRING "address (with undefined behaviour), thread, or nothing")
set_property(CACHE CAROM_SANITIZE PROPERTY STRINGS "" address thread)
if(NOT CAROM_SANITIZE MATCHES "^(address|thread)?$")
  message(FATAL_ERROR "CAROM_SANITIZE is address, thread or empty, not \"${CAROM_SANITIZE}\"")
endif()

option(CAROM_BUILD_FUZZERS "Build the targets of tests/fuzz for a fuzzing engine; without it they replay files" OFF)
# Each fuzz target links to this library or flag, as in OSS-Fuzz. The user provides the matching compile flags. If this
# variable is empty, fuzz targets use clang's libFuzzer with AddressSanitizer and UndefinedBehaviorSanitizer.
set(LIB_FUZZING_ENGINE "$ENV{LIB_FUZZING_ENGINE}" CACHE STRING "The fuzzing engine: a library or a flag of the linker")
if(CAROM_BUILD_FUZZERS AND NOT LIB_FUZZING_ENGINE)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "CAROM_BUILD_FUZZERS needs clang, or LIB_FUZZING_ENGINE")
  endif()
  if(NOT CAROM_SANITIZE)
    set(CAROM_SANITIZE address)
  endif()
endif()

# A containing project chooses its own build type.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
