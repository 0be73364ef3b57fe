# What the programs are made of, as one hash: cmake -DROOT=FOLDER -DOUTPUT=FILE -P source_hash.cmake writes it.
function(firstlight_source_hash root result)
  file(GLOB_RECURSE files RELATIVE ${root} ${root}/pt/*.h ${root}/pt/*.cpp ${root}/grader/*.h ${root}/grader/*.cpp
    ${root}/scenes/*.h ${root}/scenes/*.cpp ${root}/grader/report/page/* ${root}/grader/tasks.json)
  list(SORT files)
  set(hashes)
  foreach(file IN LISTS files)
    file(SHA256 ${root}/${file} hash)
    string(APPEND hashes "${file} ${hash}\n")
  endforeach()
  string(SHA256 hash "${hashes}")
  set(${result} ${hash} PARENT_SCOPE)
endfunction()

if(ROOT)
  firstlight_source_hash(${ROOT} hash)
  file(WRITE ${OUTPUT} ${hash})
endif()
