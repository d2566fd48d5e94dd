# The page of `seamline export web SET DIR`: ours from study/online/page/web, its modules put into one file by esbuild
# (Debian's), because a class that opens it at once asks for every file sixty times; and jsPsych from the npm registry, pinned.
# Laid together in the build folder, from where it is installed to share/seamline/web.
set(SEAMLINE_WEB AUTO CACHE STRING "build `seamline export web`: AUTO, ON or OFF")
set_property(CACHE SEAMLINE_WEB PROPERTY STRINGS AUTO ON OFF)
set(SEAMLINE_JSPSYCH "" CACHE FILEPATH "jspsych-8.3.0.tgz of the npm registry, for machines without network")
set(SEAMLINE_WEB_FOLDER ${PROJECT_BINARY_DIR}/web)
set(jspsych_version 8.3.0)
# The registry's own: sha512-UrwSVG14v8oRX6WFQ1L6uuGT0G7KgRDSH48iKIVIQI+yMRGAlvg+tEUNFKe/1xZxgk3kZiZ5xP0AnpPqPj1zkg==
set(jspsych_sha512 52bc12546d78bfca115fa5854352fabae193d06eca8110d21f8f22288548408fb231118096f83eb4450d14a7bfd71671824de4662679c4fd009e93ea3e3d7392)

seamline_npm_archive(jspsych ${jspsych_version} ${jspsych_sha512} SEAMLINE_WEB SEAMLINE_JSPSYCH SEAMLINE_HAS_WEB)

find_program(SEAMLINE_ESBUILD esbuild DOC "puts the modules of the page into one file")
if(SEAMLINE_HAS_WEB AND NOT SEAMLINE_ESBUILD)
  if(NOT SEAMLINE_WEB STREQUAL "AUTO")
    message(FATAL_ERROR "SEAMLINE_WEB=ON needs esbuild (Debian: esbuild)")
  endif()
  set(SEAMLINE_HAS_WEB FALSE)
endif()

if(SEAMLINE_HAS_WEB)
  set(web_sources ${PROJECT_SOURCE_DIR}/study/online/page/web)
  file(GLOB_RECURSE web_files CONFIGURE_DEPENDS RELATIVE ${web_sources} ${web_sources}/*)
  file(REMOVE_RECURSE ${SEAMLINE_WEB_FOLDER})
  foreach(file IN LISTS web_files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${web_sources}/${file})
    if(NOT file MATCHES "\\.js$" OR file STREQUAL "start.js")
      configure_file(${web_sources}/${file} ${SEAMLINE_WEB_FOLDER}/${file} COPYONLY)
    endif()
  endforeach()
  execute_process(
    COMMAND ${SEAMLINE_ESBUILD} seamline.js --bundle --format=iife --target=es2022 --charset=utf8 --log-level=warning
      --outfile=${SEAMLINE_WEB_FOLDER}/seamline.js
    WORKING_DIRECTORY ${web_sources} COMMAND_ERROR_IS_FATAL ANY)
  file(ARCHIVE_EXTRACT INPUT ${jspsych_archive} DESTINATION ${PROJECT_BINARY_DIR}/jspsych
    PATTERNS package/dist/index.browser.min.js)
  configure_file(${PROJECT_BINARY_DIR}/jspsych/package/dist/index.browser.min.js ${SEAMLINE_WEB_FOLDER}/jspsych.js COPYONLY)
endif()
message(STATUS "Page for browsers: ${SEAMLINE_HAS_WEB}")
