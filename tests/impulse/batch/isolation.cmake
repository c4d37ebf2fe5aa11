# SPDX-License-Identifier: BSL-1.0
# cmake -DNM=… -DOBJECTS=… -P isolation.cmake
# The linker keeps one of many copies of an inline function. Where the copy comes from a unit compiled for a wide
# instruction set, a machine without that set ends at it. So all that such a unit may define for others are the functions
# of its own namespace, carom::impulse::avx2 or ::avx512, and inline functions of packs that are as wide: no unit for a
# narrower set refers to those.

set(own "(T _ZN5carom7impulse(4avx2|6avx512)|[WV] .*simd_abi.*(_VecBuiltinILi32E|_VecBltnBtmskILi64E))")
foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND ${NM} --defined-only ${object} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
  if(NOT result EQUAL 0 OR symbols STREQUAL "")
    message(FATAL_ERROR "${NM} shows nothing of ${object}")
  endif()
  string(REGEX MATCHALL "[^\n]+" lines "${symbols}")
  foreach(line IN LISTS lines)
    # What is local is spelt in small letters, but for what is unique in the program. The reference to the handler of
    # exceptions is data.
    if(line MATCHES " [A-Ziu] " AND NOT line MATCHES " ${own}" AND NOT line MATCHES " V DW.ref.__gxx_personality_v0$")
      message(FATAL_ERROR "another unit could be linked with what ${object} defines: ${line}")
    endif()
  endforeach()
endforeach()
