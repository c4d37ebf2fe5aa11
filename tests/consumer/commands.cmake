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

# Sets `variable` to the lines of the page from the text `first` to the text `last`, both included, without their
# indentation of four spaces.
function(lines_of page first last variable)
  file(READ ${page} text)
  string(FIND "${text}" "${first}" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "${page} has no line ${first}")
  endif()
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "${last}" length)
  if(length EQUAL -1)
    message(FATAL_ERROR "${page}: no ${last} follows ${first}")
  endif()
  string(LENGTH "${last}" rest)
  math(EXPR length "${length} + ${rest}")
  string(SUBSTRING "${text}" 0 ${length} text)
  string(REGEX REPLACE "^    " "" text "${text}")
  string(REPLACE "\n    " "\n" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# Writes the lines of docs/guide/plan.md that batch.cpp includes, and sets `variable` to the file.
function(write_lines_of_plan consumer folder variable)
  lines_of(${consumer}/../../docs/guide/plan.md "carom::impulse::ContactBatch" "use(outcomes.at(0));\n" lines)
  file(WRITE ${folder}/lines_of_plan.hpp "${lines}")
  set(${variable} ${folder}/lines_of_plan.hpp PARENT_SCOPE)
endfunction()

# Writes the suite of docs/guide/conformance.md that tests my_solver.hpp.
function(write_suite consumer file)
  lines_of(${consumer}/../../docs/guide/conformance.md "    #include <carom/conformance.hpp>\n" ";\n" suite)
  file(WRITE ${file} "${suite}")
endfunction()
