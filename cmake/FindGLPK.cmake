# Finds GLPK, which ships neither a CMake module nor a pkg-config file. Defines GLPK::GLPK.
find_path(GLPK_INCLUDE_DIR glpk.h)
find_library(GLPK_LIBRARY glpk)
if(GLPK_INCLUDE_DIR)
  file(STRINGS ${GLPK_INCLUDE_DIR}/glpk.h _glpk_lines REGEX "define GLP_M(AJOR|INOR)_VERSION")
  string(REGEX REPLACE ".*MAJOR_VERSION +([0-9]+).*" "\\1" _glpk_major "${_glpk_lines}")
  string(REGEX REPLACE ".*MINOR_VERSION +([0-9]+).*" "\\1" _glpk_minor "${_glpk_lines}")
  set(GLPK_VERSION ${_glpk_major}.${_glpk_minor})
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GLPK
  REQUIRED_VARS GLPK_LIBRARY GLPK_INCLUDE_DIR
  VERSION_VAR GLPK_VERSION)
mark_as_advanced(GLPK_INCLUDE_DIR GLPK_LIBRARY)
if(GLPK_FOUND AND NOT TARGET GLPK::GLPK)
  add_library(GLPK::GLPK UNKNOWN IMPORTED)
  set_target_properties(GLPK::GLPK PROPERTIES
    IMPORTED_LOCATION ${GLPK_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${GLPK_INCLUDE_DIR})
  if(GLPK_LIBRARY MATCHES "\\.a$")  # what the archive itself needs
    set_target_properties(GLPK::GLPK PROPERTIES INTERFACE_LINK_LIBRARIES "colamd;amd;suitesparseconfig;gmp;z;ltdl;dl;m")
  endif()
endif()
