# cmake -DNM=<nm> -DOBJECTS=<objects> -P kernel_symbols.cmake
# A kernel is compiled for machines that others may not be. If its object held an inline function of a
# shared header (a weak symbol), the linker might take that copy for the whole program.
set(kernels 0)
foreach(object IN LISTS OBJECTS)
  if(NOT object MATCHES "/kernel_(plain|v2|v3|v4)\\.cpp")
    continue()
  endif()
  math(EXPR kernels "${kernels} + 1")
  execute_process(COMMAND ${NM} -C ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]* [TWVuB] [^\n]*" shared "${symbols}")
  if(shared)
    message(FATAL_ERROR "${object} defines functions that other code may end up with:\n${shared}")
  endif()
endforeach()
if(kernels EQUAL 0)
  message(FATAL_ERROR "no kernel among the objects")
endif()
