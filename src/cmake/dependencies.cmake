# SPDX-License-Identifier: BSL-1.0

if(EMSCRIPTEN)
  include(src/cmake/webassembly.cmake)
  return()
endif()
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
foreach(part IN LISTS CAROM_BUILT)
  foreach(package IN LISTS carom_${part}_packages)
    separate_arguments(words UNIX_COMMAND "${package}")
    find_package(${words} REQUIRED)
  endforeach()
endforeach()
