# What every module target has in common, said once.
include_guard(GLOBAL)

# cleave_module(NAME SOURCES src/a.cpp .. HEADERS a.hpp ..)
# Makes the library cleave_NAME with alias cleave::NAME. Headers are named relative to
# include/cleave/NAME and are each compiled on their own (all_verify_interface_header_sets).
function(cleave_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;HEADERS" ${ARGN})
  list(TRANSFORM arg_HEADERS PREPEND include/cleave/${name}/)
  add_library(cleave_${name} STATIC ${arg_SOURCES})
  add_library(cleave::${name} ALIAS cleave_${name})
  target_sources(cleave_${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${arg_HEADERS})
  target_compile_features(cleave_${name} PUBLIC cxx_std_20)
  set_target_properties(cleave_${name} PROPERTIES
    EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON POSITION_INDEPENDENT_CODE ON)
  install(TARGETS cleave_${name} EXPORT cleaveTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# Installs cleaveConfig.cmake, so that find_package(cleave COMPONENTS topology ..) works.
function(cleave_install_package)
  include(CMakePackageConfigHelpers)
  set(dir ${CMAKE_INSTALL_LIBDIR}/cmake/cleave)
  install(EXPORT cleaveTargets NAMESPACE cleave:: DESTINATION ${dir})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/cleaveConfig.cmake.in
    ${PROJECT_BINARY_DIR}/cleaveConfig.cmake INSTALL_DESTINATION ${dir})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/cleaveConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/cleaveConfig.cmake
    ${PROJECT_BINARY_DIR}/cleaveConfigVersion.cmake DESTINATION ${dir})
endfunction()
