# SPDX-License-Identifier: BSL-1.0
# The report records the compile flags of each library, as CMake composes them. Extra flags of a single file (an engine
# in src/subjects) are not recorded.

function(carom_libraries_below directory result)
  get_property(targets DIRECTORY ${directory} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(folders DIRECTORY ${directory} PROPERTY SUBDIRECTORIES)
  set(libraries)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(STATIC|SHARED|OBJECT)_LIBRARY$")
      list(APPEND libraries ${target})
    endif()
  endforeach()
  foreach(folder IN LISTS folders)
    carom_libraries_below(${folder} below)
    list(APPEND libraries ${below})
  endforeach()
  set(${result} ${libraries} PARENT_SCOPE)
endfunction()

# carom_record_flags(TARGET): gives TARGET a header io/compiled.hpp with the flags of every library defined so far.
function(carom_record_flags recorder)
  carom_libraries_below(${PROJECT_SOURCE_DIR} libraries)
  list(SORT libraries)
  set(of_configuration ${CMAKE_CXX_FLAGS})
  foreach(configuration IN LISTS CMAKE_BUILD_TYPE CMAKE_CONFIGURATION_TYPES)
    string(TOUPPER ${configuration} upper)
    string(APPEND of_configuration "$<$<CONFIG:${configuration}>: ${CMAKE_CXX_FLAGS_${upper}}>")
  endforeach()
  set(entries)
  foreach(library IN LISTS libraries)
    # CMake leaves empty and repeated entries out of the compile line.
    set(definitions $<REMOVE_DUPLICATES:$<FILTER:$<TARGET_PROPERTY:${library},COMPILE_DEFINITIONS>,INCLUDE,.>>)
    set(options $<REMOVE_DUPLICATES:$<FILTER:$<TARGET_PROPERTY:${library},COMPILE_OPTIONS>,INCLUDE,.>>)
    set(independent $<TARGET_PROPERTY:${library},POSITION_INDEPENDENT_CODE>)
    string(APPEND entries "    {\"${library}\",\n     R\"flags($<$<BOOL:${definitions}>:-D$<JOIN:${definitions}, -D>> "
                          "${of_configuration} $<$<BOOL:${independent}>:${CMAKE_CXX_COMPILE_OPTIONS_PIC} >"
                          "$<JOIN:${options}, > ${CMAKE_CXX20_STANDARD_COMPILE_OPTION})flags\"},\n")
  endforeach()
  # In a containing project with several languages, options can depend on the language.
  set(directory ${PROJECT_BINARY_DIR}/include/tool/$<CONFIG>)
  file(
    GENERATE
    OUTPUT ${directory}/$<COMPILE_LANGUAGE>/io/compiled.hpp
    CONTENT
      "// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace carom::tool {

inline constexpr std::string_view compiler = \"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\";
inline constexpr std::string_view build_type = \"$<CONFIG>\";
inline constexpr auto compiler_flags = std::to_array<std::pair<std::string_view, std::string_view>>({
${entries}});

}  // namespace carom::tool
")
  target_include_directories(${recorder} PRIVATE ${directory}/CXX)
endfunction()
