# batten_embed_shaders(TARGET FILES...): compiles the shaders into TARGET as string constants, again whenever one changes.
# shaders/stroke.vert.glsl becomes batten::render::shaders::stroke_vert, declared in "shaders/sources.h".
set(BATTEN_EMBED_SHADERS ${CMAKE_CURRENT_LIST_DIR}/embed_shaders.cmake)

function(batten_embed_shaders target)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  add_custom_command(
    OUTPUT ${generated}/shaders/sources.cpp ${generated}/shaders/sources.h
    COMMAND ${CMAKE_COMMAND} "-DSHADERS=${ARGN}" -DOUTPUT=${generated}/shaders -P ${BATTEN_EMBED_SHADERS}
    DEPENDS ${ARGN} ${BATTEN_EMBED_SHADERS}
    COMMENT "Embedding the shaders"
    VERBATIM)
  target_sources(${target} PRIVATE ${generated}/shaders/sources.cpp ${generated}/shaders/sources.h)
  target_include_directories(${target} PRIVATE ${generated})
endfunction()
