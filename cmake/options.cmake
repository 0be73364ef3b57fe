# The flags of all code. The target `firstlight_options` has the flags of all code; `firstlight_warnings` has
# the warnings for our own code (in a learner's file a warning must not stop the program).
find_package(Threads REQUIRED)

add_library(firstlight_options INTERFACE)
# Generated files have the same places in generated/ as in the tree.
target_include_directories(firstlight_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
# No contraction: a multiply-add rounds once where a multiply and an add round twice, and machines
# with and without it would disagree. Nothing here reads errno.
target_compile_options(firstlight_options INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
target_link_libraries(firstlight_options INTERFACE Threads::Threads)

# Submissions are graded with the checks of the standard library: an index beyond the end of an array, or a read of an empty
# std::optional, ends the program, instead of passing by luck.
set(FIRSTLIGHT_LIBRARY_CHECKS -D_GLIBCXX_ASSERTIONS)

add_library(firstlight_warnings INTERFACE)
target_compile_options(firstlight_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
# With -O3, g++ 12 warns of overlaps in "..." + std::string that are not there (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(firstlight_warnings INTERFACE -Wno-restrict)
endif()
# A warning of a newer compiler does not stop a user's build; .ci/run stops at all warnings.
option(FIRSTLIGHT_WERROR "Warnings are errors" OFF)
if(FIRSTLIGHT_WERROR)
  target_compile_options(firstlight_warnings INTERFACE -Werror)
endif()

# A library of ours: a target that links it also gets the libraries that it needs.
function(firstlight_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PRIVATE firstlight_warnings PUBLIC firstlight_options)
endfunction()

# The same as objects, for tasks and for code that registers itself: two definitions of a function are then an
# error of the linker, while in an archive one of them would silently win.
function(firstlight_objects name)
  add_library(${name} OBJECT ${ARGN})
  target_link_libraries(${name} PRIVATE firstlight_warnings PUBLIC firstlight_options)
endfunction()

# firstlight_starts(<program> <target>...): the program starts these targets, so they are built with it; but not if it is only
# linked (tests/rules/one_definition.sh).
option(FIRSTLIGHT_LINK_ONLY "Build programs without the programs that they start" OFF)
function(firstlight_starts program)
  if(NOT FIRSTLIGHT_LINK_ONLY)
    add_dependencies(${program} ${ARGN})
  endif()
endfunction()

# Programs of one learner's file are linked by the hundred, and so are tests: gold takes a third of ld's time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold FIRSTLIGHT_GOLD)
set(FIRSTLIGHT_FAST_LINKER)
if(FIRSTLIGHT_GOLD)
  set(FIRSTLIGHT_FAST_LINKER -fuse-ld=gold)
endif()
# gold does not find libgcc's functions for code that is optimised at link time.
if(NOT FIRSTLIGHT_LTO AND NOT "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" MATCHES "-flto" AND NOT FIRSTLIGHT_SANITIZE)
  add_link_options(${FIRSTLIGHT_FAST_LINKER})
endif()

set(FIRSTLIGHT_SANITIZERS -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
if(FIRSTLIGHT_SANITIZE)
  set(flags ${FIRSTLIGHT_SANITIZERS})
  if(FIRSTLIGHT_SANITIZE STREQUAL thread)
    set(flags -fsanitize=thread)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # Code that sanitisers add makes g++ warn of std::regex (its manual: -fsanitize and false warnings).
    list(APPEND flags -Wno-maybe-uninitialized)
  endif()
  if(FIRSTLIGHT_FUZZ)
    list(APPEND flags -fsanitize=fuzzer-no-link)  # counts what runs; the targets alone have a fuzzer in them
  endif()
  target_compile_options(firstlight_options INTERFACE ${flags})
  target_compile_definitions(firstlight_options INTERFACE FIRSTLIGHT_SANITIZED)
  target_link_options(firstlight_options INTERFACE ${flags})
endif()

if(FIRSTLIGHT_LTO)
  include(CheckIPOSupported)
  check_ipo_supported()
  set(CMAKE_INTERPROCEDURAL_OPTIMIZATION ON)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # A box test is a little too long for the compiler to inline it by itself, and is called in two places of
    # one loop.
    set(inline_more --param=max-inline-insns-auto=200 --param=inline-min-speedup=2)
    add_compile_options(${inline_more})
    add_link_options(-flto=auto ${inline_more})
    # The same source gives the same object, bit for bit: the write-up makes a figure again if its objects have
    # changed.
    string(REPLACE "<FLAGS>" "<FLAGS> -frandom-seed=<OBJECT>" CMAKE_CXX_COMPILE_OBJECT
      "${CMAKE_CXX_COMPILE_OBJECT}")
  endif()
endif()
