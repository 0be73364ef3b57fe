# graded_picture: one recipe on one worker, judged.
firstlight_library(grader_pictures pictures/render.cpp pictures/judge_recipe.cpp pictures/known_mistakes.cpp)
target_link_libraries(grader_pictures PUBLIC grader_images grader_recipes grader_property)
add_executable(graded_picture pictures/main.cpp pictures/worker_rows.cpp)
add_dependencies(graded_picture box)
target_link_libraries(graded_picture PRIVATE
  grader_pictures grader_images grader_recipes grader_recipe_scenes grader_remote grader_property grader_counting
  grader_report grader_judge grader_mistakes grader_sandbox grader_process pt_rows pt_loader pt_image pt_scene pt_base
  CLI11::CLI11 firstlight_warnings)
firstlight_link_tasks(graded_picture FROM reference)
add_dependencies(grade graded_picture)
