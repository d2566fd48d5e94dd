# Tells CTest of the suites of one GoogleTest program, after each build of it: a suite is one process, so that what its tests share
# is made once, and the libraries behind the first picture that is not plain are loaded once (they take half a second).
#   cmake -DPROGRAM=... -DFILTER=... -DFOLDER=... -DENDING=... -DPROPERTIES=... -DWORKING_DIRECTORY=... -DTESTS_OUTPUT=... -P discover_suites.cmake
execute_process(COMMAND ${PROGRAM} --gtest_list_tests "--gtest_filter=${FILTER}" TIMEOUT 60
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\\.( *#[^\n]*)?\n" ".\n" listed "${listed}")  # types of typed suites
string(REGEX REPLACE " +#[^\n]*" "" listed "${listed}")             # values of parameters
string(REPLACE "\n" ";" lines "${listed}")

set(script "")
set(suite "")
set(tests "")
function(tell_of_suite)
  if(tests STREQUAL "")
    return()
  endif()
  list(JOIN tests ":" filter)
  string(APPEND script "add_test([==[${FOLDER}.${suite}${ENDING}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${filter}]==])\n"
    "set_tests_properties([==[${FOLDER}.${suite}${ENDING}]==] PROPERTIES WORKING_DIRECTORY [==[${WORKING_DIRECTORY}]==] "
    # Skipped is a suite of which nothing passed and nothing failed: the list of the skipped ends what it says.
    "SKIP_REGULAR_EXPRESSION [==[PASSED  \\] 0 tests\\.\n\\[  SKIPPED \\] [0-9]+ tests?, listed below:\n(\\[  SKIPPED \\] [^\n]*\n?)+$]==] "
    "${PROPERTIES})\n")
  set(script "${script}" PARENT_SCOPE)
endfunction()
foreach(line IN LISTS lines)
  if(line MATCHES "^  +([^ ]+)$")
    list(APPEND tests "${suite}.${CMAKE_MATCH_1}")
  elseif(line MATCHES "^([^ ]+)\\.$")
    tell_of_suite()
    set(suite "${CMAKE_MATCH_1}")
    set(tests "")
  endif()
endforeach()
tell_of_suite()
file(WRITE "${TESTS_OUTPUT}" "${script}")
