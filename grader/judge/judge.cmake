# grade, and all that it needs to build and judge a submission without CMake: the flags, the objects of
# every worker, and the property programs, written to grade.json next to it.
include(${CMAKE_CURRENT_SOURCE_DIR}/report/report.cmake)
firstlight_library(grader_judge
  judge/ask_battery.cpp judge/audit.cpp judge/builder.cpp judge/c_functions.cpp judge/cache.cpp judge/config.cpp
  judge/files.cpp judge/findings.cpp judge/grade.cpp judge/integration.cpp judge/isolation.cpp
  judge/may_call.cpp judge/name_by_pictures.cpp judge/name_mistakes.cpp judge/no_reference.cpp
  judge/object_file.cpp judge/picture_trial.cpp judge/pictures.cpp
  judge/points.cpp judge/promises.cpp judge/sha256.cpp judge/so_far.cpp judge/staging.cpp)
target_link_libraries(grader_judge PUBLIC grader_mistakes fmt::fmt nlohmann_json::nlohmann_json)

firstlight_library(grader_hints hints/hints.cpp hints/memory.cpp)
target_link_libraries(grader_hints PUBLIC fmt::fmt)
add_executable(hint hints/main.cpp)
target_link_libraries(hint PRIVATE
  grader_hints grader_judge grader_mistakes grader_recipes grader_sandbox grader_report grader_process pt_base
  CLI11::CLI11 firstlight_warnings)

add_executable(grade judge/main.cpp judge/options.cpp)
add_dependencies(grade box box_probe)
target_link_libraries(grade PRIVATE
  grader_hints grader_judge grader_mistakes grader_recipes grader_sandbox grader_writers grader_report
  grader_process pt_image pt_base CLI11::CLI11 firstlight_warnings)

# Instructors only: the learners' edition comes without.
if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/class)
  firstlight_library(grader_class class/class.cpp)
  target_link_libraries(grader_class PUBLIC fmt::fmt)
  add_executable(grade_class class/main.cpp)
  target_link_libraries(grade_class PRIVATE
    grader_class grader_judge grader_mistakes grader_recipes grader_sandbox grader_writers grader_report
    grader_process pt_image pt_base CLI11::CLI11 firstlight_warnings)
endif()

firstlight_library(grader_watch
  watch/files.cpp watch/raw_terminal.cpp watch/running.cpp watch/session.cpp watch/verdicts.cpp)
target_link_libraries(grader_watch PUBLIC fmt::fmt)
add_executable(watch watch/main.cpp)
target_link_libraries(watch PRIVATE
  grader_watch grader_judge grader_mistakes grader_recipes grader_sandbox grader_report grader_process pt_base
  CLI11::CLI11 firstlight_warnings)

# A list of words as the inside of a JSON array, and the objects of libraries likewise.
function(firstlight_json_list result)
  list(TRANSFORM ARGN REPLACE "\\\\" "\\\\\\\\" OUTPUT_VARIABLE words)
  list(TRANSFORM words REPLACE "\"" "\\\\\"")
  list(TRANSFORM words REPLACE "(.+)" "\"\\1\"")
  string(JOIN "," text ${words})
  set(${result} "[${text}]" PARENT_SCOPE)
endfunction()
function(firstlight_json_objects result)
  set(text)
  foreach(library IN LISTS ARGN)
    list(APPEND text "\"$<JOIN:$<TARGET_OBJECTS:${library}>,\",\">\"")
  endforeach()
  string(JOIN "," text ${text})
  set(${result} "[${text}]" PARENT_SCOPE)
  add_dependencies(grade ${ARGN})
endfunction()

string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
get_target_property(options firstlight_options INTERFACE_COMPILE_OPTIONS)
firstlight_json_list(compile_flags
  ${flags} ${CMAKE_CXX20_STANDARD_COMPILE_OPTION} ${options})
separate_arguments(flags UNIX_COMMAND "${CMAKE_EXE_LINKER_FLAGS}")
get_target_property(options firstlight_options INTERFACE_LINK_OPTIONS)
if(NOT options)
  set(options)
endif()
firstlight_json_list(link_flags ${flags} ${options} -pthread)
firstlight_json_list(recording_flags ${FIRSTLIGHT_RECORDING_FLAGS})
firstlight_json_objects(framework grader_worker ${FIRSTLIGHT_RENDERER})
firstlight_json_objects(recording grader_recording)
firstlight_json_objects(radiance radiance.path)

set(callbacks)
foreach(name hit_box hit_triangle hit_sphere radiance)
  firstlight_json_objects(objects ${name}.callback)
  list(APPEND callbacks "\"${name}\": ${objects}")
endforeach()
firstlight_json_objects(objects diffuse_bsdf.mock)
list(APPEND callbacks "\"diffuse_bsdf\": ${objects}")
string(JOIN ",\n  " callbacks ${callbacks})

set(tasks)
set(last_part)
foreach(task IN LISTS FIRSTLIGHT_TASKS)
  get_filename_component(slug ${task} NAME)
  get_filename_component(part ${task} DIRECTORY)
  if(NOT part STREQUAL last_part)
    set(index 0)
    set(last_part ${part})
  endif()
  math(EXPR index "${index} + 1")
  string(REGEX MATCH "^[0-9]+" part_number ${part})
  firstlight_json_objects(objects ${slug}.reference)
  set(graded)
  if(TARGET graded.${slug})
    set(graded $<TARGET_FILE:graded.${slug}>)
    add_dependencies(grade graded.${slug})
  endif()
  list(APPEND tasks "{\"part\": \"${part}\", \"number\": \"${part_number}.${index}\", \
\"slug\": \"${slug}\", \"graded\": \"${graded}\", \"reference\": ${objects}}")
endforeach()
string(JOIN ",\n  " tasks ${tasks})

file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/grade.json CONTENT "{
 \"root\": \"${PROJECT_SOURCE_DIR}\",
 \"work\": \"${CMAKE_CURRENT_BINARY_DIR}/graded\",
 \"compiler\": \"${CMAKE_CXX_COMPILER}\",
 \"compile_flags\": ${compile_flags},
 \"link_flags\": ${link_flags},
 \"recording_flags\": ${recording_flags},
 \"framework\": ${framework},
 \"recording\": ${recording},
 \"radiance\": ${radiance},
 \"picture\": \"$<TARGET_FILE:graded_picture>\",
 \"compiler_version\": \"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\",
 \"callbacks\": {
  ${callbacks}},
 \"no_reference\": \"${FIRSTLIGHT_NO_REFERENCE}\",
 \"tasks\": [
  ${tasks}]
}
")
