# The render program, from the parts in pt/ (or the compiled ones of the learners' edition).

# firstlight_render_program(<name> <mixture>)
function(firstlight_render_program name mixture)
  firstlight_parse_mixture(${mixture})
  if(FIRSTLIGHT_REFERENCE STREQUAL stubs AND mixture MATCHES reference)
    message(FATAL_ERROR "there is no reference on this machine: ${FIRSTLIGHT_NO_REFERENCE}")
  endif()
  add_executable(${name})
  target_link_libraries(${name} PRIVATE pt_render_main pt_render pt_loader pt_progress)
  firstlight_link_tasks(${name} FROM ${MIXTURE_FROM} RADIANCE recorded CHOICES ${MIXTURE_CHOICES}
    FAST RECORDED)
endfunction()

# firstlight: what another project links to render with the reference's tasks (tests/pt/outside).
function(firstlight_add_library)
  add_library(firstlight INTERFACE)
  target_link_libraries(firstlight INTERFACE pt_render pt_loader)
  foreach(task IN LISTS FIRSTLIGHT_TASKS)
    get_filename_component(slug ${task} NAME)
    target_sources(firstlight INTERFACE $<TARGET_OBJECTS:${slug}.reference>)
  endforeach()
  target_sources(firstlight INTERFACE $<TARGET_OBJECTS:radiance.path>)
endfunction()

# Makes a render program of one whole implementation, and one for each mixture that was asked for.
function(firstlight_add_render_programs)
  if(FIRSTLIGHT_REFERENCE STREQUAL sources)
    firstlight_render_program(render reference)
    firstlight_add_library()
  else()
    firstlight_render_program(render student)
  endif()
  foreach(mixture IN LISTS FIRSTLIGHT_MIXTURES)
    firstlight_parse_mixture(${mixture})
    firstlight_render_program(render.${MIXTURE_SUFFIX} ${mixture})
  endforeach()
endfunction()

# All mixtures for other programs: the learner's tasks, the mixtures that were asked for, and the reference if it is here.
set(FIRSTLIGHT_ALL_MIXTURES student ${FIRSTLIGHT_MIXTURES})
if(EXISTS ${PROJECT_SOURCE_DIR}/reference OR EXISTS ${PROJECT_SOURCE_DIR}/reference-objects)
  list(APPEND FIRSTLIGHT_ALL_MIXTURES reference)
endif()
list(REMOVE_DUPLICATES FIRSTLIGHT_ALL_MIXTURES)
