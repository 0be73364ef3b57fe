# The renderer and the reference.
firstlight_test(test_math quick SOURCES pt/math/math_test.cpp)
firstlight_test(test_bvh_builder quick SOURCES pt/geometry/bvh_builder_test.cpp)
firstlight_test(test_accel quick SOURCES pt/accel/accel_test.cpp)
firstlight_test(test_child_choice quick SOURCES pt/accel/child_choice_test.cpp)
firstlight_test(test_accel_truth quick SOURCES pt/accel/accel_truth_test.cpp)
firstlight_test(test_accel_meshes rest PATHS SOURCES pt/accel/accel_meshes_test.cpp LIBRARIES pt_loader)
if(NOT FIRSTLIGHT_SANITIZE)
  firstlight_add_test(kernel_symbols quick NEEDS pt_scene COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM}
    "-DOBJECTS=$<TARGET_OBJECTS:pt_scene>" -P ${tests}/pt/accel/kernel_symbols.cmake)
endif()
firstlight_test(test_collada rest PATHS LIBRARIES pt_loader fmt::fmt SOURCES
  pt/scene/collada_test.cpp pt/scene/collada_camera_test.cpp pt/scene/collada_course_test.cpp pt/scene/collada_damage_test.cpp
  pt/scene/collada_errors_test.cpp pt/scene/collada_faces_test.cpp pt/scene/collada_foreign_test.cpp
  pt/scene/collada_lights_test.cpp pt/scene/collada_materials_test.cpp pt/scene/collada_wild_test.cpp pt/scene/frame_camera_test.cpp
  pt/scene/twins_test.cpp)
firstlight_test(test_export quick PATHS SOURCES pt/scene/export_test.cpp LIBRARIES pt_export GTest::gmock)
firstlight_test(test_meshes rest SOURCES pt/scene/meshes_test.cpp LIBRARIES scene_meshes)
firstlight_test(test_scenes quick PATHS SOURCES pt/scene/scenes_test.cpp LIBRARIES pt_loader NEEDS generate
  DEFINES FIRSTLIGHT_SCENES="${PROJECT_SOURCE_DIR}/scenes" FIRSTLIGHT_GENERATE="$<TARGET_FILE:generate>")
firstlight_test(test_image quick SOURCES pt/image/accuracy_test.cpp pt/image/image_test.cpp pt/image/image_io_test.cpp LIBRARIES pt_image)
firstlight_test(test_fast quick SOURCES pt/render/fast_test.cpp CHOICES camera_ray=fast direct_lights=fast)
firstlight_test(test_render quick SOURCES pt/render/render_test.cpp LIBRARIES pt_rows pt_progress RADIANCE recorded)

# The render program without what is in fast/.
firstlight_render_program(render_plain reference+camera_ray=reference+direct_lights=reference)
firstlight_render_program(render_stubs student)
firstlight_render_program(render_mistake reference+hit_bvh=first_child_that_hits)
firstlight_add_solution(hit_triangle always_a_miss)
firstlight_render_program(render_blind reference+hit_triangle=always_a_miss)
firstlight_test(test_render_program quick SOURCES pt/render/render_program_test.cpp LIBRARIES pt_image
  NEEDS render render_plain render_stubs render_mistake render_blind
  DEFINES RENDER_PROGRAM="$<TARGET_FILE:render>" PLAIN_RENDER_PROGRAM="$<TARGET_FILE:render_plain>"
    STUBS_RENDER_PROGRAM="$<TARGET_FILE:render_stubs>" MISTAKE_RENDER_PROGRAM="$<TARGET_FILE:render_mistake>"
    BLIND_RENDER_PROGRAM="$<TARGET_FILE:render_blind>"
    FIRSTLIGHT_SCENES="${PROJECT_SOURCE_DIR}/scenes" FIRSTLIGHT_HANDBOOK="${PROJECT_SOURCE_DIR}/student")

# Held to closed forms, and to brute force.
foreach(proof furnace interreflection area_lights samplers brute_force stability)
  firstlight_test(test_${proof} quick SOURCES proof/${proof}_test.cpp)
endforeach()
foreach(proof delta_lights light_samplers worst_inputs agreement)
  firstlight_test(test_${proof} rest SOURCES proof/${proof}_test.cpp)
endforeach()

# Pictures of several numbers of bounces from one walk: of the reference, of right ways to write trace_path, and
# of a wrong one with which it cannot be.
firstlight_objects(bounces_apart_test proof/bounces_apart_test.cpp)
target_link_libraries(bounces_apart_test PRIVATE GTest::gtest)
function(firstlight_apart_test tier way)
  firstlight_add_solution(trace_path ${way})
  firstlight_test(test_bounces_apart_${way} ${tier} RECORDED RADIANCE apart SOURCES ${ARGN}
    LIBRARIES pt_render_apart CHOICES trace_path=${way})
endfunction()
firstlight_apart_test(quick reference $<TARGET_OBJECTS:bounces_apart_test> proof/bounces_up_to_test.cpp)
foreach(way recursion path_first_light_afterwards float_throughput survival_by_throughput)
  firstlight_apart_test(rest ${way} $<TARGET_OBJECTS:bounces_apart_test>)
endforeach()
firstlight_apart_test(rest emission_at_every_vertex proof/bounces_not_apart_test.cpp)

if(TARGET convert)
  firstlight_script_test(convert rest pt/scene/convert.sh ARGUMENTS ${PROJECT_BINARY_DIR} NEEDS convert render)
endif()

# Compares the loader with assimp, on request: pt/scene/against_assimp.sh.
find_package(assimp QUIET)
if(TARGET assimp::assimp)
  add_executable(against_assimp EXCLUDE_FROM_ALL pt/scene/against_assimp.cpp)
  target_link_libraries(against_assimp PRIVATE firstlight_warnings pt_loader fmt::fmt assimp::assimp)
endif()
