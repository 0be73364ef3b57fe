# The libraries that are used in several places. Other libraries are found where they are used.
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)

# Debian and Ubuntu package tinyxml2 with a CMake config; pkg-config is for other systems.
find_package(tinyxml2 CONFIG QUIET)
if(TARGET tinyxml2::tinyxml2)
  set_target_properties(tinyxml2::tinyxml2 PROPERTIES IMPORTED_GLOBAL TRUE)
else()
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(TINYXML2 REQUIRED IMPORTED_TARGET GLOBAL tinyxml2)
  add_library(tinyxml2::tinyxml2 ALIAS PkgConfig::TINYXML2)
endif()
