# Installation: the library for CMake and pkg-config, and a Debian package of everything.
include(CMakePackageConfigHelpers)

install(TARGETS signorini EXPORT signoriniTargets
  LIBRARY COMPONENT library
  NAMELINK_COMPONENT headers
  ARCHIVE COMPONENT headers)
install(DIRECTORY include/signorini ${PROJECT_BINARY_DIR}/include/signorini
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT headers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/signorini)
install(EXPORT signoriniTargets NAMESPACE signorini:: DESTINATION ${package_dir} COMPONENT headers)
configure_package_config_file(cmake/signoriniConfig.cmake.in signoriniConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(signoriniConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/signoriniConfig.cmake
  ${PROJECT_BINARY_DIR}/signoriniConfigVersion.cmake
  cmake/FindGLPK.cmake
  cmake/FindIPOPT.cmake
  cmake/FindNLOPT.cmake
  DESTINATION ${package_dir}
  COMPONENT headers)

# A static library leaves its own libraries to whoever links it.
set(pc_requires eigen3)
set(pc_libs)
if(NOT BUILD_SHARED_LIBS)
  set(pc_libs "-lfmt -lSQLiteCpp -lsqlite3")
  if(SIGNORINI_HAS_GLPK)
    string(APPEND pc_libs " -lglpk")
  endif()
  if(SIGNORINI_HAS_IPOPT)
    string(APPEND pc_requires ", ipopt")
  endif()
  if(SIGNORINI_HAS_NLOPT)
    string(APPEND pc_requires ", nlopt")
  endif()
endif()
# The installed tree may be moved: its prefix is found from where the file lies.
file(RELATIVE_PATH pc_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/signorini.pc.in signorini.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/signorini.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT headers)

# `cpack -G DEB` in the build folder: one package of library, programs and headers.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The authors of signorini")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS libeigen3-dev)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
include(CPack)
