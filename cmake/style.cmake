# The version of clang-format and clang-tidy that the sources are kept by: others lay out and find other things. scripts/setup reads it here.
set(BATTEN_STYLE_VERSION 14)

# batten_find_style_program(VARIABLE NAME): the program of that version, whether its name says so or not; else VARIABLE is false.
function(batten_find_style_program variable name)
  find_program(${variable} NAMES ${name}-${BATTEN_STYLE_VERSION} ${name})
  if(${variable})
    execute_process(COMMAND ${${variable}} --version OUTPUT_VARIABLE answer ERROR_QUIET)
    if(NOT answer MATCHES "version ${BATTEN_STYLE_VERSION}\\.")
      unset(${variable} CACHE)
    endif()
  endif()
endfunction()

# batten_style_test(NAME PROGRAM COMMAND...): a test that is skipped, and says why, where the program was not found.
function(batten_style_test name program)
  if(${program})
    add_test(NAME ${name} COMMAND ${ARGN})
  else()
    string(TOLOWER ${program} program_name)
    string(REPLACE "_" "-" program_name ${program_name})
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo
      "Skipped: ${program_name} ${BATTEN_STYLE_VERSION} is not installed; where the system has it, scripts/setup style installs it.")
    set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "^Skipped:")
  endif()
endfunction()
