# A build whose objects hold the compiler's own language beside the machine's (CMAKE_TOOLCHAIN_FILE=tests/odr_build.cmake):
# programs are linked from the machine's, and tests/odr reads the compiler's.
set(CMAKE_CXX_FLAGS_INIT "-flto=auto -ffat-lto-objects")
foreach(kind EXE SHARED MODULE)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "-fno-lto")
endforeach()
# The compiler's plugin would put names into an archive's index that the machine's code does not have: members were linked twice.
set(CMAKE_CXX_ARCHIVE_CREATE "<CMAKE_AR> qc --plugin /dev/null <TARGET> <LINK_FLAGS> <OBJECTS>")
set(CMAKE_CXX_ARCHIVE_APPEND "<CMAKE_AR> q --plugin /dev/null <TARGET> <LINK_FLAGS> <OBJECTS>")
set(CMAKE_CXX_ARCHIVE_FINISH "<CMAKE_RANLIB> --plugin /dev/null <TARGET>")
