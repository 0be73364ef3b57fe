# The seam: reads the description of each task in grader/tasks/, and links one implementation of each task into a program.
#
# A task has one slug, the same in file, header, function, library, test suite and report. An implementation is
# a tree of files <part>/<slug>.cpp that define the functions of the contract pt/tasks/<slug>.h. Each file
# becomes an object library <slug>.<implementation>; a program links exactly one library for each task.
#
# grader/tasks/<slug>/task.json describes a task (grader/tasks.h explains its words); its `number` (1.3) is its place in the
# course. All files together are the table, generated/tasks.json of the build. It gives, for each slug,
#   FIRSTLIGHT_JUDGE_ANSWERS_<slug>  the calls that the judge answers while the task is judged alone
#   FIRSTLIGHT_MOCKS_<slug>          the tasks that a mock replaces then
#   FIRSTLIGHT_FUNCTIONS_<slug>      the functions of the contract
# and the lists FIRSTLIGHT_RECORDED (calls can be recorded), FIRSTLIGHT_VIEWED (by the view alone), FIRSTLIGHT_COUNTED (there is a counting version),
# FIRSTLIGHT_MOCKED (there is a mock) and FIRSTLIGHT_ANSWERED (the judge answers; also the slot radiance).
set(FIRSTLIGHT_GENERATED ${PROJECT_BINARY_DIR}/generated)

