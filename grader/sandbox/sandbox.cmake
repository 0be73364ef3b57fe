# Boxes for programs of a submission: what starts them, the launcher that runs in them, and the program
# that says whether one holds.
firstlight_library(grader_sandbox sandbox/box.cpp sandbox/probe.cpp)
target_link_libraries(grader_sandbox PUBLIC fmt::fmt)

find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(SECCOMP QUIET IMPORTED_TARGET libseccomp)
endif()
if(NOT SECCOMP_FOUND)
  message(STATUS "libseccomp is missing: the system calls of a submission are not filtered")
endif()
add_executable(box
  sandbox/launcher/main.cpp sandbox/launcher/options.cpp sandbox/launcher/user.cpp
  sandbox/launcher/landlock.cpp sandbox/launcher/filter.cpp process/limits.cpp)
target_link_libraries(box PRIVATE
  firstlight_options firstlight_warnings $<TARGET_NAME_IF_EXISTS:PkgConfig::SECCOMP>)
target_compile_definitions(box PRIVATE FIRSTLIGHT_SECCOMP=$<BOOL:${SECCOMP_FOUND}>)

add_executable(box_probe sandbox/box_probe.cpp)
target_link_libraries(box_probe PRIVATE firstlight_options firstlight_warnings)
