# Optional libraries, decided once: the build, config.hpp and the installed package all read
# SIGNORINI_HAS_<NAME>.

# signorini_optional(NAME [COMPONENT...]): SIGNORINI_WITH_<NAME> = AUTO (use it when found), ON
# (require it) or OFF; sets SIGNORINI_HAS_<NAME> to 1 or 0.
function(signorini_optional name)
  set(SIGNORINI_WITH_${name} AUTO CACHE STRING "Optional library ${name}: AUTO, ON or OFF")
  set_property(CACHE SIGNORINI_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
  set(choice ${SIGNORINI_WITH_${name}})
  set(components ${ARGN})
  if(components)
    list(PREPEND components COMPONENTS)
  endif()
  set(has 0)
  if(choice STREQUAL "AUTO")
    find_package(${name} QUIET ${components})
  elseif(choice)
    find_package(${name} REQUIRED ${components})
  endif()
  if(choice AND ${name}_FOUND)
    set(has 1)
  endif()
  set(SIGNORINI_HAS_${name} ${has} PARENT_SCOPE)
  message(STATUS "signorini: ${name}: ${choice} -> ${has}")
endfunction()
