# The headers of the standard library, and of the libraries that take the compiler longest, are read once and kept compiled.
#
# Every file still includes all that it needs; this is tested where nothing is precompiled (./run lint, ./run tidy, and wherever
# there is a compiler cache). Not used with link-time optimisation, where each file has flags of its own. Not used for pt/, the
# tasks, and what a worker links with them: their objects must depend on their own files only.
#
# Measured with g++ 12 (CPU seconds per file, without and with): tests of the renderer 2.8 and 1.6, properties 6.1 and 5.1, the
# rest of the grader and of the write-up 2.3 and 1.2. CLI11 gains nothing: its time goes into what a file makes
# of it. A compiler cache serves files without better, and so this is for machines that have none.
set(default OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT FIRSTLIGHT_SANITIZE)
  set(default ON)
endif()
option(FIRSTLIGHT_PCH "Precompiled headers in the grader, its tests and the write-up" ${default})

set(FIRSTLIGHT_PRECOMPILED_STANDARD <algorithm> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <set> <span>
  <sstream> <string> <vector>)

# g++ 12 treats precompiled code as code of the file itself, and then warns of std::string in it. It collects garbage from 512 MB on
# instead of 128 MB, which saves a tenth of the time of large files.
set(FIRSTLIGHT_PRECOMPILED_FLAGS -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
  --param=ggc-min-heapsize=524288)

# firstlight_precompiled(<name> HEADERS <header>... LIBRARIES <library>...): these and the usual ones of the standard
# library, as they are where the libraries are linked.
function(firstlight_precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;LIBRARIES")
  # Where a handout brings the objects of our own code, there is next to nothing to compile.
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

# firstlight_compile_together(<target>...): where headers are precompiled, all files of the target are one file for the
# compiler, in a third of the time (eight at a time: in half of it). So two of its files cannot have one name for two things,
# even in a namespace without a name.
function(firstlight_compile_together)
  foreach(target IN LISTS ARGN)
    if(FIRSTLIGHT_PCH AND NOT FIRSTLIGHT_LTO AND NOT FIRSTLIGHT_COMPILED)
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
      target_compile_options(${target} PRIVATE ${FIRSTLIGHT_PRECOMPILED_FLAGS})
    endif()
  endforeach()
endfunction()

# firstlight_use_precompiled(<name> <target>...): for those of the targets that there are.
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

# firstlight_use_precompiled_here(<name> [EXCEPT <target>...]): all programs and libraries of this folder. Not those that are
# objects: solutions of tasks are. tests/precompiled_fits.py says which target lacks what the header was compiled with.
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
