# grade.json: all that `grade` needs to build and judge a submission without CMake. It is next to the programs of the grader,
# where they look for each other. The target `grade` is the judge with everything except the programs of single tasks, which
# are the target `graded` (grader/programs/CMakeLists.txt).

# Sets words as the inside of a JSON array; also the objects of libraries, which are built before `target`.
function(firstlight_json_list result)
  list(TRANSFORM ARGN REPLACE "\\\\" "\\\\\\\\" OUTPUT_VARIABLE words)
  list(TRANSFORM words REPLACE "\"" "\\\\\"")
  list(TRANSFORM words REPLACE "(.+)" "\"\\1\"")
  string(JOIN "," text ${words})
  set(${result} "[${text}]" PARENT_SCOPE)
endfunction()
function(firstlight_json_objects target result)
  set(text)
  foreach(library IN LISTS ARGN)
    firstlight_objects_of(${library} "\",\"" objects)
    list(APPEND text "\"${objects}\"")
    get_target_property(compiled ${library} IMPORTED)
    if(NOT compiled)
      add_dependencies(${target} ${library})
    endif()
  endforeach()
  string(JOIN "," text ${text})
  set(${result} "[${text}]" PARENT_SCOPE)
endfunction()

function(firstlight_write_grade_json)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
  get_target_property(options firstlight_options INTERFACE_COMPILE_OPTIONS)
  if(FIRSTLIGHT_SANITIZE) # is for our code: the judge refuses an object with what sanitisers add
    list(FILTER options EXCLUDE REGEX "sanitize")
  endif()
  firstlight_json_list(compile_flags
    ${flags} ${CMAKE_CXX20_STANDARD_COMPILE_OPTION} ${options} ${FIRSTLIGHT_LIBRARY_CHECKS})
  separate_arguments(flags UNIX_COMMAND "${CMAKE_EXE_LINKER_FLAGS}")
  get_target_property(options firstlight_options INTERFACE_LINK_OPTIONS)
  if(NOT options)
    set(options)
  endif()
  firstlight_json_list(link_flags ${flags} ${FIRSTLIGHT_FAST_LINKER} ${options} -pthread)
  firstlight_json_list(recording_flags ${FIRSTLIGHT_RECORDER_FLAGS})
  # What both judges build from, so that either may be built first.
  add_custom_target(grade_parts)
  add_dependencies(grade grade_parts)
  add_dependencies(grade_examples grade_parts)
  # The parts of every program that runs tasks, besides the tasks.
  firstlight_ours_handed_on(libraries grader_worker grader_connection grader_serve pt_rows)
  firstlight_json_objects(grade_parts framework ${libraries})
  firstlight_json_objects(grade_parts recording recorder_calls)
  firstlight_json_objects(grade_parts radiance radiance.path)

  set(callbacks)
  foreach(name IN LISTS FIRSTLIGHT_ANSWERED)
    firstlight_json_objects(grade_parts objects ${name}.callback)
    list(APPEND callbacks "\"${name}\": ${objects}")
  endforeach()
  foreach(slug IN LISTS FIRSTLIGHT_MOCKED)
    firstlight_json_objects(grade_parts objects ${slug}.mock)
    list(APPEND callbacks "\"${slug}\": ${objects}")
  endforeach()
  string(JOIN ",\n  " callbacks ${callbacks})

  set(tasks)
  foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
    firstlight_json_objects(grade_parts objects ${slug}.reference)
    list(APPEND tasks "{\"slug\": \"${slug}\", \"graded\": \"${PROJECT_BINARY_DIR}/grader/graded.${slug}\", \
\"reference\": ${objects}}")
  endforeach()
  string(JOIN ",\n  " tasks ${tasks})

  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/grader/grade.json CONTENT "{
 \"root\": \"${PROJECT_SOURCE_DIR}\",
 \"work\": \"${PROJECT_BINARY_DIR}/grader/graded\",
 \"compiler\": \"${CMAKE_CXX_COMPILER}\",
 \"compile_flags\": ${compile_flags},
 \"link_flags\": ${link_flags},
 \"recording_flags\": ${recording_flags},
 \"framework\": ${framework},
 \"recording\": ${recording},
 \"radiance\": ${radiance},
 \"picture\": \"${PROJECT_BINARY_DIR}/grader/graded_picture\",
 \"version\": \"${PROJECT_VERSION}\",
 \"compiler_version\": \"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\",
 \"callbacks\": {
  ${callbacks}},
 \"no_reference\": \"${FIRSTLIGHT_NO_REFERENCE}\",
 \"tasks\": [
  ${tasks}]
}
")
endfunction()

# ordinary.<slug>.txt, also there: the mistakes that ordinary inputs show, that is, in 1 % of them or more. The examples in
# grader/tasks/<slug>/ordinary catch these. An edition has this file in grader/known.
function(firstlight_add_ordinary slug)
  set(made ${PROJECT_BINARY_DIR}/grader/ordinary.${slug}.txt)
  set(folder ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/ordinary)
  set(brought ${PROJECT_SOURCE_DIR}/grader/known/ordinary.${slug}.txt)
  if(EXISTS ${folder})
    add_custom_command(OUTPUT ${made} VERBATIM
      COMMAND grade_examples ${slug} --submission ${folder} --caught ${made}
      DEPENDS grade_examples ${folder}/${slug}.examples.cpp ${PROJECT_SOURCE_DIR}/pt/examples/inputs.h
        $<TARGET_OBJECTS:${slug}.mistakes>
      COMMENT "Asking the known mistakes of ${slug} ordinary inputs")
    add_custom_target(ordinary.${slug} DEPENDS ${made})
    add_dependencies(examples.${slug} ordinary.${slug})
    add_dependencies(graded ordinary.${slug})  # for a handout
  elseif(EXISTS ${brought})
    file(COPY ${brought} DESTINATION ${PROJECT_BINARY_DIR}/grader)
  endif()
endfunction()

# examples.json, also there: what `grade_examples` needs besides. `solutions` has the objects of all solutions of each task; the target
# examples.<slug> builds them. A handout has them compiled, if they fit.
function(firstlight_write_examples_json)
  firstlight_ours_handed_on(libraries examples_runner pt_rows)
  firstlight_json_objects(grade_examples framework ${libraries})
  set(solutions)
  foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
    add_custom_target(examples.${slug})
    set(objects "[]")
    if(TARGET ${slug}.mistakes)
      firstlight_json_objects(examples.${slug} objects ${slug}.mistakes)
    endif()
    list(APPEND solutions "\"${slug}\": ${objects}")
    firstlight_add_ordinary(${slug})
  endforeach()
  string(JOIN ",\n  " solutions ${solutions})
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/grader/examples.json CONTENT "{
 \"framework\": ${framework},
 \"solutions\": {
  ${solutions}}
}
")
endfunction()
