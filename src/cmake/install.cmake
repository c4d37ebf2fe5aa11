# SPDX-License-Identifier: BSL-1.0

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# carom_library(TARGET NAME): defines the alias carom::NAME and installs TARGET in the component that carom_component
# chose.
function(carom_library target name)
  set(part ${CMAKE_INSTALL_DEFAULT_COMPONENT_NAME})
  add_library(carom::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT carom-${part})
  set_property(GLOBAL APPEND PROPERTY CAROM_INSTALLED_LIBRARIES ${target})
  set_property(GLOBAL APPEND PROPERTY CAROM_LIBRARIES_OF_${part} ${name})
endfunction()

# carom_folder(TARGET NAME DIRECTORY SCOPE …): defines the library carom::NAME with the headers of DIRECTORY. Sources
# include them as <carom/NAME/…>, before and after installation, if their target links to the library. Further arguments
# exclude headers from the installation.
function(carom_folder target name directory scope)
  set(root ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${root}/carom)
  file(CREATE_LINK ${directory} ${root}/carom/${name} SYMBOLIC)
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${root}>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${scope} cxx_std_20)
  carom_library(${target} ${name})
  install(DIRECTORY ${directory}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/carom/${name} FILES_MATCHING PATTERN "*.hpp"
          ${ARGN})
endfunction()

# Installs the package for find_package(carom). Call it after all libraries are defined. Each component installs its own
# files carom-component-PART.cmake and carom-targets-PART.cmake.
function(carom_install_package)
  set(directory ${CMAKE_INSTALL_LIBDIR}/cmake/carom)
  carom_component(impulse)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/carom-config.cmake.in
                                ${PROJECT_BINARY_DIR}/carom-config.cmake INSTALL_DESTINATION ${directory})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/carom-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/carom-config.cmake ${PROJECT_BINARY_DIR}/carom-config-version.cmake
          DESTINATION ${directory})
  foreach(part IN LISTS carom_parts)
    if(NOT part IN_LIST CAROM_BUILT)
      continue()
    endif()
    carom_component(${part})
    get_property(libraries GLOBAL PROPERTY CAROM_LIBRARIES_OF_${part})
    set(needs ${carom_${part}_needs})
    set(packages ${carom_${part}_packages_of_users})
    configure_file(${PROJECT_SOURCE_DIR}/src/cmake/carom-component.cmake.in
                   ${PROJECT_BINARY_DIR}/carom-component-${part}.cmake @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/carom-component-${part}.cmake DESTINATION ${directory})
    install(EXPORT carom-${part} NAMESPACE carom:: FILE carom-targets-${part}.cmake DESTINATION ${directory})
    install(FILES ${PROJECT_SOURCE_DIR}/src/package/copyright
            DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libcarom-${part}-dev)
  endforeach()
  # If there is no program, the package of the solvers contains the licences.
  set(part impulse)
  if("program" IN_LIST CAROM_BUILT)
    set(part carom)
  endif()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/licences/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/licences COMPONENT ${part})
endfunction()
