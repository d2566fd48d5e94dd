# What `cmake --install build/release` copies, and the Debian package that `cpack` makes of it (documentation/how-to/install.md).
# The program looks for its files in ../share/seamline, and in ../lib/seamline, so bin, lib and share stay side by side (support/files/assets.cpp).
install(TARGETS seamline RUNTIME DESTINATION bin)
install(TARGETS seamline_pictures LIBRARY DESTINATION lib/seamline)
install(DIRECTORY ${builtin_scenes_folder}/ DESTINATION share/seamline/scenes/builtin FILES_MATCHING PATTERN "*.glb" PATTERN "*.exr")
install(DIRECTORY stimuli/ DESTINATION share/seamline/stimuli FILES_MATCHING PATTERN "*.toml" PATTERN "estimated/*.png"
  PATTERN "definition" EXCLUDE PATTERN "pictures" EXCLUDE PATTERN "set" EXCLUDE PATTERN "study_file" EXCLUDE)
if(SEAMLINE_HAS_WEB)
  install(DIRECTORY ${SEAMLINE_WEB_FOLDER}/ DESTINATION share/seamline/web)
endif()
if(SEAMLINE_HAS_X3D)
  install(DIRECTORY ${SEAMLINE_X3D_FOLDER}/ DESTINATION share/seamline/x3d)
endif()
install(FILES python/seamline.py DESTINATION share/seamline/python)
# The pages, without the scripts that make the site and the pictures.
install(DIRECTORY documentation DESTINATION share/doc/seamline PATTERN ".gitignore" EXCLUDE PATTERN "__pycache__" EXCLUDE
  PATTERN "documentation/site" EXCLUDE PATTERN "pictures/make_*" EXCLUDE)
install(FILES README.md LICENSE CHANGELOG.md CITATION.cff packaging/copyright DESTINATION share/doc/seamline)
install(DIRECTORY ${PROJECT_BINARY_DIR}/manual/compressed/man1 DESTINATION share/man)
# Debian's own changelog, in its form and compressed as it wants it (-n: no name and time, so same bytes).
configure_file(packaging/changelog.in ${PROJECT_BINARY_DIR}/manual/changelog @ONLY)
execute_process(COMMAND gzip -9nfk ${PROJECT_BINARY_DIR}/manual/changelog COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${PROJECT_BINARY_DIR}/manual/changelog.gz DESTINATION share/doc/seamline)
if(SEAMLINE_HAS_SITE)
  # A picture that pages and site both have is a link in the pages: 20 MB.
  install(CODE [[
    set(pages "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/doc/seamline")
    file(GLOB pictures "${pages}/site/_images/*")
    file(GLOB_RECURSE in_pages "${pages}/documentation/*.png" "${pages}/documentation/*.svg")
    foreach(picture ${pictures})
      get_filename_component(name "${picture}" NAME)
      foreach(same ${in_pages})
        if(same MATCHES "/${name}$" AND NOT IS_SYMLINK "${same}")
          execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files "${picture}" "${same}" RESULT_VARIABLE differ ERROR_QUIET)
          if(NOT differ)
            get_filename_component(folder "${same}" DIRECTORY)
            file(RELATIVE_PATH to "${folder}" "${picture}")
            file(CREATE_LINK "${to}" "${same}" SYMBOLIC)
          endif()
        endif()
      endforeach()
    endforeach()
  ]])
endif()
install(FILES ${PROJECT_BINARY_DIR}/manual/seamline.bash DESTINATION share/bash-completion/completions RENAME seamline)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME seamline)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "The Seamline developers")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/PackageOptions.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Seamline developers <seamline@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "perceptual thresholds of depth resolution in mixed reality")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Renders pictures in which one object was composited into a scene through
a depth map of a chosen resolution, shows them to people in forced-choice
trials, and computes perceptual thresholds from their answers.

Real people answer in a window or in a browser; simulated ones need neither.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# What the program runs (figures of a report) and reads (letters of contact sheets and of the window).
set(CPACK_DEBIAN_PACKAGE_DEPENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-lohit-deva, fonts-tlwg-loma-ttf")
# Letters of the other scripts, for the window: 42 MB and 90 MB.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "bash-completion, man-db, fonts-noto-core, fonts-noto-cjk")
include(CPack)
