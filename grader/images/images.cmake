include_guard(GLOBAL)
# The verdicts on pictures and sample maps: numbers in, a verdict out. The benchmarks use it too.
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
set(images block_means cells contradictions evidence golden guards image_verdict name_mistake sample_map_reference
  sample_map_verdict sentences)
list(TRANSFORM images REPLACE "(.+)" "${CMAKE_CURRENT_LIST_DIR}/\\1.cpp")
firstlight_library(grader_images ${images})
target_link_libraries(grader_images PUBLIC fmt::fmt nlohmann_json::nlohmann_json)
