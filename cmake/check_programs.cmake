# The programs that check one task. They link the chosen implementation of the task, counting versions and mocks of the tasks that
# it calls, and for all others the reference, or another implementation that is named last.
function(firstlight_link_asked program slug implementation)
  firstlight_inner_choices(${slug} counting scripted)
  target_link_libraries(${program} PRIVATE firstlight_warnings)
  set(others reference ${ARGN})
  list(GET others -1 others)
  firstlight_link_tasks(${program} FROM ${others} RADIANCE ${INNER_RADIANCE}
    CHOICES ${slug}=${implementation} ${INNER_CHOICES} ${INNER_RECORDED})
endfunction()

# Also links the properties of the task.
function(firstlight_link_properties program slug implementation)
  target_link_libraries(${program} PRIVATE properties.${slug})
  firstlight_link_asked(${program} ${slug} ${implementation} ${ARGN})
endfunction()

# check.<slug>.<implementation>: the properties of one task in one process, for a debugger and for the
# tests of the properties themselves. A handout on another machine has no reference, and links the learner's other tasks.
function(firstlight_add_check_program slug implementation)
  set(program check.${slug}.${implementation})
  add_executable(${program} ${ARGN})
  set_target_properties(${program} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${program} PRIVATE ${slug}.repeat GTest::gtest_main)
  set(others)
  if(FIRSTLIGHT_REFERENCE STREQUAL stubs)
    set(others student)
  endif()
  firstlight_link_properties(${program} ${slug} ${implementation} ${others})
endfunction()

# check.<slug>.<implementation> with the learner's file, compiled with further options; these are also for the linker. All else is linked as
# it is, so that it takes seconds.
function(firstlight_add_learners_check_program slug implementation options)
  get_target_property(source ${slug}.student SOURCES)
  add_library(${slug}.${implementation} OBJECT EXCLUDE_FROM_ALL ${source})
  firstlight_depend_on_text(${source} ${source}) # once more: a property of a file is that of one folder
  target_link_libraries(${slug}.${implementation} PRIVATE firstlight_options)
  target_compile_options(${slug}.${implementation} PRIVATE ${options} ${ARGN})
  firstlight_add_check_program(${slug} ${implementation} EXCLUDE_FROM_ALL)
  target_link_options(check.${slug}.${implementation} PRIVATE ${options})
endfunction()

# The implementation `sanitized` is the learner's file under sanitizers; `covered` counts how often each of its lines runs.
function(firstlight_add_check_programs)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/grader)
  foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
    foreach(implementation reference student)
      if(TARGET ${slug}.${implementation})
        firstlight_add_check_program(${slug} ${implementation})
      endif()
    endforeach()
    if(TARGET ${slug}.submission)
      firstlight_add_check_program(${slug} submission EXCLUDE_FROM_ALL)
    endif()
    if(TARGET ${slug}.student AND NOT FIRSTLIGHT_SANITIZE)
      firstlight_add_learners_check_program(${slug} sanitized "${FIRSTLIGHT_SANITIZERS}" ${FIRSTLIGHT_LIBRARY_CHECKS} -O1 -g1)
      firstlight_add_learners_check_program(${slug} covered --coverage -O0)
    endif()
  endforeach()
endfunction()

# firstlight_gather(<program>): adds it to the target of its kind, if it has one. graded_programs judge tasks and pictures; graded is these
# and what is known of mistakes; stability_programs measure the curves of tasks, and search.
function(firstlight_gather program)
  if(program MATCHES "^graded[._]")
    set(all graded_programs)
  elseif(program MATCHES "^known[.]")
    set(all graded)
  elseif(program MATCHES "^(stability|search)[.]")
    set(all stability_programs)
  else()
    return()
  endif()
  if(NOT TARGET graded)
    add_custom_target(graded_programs)
    add_custom_target(graded DEPENDS graded_programs)
    add_custom_target(stability_programs)
  endif()
  add_dependencies(${all} ${program})
endfunction()
