# The results model, what the terminal shows of it, and results.json. Programs that use it link pt_base.
firstlight_library(grader_report
  report/results.cpp report/json.cpp report/order.cpp report/presentable.cpp report/read_json.cpp
  report/readable.cpp report/summary.cpp
  report/terminal.cpp)
target_link_libraries(grader_report PUBLIC fmt::fmt nlohmann_json::nlohmann_json)

# All other reports. Programs that use it link grader_report, pt_image and pt_base.
find_path(MUSTACHE_INCLUDE_DIR kainjow/mustache.hpp REQUIRED)
set(page ${CMAKE_CURRENT_SOURCE_DIR}/report/page)
set(sources ${page}/page.html ${page}/page.css ${page}/page.js)
set(embedded ${CMAKE_CURRENT_BINARY_DIR}/page_sources.cpp)
add_custom_command(OUTPUT ${embedded} VERBATIM
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${embedded} -DHEADER=grader/report/page/sources.h
    -DNAMESPACE=grader "-DINPUTS=${sources}" -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
  DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
firstlight_library(grader_writers
  report/csv.cpp report/embedded.cpp report/gradescope.cpp report/html.cpp report/html_picture.cpp
  report/junit.cpp report/pictures.cpp report/write_reports.cpp ${embedded})
target_include_directories(grader_writers SYSTEM PRIVATE ${MUSTACHE_INCLUDE_DIR})
target_link_libraries(grader_writers PUBLIC
  fmt::fmt nlohmann_json::nlohmann_json tinyxml2::tinyxml2)
