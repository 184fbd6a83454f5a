# Generates the loader of the OpenGL 3.3 core functions with glad, into the build tree, as the library glad.
find_program(GLAD_PROGRAM glad REQUIRED)
set(glad_dir ${PROJECT_BINARY_DIR}/glad)
if(NOT EXISTS ${glad_dir}/src/gl.c)
  execute_process(
    COMMAND ${GLAD_PROGRAM} --reproducible --quiet --api gl:core=3.3 --extensions "" --out-path ${glad_dir} c
    COMMAND_ERROR_IS_FATAL ANY)
endif()
add_library(glad STATIC ${glad_dir}/src/gl.c)
target_include_directories(glad SYSTEM PUBLIC ${glad_dir}/include)
