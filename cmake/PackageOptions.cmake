# Read by cpack when it runs. Same sources, same bytes: files in a package bear one fixed date (2026-01-01), no time of day.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  set(ENV{SOURCE_DATE_EPOCH} 1767225600)
endif()
if(CPACK_GENERATOR STREQUAL "DEB")
  # Without these cpack would write a package that needs no library at all.
  foreach(tool dpkg-shlibdeps file)
    find_program(path_of_${tool} ${tool})
    if(NOT path_of_${tool})
      message(FATAL_ERROR "cpack -G DEB needs ${tool}: apt-get install dpkg-dev file")
    endif()
  endforeach()
endif()
