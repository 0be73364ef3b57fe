# What ./run does, and rules that the tree keeps.
set(build ARGUMENTS ${PROJECT_BINARY_DIR})
foreach(test layers_test comments_test)
  firstlight_test(${test} quick PLAIN PATHS SOURCES rules/${test}.cpp LIBRARIES grader_base)
endforeach()
# Mistakes in the framework, each of which a test must find: that they fit their files, and, long, that they are found; and small
# changes of it, other ones each time.
firstlight_script_test(edits quick rules/edits.sh)
firstlight_script_test(mutants_fit quick mutants/run.py ARGUMENTS --check)
# Small changes of correct solutions, each of which a promise must find: that the reasons for others fit, and, long, that they are found.
firstlight_script_test(small_changes_fit quick mutants/small_changes.py ARGUMENTS ${PROJECT_BINARY_DIR} --list)
firstlight_script_test(pages quick rules/pages.py)
firstlight_script_test(english quick rules/english.py)
firstlight_script_test(drawings quick ../scripts/drawings.py ARGUMENTS --check)
# Newer compilers bring fewer headers along than those of the tests.
firstlight_script_test(std_includes quick rules/std_includes.py)
# Where headers are precompiled, whole libraries are one file, and this sees the other files only.
firstlight_script_test(compiled_once quick rules/compiled_once.py ${build})
firstlight_script_test(precompiled_fits rest rules/precompiled_fits.py
  ARGUMENTS ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/precompiled)
# When all folders have been read.
include(rules/link_lists.cmake)
cmake_language(DEFER DIRECTORY ${PROJECT_SOURCE_DIR} CALL firstlight_write_link_lists)
firstlight_script_test(link_lists quick rules/link_lists.py ${build})
firstlight_script_test(edition rest commands/edition.sh)
firstlight_script_test(editors rest commands/editors.sh)
firstlight_script_test(run_setup rest commands/run_setup.sh)
if(FIRSTLIGHT_SANITIZE)  # some of the programs are not built then
  return()
endif()
firstlight_script_test(newest_text rest commands/newest_text.sh ARGUMENTS ${PROJECT_BINARY_DIR})
firstlight_script_test(run_refuses quick commands/run_refuses.sh)
firstlight_script_test(mixtures quick commands/mixtures.sh)
firstlight_script_test(coverage quick commands/coverage.sh)
firstlight_script_test(walk quick commands/walk.sh ${build}
  NEEDS render export judge compare_picture view view_worker.reference compare check.hit_sphere.sanitized grade graded_programs hint grade_class)
firstlight_script_test(help_pages rest commands/help.sh ${build} NEEDS grade grade_examples hint watch box render view compare generate writeup
  accuracy.reference measure stability bless grade_class ladder judge export)
# The functions of the live figures, for this machine: their hit_box and hit_sphere count calls (site/live/recorded.cpp).
file(GLOB live ${PROJECT_SOURCE_DIR}/site/live/*.cpp)
add_executable(live_calls EXCLUDE_FROM_ALL site/calls.cpp ${live})
target_link_libraries(live_calls PRIVATE firstlight_warnings radiance.path nlohmann_json::nlohmann_json)
set_target_properties(live_calls PROPERTIES ENABLE_EXPORTS ON)
set(own hit_box hit_sphere)
foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
  if(NOT slug IN_LIST own)
    target_link_libraries(live_calls PRIVATE ${slug}.reference)
  endif()
endforeach()
firstlight_script_test(site rest site/site.sh ARGUMENTS $<TARGET_FILE:live_calls>
  NEEDS live_calls site grade graded_programs grade_class view view_worker.reference)
firstlight_script_test(autograder_made rest commands/autograder.sh ARGUMENTS ${PROJECT_BINARY_DIR} made NEEDS grade graded)
firstlight_script_test(workflows rest commands/workflows.sh ${build} NEEDS grade graded)
# For Windows and macOS, where their compilers are installed.
foreach(system windows macos)
  firstlight_script_test(${system} rest rules/other_systems.py ARGUMENTS ${system})
endforeach()
firstlight_script_test(release rest commands/release.sh ${build} NEEDS compiled graded reference_objects)
firstlight_script_test(resume rest commands/resume.sh ARGUMENTS ${PROJECT_BINARY_DIR}/grader NEEDS grade graded grade_class)
firstlight_script_test(faults rest commands/faults.sh ${build} NEEDS grade graded watch hint)
# These build the project again: minutes, or with ccache the first time only.
firstlight_script_test(handout long commands/handout.sh ${build} NEEDS compiled graded reference_objects)
firstlight_script_test(outside long pt/outside/outside.sh ARGUMENTS $<TARGET_FILE:render_plain> NEEDS render_plain)
firstlight_script_test(autograder long commands/autograder.sh ${build} NEEDS grade graded)
# In pieces, each of which ends within 40 minutes on two idle cores.
foreach(part RANGE 1 8)
  firstlight_script_test(mutants_${part} long mutants/run.py ARGUMENTS ${PROJECT_BINARY_DIR}/mutants --part ${part} 8)
endforeach()
firstlight_script_test(drawn_mutants long mutants/run.py ARGUMENTS ${PROJECT_BINARY_DIR}/mutants --draw 25)
foreach(task IN LISTS FIRSTLIGHT_TASKS)
  get_filename_component(task ${task} NAME)
  firstlight_script_test(small_changes_${task} long mutants/small_changes.py ARGUMENTS ${PROJECT_BINARY_DIR} ${task})
  firstlight_script_test(arms_${task} long mutants/arms.py ARGUMENTS ${PROJECT_BINARY_DIR} ${task})
endforeach()
firstlight_script_test(adding_a_task long commands/adding_a_task.sh ARGUMENTS ${PROJECT_BINARY_DIR}/../adding_a_task)
