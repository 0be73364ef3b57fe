# The headers of other people's libraries that take the compiler longest are read once, and kept compiled.
#
# Every file includes what it needs all the same; that it does is seen where nothing is precompiled
# (the default, and ./run tidy). Not with link-time optimisation: there each file has flags of its own. Not for pt/,
# the tasks, and what is linked with them: their objects are to depend on what is in their files only.
#
# Measured with g++ 12: a file that includes fmt takes 1.4 CPU seconds in place of 2.2, the properties of a task 5.7 in
# place of 8.2. With CLI11 and nlohmann_json in the same precompiled header both took longer than with none. Off by
# default, as a compiler cache serves files without better.
option(FIRSTLIGHT_PCH "Precompiled headers in the grader" OFF)

# firstlight_precompiled(<name> HEADERS <header>... LIBRARIES <library>...): the headers, as they are where these are linked.
function(firstlight_precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;LIBRARIES")
  if(NOT FIRSTLIGHT_PCH OR FIRSTLIGHT_LTO)
    return()
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "")
  endif()
  firstlight_objects(${name} ${source})
  target_link_libraries(${name} PUBLIC ${ARG_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# firstlight_use_precompiled(<name> <target>...)
function(firstlight_use_precompiled name)
  if(TARGET ${name})
    foreach(target IN LISTS ARGN)
      target_precompile_headers(${target} REUSE_FROM ${name})
    endforeach()
  endif()
endfunction()