# Sets `table` to the table, in the order of the course.
function(firstlight_read_tasks)
  file(GLOB files ${PROJECT_SOURCE_DIR}/grader/tasks/*/task.json)
  # The folder is newer where a task has come or gone.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files} ${PROJECT_SOURCE_DIR}/grader/tasks)
  foreach(file IN LISTS files)
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(slug ${folder} NAME)
    file(READ ${file} task)
    string(JSON number ERROR_VARIABLE problem GET "${task}" number)
    if(problem)
      message(FATAL_ERROR "${file} has no \"number\", or is not JSON (${problem}); write \"number\": \"1.3\"")
    endif()
    if(DEFINED task_${number})
      message(FATAL_ERROR "${file}: another task has the number ${number}; give each task a different number")
    endif()
    string(JSON task_${number} SET "${task}" slug "\"${slug}\"")
    list(APPEND numbers ${number})
  endforeach()
  list(SORT numbers COMPARE NATURAL)
  set(all "[]")
  set(i 0)
  foreach(number IN LISTS numbers)
    string(JSON all SET "${all}" ${i} "${task_${number}}")
    math(EXPR i "${i} + 1")
  endforeach()
  string(JSON table SET "{}" tasks "${all}")
  file(CONFIGURE OUTPUT ${FIRSTLIGHT_GENERATED}/tasks.json CONTENT "${table}" @ONLY)
  set(table "${table}" PARENT_SCOPE)
endfunction()
firstlight_read_tasks()
# firstlight_names(<variable> <words of the path in the table>...): sets an array of names as a list; empty if
# there is none.
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
  firstlight_names(FIRSTLIGHT_FUNCTIONS_${slug} tasks ${i} functions)
  if(NOT FIRSTLIGHT_FUNCTIONS_${slug})
    set(FIRSTLIGHT_FUNCTIONS_${slug} ${slug})
  endif()
  string(JSON recorded ERROR_VARIABLE missing GET "${table}" tasks ${i} recorded)
  if(NOT missing AND recorded)
    list(APPEND FIRSTLIGHT_RECORDED ${slug})
  endif()
  string(JSON viewed ERROR_VARIABLE missing GET "${table}" tasks ${i} viewed)
  if(NOT missing AND viewed)
    list(APPEND FIRSTLIGHT_VIEWED ${slug})
  endif()
  if(EXISTS ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/counting.cpp)
    list(APPEND FIRSTLIGHT_COUNTED ${slug})
  endif()
  list(APPEND FIRSTLIGHT_ANSWERED ${FIRSTLIGHT_JUDGE_ANSWERS_${slug}})
  list(APPEND FIRSTLIGHT_MOCKED ${FIRSTLIGHT_MOCKS_${slug}})
endforeach()
list(REMOVE_DUPLICATES FIRSTLIGHT_ANSWERED)
list(REMOVE_DUPLICATES FIRSTLIGHT_MOCKED)

# firstlight_write_calls(): generated/grader/task_calls.h, the functions of all tasks with their types, as the contracts declare
# them (grader/calls.h). CALL is a pure function; DRAW is a function that also takes a Sampler&, as its last argument.
function(firstlight_write_calls)
  set(TASK_INCLUDES)
  set(TASK_CALLS)
  set(TASK_LIST)
  foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
    set(contract ${PROJECT_SOURCE_DIR}/pt/tasks/${slug}.h)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${contract})
    file(READ ${contract} text)
    string(APPEND TASK_INCLUDES "#include \"pt/tasks/${slug}.h\"\n")
    string(APPEND TASK_LIST " \\\n  TASK(${slug}, CALL, DRAW)")
    string(APPEND TASK_CALLS "#define FIRSTLIGHT_CALLS_${slug}(CALL, DRAW)")
    foreach(function IN LISTS FIRSTLIGHT_FUNCTIONS_${slug})
      if(NOT text MATCHES "\n([A-Za-z_:<>]+) ${function}\\(([^()]*)\\);")
        message(FATAL_ERROR "${contract} does not declare the function ${function}; declare it at the beginning of a line, its type before it")
      endif()
      set(result ${CMAKE_MATCH_1})
      string(REGEX REPLACE "[ \n]+" " " parameters "${CMAKE_MATCH_2}")
      string(REGEX REPLACE "[^,]*[ &]([a-z_]+)(,|$)" "\\1\\2" names "${parameters}")
      string(REPLACE "," ", " names "${names}")
      set(kind CALL)
      if(parameters MATCHES "Sampler& sampler$")
        set(kind DRAW)
      endif()
      string(APPEND TASK_CALLS " \\\n  ${kind}(${result}, ${function}, (${parameters}), (${names}))")
      set(FIRSTLIGHT_RESULT_${function} "${result}" PARENT_SCOPE)
      set(FIRSTLIGHT_PARAMETERS_${function} "${parameters}" PARENT_SCOPE)
      set(FIRSTLIGHT_ARGUMENTS_${function} "${names}" PARENT_SCOPE)
    endforeach()
    string(APPEND TASK_CALLS "\n")
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/task_calls.h.in ${FIRSTLIGHT_GENERATED}/grader/task_calls.h @ONLY)
endfunction()
firstlight_write_calls()

# Sets `result` to the function `called`, whose calls of unrecorded_<function> go through the recorder.
function(firstlight_recorded_function function called result)
  set(${result} "
${FIRSTLIGHT_RESULT_${function}} ${called}(${FIRSTLIGHT_PARAMETERS_${function}}) {
  return record_call(\"${function}\", &unrecorded_${function}, ${FIRSTLIGHT_ARGUMENTS_${function}});
}
" PARENT_SCOPE)
endfunction()

# Writes the file in which calls of the task go through the recorder. `before` stands ahead of its `functions`.
function(firstlight_write_recorded file slug before functions)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/recorded.cpp.in ${file} @ONLY)
endfunction()

# firstlight_depend_on_text(<file> <source>): the objects of the file depend on the text of the source, if this is a learner's, and not only on
# its time (scripts/ninja.sh).
function(firstlight_depend_on_text file source)
  file(RELATIVE_PATH task ${PROJECT_SOURCE_DIR}/student ${source})
  if(NOT task MATCHES "^[.][.]")
    string(REGEX REPLACE "[.]cpp$" "" task ${task})
    set(saved ${PROJECT_BINARY_DIR}/saved/${task})
    if(NOT EXISTS ${saved})
      file(WRITE ${saved} "")
    endif()
    set_property(SOURCE ${file} APPEND PROPERTY OBJECT_DEPENDS ${saved})
  endif()
endfunction()

# The library <slug>.<name>.recorded: the same implementation, whose calls are recorded.
function(firstlight_add_recorded slug name source)
  if(slug IN_LIST FIRSTLIGHT_RECORDED OR slug IN_LIST FIRSTLIGHT_VIEWED)
    set(recorded ${CMAKE_CURRENT_BINARY_DIR}/recorded/${slug}.${name}.cpp)
    set(declared)  # functions of one task may call each other
    set(renamed)
    set(undone)
    set(functions)
    foreach(function IN LISTS FIRSTLIGHT_FUNCTIONS_${slug})
      string(APPEND declared "${FIRSTLIGHT_RESULT_${function}} unrecorded_${function}(${FIRSTLIGHT_PARAMETERS_${function}});\n")
      string(APPEND renamed "#define ${function} unrecorded_${function}\n")
      string(APPEND undone "#undef ${function}\n")
      firstlight_recorded_function(${function} ${function} text)
      string(APPEND functions "${text}")
    endforeach()
    firstlight_write_recorded(${recorded} ${slug} "
namespace pt {
${declared}}

${renamed}#include \"${source}\"
${undone}" "${functions}")
    add_library(${slug}.${name}.recorded OBJECT EXCLUDE_FROM_ALL ${recorded})
    target_link_libraries(${slug}.${name}.recorded PRIVATE firstlight_options)
    set_property(SOURCE ${recorded} APPEND PROPERTY OBJECT_DEPENDS ${source})
    firstlight_depend_on_text(${recorded} ${source})
  endif()
endfunction()

# Object libraries <slug>.<name> for every task file of the tree at `root`. Missing files are left out.
function(firstlight_add_implementation name root)
  foreach(task IN LISTS FIRSTLIGHT_TASKS)
    get_filename_component(slug ${task} NAME)
    if(EXISTS ${root}/${task}.cpp)
      add_library(${slug}.${name} OBJECT ${root}/${task}.cpp)
      firstlight_depend_on_text(${root}/${task}.cpp ${root}/${task}.cpp)
      target_link_libraries(${slug}.${name} PRIVATE firstlight_options)
      if(root MATCHES "/(reference|fast)$")
        target_link_libraries(${slug}.${name} PRIVATE firstlight_warnings)
      endif()
      firstlight_add_recorded(${slug} ${name} ${root}/${task}.cpp)
    endif()
  endforeach()
endfunction()

# firstlight_add_solution(<slug> <name>): the library <slug>.<name> of the mistake of that name, or of the right variant
# grader/tasks/<slug>/right/<name>.cpp, if there is one. It is added only once.
function(firstlight_add_solution slug name)
  set(source ${FIRSTLIGHT_MISTAKES}/${slug}/${name}/${slug}.cpp)
  if(NOT EXISTS ${source})
    set(source ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/right/${name}.cpp)
  endif()
  if(TARGET ${slug}.${name} OR NOT EXISTS ${source})
    return()
  endif()
  add_library(${slug}.${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${slug}.${name} PRIVATE firstlight_options)
  firstlight_add_recorded(${slug} ${name} ${source})
endfunction()

# Adds the solutions that mixtures name, as in hit_bvh=first_child_that_hits, and the mistakes that the handbook shows.
function(firstlight_add_solutions)
  list(TRANSFORM FIRSTLIGHT_SHOWN_MISTAKES REPLACE "/" "=" OUTPUT_VARIABLE choices)
  foreach(mixture IN LISTS FIRSTLIGHT_MIXTURES)
    firstlight_parse_mixture(${mixture})
    list(APPEND choices ${MIXTURE_CHOICES})
  endforeach()
  foreach(choice IN LISTS choices)
    if(choice MATCHES "^([a-z_]+)=([a-z0-9_-]+)$")
      firstlight_add_solution(${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
    endif()
  endforeach()
endfunction()

# Stops, and names the implementations of the task that there are.
function(firstlight_refuse_implementation slug name)
  set(names)
  foreach(known student reference ${FIRSTLIGHT_SHOWN_MISTAKES})
    string(REGEX REPLACE "^${slug}/" "" known ${known})
    if(TARGET ${slug}.${known})
      list(APPEND names ${known})
    endif()
  endforeach()
  if(FIRSTLIGHT_MISTAKES_${slug})
    list(APPEND names "every mistake in build/mistakes/${slug}" "every right solution in grader/tasks/${slug}/right")
  endif()
  list(JOIN names ", " names)
  message(FATAL_ERROR "there is no implementation '${name}' of the task ${slug}; there are ${names}")
endfunction()

# firstlight_link_tasks(<program> FROM <implementation> [RADIANCE <implementation>]
#                       [CHOICES <slug>=<implementation> ...] [FAST] [RECORDED | VIEWED])
# links one definition of every task, all FROM one implementation but for the CHOICES, and one of the
# slot radiance (default: path; none: the program defines it itself). FAST takes the faster form of the
# tasks that come FROM the reference and have one. RECORDED takes the recorded form of the FIRSTLIGHT_RECORDED tasks, VIEWED of
# all tasks that have one. Sets LINKED_<slug> to the library that was linked.
function(firstlight_link_tasks program)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "FAST;RECORDED;VIEWED" "FROM;RADIANCE" "CHOICES")
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
    if(NOT choice MATCHES "^([a-z_]+)=([a-z0-9_-]+)$" OR NOT CMAKE_MATCH_1 IN_LIST slugs)
      message(FATAL_ERROR "'${choice}' is not a choice: write <task>=<implementation>; <task> is one of ${slugs}")
    endif()
    set(choice_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endforeach()
  set_target_properties(${program} PROPERTIES LINKER_LANGUAGE CXX) # where all of it is compiled already
  foreach(slug IN LISTS slugs)
    set(library ${slug}.${choice_${slug}})
    if(NOT TARGET ${library})
      firstlight_refuse_implementation(${slug} ${choice_${slug}})
    endif()
    if(ARG_VIEWED OR (ARG_RECORDED AND slug IN_LIST FIRSTLIGHT_RECORDED))
      if(TARGET ${library}.recorded)
        set(library ${library}.recorded)
      elseif(library STREQUAL ${slug}.fast) # a handout has the recorded form of the reference alone
        set(library ${slug}.reference.recorded)
      endif()
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
# that the judge answers, and mocks; and INNER_RADIANCE: <radiance>, or path if the judge does not answer
# radiance().
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

# firstlight_symbol(<function> <variable>): the name that g++ and clang give to the function of a recorded task;
# tests/grader/tasks/tasks_test.cpp compares it with the reference's object.
function(firstlight_symbol function variable)
  string(LENGTH ${function} length)
  set(parameters "${FIRSTLIGHT_PARAMETERS_${function}}")
  set(arguments RKNS_5SceneERKNS_12SurfacePointEiRNS_7SamplerE)
  if(parameters MATCHES "^const ([A-Za-z]+)& [a-z]+, const Ray& ray$")
    string(LENGTH ${CMAKE_MATCH_1} shape_length)
    set(arguments RKNS_${shape_length}${CMAKE_MATCH_1}ERKNS_3RayE)
  elseif(parameters MATCHES "^const Camera& [a-z]+, double [a-z]+, double [a-z]+$")
    set(arguments RKNS_6CameraEdd)
  elseif(parameters MATCHES "^Rgb [a-z]+, Vec3 [a-z]+, Vec3 [a-z]+$")
    set(arguments NS_3RgbENS_4Vec3ES1_)
  elseif(parameters MATCHES "^Rgb [a-z]+, Vec3 [a-z]+, Sampler& [a-z]+$")
    set(arguments NS_3RgbENS_4Vec3ERNS_7SamplerE)
  elseif(parameters MATCHES "^Vec3 [a-z]+, Vec3 [a-z]+$")
    set(arguments NS_4Vec3ES0_)
  endif()
  set(${variable} _ZN2pt${length}${function}E${arguments} PARENT_SCOPE)
endfunction()

# firstlight_add_recorder_calls(<library> <slug> ...): objects through which the linker, with the flags of these tasks
# (firstlight_recorder_flags), sends all their calls from other files. They are for workers, whose tasks come from a submission.
function(firstlight_recorder_flags result)
  foreach(slug IN LISTS ARGN)
    foreach(function IN LISTS FIRSTLIGHT_FUNCTIONS_${slug})
      firstlight_symbol(${function} symbol)
      list(APPEND flags -Wl,--wrap=${symbol})
    endforeach()
  endforeach()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()
firstlight_recorder_flags(FIRSTLIGHT_RECORDER_FLAGS ${FIRSTLIGHT_RECORDED})
function(firstlight_add_recorder_calls library)
  foreach(slug IN LISTS ARGN)
    set(text)
    foreach(function IN LISTS FIRSTLIGHT_FUNCTIONS_${slug})
      firstlight_symbol(${function} symbol)
      set(result "${FIRSTLIGHT_RESULT_${function}}")
      set(parameters "${FIRSTLIGHT_PARAMETERS_${function}}")
      firstlight_recorded_function(${function} recorded_${function} recorded)
      string(APPEND text "
${result} unrecorded_${function}(${parameters}) asm(\"__real_${symbol}\");
${result} recorded_${function}(${parameters}) asm(\"__wrap_${symbol}\");
${recorded}")
    endforeach()
    set(file ${CMAKE_CURRENT_BINARY_DIR}/recorder_calls/${slug}.cpp)
    firstlight_write_recorded(${file} ${slug} "" "${text}")
    list(APPEND files ${file})
  endforeach()
  firstlight_objects(${library} ${files})
endfunction()

# Turns a mixture in words, "reference" or "reference+hit_bvh=student+...", into the arguments of
# firstlight_link_tasks (MIXTURE_FROM and MIXTURE_CHOICES) and a suffix for targets and files.
macro(firstlight_parse_mixture mixture)
  string(REPLACE "+" ";" MIXTURE_CHOICES "${mixture}")
  list(POP_FRONT MIXTURE_CHOICES MIXTURE_FROM)
  string(REPLACE "=" "-" MIXTURE_SUFFIX "${mixture}")
endmacro()
