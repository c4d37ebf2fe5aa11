# SPDX-License-Identifier: BSL-1.0
# Debian packages: `carom`, the program with what it reads and its documentation, and `libcarom-dev`, the C++ libraries.
# The target carom_package builds what is in them, and writes them to build/package.

set(CAROM_PACKAGE_CONTACT "Carom <carom@localhost>" CACHE STRING "Whom the packages name as their maintainer")

# What is neither compiled nor a header. Pages, examples and schemas lie to each other as in the tree, so that links
# lead somewhere. What programs read is not among the documentation, which small systems leave out.
function(carom_install_documents)
  set(data ${CMAKE_INSTALL_DATADIR}/carom)
  set(documents ${CMAKE_INSTALL_DOCDIR}/docs)
  install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${documents} COMPONENT program
          PATTERN examples EXCLUDE PATTERN schemas EXCLUDE)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/examples DESTINATION ${data} COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/reference/schemas DESTINATION ${data} COMPONENT program)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/documents)
  foreach(link examples reference/schemas)
    get_filename_component(name ${link} NAME)
    get_filename_component(folder ${documents}/${link} DIRECTORY)
    file(RELATIVE_PATH target /${folder} /${data}/${name})
    file(CREATE_LINK ${target} ${PROJECT_BINARY_DIR}/documents/${name} SYMBOLIC)
    install(FILES ${PROJECT_BINARY_DIR}/documents/${name} DESTINATION ${folder} COMPONENT program)
  endforeach()
  install(FILES ${PROJECT_SOURCE_DIR}/src/package/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/carom COMPONENT program)
  install(FILES ${PROJECT_SOURCE_DIR}/src/package/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libcarom-dev
          COMPONENT development)
endfunction()

# To be called once all that is installed is known.
macro(carom_package)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_PACKAGE_CONTACT ${CAROM_PACKAGE_CONTACT})
  set(CPACK_STRIP_FILES ON)
  set(CPACK_COMPONENTS_ALL program development)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME carom)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox) # for charts, and the pictures of scenes
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "nodejs, npm, python3") # engines that npm has, and examples
  set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
      "Judges solvers of rigid-body collision impulses against exact arithmetic: a gate for continuous integration.")

  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcarom-dev)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
      "libeigen3-dev, libcgal-dev, libmpfi-dev, libfcl-dev, libfmt-dev, nlohmann-json3-dev")
  foreach(engine bullet ode)
    if(${engine}_FOUND)
      string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", lib${engine}-dev")
    endif()
  endforeach()
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libgtest-dev, librapidcheck-dev")
  set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
      "C++ libraries of Carom: solvers of collision impulses, the invariants that they keep, and the gate.")
  include(CPack)

  get_property(libraries GLOBAL PROPERTY CAROM_INSTALLED_LIBRARIES)
  add_custom_target(
    carom_package
    COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
    DEPENDS carom_programs ${libraries}
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
    COMMENT "Writing the packages to build/package"
    VERBATIM)
endmacro()
