# The verdicts on pictures and sample maps: numbers in, a verdict out.
firstlight_library(grader_images
  images/cells.cpp images/contradictions.cpp images/golden.cpp images/guards.cpp
  images/image_verdict.cpp images/sample_map_reference.cpp images/sample_map_verdict.cpp
  images/sentences.cpp)
target_link_libraries(grader_images PUBLIC fmt::fmt nlohmann_json::nlohmann_json)
