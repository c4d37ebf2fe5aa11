# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DBUILD=… -DWORK=… -DCONSUMER=… -P run.cmake: installs into WORK, builds the consumers against that, runs them.

include(${CMAKE_CURRENT_LIST_DIR}/commands.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)

# The solvers and the gate ask for neither GoogleTest nor RapidCheck.
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/installed
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/solve)
run(${WORK}/build/batch)
run(${WORK}/build/judge)
run(${WORK}/installed/bin/carom subjects)

run(${CMAKE_COMMAND} -S ${CONSUMER}/conformance -B ${WORK}/conformance -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/installed
    -DCMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${WORK}/conformance)
run(${CMAKE_COMMAND} -E env CAROM_CASES=10 ${WORK}/conformance/sound_test)
expect_output("[       OK ] Textbook/Conformance.Holds/restitution_in_near_head_on")
run_expecting(1 ${WORK}/conformance/mutant_test)
expect_output("mutant violates restitution in generic" "The normal velocity is reversed and multiplied by ε."
              "B: immovable, at (0, 0, 0)" "  answered" "N·V⁺ and −ε N·V⁻: 2 and 1, apart by 1, allowed" "RC_PARAMS="
              "[       OK ] Mutant/Conformance.Holds/restitution_in_inelastic")
