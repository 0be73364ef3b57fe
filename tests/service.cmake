# What the grader has because the code is somebody else's.
set(programs ${PROJECT_BINARY_DIR}/grader)
set(service grader/service)
firstlight_test(test_process_time quick LIBRARIES grader_process SOURCES
  ${service}/process/process_time_test.cpp ${service}/process/memory_group_test.cpp ${service}/process/run_command_test.cpp
  ${service}/process/submitted_files_test.cpp ${service}/process/printable_test.cpp)
firstlight_test(process_test quick PLAIN SOURCES ${service}/process/process_test.cpp LIBRARIES grader_process)
firstlight_test(test_filter quick SOURCES ${service}/sandbox/filter_test.cpp LIBRARIES grader_launcher)
firstlight_test(test_remote quick SOURCES ${service}/wire/remote_test.cpp LIBRARIES grader_wire)
firstlight_test(audit_test quick PLAIN PATHS SOURCES ${service}/audit/audit_test.cpp LIBRARIES grader_build
  DEFINES FIRSTLIGHT_CXX="${CMAKE_CXX_COMPILER}")
firstlight_test(standard_library_test rest PLAIN PATHS SOURCES ${service}/audit/standard_library_test.cpp LIBRARIES grader_build
  DEFINES FIRSTLIGHT_CXX="${CMAKE_CXX_COMPILER}" FIRSTLIGHT_LIBRARY="${tests}/${service}/audit/standard_library")
firstlight_test(test_cache quick LIBRARIES grader_judging SOURCES
  ${service}/build/cache_test.cpp ${service}/judging/so_far_test.cpp ${service}/sandbox/box_users_test.cpp)

if(FIRSTLIGHT_CLASS)
  find_package(LibArchive REQUIRED)  # makes the archives
  firstlight_test(test_intake quick LIBRARIES grader_intake LibArchive::LibArchive GTest::gmock SOURCES
    ${service}/intake/intake.cpp ${service}/intake/intake_platforms_test.cpp ${service}/intake/intake_archives_test.cpp
    ${service}/intake/intake_trees_test.cpp ${service}/intake/intake_names_test.cpp ${service}/intake/form_table_test.cpp
    DEFINES FIRSTLIGHT_ROOT="${PROJECT_SOURCE_DIR}")
  add_executable(forged_names ${service}/intake/forged_names_main.cpp)
  target_link_libraries(forged_names PRIVATE grader_intake firstlight_warnings)
  target_compile_definitions(forged_names PRIVATE FIRSTLIGHT_ROOT="${PROJECT_SOURCE_DIR}")
  firstlight_add_test(random_classes long NEEDS test_intake
    COMMAND env FIRSTLIGHT_CLASSES=2000 $<TARGET_FILE:test_intake> --gtest_filter=*of_random*)
  firstlight_add_test(forged_names quick COMMAND forged_names 20000 NEEDS forged_names)
  set(class NEEDS grade graded_programs grade_class)
  firstlight_script_test(grade_class rest ${service}/classes/grade_class.sh ARGUMENTS ${programs}/grade_class ${class})
  firstlight_script_test(three_doors rest ${service}/intake/three_doors.sh ARGUMENTS ${programs} ${class})
  firstlight_script_test(class_rules rest ${service}/classes/class_rules.sh ARGUMENTS ${programs} ${class})
  firstlight_script_test(class_changes rest ${service}/classes/class_changes.sh ARGUMENTS ${programs} ${class})
  firstlight_script_test(class_faults rest ${service}/classes/class_faults.sh ARGUMENTS ${programs} ${class})
  firstlight_script_test(class_steps rest ${service}/classes/class_engines.sh ARGUMENTS ${programs} ${class})
  foreach(engine parallel slurm)
    firstlight_script_test(class_${engine} rest ${service}/classes/class_engines.sh ARGUMENTS ${programs} ${engine} ${class})
  endforeach()
  foreach(engine local parallel slurm)
    firstlight_script_test(class_kills_${engine} long ${service}/classes/class_kills.sh ARGUMENTS ${programs} ${engine} ${class})
  endforeach()
endif()

# The box does not go with AddressSanitizer.
if(FIRSTLIGHT_SANITIZE)
  return()
endif()

# The limits of a session, on a worker whose calls crash and hang as they are told. It looks for the box in the folder of programs.
foreach(slug hit_sphere diffuse_bsdf)
  add_library(${slug}.obedient OBJECT ${service}/wire/obedient_${slug}.cpp)
  target_link_libraries(${slug}.obedient PRIVATE firstlight_options firstlight_warnings)
endforeach()
add_executable(obedient_worker)
target_link_libraries(obedient_worker PRIVATE grader_worker grader_connection grader_serve pt_rows)
firstlight_link_tasks(obedient_worker FROM reference RADIANCE callback CHOICES hit_sphere=obedient diffuse_bsdf=obedient)
firstlight_test(session_test quick SOURCES ${service}/wire/session_test.cpp LIBRARIES grader_wire RADIANCE scripted
  CHOICES hit_sphere=remote diffuse_bsdf=remote estimate_pixel=remote
  NEEDS obedient_worker box DEFINES FIRSTLIGHT_OBEDIENT_WORKER="$<TARGET_FILE:obedient_worker>")

foreach(test build/precompiled build/ahead judging/blame)
  get_filename_component(name ${test} NAME)
  firstlight_test(${name}_test rest PLAIN PATHS SOURCES ${service}/${test}_test.cpp LIBRARIES grader_judging NEEDS grade graded_programs)
endforeach()

# Submissions that attack the grader, and files that it must not take; variables that live on between
# calls; a busy machine; four bugs that a write-up tells of; and what is right on average and too noisy.
foreach(test hostile state noisy)
  firstlight_test(${test}_test rest PLAIN PATHS SOURCES ${service}/judging/${test}_test.cpp LIBRARIES grader_submissions
    NEEDS grade graded_programs)
endforeach()
# Each attack in one tier, and then all of them in both.
firstlight_test(attack_test long PLAIN PATHS SOURCES ${service}/judging/attack_test.cpp LIBRARIES grader_submissions
  NEEDS grade graded_programs)
set(tried_in_the_other_tier *at_run_time/B:*commands_and_flags/A:*directives/B:*names_and_files/A:*compiling_for_ever/B)
firstlight_add_test(attacks rest COMMAND attack_test --gtest_filter=-${tried_in_the_other_tier} NEEDS attack_test grade graded_programs)
# Endless loops run beside it, and nothing else gets on.
firstlight_test(busy_test long PLAIN PATHS SOURCES ${service}/judging/busy_test.cpp LIBRARIES grader_submissions NEEDS grade graded_programs)
firstlight_test(four_bugs_test rest PLAIN PATHS SOURCES grader/tasks/four_bugs_test.cpp LIBRARIES grader_submissions
  NEEDS grade graded_programs)

# `contained` runs a program under a filter of system calls like that of a container.
if(TARGET PkgConfig::SECCOMP)
  add_executable(contained ${service}/sandbox/contained.cpp)
  target_link_libraries(contained PRIVATE firstlight_options firstlight_warnings PkgConfig::SECCOMP)
  firstlight_test(tier_test rest PLAIN PATHS SOURCES ${service}/sandbox/tier_test.cpp LIBRARIES grader_submissions
    NEEDS grade graded_programs contained DEFINES FIRSTLIGHT_CONTAINED="$<TARGET_FILE:contained>")
endif()
