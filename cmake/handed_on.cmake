# firstlight_handed_on(<result> <library>... [EXCEPT <library>...]): these libraries, and all libraries that they hand on to their
# users, each before those that it calls. So a list has only what its program itself calls. It leaves out the libraries after EXCEPT
# and what only they hand on, libraries of only flags and headers, and what a library does not hand on.
function(firstlight_handed_on result)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "EXCEPT")
  set(waiting ${ARG_UNPARSED_ARGUMENTS})
  set(all)
  while(waiting)
    list(POP_FRONT waiting name)
    if(TARGET ${name} AND NOT name IN_LIST ARG_EXCEPT)
      list(REMOVE_ITEM all ${name})  # it stands behind the last one that calls it
      list(APPEND all ${name})
      get_property(libraries TARGET ${name} PROPERTY INTERFACE_LINK_LIBRARIES)
      list(APPEND waiting ${libraries})  # $<LINK_ONLY:...> is not a target
    endif()
  endwhile()
  set(linked)
  foreach(name IN LISTS all)
    get_target_property(type ${name} TYPE)
    if(NOT type STREQUAL INTERFACE_LIBRARY)
      list(APPEND linked ${name})
    endif()
  endforeach()
  set(${result} ${linked} PARENT_SCOPE)
endfunction()

# firstlight_ours_handed_on(<result> ...): the same, without the libraries of others.
function(firstlight_ours_handed_on result)
  firstlight_handed_on(all ${ARGN})
  set(ours)
  foreach(name IN LISTS all)
    get_target_property(imported ${name} IMPORTED)
    if(NOT imported OR name IN_LIST compiled_archives OR name IN_LIST compiled_objects)
      list(APPEND ours ${name})
    endif()
  endforeach()
  set(${result} ${ours} PARENT_SCOPE)
endfunction()

# firstlight_list_objects(PROGRAM LIBRARY ... [EXCEPT LIBRARY ...]): writes PROGRAM.objects next to a program with linked tasks. It
# has a line for each object: "hit_box path" for a task, "framework path" for the libraries and those that they hand on. Objects
# that change no render are left out.
function(firstlight_list_objects name)
  firstlight_ours_handed_on(libraries ${ARGN})
  set(text)
  foreach(library IN LISTS libraries)
    firstlight_objects_of(${library} "\nframework " objects)
    string(APPEND text "framework ${objects}\n")
  endforeach()
  foreach(slug IN LISTS FIRSTLIGHT_SLUGS)
    string(APPEND text "${slug} $<JOIN:$<TARGET_OBJECTS:${LINKED_${slug}}>,\n${slug} >\n")
  endforeach()
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.objects CONTENT "${text}")
endfunction()
