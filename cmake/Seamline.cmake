# What every target of Seamline is built with.
add_library(seamline_warnings INTERFACE)
target_compile_options(seamline_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
  -Wno-restrict  # GCC 12 sees overlaps in std::string that are not there (GCC bug 105651)
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

# What most files include, compiled once a target: half of the time to build. Every file names its own includes all the
# same; SEAMLINE_PRECOMPILE=OFF shows whether it does.
option(SEAMLINE_PRECOMPILE "Compile the headers that most files include once, and commands together" ON)
function(seamline_precompile name)
  if(SEAMLINE_PRECOMPILE)
    target_precompile_headers(${name} PRIVATE
      <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string> <variant> <vector>
      <Eigen/Dense> ${ARGN})
  endif()
  # The same bug of GCC 12, with a std::map's values too; and it forgets that precompiled headers are the system's.
  target_compile_options(${name} PRIVATE
    -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized)
endfunction()

# One library a folder. The repository root is the include root, so an include names its folder: "stimuli/manifest.h".
function(seamline_library name)
  add_library(${name} STATIC ${ARGN})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE seamline_warnings)
  seamline_precompile(${name})
endfunction()

# The command line's library takes 13 s of every file that includes it: a library's commands are compiled as one file.
function(seamline_commands name)
  if(SEAMLINE_PRECOMPILE)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP commands)
  endif()
endfunction()
