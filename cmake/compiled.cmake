# All that is not the learner's, compiled. The full tree says what that is (firstlight_describe_compiled), and
# grader/editions/handout.sh copies it to compiled/ of the learners' edition. Where it fits, targets of the same names are made
# of it (firstlight_add_compiled), and only the learner's files are left to compile; where it does not, all is built from
# its sources, as in the full tree.

# The archives that the programs link; the objects of some are listed in grade.json and by the write-up.
set(compiled_archives pt_base pt_scene pt_image pt_loader pt_render pt_rows pt_progress grader_tasks grader_base grader_process
  grader_sandbox grader_results grader_pictures grader_recipe_scenes grader_report grader_judge grader_mistakes grader_check
  grader_counting grader_wire)
set(compiled_archives_and_objects pt_base pt_scene pt_loader pt_render pt_rows)
set(compiled_objects pt_render_main pt_render_apart pt_rows_measured radiance.apart radiance.path radiance.recorded radiance.scripted
  grader_worker grader_recording
  diffuse_bsdf.mock hit_box.counting hit_sphere.counting hit_triangle.counting hit_box.callback hit_sphere.callback
  hit_triangle.callback radiance.callback)
set(compiled_programs grader/grade grader/hint grader/watch grader/box grader/box_probe grader/graded_picture pt/compare
  scenes/generate)
foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
  list(APPEND compiled_objects properties.${slug} ${slug}.repeat)
  list(APPEND compiled_programs grader/graded.${slug})
  if(EXISTS ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/curves.cpp)
    list(APPEND compiled_programs grader/stability.${slug})
  endif()
endforeach()

# firstlight_objects_of(<library> <separator> <result>): the paths of its objects, built here or compiled elsewhere.
function(firstlight_objects_of library separator result)
  set(joined "$<JOIN:$<TARGET_OBJECTS:${library}>,${separator}>")
  if(FIRSTLIGHT_COMPILED AND library IN_LIST compiled_archives_and_objects)
    file(GLOB found ${PROJECT_SOURCE_DIR}/compiled/${library}/*.o)
    list(JOIN found "${separator}" joined)
  endif()
  set(${result} "${joined}" PARENT_SCOPE)
endfunction()

# The target `compiled` builds it all; compiled/files of the build lists it, a line each:
#   archive <library> <file>
#   object <library> <file>
#   program <place> <file>
# and compiled/links.cmake says what the libraries link.
function(firstlight_describe_compiled)
  if(FIRSTLIGHT_LTO OR FIRSTLIGHT_SANITIZE OR NOT FIRSTLIGHT_TESTS OR NOT FIRSTLIGHT_REFERENCE STREQUAL sources)
    return()
  endif()
  set(text)
  set(links)
  foreach(library IN LISTS compiled_archives)
    string(APPEND text "archive ${library} $<TARGET_FILE:${library}>\n")
  endforeach()
  foreach(library IN LISTS compiled_objects compiled_archives_and_objects)
    string(APPEND text "object ${library} $<JOIN:$<TARGET_OBJECTS:${library}>,\nobject ${library} >\n")
  endforeach()
  add_custom_target(compiled DEPENDS ${compiled_archives} ${compiled_objects})
  foreach(place IN LISTS compiled_programs)
    get_filename_component(program ${place} NAME)
    string(APPEND text "program ${place} $<TARGET_FILE:${program}>\n")
    add_dependencies(compiled ${program})
  endforeach()
  foreach(library IN LISTS compiled_archives compiled_objects)
    get_target_property(linked ${library} INTERFACE_LINK_LIBRARIES)
    string(APPEND links "target_link_libraries(${library} INTERFACE \"${linked}\")\n")
  endforeach()
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/compiled/files CONTENT "${text}")
  file(WRITE ${PROJECT_BINARY_DIR}/compiled/links.cmake "${links}")
endfunction()

# Sets `result` to the reason why it cannot be used here; empty if it can. It starts the programs to see whether the
# libraries of the system fit them.
function(firstlight_compiled_misfit folder result)
  firstlight_misfit(${folder} why)
  firstlight_source_hash(${PROJECT_SOURCE_DIR} here)
  file(READ ${folder}/sources there)
  if(NOT why AND NOT here STREQUAL there)
    set(why "other sources in pt/, grader/ or scenes/")
  endif()
  foreach(place IN LISTS compiled_programs)
    get_filename_component(program ${place} NAME)
    if(NOT why AND NOT program MATCHES "^box")
      execute_process(COMMAND ${folder}/${place} --help RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
      if(NOT status EQUAL 0)
        set(why "other libraries than this system has")
      endif()
    endif()
  endforeach()
  set(${result} "${why}" PARENT_SCOPE)
endfunction()

function(firstlight_add_compiled)
  set(folder ${PROJECT_SOURCE_DIR}/compiled)
  if(NOT EXISTS ${folder}/stamp)
    return()
  endif()
  file(GLOB_RECURSE sources ${PROJECT_SOURCE_DIR}/pt/*.cpp ${PROJECT_SOURCE_DIR}/grader/*.cpp ${PROJECT_SOURCE_DIR}/grader/*.h
    ${PROJECT_SOURCE_DIR}/scenes/*.cpp ${PROJECT_SOURCE_DIR}/scenes/*.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/stamp ${folder}/sources ${sources})
  firstlight_compiled_misfit(${folder} why)
  if(why)
    file(WRITE ${PROJECT_BINARY_DIR}/not_compiled
      "All programs are built here, which takes some minutes: those in compiled/ were compiled for ${why}.\n")
    return()
  endif()
  file(REMOVE ${PROJECT_BINARY_DIR}/not_compiled)
  set(FIRSTLIGHT_COMPILED TRUE)
  set(FIRSTLIGHT_COMPILED TRUE PARENT_SCOPE)
  foreach(library IN LISTS compiled_archives)
    add_library(${library} STATIC IMPORTED GLOBAL)
    set_target_properties(${library} PROPERTIES IMPORTED_LOCATION ${folder}/lib${library}.a)
  endforeach()
  foreach(library IN LISTS compiled_objects)
    file(GLOB found ${folder}/${library}/*.o)
    add_library(${library} OBJECT IMPORTED GLOBAL)
    set_target_properties(${library} PROPERTIES IMPORTED_OBJECTS "${found}")
  endforeach()
  include(${folder}/links.cmake)
  add_custom_target(graded)
  add_custom_target(stability_programs)
  foreach(place IN LISTS compiled_programs)
    get_filename_component(program ${place} NAME)
    set(copy ${PROJECT_BINARY_DIR}/${place})
    add_custom_command(OUTPUT ${copy} DEPENDS ${folder}/${place}
      COMMAND ${CMAKE_COMMAND} -E copy ${folder}/${place} ${copy})
    add_custom_target(${program} DEPENDS ${copy})
    if(place MATCHES "^grader/box")
      add_dependencies(grade ${program})
    elseif(place MATCHES "^grader/graded[._]")
      add_dependencies(graded ${program})
    elseif(place MATCHES "^grader/stability[.]")
      add_dependencies(stability_programs ${program})
    endif()
  endforeach()
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/pt)
  firstlight_add_render_programs()
  if(FIRSTLIGHT_TESTS)
    firstlight_add_check_programs()
    firstlight_write_grade_json()
  endif()
endfunction()
