# SPDX-License-Identifier: BSL-1.0
# cmake -DNM=… -DOBJECTS=… -P isolation.cmake
#
# The linker keeps one of many copies of an inline function. If this copy comes from a unit for a wide instruction set,
# the program crashes on a machine without the set. So a wide unit may define only two kinds of global functions: those
# of its own namespace, carom::impulse::avx2 or ::avx512, and inline functions of packs of its width. No narrower unit
# refers to these functions.

set(own "(T _ZN5carom7impulse(4avx2|6avx512)|[WV] .*simd_abi.*(_VecBuiltinILi32E|_VecBltnBtmskILi64E))")
foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND ${NM} --defined-only ${object} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
  if(NOT result EQUAL 0 OR symbols STREQUAL "")
    message(FATAL_ERROR "${NM} shows nothing of ${object}")
  endif()
  string(REGEX MATCHALL "[^\n]+" lines "${symbols}")
  foreach(line IN LISTS lines)
    # nm marks global symbols with capital letters, `i` or `u`. The reference to the exception handler is only data.
    if(line MATCHES " [A-Ziu] " AND NOT line MATCHES " ${own}" AND NOT line MATCHES " V DW.ref.__gxx_personality_v0$")
      message(FATAL_ERROR "another unit could be linked with what ${object} defines: ${line}")
    endif()
  endforeach()
endforeach()
