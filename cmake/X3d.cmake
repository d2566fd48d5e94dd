# The page of `seamline export x3d SET_OR_SCENE DIR`: ours from x3d/page, and X3DOM from the npm registry, pinned.
# Laid together in the build folder, from where it is installed to share/seamline/x3d.
set(SEAMLINE_X3D AUTO CACHE STRING "build `seamline export x3d`: AUTO, ON or OFF")
set_property(CACHE SEAMLINE_X3D PROPERTY STRINGS AUTO ON OFF)
set(SEAMLINE_X3DOM "" CACHE FILEPATH "x3dom-1.8.3.tgz of the npm registry, for machines without network")
set(SEAMLINE_X3D_FOLDER ${PROJECT_BINARY_DIR}/x3d)
set(x3dom_version 1.8.3)
# The registry's own: sha512-sqd4bIyKEKcGG+D9fa7lB5oiOeN57a1FzX0HBZvrOGwVmFTYjNmT3zqEobzqo/YaDYc7FWi2Dvt6RBVPMXyuXA==
set(x3dom_sha512 b2a7786c8c8a10a7061be0fd7daee5079a2239e379edad45cd7d07059beb386c159854d88cd993df3a84a1bceaa3f61a0d873b1568b60efb7a44154f317cae5c)

seamline_npm_archive(x3dom ${x3dom_version} ${x3dom_sha512} SEAMLINE_X3D SEAMLINE_X3DOM SEAMLINE_HAS_X3D)

if(SEAMLINE_HAS_X3D)
  set(x3d_sources ${PROJECT_SOURCE_DIR}/x3d/page)
  file(GLOB x3d_files CONFIGURE_DEPENDS RELATIVE ${x3d_sources} ${x3d_sources}/*)
  file(REMOVE_RECURSE ${SEAMLINE_X3D_FOLDER})
  foreach(file IN LISTS x3d_files)
    configure_file(${x3d_sources}/${file} ${SEAMLINE_X3D_FOLDER}/${file} COPYONLY)
  endforeach()
  file(ARCHIVE_EXTRACT INPUT ${x3dom_archive} DESTINATION ${PROJECT_BINARY_DIR}/x3dom
    PATTERNS package/x3dom.js package/x3dom.css)
  foreach(file x3dom.js x3dom.css)
    configure_file(${PROJECT_BINARY_DIR}/x3dom/package/${file} ${SEAMLINE_X3D_FOLDER}/${file} COPYONLY)
  endforeach()
endif()
message(STATUS "Page in X3DOM: ${SEAMLINE_HAS_X3D}")
