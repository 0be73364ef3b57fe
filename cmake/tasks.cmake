# The seam: reads the table of the tasks, grader/tasks.json, and links one implementation of each task into a program.
#
# A task is one slug: the same in file, header, function, library, test suite and report. An
# implementation is a tree of files <part>/<slug>.cpp that define the functions of the contract
# pt/tasks/<slug>.h. Each file becomes an object library <slug>.<implementation>; a program links
# exactly one library for each task. Exercise numbers (1.3) follow from the order in the table.
#
# grader/tasks.json is the table of the tasks. From it come, for each slug,
#   FIRSTLIGHT_JUDGE_ANSWERS_<slug>  the calls that the judge answers while the task is judged alone
#   FIRSTLIGHT_MOCKS_<slug>          the tasks that a mock replaces then
#   FIRSTLIGHT_COUNTED_<slug>        if its calls can be counted: the types of result and shape, and the counter
# and the lists FIRSTLIGHT_COUNTED (calls can be counted), FIRSTLIGHT_TAPED (the write-up can keep the answers on a
# tape), FIRSTLIGHT_MOCKED (there is a mock) and FIRSTLIGHT_ANSWERED (the judge answers; also the slot radiance).
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/grader/tasks.json)
file(READ ${PROJECT_SOURCE_DIR}/grader/tasks.json table)
# firstlight_names(<variable> <words of the path in the table>...): an array of names as a list; empty
# where there is none.
function(firstlight_names variable)
  set(names)
  string(JSON count ERROR_VARIABLE missing LENGTH "${table}" ${ARGN})
  if(NOT missing AND count GREATER 0)
    math(EXPR last "${count} - 1")
    foreach(i RANGE ${last})
      string(JSON name GET "${table}" ${ARGN} ${i})
      list(APPEND names ${name})
    endforeach()
  endif()
  set(${variable} ${names} PARENT_SCOPE)
endfunction()
string(JSON last LENGTH "${table}" tasks)
math(EXPR last "${last} - 1")
foreach(i RANGE ${last})
  string(JSON slug GET "${table}" tasks ${i} slug)
  string(JSON part GET "${table}" tasks ${i} part)
  list(APPEND FIRSTLIGHT_SLUGS ${slug})
  list(APPEND FIRSTLIGHT_TASKS ${part}/${slug})
  firstlight_names(FIRSTLIGHT_JUDGE_ANSWERS_${slug} tasks ${i} judge_answers)
  firstlight_names(FIRSTLIGHT_MOCKS_${slug} tasks ${i} mocks)
  foreach(word result shape counter)
    string(JSON value ERROR_VARIABLE missing GET "${table}" tasks ${i} counted ${word})
    if(NOT missing)
      list(APPEND FIRSTLIGHT_COUNTED_${slug} ${value})
    endif()
  endforeach()
  if(DEFINED FIRSTLIGHT_COUNTED_${slug})
    list(APPEND FIRSTLIGHT_COUNTED ${slug})
  endif()
  string(JSON taped ERROR_VARIABLE missing GET "${table}" tasks ${i} taped)
  if(NOT missing AND taped)
    list(APPEND FIRSTLIGHT_TAPED ${slug})
  endif()
  list(APPEND FIRSTLIGHT_ANSWERED ${FIRSTLIGHT_JUDGE_ANSWERS_${slug}})
  list(APPEND FIRSTLIGHT_MOCKED ${FIRSTLIGHT_MOCKS_${slug}})
endforeach()
list(REMOVE_DUPLICATES FIRSTLIGHT_ANSWERED)
list(REMOVE_DUPLICATES FIRSTLIGHT_MOCKED)

# Sets `result`, `shape` and `counter` to the words of a counted task.
macro(firstlight_counted_by slug)
  list(GET FIRSTLIGHT_COUNTED_${slug} 0 result)
  list(GET FIRSTLIGHT_COUNTED_${slug} 1 shape)
  list(GET FIRSTLIGHT_COUNTED_${slug} 2 counter)
endmacro()

