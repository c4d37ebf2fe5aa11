# SPDX-License-Identifier: BSL-1.0
# cmake -DBUILD=… -DSOURCE=… -DWORK=… -P moved_prefix.cmake: the program, installed into WORK and moved, finds what it reads.

include(${CMAKE_CURRENT_LIST_DIR}/../consumer/commands.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed --component carom)
set(prefix "${WORK}/moved to/here")
file(MAKE_DIRECTORY "${WORK}/moved to")
file(RENAME ${WORK}/installed "${prefix}")
set(carom "${prefix}/bin/carom")

# No path of the tree or of the build is in it.
file(STRINGS "${carom}" paths REGEX "${SOURCE}/|${BUILD}/")
if(paths)
  message(FATAL_ERROR "${carom} names the tree that it was built from: ${paths}")
endif()

# The adapters of its own prefix; what is to be typed can be typed as it stands.
run(${CMAKE_COMMAND} -E env --unset=CAROM_ENGINES "${carom}" subjects)
expect_output("cannon-es is not installed: npm ci --prefix '${prefix}/share/carom/npm'")

# Those of another folder, in which an engine is installed; here in its place the example.
set(engines "${WORK}/my engines")
file(COPY "${prefix}/share/carom/npm/" DESTINATION "${engines}")
file(MAKE_DIRECTORY "${engines}/node_modules/cannon-es")
file(COPY_FILE "${prefix}/share/carom/examples/solver.mjs" "${engines}/cannon.mjs")
find_program(node NAMES node)
if(node)
  run(${CMAKE_COMMAND} -E env "CAROM_ENGINES=${engines}" "${carom}" gate cannon --families generic --cases 20)
  expect_output("cannon " "sound")
endif()
run(${CMAKE_COMMAND} -E env "CAROM_ENGINES=${engines}" PATH=/no/such "${carom}" subjects)
expect_output("node, which runs it, is not on the PATH")
file(REMOVE "${engines}/cannon.mjs")
run(${CMAKE_COMMAND} -E env "CAROM_ENGINES=${engines}" "${carom}" subjects)
expect_output("${engines}/cannon.mjs is not there, in the folder that CAROM_ENGINES names")

# A folder that cannot be written has to be copied. The superuser can write everything.
execute_process(COMMAND id -u OUTPUT_VARIABLE user OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT user STREQUAL "0")
  file(CHMOD "${prefix}/share/carom/npm" PERMISSIONS OWNER_READ OWNER_EXECUTE)
  run(${CMAKE_COMMAND} -E env --unset=CAROM_ENGINES "${carom}" subjects)
  file(CHMOD "${prefix}/share/carom/npm" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  expect_output("cp -r '${prefix}/share/carom/npm' ~/carom-engines && npm ci --prefix ~/carom-engines && ")
endif()

# The page of replays is within the program, and scenes and pages are where the documentation says.
set(scene "${prefix}/share/doc/carom/docs/examples/scenes/cradle.json")
run("${carom}" scene "${scene}" --out "${WORK}/scene")
