# The target `man_page` makes batten.1 from what the program says about itself.
find_program(HELP2MAN help2man)
if(HELP2MAN)
  set(MAN_PAGE ${PROJECT_BINARY_DIR}/batten.1)
  add_custom_command(OUTPUT ${MAN_PAGE}
    COMMAND ${HELP2MAN} --no-info --no-discard-stderr --help-option=--help-all
      --name "edit and compute B-spline and NURBS curves" --output ${MAN_PAGE} $<TARGET_FILE:batten>
    DEPENDS batten
    VERBATIM)
  add_custom_target(man_page ALL DEPENDS ${MAN_PAGE})
endif()
