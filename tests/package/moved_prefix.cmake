# SPDX-License-Identifier: BSL-1.0
# cmake -DBUILD=… -DSOURCE=… -DWORK=… -P moved_prefix.cmake: installs the program into WORK and moves it. The program
# must find the files that it reads.

include(${CMAKE_CURRENT_LIST_DIR}/../consumer/commands.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed --component carom)
set(prefix "${WORK}/moved to/here")
file(MAKE_DIRECTORY "${WORK}/moved to")
file(RENAME ${WORK}/installed "${prefix}")
set(carom "${prefix}/bin/carom")

# If the program carom-scene is missing, the program carom refuses scenes and engines in time, but still plans collisions.
run_expecting(2 "${carom}" scene "${prefix}/share/carom/examples/scenes/cradle.json")
expect_output("the program carom-scene is not in the directory of this program")
run_expecting(2 "${carom}" time --quick)
expect_output("time: the program carom-scene is not in the directory of this program")
run_expecting(2 "${carom}" plan "${prefix}/share/carom/examples/scenes/cradle.json")
expect_output("this file is a scene; to plan it, install carom-scene")
run("${carom}" plan "${prefix}/share/carom/examples/contacts.jsonl" --repetitions 0)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix "${prefix}" --component carom-scene)

file(STRINGS "${carom}" paths REGEX "${SOURCE}/|${BUILD}/")
if(paths)
  message(FATAL_ERROR "${carom} names the tree that it was built from: ${paths}")
endif()

# The program uses the adapters in its own prefix. The command that it prints works.
run(${CMAKE_COMMAND} -E env --unset=CAROM_ENGINES "${carom}" subjects)
expect_output("cannon-es is not installed: npm ci --prefix '${prefix}/share/carom/npm'")

# The program can also use the adapters of another folder. The example solver plays an installed engine.
set(engines "${WORK}/my engines")
file(COPY "${prefix}/share/carom/npm/" DESTINATION "${engines}")
file(MAKE_DIRECTORY "${engines}/node_modules/cannon-es")
file(COPY_FILE "${prefix}/share/carom/examples/solver.mjs" "${engines}/cannon.mjs")
find_program(node NAMES node)
if(node)
  run(${CMAKE_COMMAND} -E env "CAROM_ENGINES=${engines}" "${carom}" gate cannon --cases 5)
  expect_output("cannon " "sound")
endif()
run(${CMAKE_COMMAND} -E env "CAROM_ENGINES=${engines}" PATH=/no/such "${carom}" subjects)
expect_output("node is not on PATH: install nodejs")
file(REMOVE "${engines}/cannon.mjs")
run(${CMAKE_COMMAND} -E env "CAROM_ENGINES=${engines}" "${carom}" subjects)
expect_output("${engines}/cannon.mjs does not exist; check CAROM_ENGINES")

# If the folder is not writable, the printed command copies it first. The superuser can write to any folder.
execute_process(COMMAND id -u OUTPUT_VARIABLE user OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT user STREQUAL "0")
  file(CHMOD "${prefix}/share/carom/npm" PERMISSIONS OWNER_READ OWNER_EXECUTE)
  run(${CMAKE_COMMAND} -E env --unset=CAROM_ENGINES "${carom}" subjects)
  file(CHMOD "${prefix}/share/carom/npm" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  expect_output("cp -r '${prefix}/share/carom/npm' ~/carom-engines && npm ci --prefix ~/carom-engines && ")
endif()

# The program contains the page of replays.
set(scene "${prefix}/share/doc/carom/docs/examples/scenes/cradle.json")
run("${carom}" scene "${scene}" --out "${WORK}/scene")
