# SPDX-License-Identifier: BSL-1.0
# Debian packages: `carom` has the program, the files that it reads, and the documentation. `carom-scene` has the
# commands that run scenes. libcarom-PART-dev has the libraries of a component. The target carom_package writes them to
# build/package.

set(CAROM_PACKAGE_CONTACT "Carom <carom@localhost>" CACHE STRING "Whom the packages name as their maintainer")

# Installs everything that is neither compiled nor a header. Pages, examples and schemas keep their relative paths, so
# that links work. Files that programs read are outside the documentation, because small systems omit documentation.
function(carom_install_documents)
  set(data ${CMAKE_INSTALL_DATADIR}/carom)
  set(documents ${CMAKE_INSTALL_DOCDIR}/docs)
  install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT carom)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${documents} COMPONENT carom
          PATTERN examples EXCLUDE PATTERN schemas EXCLUDE)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/examples DESTINATION ${data} COMPONENT carom)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/reference/schemas DESTINATION ${data} COMPONENT carom)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/documents)
  foreach(link examples reference/schemas)
    get_filename_component(name ${link} NAME)
    get_filename_component(folder ${documents}/${link} DIRECTORY)
    file(RELATIVE_PATH target /${folder} /${data}/${name})
    file(CREATE_LINK ${target} ${PROJECT_BINARY_DIR}/documents/${name} SYMBOLIC)
    install(FILES ${PROJECT_BINARY_DIR}/documents/${name} DESTINATION ${folder} COMPONENT carom)
  endforeach()
  install(FILES ${PROJECT_SOURCE_DIR}/src/package/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/carom COMPONENT carom)
endfunction()

# Call this after all install commands.
macro(carom_package)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_PACKAGE_CONTACT ${CAROM_PACKAGE_CONTACT})
  set(CPACK_STRIP_FILES ON)
  set(CPACK_COMPONENTS_ALL ${CAROM_BUILT})
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL proofs)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

  # The Debian packages that the users of each component's libraries need.
  set(carom_impulse_debian libeigen3-dev)
  set(carom_judge_debian libcgal-dev libgmp-dev libfmt-dev nlohmann-json3-dev)
  set(carom_report_debian libpugixml-dev)
  set(carom_kit_debian libgtest-dev librapidcheck-dev)
  set(carom_scenes_debian libfcl-dev)
  set(carom_program_debian libboost-dev)
  set(carom_impulse_contents "solvers of collision impulses, as templates and in SIMD batches")
  set(carom_judge_contents "exact oracles, invariants, families and the gate")
  set(carom_report_contents "the results of a run: one value, its JSON, and pages that show it")
  set(carom_kit_contents "generators for RapidCheck and a suite for GoogleTest")
  set(carom_scenes_contents "scenes of spheres and convex polyhedra, and phenomena for engines in time")
  set(carom_program_contents "the subjects that the program judges, and its plans")
  foreach(engine bullet ode)
    if(${engine}_FOUND)
      list(APPEND carom_program_debian lib${engine}-dev)
    endif()
  endforeach()
  foreach(part IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${part} upper)
    set(depends ${carom_${part}_debian})
    foreach(needed IN LISTS carom_${part}_needs)
      list(APPEND depends "libcarom-${needed}-dev (= ${PROJECT_VERSION})")
    endforeach()
    list(JOIN depends ", " CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME libcarom-${part}-dev)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION libdevel)
    set(CPACK_COMPONENT_${upper}_DESCRIPTION "C++ libraries of Carom: ${carom_${part}_contents}.")
  endforeach()

  if("program" IN_LIST CAROM_BUILT)
    list(APPEND CPACK_COMPONENTS_ALL carom)
    set(CPACK_DEBIAN_CAROM_PACKAGE_NAME carom)
    set(CPACK_DEBIAN_CAROM_PACKAGE_SECTION science)
    set(CPACK_DEBIAN_CAROM_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_CAROM_PACKAGE_RECOMMENDS gnuplot-nox) # for charts, and the pictures of scenes
    set(CPACK_DEBIAN_CAROM_PACKAGE_SUGGESTS "nodejs, npm, python3") # npm engines, and examples
    set(CPACK_COMPONENT_CAROM_DESCRIPTION
        "Judges solvers of rigid-body collision impulses against exact arithmetic: a gate for continuous integration.")
  endif()
  if("scenes" IN_LIST CAROM_BUILT)
    list(APPEND CPACK_COMPONENTS_ALL carom-scene)
    set(CPACK_DEBIAN_CAROM-SCENE_PACKAGE_NAME carom-scene)
    set(CPACK_DEBIAN_CAROM-SCENE_PACKAGE_SECTION science)
    set(CPACK_DEBIAN_CAROM-SCENE_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_CAROM-SCENE_PACKAGE_DEPENDS "carom (= ${PROJECT_VERSION})")
    set(CPACK_DEBIAN_CAROM-SCENE_PACKAGE_RECOMMENDS gnuplot-nox) # for pictures
    set(CPACK_COMPONENT_CAROM-SCENE_DESCRIPTION "The commands of carom that run scenes of many bodies, and that measure engines in time.")
  endif()
  include(CPack)

  get_property(libraries GLOBAL PROPERTY CAROM_INSTALLED_LIBRARIES)
  add_custom_target(
    carom_package
    COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
    DEPENDS $<TARGET_NAME_IF_EXISTS:carom_programs> ${libraries}
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
    COMMENT "Writing the packages to build/package"
    VERBATIM)
endmacro()
