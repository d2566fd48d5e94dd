# What every target of Seamline is built with.

# The files of a folder are compiled forty at a time, as one: their headers and templates are most of the time to build.
# Every file stands alone all the same; CMAKE_UNITY_BUILD=OFF shows it, and rebuilds less after a change.
set(CMAKE_UNITY_BUILD ON CACHE BOOL "compile the files of a folder forty at a time")
set(CMAKE_UNITY_BUILD_BATCH_SIZE 40 CACHE STRING "how many files are compiled as one; 0: all of a folder")

# Where many files are compiled as one, a local may bear the name of another file's constant; a file alone is asked for all.
set(shadow_warning -Wshadow)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(shadow_warning -Wshadow=local)
endif()
add_library(seamline_warnings INTERFACE)
target_compile_options(seamline_warnings INTERFACE
  -Wall -Wextra -Wpedantic $<$<NOT:$<BOOL:$<TARGET_PROPERTY:SEAMLINE_MAY_SHADOW>>>:${shadow_warning}> -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
  # GCC 12 sees overlaps and overflows in std::string and std::map that are not there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized>
  $<$<BOOL:${SEAMLINE_WERROR}>:-Werror>)

# Same input, same bits: no fused multiply-add unless the source says so, no unsafe algebra.
add_compile_options(-ffp-contract=off)
if(SEAMLINE_SANITIZE)
  add_compile_options(-fsanitize=${SEAMLINE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${SEAMLINE_SANITIZE})
endif()
if(SEAMLINE_COVERAGE)
  add_compile_options(--coverage -O0)
  add_link_options(--coverage)
endif()

# Many files compiled as one meet GCC's bound on how much inlining may make a file grow, and what light adds up pixel by pixel is called
# then instead of inlined: 4 % of a render.
set(seamline_inlining $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=400> $<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=1000000>)

# Folders that wait for files, people and words: with -O3 they would take half as long again to compile, and nobody would feel it.
function(seamline_waits name)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O2>)
endfunction()

# One library a folder. The repository root is the include root, so an include names its folder: "stimuli/set/manifest.h".
function(seamline_library name)
  # Commands next to one another: the command line's library is 10 s of every compilation that sees it.
  set(commands ${ARGN})
  list(FILTER commands INCLUDE REGEX "(commands?|option)\\.cpp$")
  set(others ${ARGN})
  list(FILTER others EXCLUDE REGEX "(commands?|option)\\.cpp$")
  add_library(${name} STATIC ${others} ${commands})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE seamline_warnings)
endfunction()
