# The border between judge and submission: <slug>.remote for the property programs, workers to answer
# them, and callbacks from a worker to the judge.
firstlight_library(grader_process
  process/cause_of_end.cpp process/limits.cpp process/process_time.cpp process/run_command.cpp
  process/spawn.cpp process/time_limit.cpp)
target_link_libraries(grader_process PUBLIC fmt::fmt)

firstlight_library(grader_remote
  remote/worker_process.cpp remote/session.cpp remote/answers.cpp)
target_link_libraries(grader_remote PUBLIC grader_property)

firstlight_library(grader_worker
  worker/main.cpp worker/connection.cpp worker/crash.cpp worker/kept_state.cpp worker/serve.cpp
  worker/store.cpp)
firstlight_library(grader_recording worker/recording.cpp)

foreach(task IN LISTS FIRSTLIGHT_TASKS)
  get_filename_component(slug ${task} NAME)
  firstlight_library(${slug}.remote remote/implementation.cpp)
  target_compile_definitions(${slug}.remote PRIVATE FIRSTLIGHT_TASK=${slug})
  target_link_libraries(${slug}.remote PRIVATE grader_property)
endforeach()
foreach(slug hit_box hit_triangle hit_sphere radiance)
  firstlight_library(${slug}.callback worker/callback.cpp)
  target_compile_definitions(${slug}.callback PRIVATE FIRSTLIGHT_TASK=${slug})
endforeach()

# The batteries, by which mistakes are named: one for each task.
firstlight_library(grader_mistakes
  mistakes/answers.cpp mistakes/compare.cpp mistakes/known.cpp mistakes/naming.cpp)
target_link_libraries(grader_mistakes PUBLIC fmt::fmt nlohmann_json::nlohmann_json)
firstlight_library(grader_battery mistakes/battery.cpp)
target_link_libraries(grader_battery PUBLIC grader_property grader_mistakes)
foreach(task IN LISTS FIRSTLIGHT_TASKS)
  get_filename_component(slug ${task} NAME)
  firstlight_library(battery.${slug} mistakes/${slug}.cpp)
  target_link_libraries(battery.${slug} PUBLIC grader_battery)
endforeach()

firstlight_library(grader_graded graded/report.cpp)
target_link_libraries(grader_graded PUBLIC grader_property nlohmann_json::nlohmann_json)

# What every program that runs tasks consists of, beside the tasks.
set(FIRSTLIGHT_RENDERER pt_base pt_scene pt_rows)

# The inner calls of a task that come back to the judge when it is judged by itself, or that a mock
# answers.
function(firstlight_worker_choices slug)
  set(choices)
  set(radiance path)
  if(slug STREQUAL hit_bvh)
    set(choices hit_box=callback hit_triangle=callback hit_sphere=callback)
  elseif(slug MATCHES "^(estimate|adaptive)_pixel$")
    set(radiance callback)
  elseif(slug STREQUAL trace_path)
    set(choices diffuse_bsdf=mock)
  endif()
  set(WORKER_CHOICES ${choices} PARENT_SCOPE)
  set(WORKER_RADIANCE ${radiance} PARENT_SCOPE)
endfunction()

# worker.<slug>: a worker that runs the reference, for tests and for measuring.
function(firstlight_worker slug)
  if(NOT TARGET worker.${slug})
    firstlight_worker_choices(${slug})
    add_executable(worker.${slug})
    target_link_libraries(worker.${slug} PRIVATE grader_worker ${FIRSTLIGHT_RENDERER})
    firstlight_link_tasks(worker.${slug} FROM reference RADIANCE ${WORKER_RADIANCE}
      CHOICES ${WORKER_CHOICES})
  endif()
endfunction()

# graded.<slug>: the properties of one task, asked of a worker.
function(firstlight_graded slug)
  add_executable(graded.${slug} graded/main.cpp)
  add_dependencies(graded.${slug} box)
  target_compile_definitions(graded.${slug} PRIVATE FIRSTLIGHT_TASK="${slug}")
  target_link_libraries(graded.${slug} PRIVATE
    grader_graded battery.${slug} grader_battery grader_mistakes grader_remote grader_sandbox grader_process
    CLI11::CLI11 firstlight_warnings)
  firstlight_link_properties(graded.${slug} ${slug} remote)

  firstlight_worker(${slug})
  add_test(NAME graded.${slug} COMMAND graded.${slug} --promises=-*_bonus
    --worker $<TARGET_FILE:worker.${slug}>)
endfunction()

# What the linker has to do so that the integrated worker can say which tests hit_bvh makes
# (worker/recording.cpp).
set(FIRSTLIGHT_RECORDING_FLAGS
  -Wl,--wrap=_ZN2pt7hit_boxERKNS_3BoxERKNS_3RayE
  -Wl,--wrap=_ZN2pt12hit_triangleERKNS_8TriangleERKNS_3RayE
  -Wl,--wrap=_ZN2pt10hit_sphereERKNS_6SphereERKNS_3RayE)

# What a call costs: call_bench <worker.diffuse_bsdf>.
if(FIRSTLIGHT_BENCH)
  firstlight_worker(diffuse_bsdf)
  add_executable(call_bench remote/call_bench.cpp)
  target_link_libraries(call_bench PRIVATE
    firstlight_warnings grader_remote grader_sandbox grader_property grader_process grader_counting
    pt_base pt_scene)
  firstlight_link_tasks(call_bench FROM reference CHOICES diffuse_bsdf=remote)
  add_dependencies(call_bench worker.diffuse_bsdf)
endif()
