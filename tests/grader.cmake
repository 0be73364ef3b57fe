# The core of the grader: how a promise is checked, pictures, results, reports.
foreach(test property_test curve_test search_test)
  firstlight_test(${test} quick SOURCES grader/check/${test}.cpp LIBRARIES grader_check)
endforeach()

firstlight_test(test_explain quick SOURCES grader/explain/direct_test.cpp grader/explain/path_test.cpp grader/explain/pixel_test.cpp
  LIBRARIES grader_explain)

firstlight_test(test_recipes quick PATHS SOURCES grader/pictures/recipes_test.cpp LIBRARIES grader_judge_recipe GTest::gmock RADIANCE recorded)
# Pictures and sample maps drawn from known distributions.
firstlight_library(synthetic_pictures EXCLUDE_FROM_ALL grader/pictures/synthetic_maps.cpp grader/pictures/synthetic_pictures.cpp)
target_link_libraries(synthetic_pictures PUBLIC grader_pictures)
firstlight_test(image_verdict_test rest PATHS LIBRARIES synthetic_pictures GTest::gmock SOURCES
  grader/pictures/image_verdict_test.cpp grader/pictures/image_failing_cells_test.cpp grader/pictures/image_guards_test.cpp)
firstlight_test(sample_map_verdict_test quick SOURCES grader/pictures/sample_map_verdict_test.cpp
  LIBRARIES synthetic_pictures GTest::gmock)
firstlight_test(test_compare quick SOURCES grader/pictures/compare_test.cpp LIBRARIES grader_pictures NEEDS compare
  DEFINES COMPARE_PROGRAM="$<TARGET_FILE:compare>")
firstlight_test(test_single rest PATHS SOURCES grader/pictures/single_test.cpp LIBRARIES grader_single pt_render GTest::gmock RADIANCE recorded)
firstlight_test(test_bless rest PATHS SOURCES grader/pictures/bless_test.cpp LIBRARIES grader_goldens GTest::gmock RADIANCE recorded
  NEEDS bless DEFINES BLESS_PROGRAM="$<TARGET_FILE:bless>")
firstlight_test(test_goldens rest PATHS SOURCES grader/pictures/goldens_test.cpp LIBRARIES grader_goldens GTest::gmock
  RADIANCE recorded)
firstlight_test(test_engines rest PATHS SOURCES pt/render/engines_test.cpp LIBRARIES grader_pictures pt_loader RADIANCE recorded)

# What needs a box: renderers of others, attacks of work in the skeleton of a course, and hostile examples.
if(NOT FIRSTLIGHT_SANITIZE)
  firstlight_script_test(judge quick grader/renderers/judge.sh ARGUMENTS ${PROJECT_BINARY_DIR}/grader NEEDS judge)
  firstlight_script_test(course_attacks rest grader/door/attacks.py ARGUMENTS ${PROJECT_BINARY_DIR}/grader NEEDS grade graded)
  firstlight_script_test(examples quick grader/examples/examples.sh ARGUMENTS ${PROJECT_BINARY_DIR} NEEDS grade_examples examples.hit_sphere)
endif()

# Work in the skeleton of a course.
firstlight_test(door_test quick PLAIN PATHS SOURCES grader/door/door_test.cpp LIBRARIES grader_door GTest::gmock)
foreach(what right mistakes doors)
  firstlight_script_test(course_${what} rest grader/door/course.py ARGUMENTS ${PROJECT_BINARY_DIR}/grader ${what} NEEDS grade graded grade_class)
endforeach()

firstlight_script_test(course_right_few rest grader/door/right_clones.py ARGUMENTS ${PROJECT_BINARY_DIR}/grader few NEEDS grade graded)
firstlight_script_test(course_right_all long grader/door/right_clones.py ARGUMENTS ${PROJECT_BINARY_DIR}/grader NEEDS grade graded)
firstlight_script_test(course_dialects rest grader/door/dialects.py ARGUMENTS ${PROJECT_BINARY_DIR}/grader NEEDS grade graded)

