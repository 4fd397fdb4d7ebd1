# signorini_core alone: the floors base ... answers and a table of back ends that is empty but for the
# closed form. For compilers and machines without our libraries: Clang with libc++, 32 bits, the
# browser. Eigen, Boost and fmt are read as headers from the folder SIGNORINI_HEADERS.
set(SIGNORINI_HEADERS /usr/include CACHE PATH "Folder with eigen3 (or Eigen), boost and fmt")
foreach(library IN ITEMS Eigen3::Eigen Boost::headers fmt::fmt)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} SYSTEM INTERFACE
    ${SIGNORINI_HEADERS} ${SIGNORINI_HEADERS}/eigen3)
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
# Steps and cells are 64-bit numbers everywhere; so are indices of Eigen, also where pointers are shorter.
target_compile_definitions(Eigen3::Eigen INTERFACE EIGEN_DEFAULT_DENSE_INDEX_TYPE=__INT64_TYPE__)
if(CMAKE_SIZEOF_VOID_P EQUAL 4)
  target_compile_options(Eigen3::Eigen INTERFACE
    "SHELL:-include ${PROJECT_SOURCE_DIR}/cmake/eigen_wide_index.hpp")
endif()
foreach(library IN ITEMS GLPK IPOPT NLOPT)
  set(SIGNORINI_HAS_${library} 0)
endforeach()
configure_file(cmake/config.hpp.in include/signorini/config.hpp @ONLY)

signorini_floors(base mechanics paper check geometry optimise sets forms find explore answers)
add_subdirectory(solvers)
get_property(floors GLOBAL PROPERTY SIGNORINI_FLOORS)
add_library(signorini_core STATIC)
set_target_properties(signorini_core PROPERTIES LINKER_LANGUAGE CXX)
target_include_directories(signorini_core PUBLIC include ${PROJECT_BINARY_DIR}/include)
target_compile_features(signorini_core PUBLIC cxx_std_20)
target_link_libraries(signorini_core PUBLIC Eigen3::Eigen PRIVATE fmt::fmt)
foreach(floor IN LISTS floors)
  target_sources(signorini_core PRIVATE $<TARGET_OBJECTS:${floor}>)
endforeach()

# It finds, verifies and draws numbers from a motion, and ends with 0 if they are right.
add_executable(core-program tests/core/core_program.cpp)
target_link_libraries(core-program PRIVATE signorini_core signorini_warnings)
enable_testing()
add_test(NAME "core: finds, proves, verifies" COMMAND core-program)
if(EMSCRIPTEN)
  # One file, for Node fetches no other one from a disk; and the status of main.
  target_link_options(core-program PRIVATE -sSINGLE_FILE=1 -sEXIT_RUNTIME=1 -sALLOW_MEMORY_GROWTH=1)
endif()

# The explorer's bridge; nlohmann-json from the same folder of headers.
if(SIGNORINI_BUILD_WEB)
  add_subdirectory(web/core)
endif()
