# Finds Ipopt through pkg-config. Defines IPOPT::IPOPT.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(_ipopt QUIET ipopt)
endif()
find_path(IPOPT_INCLUDE_DIR IpIpoptApplication.hpp
  HINTS ${_ipopt_INCLUDE_DIRS} PATH_SUFFIXES coin-or coin)
find_library(IPOPT_LIBRARY ipopt HINTS ${_ipopt_LIBRARY_DIRS})
set(IPOPT_VERSION ${_ipopt_VERSION})
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(IPOPT
  REQUIRED_VARS IPOPT_LIBRARY IPOPT_INCLUDE_DIR
  VERSION_VAR IPOPT_VERSION)
mark_as_advanced(IPOPT_INCLUDE_DIR IPOPT_LIBRARY)
if(IPOPT_FOUND AND NOT TARGET IPOPT::IPOPT)
  add_library(IPOPT::IPOPT UNKNOWN IMPORTED)
  set_target_properties(IPOPT::IPOPT PROPERTIES
    IMPORTED_LOCATION ${IPOPT_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${IPOPT_INCLUDE_DIR}
    # The headers of Ipopt 3.11 include <cstddef> only when told that it exists.
    INTERFACE_COMPILE_DEFINITIONS HAVE_CSTDDEF)
endif()
