# Optional back ends, decided once: the build, config.hpp and the installed package all read
# SIGNORINI_HAS_<NAME>.

# signorini_optional_backend(NAME): SIGNORINI_WITH_<NAME> = AUTO (use it when found), ON (require
# it) or OFF; sets SIGNORINI_HAS_<NAME> to 1 or 0.
function(signorini_optional_backend name)
  set(SIGNORINI_WITH_${name} AUTO CACHE STRING "Back end ${name}: AUTO, ON or OFF")
  set_property(CACHE SIGNORINI_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
  set(choice ${SIGNORINI_WITH_${name}})
  set(has 0)
  if(choice STREQUAL "AUTO")
    find_package(${name} QUIET)
  elseif(choice)
    find_package(${name} REQUIRED)
  endif()
  if(choice AND ${name}_FOUND)
    set(has 1)
  endif()
  set(SIGNORINI_HAS_${name} ${has} PARENT_SCOPE)
  message(STATUS "signorini: back end ${name}: ${choice} -> ${has}")
endfunction()
