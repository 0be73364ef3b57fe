# The headers of the standard library, and of the libraries that take the compiler longest, are read once and kept compiled.
#
# Every file still includes all that it needs; builds without precompiled headers test this (./run lint --all, ./run tidy, and all
# builds with a compiler cache). Not used with link-time optimisation, where each file has its own flags, nor for pt/, the
# tasks, and what a worker links with them: their objects must depend only on their own files.
#
# Measured with g++ 12 (CPU seconds per file, without and with): tests of the renderer 2.8 and 1.6, properties 6.1 and 5.1, the
# rest of the grader and of the write-up 2.3 and 1.2. CLI11 gains nothing: its time goes into its templates. A compiler cache
# works better without precompiled headers, so these are for machines without a cache.
set(default OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT FIRSTLIGHT_SANITIZE)
  set(default ON)
endif()
option(FIRSTLIGHT_PCH "Precompiled headers in the grader, its tests and the write-up" ${default})

set(FIRSTLIGHT_PRECOMPILED_STANDARD <algorithm> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <set> <span>
  <sstream> <string> <vector>)

# g++ 12 treats precompiled code as code of the file itself, and then warns about std::string in it. It collects garbage above 512
# MB instead of 128 MB, which saves a tenth of the time of large files.
set(FIRSTLIGHT_PRECOMPILED_FLAGS -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
  --param=ggc-min-heapsize=524288)

# firstlight_precompiled(<name> HEADERS <header>... LIBRARIES <library>...): precompiles these and the usual headers
# of the standard library, with the flags of the libraries.
function(firstlight_precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;LIBRARIES")
  # If a handout has the objects of our own code, almost nothing is left to compile.
  if(NOT FIRSTLIGHT_PCH OR FIRSTLIGHT_LTO OR FIRSTLIGHT_COMPILED)
    return()
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "")
  endif()
  firstlight_objects(${name} ${source})
  target_link_libraries(${name} PUBLIC ${ARG_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${FIRSTLIGHT_PRECOMPILED_STANDARD} ${ARG_HEADERS})
endfunction()

# firstlight_compile_together(<target>...): with precompiled headers, all files of the target are one file for the compiler,
# which takes a third of the time (eight at a time: half). So two files of a target cannot use one name for two things, even
# in a namespace without a name. A learners' edition lacks some of the targets.
function(firstlight_compile_together)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target} AND FIRSTLIGHT_PCH AND NOT FIRSTLIGHT_LTO AND NOT FIRSTLIGHT_COMPILED)
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
      target_compile_options(${target} PRIVATE ${FIRSTLIGHT_PRECOMPILED_FLAGS})
    endif()
  endforeach()
endfunction()

# firstlight_use_precompiled(<name> <target>...): for those targets that exist.
function(firstlight_use_precompiled name)
  if(NOT TARGET ${name})
    return()
  endif()
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      target_precompile_headers(${target} REUSE_FROM ${name})
      target_compile_options(${target} PRIVATE ${FIRSTLIGHT_PRECOMPILED_FLAGS})
    endif()
  endforeach()
endfunction()

# firstlight_use_precompiled_here(<name> [EXCEPT <target>...]): for all programs and libraries of this folder, but not for
# object libraries, such as solutions of tasks. tests/rules/precompiled_fits.py finds targets without a flag of the header.
function(firstlight_use_precompiled_here name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "EXCEPT")
  get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  list(REMOVE_ITEM targets ${name} ${ARG_EXCEPT})
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(STATIC_LIBRARY|EXECUTABLE)$")
      firstlight_use_precompiled(${name} ${target})
    endif()
  endforeach()
endfunction()
