# SPDX-License-Identifier: BSL-1.0

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Of the components `program` and `development` what is said of neither is of the latter.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

# carom_library(TARGET NAME): an alias carom::NAME, under which it is installed.
function(carom_library target name)
  add_library(carom::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT carom)
  set_property(GLOBAL APPEND PROPERTY CAROM_INSTALLED_LIBRARIES ${target})
  set_property(GLOBAL APPEND PROPERTY CAROM_LIBRARIES ${name})
endfunction()

# carom_folder(TARGET NAME DIRECTORY SCOPE …): a library, and the spelling <carom/NAME/…> that its folder of the tree has
# once installed. Each target sees the folders that it links to and no others. Further arguments choose among the headers
# to install.
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

# The package that find_package(carom) finds, once all of its libraries are known.
function(carom_install_package)
  set(directory ${CMAKE_INSTALL_LIBDIR}/cmake/carom)
  get_property(carom_libraries GLOBAL PROPERTY CAROM_LIBRARIES)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/carom-config.cmake.in
                                ${PROJECT_BINARY_DIR}/carom-config.cmake INSTALL_DESTINATION ${directory})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/carom-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/carom-config.cmake ${PROJECT_BINARY_DIR}/carom-config-version.cmake
          DESTINATION ${directory})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/licences/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/licences
          COMPONENT program)
  install(EXPORT carom NAMESPACE carom:: FILE carom-targets.cmake DESTINATION ${directory})
endfunction()
