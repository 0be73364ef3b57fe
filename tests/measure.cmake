# What is measured, and the write-up.
firstlight_test(test_accuracy quick SOURCES measure/accuracy_test.cpp
  LIBRARIES measure_scene measure_rows_here pt_rows_measured pt_render_apart RECORDED RADIANCE apart)
firstlight_test(test_merit rest PATHS SOURCES measure/merit_test.cpp
  LIBRARIES measure_scene measure_rows_here pt_rows_measured pt_render_apart RECORDED RADIANCE apart)
if(TARGET measure)
  firstlight_test(test_measure quick SOURCES measure/measure_test.cpp LIBRARIES measure_calls)
endif()
firstlight_test(test_writeup quick PATHS LIBRARIES writeup_figures GTest::gmock SOURCES
  writeup/writeup_text_test.cpp writeup/writeup_store_test.cpp writeup/writeup_numbers_test.cpp)
if(FIRSTLIGHT_SANITIZE)
  return()
endif()
# The benchmarks compile and link; the one against Embree where Embree is.
get_target_property(kind bench_embree TYPE)
set(benchmarks verdict_rules speedup)
if(kind STREQUAL EXECUTABLE)
  list(APPEND benchmarks bench_embree)
endif()
firstlight_add_test(benchmarks rest COMMAND verdict_rules --help NEEDS ${benchmarks})
firstlight_script_test(verdict_rules rest measure/verdict_rules.sh ARGUMENTS ${PROJECT_BINARY_DIR}/bench/verdict_rules NEEDS verdict_rules)
set(build ARGUMENTS ${PROJECT_BINARY_DIR})
firstlight_script_test(accuracy rest measure/accuracy.sh ${build} NEEDS accuracy.reference accuracy.student ladder generate render)
set(needs NEEDS accuracy_boxed ladder_rung.reference measure stability stability.hit_sphere writeup writeup_boxed generate)
firstlight_script_test(submissions quick measure/submissions.sh ${build} few ${needs})
firstlight_script_test(more_submissions long measure/submissions.sh ${build} more ${needs})
firstlight_script_test(measure rest measure/measure.sh ${build} NEEDS measure)
firstlight_script_test(stability rest measure/stability.sh ARGUMENTS $<TARGET_FILE:stability> NEEDS stability stability_programs)
firstlight_script_test(promises_on_curves long measure/promises_on_curves.sh ARGUMENTS $<TARGET_FILE:stability> NEEDS stability stability_programs)
firstlight_script_test(writeup rest writeup/writeup.sh ${build} NEEDS writeup writeup_mistakes writeup_render.reference
  writeup_render.student writeup_boxed accuracy.reference accuracy.student accuracy_boxed ladder measure stability stability_programs generate view view_worker.reference)
