# The view: its paths on the reference, on mistakes and on right variants; its server, and its page.

# view_<name>: the paths of many pixels with these choices. `breaks` is the promise of a red cell, or none.
firstlight_objects(view_paths_test view/paths_test.cpp)
target_link_libraries(view_paths_test PRIVATE GTest::gtest view_paths)
target_compile_definitions(view_paths_test PRIVATE FIRSTLIGHT_SCENES="${PROJECT_SOURCE_DIR}/scenes" FIRSTLIGHT_ROOT="${PROJECT_SOURCE_DIR}")
function(firstlight_view_test name tier breaks)
  foreach(choice IN LISTS ARGN)
    string(REPLACE "=" ";" choice ${choice})
    firstlight_add_solution(${choice})
  endforeach()
  add_executable(view_${name} $<TARGET_OBJECTS:view_paths_test>)
  target_link_libraries(view_${name} PRIVATE view_paths grader_results GTest::gtest_main)
  firstlight_link_tasks(view_${name} FROM reference RADIANCE none CHOICES ${ARGN} VIEWED)
  firstlight_add_test(view_${name} ${tier} NEEDS view_${name}
    COMMAND ${CMAKE_COMMAND} -E env VIEW_BREAKS=${breaks} $<TARGET_FILE:view_${name}>)
endfunction()
firstlight_view_test(reference quick reference)
firstlight_view_test(no_cosine quick weighs_by_the_cosine trace_path=no_cosine)
firstlight_view_test(sample_with_another_pdf quick a_sample_knows_its_own_f_and_pdf diffuse_bsdf=sample_with_another_pdf)
firstlight_view_test(half_of_f rest f_reflects_the_albedo diffuse_bsdf=half_of_f)
firstlight_view_test(no_shadow_ray rest adds_the_lights_up direct_lights=no_shadow_ray)
firstlight_view_test(farther_hit_overwrites rest finds_the_nearest_hit hit_bvh=farther_hit_overwrites)
firstlight_view_test(normal_inwards rest returns_the_outward_unit_normal hit_sphere=normal_inwards)
firstlight_view_test(right_ones rest none trace_path=survival_by_throughput direct_lights=any_order diffuse_bsdf=uniform
  hit_bvh=iterative camera_ray=single_precision estimate_pixel=stratified hit_sphere=float_normal hit_triangle=float_normal)
firstlight_view_test(other_right_ones rest none trace_path=two_first_directions direct_lights=multiple_importance
  diffuse_bsdf=rejection hit_bvh=priority_queue build_bvh=morton_codes direct_hemisphere=stratified hit_triangle=watertight)
firstlight_view_test(more_right_ones rest none trace_path=path_first_light_afterwards direct_lights=shadow_ray_of_its_own
  diffuse_bsdf=in_float direct_hemisphere=in_float hit_sphere=textbook estimate_pixel=float_sum)

firstlight_test(test_view_server quick PLAIN SOURCES view/server_test.cpp LIBRARIES view_server GTest::gmock)
if(FIRSTLIGHT_SANITIZE)
  return()
endif()
firstlight_script_test(view_page rest view/page.sh ARGUMENTS ${PROJECT_BINARY_DIR} NEEDS view view_worker.reference view_boxed)
