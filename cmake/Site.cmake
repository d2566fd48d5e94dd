# The manual as a site that opens from the disk (documentation/site/build): $build/site, installed to share/doc/seamline/site.
# A dead link or anchor fails the target `site`, which is part of `all`.
set(SEAMLINE_SITE AUTO CACHE STRING "build the manual as a site: AUTO, ON or OFF")
set_property(CACHE SEAMLINE_SITE PROPERTY STRINGS AUTO ON OFF)
set(SEAMLINE_HAS_SITE FALSE)
if(SEAMLINE_SITE STREQUAL "AUTO" OR SEAMLINE_SITE)
  find_program(SEAMLINE_SPHINX sphinx-build DOC "makes pages of the manual")
  find_program(SEAMLINE_PANDOC pandoc DOC "makes equations of the manual")
  if(SEAMLINE_SPHINX AND SEAMLINE_PANDOC)
    # Asked of Sphinx's own interpreter, which its first line names: another python3 may stand before it on the path.
    file(STRINGS ${SEAMLINE_SPHINX} site_python LIMIT_COUNT 1)
    string(REGEX REPLACE "^#! *" "" site_python "${site_python}")
    execute_process(COMMAND ${site_python} -c "import furo, myst_parser" RESULT_VARIABLE site_imports OUTPUT_QUIET ERROR_QUIET)
    if(site_imports EQUAL 0)
      set(SEAMLINE_HAS_SITE TRUE)
    endif()
  endif()
  if(NOT SEAMLINE_HAS_SITE AND NOT SEAMLINE_SITE STREQUAL "AUTO")
    message(FATAL_ERROR "SEAMLINE_SITE=ON needs python3-sphinx, python3-myst-parser, furo and pandoc")
  endif()
endif()
if(SEAMLINE_HAS_SITE)
  file(GLOB_RECURSE site_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/documentation/*)
  list(FILTER site_sources EXCLUDE REGEX "__pycache__")
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/site/index.html
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/site
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${PROJECT_SOURCE_DIR}/documentation/site/build ${PROJECT_BINARY_DIR}/site
    DEPENDS ${site_sources} ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    COMMENT "Building the manual's site" VERBATIM)
  add_custom_target(site ALL DEPENDS ${PROJECT_BINARY_DIR}/site/index.html)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/site DESTINATION share/doc/seamline OPTIONAL)
endif()
message(STATUS "Manual as a site: ${SEAMLINE_HAS_SITE}")
