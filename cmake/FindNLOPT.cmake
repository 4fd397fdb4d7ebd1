# Finds NLopt by its own CMake package, or by its files. Defines NLopt::nlopt.
find_package(NLopt CONFIG QUIET)
if(TARGET NLopt::nlopt)
  set(NLOPT_TARGET NLopt::nlopt)
  set(NLOPT_VERSION ${NLopt_VERSION})
else()
  find_path(NLOPT_INCLUDE_DIR nlopt.h)
  find_library(NLOPT_LIBRARY NAMES nlopt nlopt_cxx)
  mark_as_advanced(NLOPT_INCLUDE_DIR NLOPT_LIBRARY)
  if(NLOPT_INCLUDE_DIR AND NLOPT_LIBRARY)
    add_library(NLopt::nlopt UNKNOWN IMPORTED)
    set_target_properties(NLopt::nlopt PROPERTIES
      IMPORTED_LOCATION ${NLOPT_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${NLOPT_INCLUDE_DIR})
    set(NLOPT_TARGET NLopt::nlopt)
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NLOPT
  REQUIRED_VARS NLOPT_TARGET
  VERSION_VAR NLOPT_VERSION)
