# Pictures and sample maps drawn from known distributions: for tests, and for a benchmark that is built without them.
include_guard(GLOBAL)
set(here ${CMAKE_CURRENT_LIST_DIR})
firstlight_library(synthetic_pictures EXCLUDE_FROM_ALL ${here}/synthetic_maps.cpp ${here}/synthetic_pictures.cpp)
target_link_libraries(synthetic_pictures PUBLIC grader_pictures)
