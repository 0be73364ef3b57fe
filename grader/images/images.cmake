# The verdicts on pictures and sample maps: numbers in, a verdict out.
include_guard(GLOBAL)
set(sources
  cells.cpp contradictions.cpp golden.cpp guards.cpp
  image_verdict.cpp sample_map_reference.cpp sample_map_verdict.cpp sentences.cpp)
list(TRANSFORM sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
firstlight_library(grader_images ${sources})
target_link_libraries(grader_images PUBLIC fmt::fmt nlohmann_json::nlohmann_json)
