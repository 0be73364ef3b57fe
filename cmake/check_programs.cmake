# The programs that check one task: the task as asked for, counting versions and mocks of the tasks that it calls, the reference for all
# others.
function(firstlight_link_asked program slug implementation)
  firstlight_inner_choices(${slug} counting scripted)
  target_link_libraries(${program} PRIVATE firstlight_warnings)
  firstlight_link_tasks(${program} FROM reference RADIANCE ${INNER_RADIANCE}
    CHOICES ${slug}=${implementation} ${INNER_CHOICES})
endfunction()

# The same with the properties of the task.
function(firstlight_link_properties program slug implementation)
  target_link_libraries(${program} PRIVATE properties.${slug})
  firstlight_link_asked(${program} ${slug} ${implementation})
endfunction()

# check.<slug>.<implementation>: the properties of one task in one process, for a debugger and for the
# tests of the properties themselves.
function(firstlight_add_check_programs)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/grader)
  foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
    foreach(implementation reference student)
      if(TARGET ${slug}.${implementation})
        set(program check.${slug}.${implementation})
        add_executable(${program})
        set_target_properties(${program} PROPERTIES LINKER_LANGUAGE CXX)
        target_link_libraries(${program} PRIVATE ${slug}.repeat GTest::gtest_main)
        firstlight_link_properties(${program} ${slug} ${implementation})
      endif()
    endforeach()
    # A bonus promise may ask for more than the plain method that the reference shows.
    if(TARGET check.${slug}.reference)
      add_test(NAME check.${slug} COMMAND check.${slug}.reference --gtest_filter=-*_bonus)
    endif()
  endforeach()
endfunction()

# The target graded is all programs that judge a task and what is known of its mistakes, and stability_programs are those that measure its curves and search: adds the
# program to its target, if it has one.
function(firstlight_gather program)
  if(program MATCHES "^(graded|known)[._]")
    set(all graded)
  elseif(program MATCHES "^(stability|search)[.]")
    set(all stability_programs)
  else()
    return()
  endif()
  if(NOT TARGET ${all})
    add_custom_target(${all})
  endif()
  add_dependencies(${all} ${program})
endfunction()
