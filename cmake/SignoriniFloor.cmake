# signorini_floor(name HEADERS h... SOURCES s... FLOORS f... LIBRARIES l...): one floor of the house.
#
# HEADERS are its public headers, include/signorini/<h>.hpp; SOURCES its files in the folder of the
# call; FLOORS the floors below that it stands on. A floor sees its own folder, its public headers
# and those of the floors below, through include roots of their own: a header of a floor above is
# "file not found".
function(signorini_floor name)
  cmake_parse_arguments(floor "" "" "HEADERS;SOURCES;FLOORS;LIBRARIES" ${ARGN})
  set(target signorini_${name})
  set(root ${PROJECT_BINARY_DIR}/floors/${name})
  foreach(header IN LISTS floor_HEADERS)
    # Relative, so that compiler caches serve every checkout.
    file(RELATIVE_PATH path ${root}/signorini ${PROJECT_SOURCE_DIR}/include/signorini/${header}.hpp)
    file(CONFIGURE OUTPUT ${root}/signorini/${header}.hpp CONTENT "#include \"${path}\"\n")
  endforeach()
  add_library(${target} STATIC ${floor_SOURCES})
  target_include_directories(${target} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR} ${root})
  list(TRANSFORM floor_FLOORS PREPEND signorini_)
  target_link_libraries(${target}
    PUBLIC ${floor_FLOORS} ${floor_LIBRARIES}
    PRIVATE signorini_warnings)
  signorini_precompile(${target})
  set_property(GLOBAL APPEND PROPERTY SIGNORINI_FLOORS ${target})
  set_property(GLOBAL APPEND PROPERTY SIGNORINI_PUBLIC_HEADERS ${floor_HEADERS})
endfunction()

# signorini_precompile(target): headers that nearly all sources include are read once for all targets,
# in a debug build once more for those that it optimises less. Sources include what they use all the same.
function(signorini_precompile target)
  if(SIGNORINI_CORE_ONLY)  # other compilers, each once, some with a header of their own before all others
    return()
  endif()
  set(reader signorini_base)
  get_directory_property(options COMPILE_OPTIONS)
  if(CMAKE_BUILD_TYPE STREQUAL "Debug" AND options MATCHES "-O0")
    set(reader signorini_answers)
  endif()
  if(target STREQUAL reader)
    target_precompile_headers(${target} PRIVATE
      <algorithm> <cmath> <functional> <map> <numbers> <numeric> <optional> <span> <string> <vector>
      <Eigen/Core> <boost/multiprecision/cpp_int.hpp> <fmt/format.h>)
  else()
    target_precompile_headers(${target} REUSE_FROM ${reader})
  endif()
endfunction()

# signorini_floors(name...): the folders of src in the order given, each below the next.
function(signorini_floors)
  foreach(floor IN LISTS ARGN)
    add_subdirectory(${PROJECT_SOURCE_DIR}/src/${floor} ${PROJECT_BINARY_DIR}/src/${floor})
  endforeach()
endfunction()

# signorini_floors_up_to(name result): the targets of that floor and of all below it.
function(signorini_floors_up_to name result)
  get_property(floors GLOBAL PROPERTY SIGNORINI_FLOORS)
  list(FIND floors signorini_${name} place)
  math(EXPR count "${place} + 1")
  list(SUBLIST floors 0 ${count} floors)
  set(${result} ${floors} PARENT_SCOPE)
endfunction()
