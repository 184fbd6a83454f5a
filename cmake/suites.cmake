# batten_discover_tests(TARGET [PROPERTIES NAME VALUE...]): the tests of a GoogleTest program, one by one for ctest. Where sources are compiled
# together, which is for those who run all of them, one process runs a whole suite: under the sanitizers starting takes longer than most tests.
include(GoogleTest)

set(BATTEN_LIST_SUITES ${CMAKE_CURRENT_LIST_DIR}/list_suites.cmake)

function(batten_discover_tests target)
  if(NOT BATTEN_TOGETHER)
    gtest_discover_tests(${target} DISCOVERY_TIMEOUT 60 ${ARGN})
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "PROPERTIES")
  set(suites ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
  add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${suites} VERBATIM
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${target}> -D SUITES=${suites} -D "PROPERTIES=${arg_PROPERTIES}" -P ${BATTEN_LIST_SUITES})
  set(tests ${CMAKE_CURRENT_BINARY_DIR}/${target}_tests.cmake)
  file(WRITE ${tests} "if(EXISTS [==[${suites}]==])\n  include([==[${suites}]==])\nelse()\n  add_test(${target}_NOT_BUILT ${target}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${tests})
endfunction()
