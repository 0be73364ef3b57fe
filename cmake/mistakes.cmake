# Learners' mistakes, kept as edits of right solutions in grader/tasks/<slug>/mistakes.txt (cmake/edits.awk has the form).
#
# When the tree is configured each becomes a file build/mistakes/<slug>/<name>/<slug>.cpp, for an editor and for
# `./run grade <slug> --submission build/mistakes/<slug>/<name>`. An edit that does not fit its base is an error.
set(FIRSTLIGHT_MISTAKES ${PROJECT_SOURCE_DIR}/build/mistakes)

# The mistakes of which the handbook and the write-up show pictures. A handout has them compiled.
set(FIRSTLIGHT_SHOWN_MISTAKES hit_triangle/t_never_stored hit_triangle/weights_permuted hit_bvh/range_overwritten
  hit_bvh/first_child_that_hits direct_lights/no_offset trace_path/bsdf_applied_twice trace_path/emission_at_every_vertex
  adaptive_pixel/running_total_as_the_sample)

# A close relative of a mistake, with another number or operator (`vary`), tests its name. These are made in build/relatives.

# firstlight_make_edits(<what> <table> <task>): makes the files of a table, with <what> "out" the mistakes and with "relatives" these,
# removes other files, and sets `names` to their names; empty if there is no table, as in a handout.
function(firstlight_make_edits what table task)
  set(names "" PARENT_SCOPE)
  get_filename_component(root ${table} DIRECTORY)
  get_filename_component(file ${task} NAME)
  set(reference ${PROJECT_SOURCE_DIR}/reference/${task}.cpp)
  set(folder ${FIRSTLIGHT_MISTAKES}/${file})
  if(what STREQUAL "relatives")
    set(folder ${PROJECT_SOURCE_DIR}/build/relatives/${file})
  endif()
  if(NOT EXISTS ${table} OR NOT EXISTS ${reference})
    return()
  endif()
  file(GLOB bases ${root}/right/*.cpp ${root}/noisy/*.cpp)
  # A folder is newer where a file has come or gone.
  file(GLOB folders LIST_DIRECTORIES true ${root}/right ${root}/noisy)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/cmake/edits.awk ${table} ${reference} ${bases} ${folders})
  execute_process(COMMAND awk -v root=${root} -v reference=${reference} "-vneeded=breaks says hint base"
    -v ${what}=${folder} -v file=${file}.cpp -f ${PROJECT_SOURCE_DIR}/cmake/edits.awk ${table}
    OUTPUT_VARIABLE names ERROR_VARIABLE why RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${why}")
  endif()
  string(REGEX MATCHALL "[^\n]+" names "${names}")
  list(JOIN names "|" kept)
  file(GLOB made RELATIVE ${folder} ${folder}/*)
  list(FILTER made EXCLUDE REGEX "^(${kept})$")
  list(TRANSFORM made PREPEND ${folder}/)
  if(made)
    file(REMOVE_RECURSE ${made})
  endif()
  set(names ${names} PARENT_SCOPE)
endfunction()

# Sets FIRSTLIGHT_MISTAKES_<slug>, the names of the mistakes of each task.
function(firstlight_make_mistakes)
  foreach(task IN LISTS FIRSTLIGHT_TASKS)
    get_filename_component(slug ${task} NAME)
    set(table ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/mistakes.txt)
    firstlight_make_edits(relatives ${table} ${task})
    firstlight_make_edits(out ${table} ${task})
    set(FIRSTLIGHT_MISTAKES_${slug} ${names} PARENT_SCOPE)
  endforeach()
endfunction()

# known.<slug>: the file known.<slug>.json next to the programs of the grader, with which mistakes are named. An edition has no
# mistakes, but this file in grader/known/, and solutions.<slug>.txt. The target `graded` has the files of all tasks.
function(firstlight_add_known slug)
  set(brought ${PROJECT_SOURCE_DIR}/grader/known/known.${slug}.json)
  set(table ${PROJECT_SOURCE_DIR}/grader/known/solutions.${slug}.txt)
  if(FIRSTLIGHT_MISTAKES_${slug})
    firstlight_add_fingerprints(${slug})
  else()
    add_custom_target(known.${slug})
    if(EXISTS ${brought})
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${brought})
      file(COPY ${brought} ${table} DESTINATION ${PROJECT_BINARY_DIR}/grader)
    endif()
  endif()
  firstlight_gather(known.${slug})
endfunction()

# mistakes.<slug>: a worker that contains all mistakes and right solutions of a task, and acts as the one by whose number it is
# called. The mistakes' answers to the battery of the task are their fingerprints, in known.<slug>.json next to the programs
# of the grader. A mistake that answers like a right solution is left out, and so are guards, which have no hint.
# solutions.<slug>.txt, also there, says what each number is: a name, and the promise that it breaks, or `right`.
function(firstlight_add_fingerprints slug)
  set(includes)
  set(code)
  set(spaces)
  set(solutions)
  set(number 0)
  file(GLOB rights RELATIVE ${PROJECT_SOURCE_DIR}/grader/tasks/${slug} ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/right/*.cpp)
  foreach(name IN LISTS FIRSTLIGHT_MISTAKES_${slug} rights)
    set(path ${FIRSTLIGHT_MISTAKES}/${slug}/${name}/${slug}.cpp)
    if(name IN_LIST rights)
      set(path ${PROJECT_SOURCE_DIR}/grader/tasks/${slug}/${name})
      string(REGEX REPLACE "right/(.*)[.]cpp" "right.\\1" name ${name})
      set(breaks right)
    else()
      file(STRINGS ${path} hint REGEX "^// hint: ")
      if(NOT hint)
        continue()
      endif()
      file(STRINGS ${path} breaks REGEX "^// breaks: ")
      string(REGEX REPLACE "^// breaks: " "" breaks "${breaks}")
    endif()
    file(STRINGS ${path} lines REGEX "^#include ")
    list(APPEND includes ${lines})
    set(space in_${number})
    math(EXPR number "${number} + 1")
    string(APPEND solutions "${name} ${breaks}\n")
    string(APPEND code "namespace ${space} {\nusing namespace ::pt;\nFIRSTLIGHT_CALLS_${slug}(DECLARE, DECLARE)\n}\n#define pt ${space}\n#include \"${path}\"\n#undef pt\n")
    string(APPEND spaces " \\\n  MISTAKE(${space}, WORD)")
  endforeach()
  list(REMOVE_DUPLICATES includes)
  list(SORT includes)
  list(JOIN includes "\n" INCLUDES)
  # Each mistake has a namespace of its own, in which the functions of the contract have other names.
  set(RENAMED)
  set(RENAMED_BACK)
  foreach(function IN LISTS FIRSTLIGHT_FUNCTIONS_${slug})
    string(APPEND RENAMED "#define ${function} mistaken_${function}\n")
    string(APPEND RENAMED_BACK "#undef ${function}\n")
  endforeach()
  set(SLUG ${slug})
  set(MISTAKES "${code}")
  set(SPACES "${spaces}")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/mistakes.${slug}.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/mistakes.cpp.in ${source} @ONLY)
  add_library(${slug}.mistakes OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${slug}.mistakes PRIVATE firstlight_options)
  # As the judge compiles a submission. The last two: for a function that may end without a result
  # (grader/service/build/submission_flags.h).
  target_compile_options(${slug}.mistakes PRIVATE -w ${FIRSTLIGHT_LIBRARY_CHECKS}
    -fsanitize=return -fsanitize-undefined-trap-on-error)
  firstlight_worker(mistakes.${slug} ${slug} mistakes)
  set(known ${PROJECT_BINARY_DIR}/grader/known.${slug}.json)
  set(table ${PROJECT_BINARY_DIR}/grader/solutions.${slug}.txt)
  file(CONFIGURE OUTPUT ${table} CONTENT "${solutions}" @ONLY)
  add_custom_command(OUTPUT ${known} VERBATIM
    COMMAND know --graded $<TARGET_FILE:graded.${slug}> --reference $<TARGET_FILE:worker.${slug}>
      --all $<TARGET_FILE:mistakes.${slug}> --solutions ${table} --made ${FIRSTLIGHT_MISTAKES}/${slug} --out ${known}
    DEPENDS know graded.${slug} worker.${slug} mistakes.${slug} ${table}
    COMMENT "Asking the known mistakes of ${slug}")
  add_custom_target(known.${slug} DEPENDS ${known})
endfunction()
