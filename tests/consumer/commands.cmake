# SPDX-License-Identifier: BSL-1.0

# Runs a command that must end with the exit status `expected`. Sets `output` to its output.
function(run_expecting expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  if(NOT result EQUAL expected)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}\nended in ${result}\n${printed}")
  endif()
  set(output "${printed}" PARENT_SCOPE)
endfunction()

macro(run)
  run_expecting(0 ${ARGN})
endmacro()

# Fails if the last output lacks one of these texts.
function(expect_output)
  foreach(text IN LISTS ARGN)
    string(FIND "${output}" "${text}" place)
    if(place EQUAL -1)
      message(FATAL_ERROR "expected in the output: ${text}\n${output}")
    endif()
  endforeach()
endfunction()