# The library <slug>.<name>.counted: the same implementation, and a counter (pt/render/test_count.h).
function(firstlight_add_counted slug name source)
  if(DEFINED FIRSTLIGHT_COUNTED_${slug})
    firstlight_counted_by(${slug})
    set(counted ${CMAKE_CURRENT_BINARY_DIR}/counted/${slug}.${name}.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/counted.cpp.in ${counted} @ONLY)
    add_library(${slug}.${name}.counted OBJECT EXCLUDE_FROM_ALL ${counted})
    target_link_libraries(${slug}.${name}.counted PRIVATE firstlight_options)
    set_property(SOURCE ${counted} APPEND PROPERTY OBJECT_DEPENDS ${source})
  endif()
endfunction()

# The library <slug>.<name>.taped: the same implementation, by way of the tape of pt/render/bounces_apart.h.
function(firstlight_add_taped slug name source)
  if(slug IN_LIST FIRSTLIGHT_TAPED)
    set(taped ${CMAKE_CURRENT_BINARY_DIR}/taped/${slug}.${name}.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/taped.cpp.in ${taped} @ONLY)
    add_library(${slug}.${name}.taped OBJECT EXCLUDE_FROM_ALL ${taped})
    target_link_libraries(${slug}.${name}.taped PRIVATE firstlight_options)
    set_property(SOURCE ${taped} APPEND PROPERTY OBJECT_DEPENDS ${source})
  endif()
endfunction()

# Object libraries <slug>.<name> for every task file that the tree at `root` has: missing files are
# left out.
function(firstlight_add_implementation name root)
  foreach(task IN LISTS FIRSTLIGHT_TASKS)
    get_filename_component(slug ${task} NAME)
    if(EXISTS ${root}/${task}.cpp)
      add_library(${slug}.${name} OBJECT ${root}/${task}.cpp)
      target_link_libraries(${slug}.${name} PRIVATE firstlight_options)
      if(root MATCHES "/(reference|fast)$")
        target_link_libraries(${slug}.${name} PRIVATE firstlight_warnings)
      endif()
      firstlight_add_counted(${slug} ${name} ${root}/${task}.cpp)
      firstlight_add_taped(${slug} ${name} ${root}/${task}.cpp)
    endif()
  endforeach()
endfunction()

