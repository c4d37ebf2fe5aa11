# SPDX-License-Identifier: BSL-1.0
# What src/web/libraries.sh put in CAROM_WEB_LIBRARIES, as the targets that the native build finds in packages; and the
# flags of every file.

set(CAROM_WEB_LIBRARIES ${PROJECT_BINARY_DIR}/libraries CACHE PATH "The directory that src/web/libraries.sh filled")
if(NOT EXISTS ${CAROM_WEB_LIBRARIES}/lib/libmpfr.a)
  message(FATAL_ERROR "${CAROM_WEB_LIBRARIES} has no lib/libmpfr.a: run bash src/bootstrap.sh wasm")
endif()

add_compile_options(-fwasm-exceptions -I${PROJECT_SOURCE_DIR}/src/web/old_library
                    "SHELL:-include prelude.hpp" "SHELL:-include range_algorithms.hpp")
# The memory of WebAssembly has 32-bit addresses, and the judge keeps far fewer than 2^32 cases.
add_compile_options(-Wno-shorten-64-to-32)
add_link_options(-fwasm-exceptions)

function(carom_web_library name)
  add_library(${name} INTERFACE IMPORTED)
  target_include_directories(${name} SYSTEM INTERFACE ${CAROM_WEB_LIBRARIES}/include)
endfunction()
foreach(name Eigen3::Eigen nlohmann_json::nlohmann_json fmt::fmt CGAL::CGAL pugixml::pugixml)
  carom_web_library(${name})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
target_compile_definitions(pugixml::pugixml INTERFACE PUGIXML_HEADER_ONLY)
target_link_libraries(CGAL::CGAL INTERFACE ${CAROM_WEB_LIBRARIES}/lib/libmpfr.a ${CAROM_WEB_LIBRARIES}/lib/libgmp.a)
# WebAssembly always rounds to nearest, so CGAL's intervals of doubles have to widen their ends.
target_compile_definitions(CGAL::CGAL INTERFACE CGAL_ALWAYS_ROUND_TO_NEAREST)