# Learners' examples of tasks.
firstlight_script_test(examples_of_a_class rest grader/examples/class.sh ARGUMENTS ${PROJECT_BINARY_DIR}
  NEEDS grade grade_class grade_examples graded.hit_sphere known.hit_sphere examples.hit_sphere)
set(needed)
file(GLOB good RELATIVE ${tests}/fixtures/examples/good ${tests}/fixtures/examples/good/*.cpp)
foreach(file IN LISTS good)
  string(REPLACE ".examples.cpp" "" slug ${file})
  list(APPEND needed examples.${slug})
endforeach()
firstlight_script_test(good_examples rest grader/examples/good_files.sh ARGUMENTS ${PROJECT_BINARY_DIR} NEEDS grade_examples ${needed})

firstlight_library(example_results grader/report/example_results.cpp)
target_link_libraries(example_results PUBLIC grader_platforms)
firstlight_test(test_report quick PATHS LIBRARIES example_results GTest::gmock SOURCES
  grader/report/report_test.cpp grader/report/report_junit_test.cpp grader/report/report_page_test.cpp
  grader/report/report_pictures_test.cpp grader/report/report_order_test.cpp grader/service/platforms/platforms_test.cpp
  grader/service/platforms/worksheet_test.cpp grader/report/report_writers_test.cpp grader/service/platforms/class_page_test.cpp
  grader/report/autograders_test.cpp grader/service/platforms/likeness_test.cpp grader/results/changes_test.cpp)
add_executable(example_page grader/report/example_page.cpp)
target_link_libraries(example_page PRIVATE firstlight_warnings example_results)
firstlight_script_test(page rest grader/report/page.sh ARGUMENTS $<TARGET_FILE:example_page> NEEDS example_page)
firstlight_test(test_naming quick PATHS SOURCES grader/mistakes/naming_test.cpp grader/results/points_test.cpp
  LIBRARIES grader_judging grader_battery GTest::gmock)
firstlight_test(test_hints quick PATHS SOURCES grader/report/hints_test.cpp LIBRARIES grader_judging GTest::gmock NEEDS hint
  DEFINES HINT_PROGRAM="$<TARGET_FILE:hint>")
firstlight_test(test_watch quick PATHS LIBRARIES grader_results grader_watch_fit GTest::gmock util NEEDS watch flatten
  SOURCES grader/watch/watch_test.cpp grader/watch/fit_test.cpp grader/watch/pseudo_terminal.cpp
  DEFINES WATCH_PROGRAM="$<TARGET_FILE:watch>")
firstlight_test(test_status_line quick SOURCES grader/report/status_line_test.cpp LIBRARIES grader_report GTest::gmock)

# The properties on the reference: as a submission in a worker, and in one process.
foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
  firstlight_add_test(graded.${slug} quick NEEDS graded.${slug} worker.${slug}
    COMMAND graded.${slug} --promises=-*_bonus --worker $<TARGET_FILE:worker.${slug}>)
  # A bonus promise may ask for more than the plain method that the reference shows.
  firstlight_add_test(check.${slug} rest NEEDS check.${slug}.reference
    COMMAND check.${slug}.reference --gtest_filter=-*_bonus)
  # A failure is shown on simple values if they fail, too: right work has to hold there.
  firstlight_add_test(simple.${slug} rest NEEDS check.${slug}.reference
    COMMAND check.${slug}.reference --gtest_filter=-*_bonus)
  set_tests_properties(simple.${slug} PROPERTIES ENVIRONMENT FIRSTLIGHT_SIMPLE=1)
endforeach()

# Limits on memory do not go with AddressSanitizer.
if(FIRSTLIGHT_SANITIZE)
  return()
endif()

# The grader graded: every wrong solution of a task fails the promise that it names, every right one
# keeps them all. The test compiles each as a submission is compiled, and links it to what
# check.<slug>.reference is linked to, but for the task itself: one list of objects per task.
set(programs)
foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
  list(APPEND programs check.${slug}.reference)
  get_target_property(libraries check.${slug}.reference LINK_LIBRARIES)
  list(REMOVE_ITEM libraries ${slug}.reference)
  set(content)
  foreach(library IN LISTS libraries)
    get_target_property(type ${library} TYPE)
    if(type STREQUAL OBJECT_LIBRARY)
      string(APPEND content "\"$<JOIN:$<TARGET_OBJECTS:${library}>,\"\n\">\"\n")
    endif()
  endforeach()
  firstlight_handed_on(all ${libraries})
  foreach(library IN LISTS all)
    get_target_property(type ${library} TYPE)
    if(NOT type STREQUAL OBJECT_LIBRARY)
      string(APPEND content "\"$<TARGET_FILE:${library}>\"\n")
    endif()
  endforeach()
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/tests/${slug}.objects CONTENT "${content}")
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/tests/${slug}.contract
    CONTENT "$<JOIN:$<TARGET_OBJECTS:${slug}.reference>,\n>\n")
endforeach()

# The table of tasks against the objects of the reference.
set(symbols)
foreach(slug IN LISTS FIRSTLIGHT_RECORDED FIRSTLIGHT_VIEWED)
  foreach(function IN LISTS FIRSTLIGHT_FUNCTIONS_${slug})
    firstlight_symbol(${function} symbol)
    string(APPEND symbols "${slug}=${symbol} ")
  endforeach()
endforeach()
firstlight_test(tasks_test quick PLAIN PATHS SOURCES grader/tasks/tasks_test.cpp LIBRARIES grader_judging NEEDS ${programs}
  DEFINES FIRSTLIGHT_SYMBOLS="${symbols}")

firstlight_library(grader_submissions fixtures/task_folder.cpp fixtures/hostile_submission.cpp)
target_link_libraries(grader_submissions PUBLIC grader_sandbox grader_results GTest::gtest)
firstlight_paths(grader_submissions)
add_executable(wrong_and_right_test grader/tasks/wrong_and_right_test.cpp fixtures/submission.cpp)
target_link_libraries(wrong_and_right_test PRIVATE firstlight_warnings grader_submissions grader_judging)
firstlight_paths(wrong_and_right_test)
target_compile_definitions(wrong_and_right_test PRIVATE
  FIRSTLIGHT_CXX="${CMAKE_CXX_COMPILER_LAUNCHER} ${CMAKE_CXX_COMPILER}" FIRSTLIGHT_FAST_LINKER="${FIRSTLIGHT_FAST_LINKER}")
set(needs NEEDS wrong_and_right_test ${programs})
firstlight_add_test(some_wrong_and_right quick
  COMMAND wrong_and_right_test --gtest_filter=-*every_bonus_promise --each 2 ${needs})
firstlight_add_test(many_wrong_and_right rest COMMAND wrong_and_right_test --each 5 ${needs})
firstlight_add_test(wrong_and_right_test long COMMAND wrong_and_right_test ${needs})
firstlight_script_test(debug rest commands/debug.sh NEEDS ${programs}
  ARGUMENTS ${CMAKE_CXX_COMPILER} ${PROJECT_BINARY_DIR}/tests/hit_triangle.objects)

# Right work of every kind, graded as a class hands it in: a little of it by the tests, as much as is
# asked for by hand.
add_executable(right_work grader/tasks/right_work.cpp)
target_link_libraries(right_work PRIVATE firstlight_warnings grader_submissions grader_judging CLI11::CLI11)
firstlight_add_test(right_work rest NEEDS right_work grade graded COMMAND right_work --mixtures 4 --first-seed 5060)

firstlight_add_test(right_with_20_seeds long NEEDS right_work grade graded
  COMMAND right_work --variant-seeds 20 --reference-seeds 20)

# Tests what `grade` names mistakes, their relatives and right solutions. All of them take half an hour; the test tries one
# of each kind for each task.
add_executable(naming grader/mistakes/naming.cpp)
target_link_libraries(naming PRIVATE firstlight_warnings grader_submissions grader_judging CLI11::CLI11)
firstlight_add_test(naming rest COMMAND naming --each 1 NEEDS naming grade graded)
firstlight_script_test(sample_tables rest rules/sample_tables.sh ARGUMENTS ${PROJECT_BINARY_DIR}/grader/grade NEEDS grade graded)