# firstlight_add_solution(<slug> <name>): the library <slug>.<name> of the solution grader/tasks/<slug>/*/<name>.cpp, a
# wrong one or a right variant. Once, wherever it is asked for.
function(firstlight_add_solution slug name)
  if(TARGET ${slug}.${name})
    return()
  endif()
  file(GLOB source ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/*/${name}.cpp)
  if(NOT source)
    message(FATAL_ERROR "there is no solution ${name}.cpp in grader/tasks/${slug}")
  endif()
  add_library(${slug}.${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${slug}.${name} PRIVATE firstlight_options)
endfunction()

# firstlight_link_tasks(<program> FROM <implementation> [RADIANCE <implementation>]
#                       [CHOICES <slug>=<implementation> ...] [FAST] [COUNTED] [TAPED])
# links one definition of every task, all FROM one implementation but for the CHOICES, and one of the
# slot radiance (default: path; none: the program defines it itself). FAST takes the faster form of the
# tasks that come FROM the reference and have one. COUNTED takes the counting form of the tasks that have one,
# TAPED the taped form. Sets LINKED_<slug> to the library that was linked.
function(firstlight_link_tasks program)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "COUNTED;FAST;TAPED" "FROM;RADIANCE" "CHOICES")
  if(NOT ARG_RADIANCE)
    set(ARG_RADIANCE path)
  endif()
  set(slugs)
  foreach(task IN LISTS FIRSTLIGHT_TASKS)
    get_filename_component(slug ${task} NAME)
    list(APPEND slugs ${slug})
    set(choice_${slug} ${ARG_FROM})
    if(ARG_FAST AND ARG_FROM STREQUAL reference AND TARGET ${slug}.fast)
      set(choice_${slug} fast)
    endif()
  endforeach()
  foreach(choice IN LISTS ARG_CHOICES)
    if(NOT choice MATCHES "^([a-z_]+)=([a-z_]+)$" OR NOT CMAKE_MATCH_1 IN_LIST slugs)
      message(FATAL_ERROR "'${choice}' is not a choice: write <task>=<implementation>, the task one of ${slugs}")
    endif()
    set(choice_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endforeach()
  foreach(slug IN LISTS slugs)
    set(library ${slug}.${choice_${slug}})
    if(NOT TARGET ${library})
      message(FATAL_ERROR "there is no implementation '${choice_${slug}}' of the task ${slug}")
    endif()
    if(ARG_COUNTED AND TARGET ${library}.counted)
      set(library ${library}.counted)
    endif()
    if(ARG_TAPED AND TARGET ${library}.taped)
      set(library ${library}.taped)
    endif()
    target_link_libraries(${program} PRIVATE ${library})
    set(LINKED_${slug} ${library} PARENT_SCOPE)
  endforeach()
  if(NOT ARG_RADIANCE STREQUAL none)
    target_link_libraries(${program} PRIVATE radiance.${ARG_RADIANCE})
  endif()
endfunction()

# firstlight_inner_choices(<slug> <implementation> <radiance>): the implementations for the inner calls of a
# task that is judged alone, for firstlight_link_tasks. Sets INNER_CHOICES: the implementation for the tasks
# that the judge answers, and mocks; and INNER_RADIANCE: the one given, or path where the judge does not
# answer radiance().
function(firstlight_inner_choices slug implementation radiance)
  set(choices)
  set(INNER_RADIANCE path PARENT_SCOPE)
  foreach(inner IN LISTS FIRSTLIGHT_JUDGE_ANSWERS_${slug})
    if("${inner}" STREQUAL "radiance")
      set(INNER_RADIANCE ${radiance} PARENT_SCOPE)
    else()
      list(APPEND choices ${inner}=${implementation})
    endif()
  endforeach()
  foreach(inner IN LISTS FIRSTLIGHT_MOCKS_${slug})
    list(APPEND choices ${inner}=mock)
  endforeach()
  set(INNER_CHOICES ${choices} PARENT_SCOPE)
endfunction()

# firstlight_symbol(<slug> <variable>): the name that g++ and clang give to the function of a counted or taped task;
# self_check/tasks_test.cpp compares it with the reference's object.
function(firstlight_symbol slug variable)
  string(LENGTH ${slug} length)
  if(slug IN_LIST FIRSTLIGHT_COUNTED)
    firstlight_counted_by(${slug})
    string(LENGTH ${shape} shape_length)
    set(arguments RKNS_${shape_length}${shape}ERKNS_3RayE)
  elseif(slug IN_LIST FIRSTLIGHT_TAPED)
    set(arguments RKNS_5SceneERKNS_12SurfacePointEiRNS_7SamplerE)
  else()
    message(FATAL_ERROR "grader/tasks.json does not say that ${slug} is counted or taped")
  endif()
  set(${variable} _ZN2pt${length}${slug}E${arguments} PARENT_SCOPE)
endfunction()

# firstlight_wrap(<objects> <flags> <slug>...): the objects define what calls of these tasks go through in a
# program that is linked with the flags, by the names of the functions:
# "__wrap_" FIRSTLIGHT_SYMBOL_<slug>, and "__real_" for the task itself. Without objects, only the flags are set.
function(firstlight_wrap objects flags)
  set(words)
  foreach(slug IN LISTS ARGN)
    firstlight_symbol(${slug} symbol)
    if(objects)
      target_compile_definitions(${objects} PRIVATE FIRSTLIGHT_SYMBOL_${slug}="${symbol}")
    endif()
    list(APPEND words -Wl,--wrap=${symbol})
  endforeach()
  set(${flags} ${words} PARENT_SCOPE)
endfunction()

# A mixture in words, "reference" or "reference+hit_bvh=student+...", turned into the arguments of
# firstlight_link_tasks (in MIXTURE_FROM and MIXTURE_CHOICES) and a suffix for targets and files.
macro(firstlight_parse_mixture mixture)
  string(REPLACE "+" ";" MIXTURE_CHOICES "${mixture}")
  list(POP_FRONT MIXTURE_CHOICES MIXTURE_FROM)
  string(REPLACE "=" "-" MIXTURE_SUFFIX "${mixture}")
endmacro()
