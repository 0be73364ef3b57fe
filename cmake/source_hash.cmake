# firstlight_hash_of(<root> <result> <file below the root>...): sets one hash of their names and contents.
function(firstlight_hash_of root result)
  set(files ${ARGN})
  list(SORT files)
  set(hashes)
  foreach(file IN LISTS files)
    file(SHA256 ${root}/${file} hash)
    string(APPEND hashes "${file} ${hash}\n")
  endforeach()
  string(SHA256 hash "${hashes}")
  set(${result} ${hash} PARENT_SCOPE)
endfunction()

# One hash of the sources of all programs: cmake -DROOT=FOLDER -DOUTPUT=FILE -P source_hash.cmake writes it.
function(firstlight_source_hash root result)
  file(GLOB_RECURSE files RELATIVE ${root} ${root}/pt/*.h ${root}/pt/*.cpp ${root}/grader/*.h ${root}/grader/*.cpp
    ${root}/measure/*.h ${root}/measure/*.cpp ${root}/scenes/*.h ${root}/scenes/*.cpp ${root}/view/* ${root}/grader/report/page/* ${root}/grader/tasks/*/task.json)
  firstlight_hash_of(${root} hash ${files})
  set(${result} ${hash} PARENT_SCOPE)
endfunction()

if(ROOT)
  firstlight_source_hash(${ROOT} hash)
  file(WRITE ${OUTPUT} ${hash})
endif()
