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

# Sets one hash of the headers in pt/, on which all that is compiled depends.
function(firstlight_header_hash root result)
  file(GLOB_RECURSE headers RELATIVE ${root} ${root}/pt/*.h)
  firstlight_hash_of(${root} hash ${headers})
  set(${result} ${hash} PARENT_SCOPE)
endfunction()

# Sets the sources of all programs, below the root.
function(firstlight_sources root result)
  set(patterns view/* writeup/page/* grader/report/page/* grader/tasks/*/task.json)
  foreach(room pt grader measure scenes writeup)
    list(APPEND patterns ${room}/*.h ${room}/*.cpp)
  endforeach()
  list(TRANSFORM patterns PREPEND ${root}/)
  file(GLOB_RECURSE files RELATIVE ${root} ${patterns})
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# Sets one hash of them.
function(firstlight_source_hash root result)
  firstlight_sources(${root} files)
  firstlight_hash_of(${root} hash ${files})
  set(${result} ${hash} PARENT_SCOPE)
endfunction()

# cmake -DROOT=FOLDER -DOUTPUT=FILE -DSTAMP=FILE -P source_hash.cmake writes this hash for an edition, and puts that of its headers,
# which may be fewer than here, into the stamp.
if(ROOT)
  firstlight_source_hash(${ROOT} hash)
  file(WRITE ${OUTPUT} ${hash})
  firstlight_header_hash(${ROOT} hash)
  file(READ ${STAMP} stamp)
  string(REGEX REPLACE "headers [^\n]*" "headers ${hash}" stamp "${stamp}")
  file(WRITE ${STAMP} "${stamp}")
endif()
