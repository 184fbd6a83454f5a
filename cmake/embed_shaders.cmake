# Run at build time: writes OUTPUT/sources.h and OUTPUT/sources.cpp with the files of the list SHADERS as string constants.
set(declarations "")
set(definitions "")
foreach(shader IN LISTS SHADERS)
  get_filename_component(file ${shader} NAME)
  string(REGEX REPLACE "\\.glsl$" "" name ${file})
  string(REPLACE "." "_" name ${name})
  file(READ ${shader} text)
  string(APPEND declarations "extern const char* const ${name};\n")
  string(APPEND definitions "const char* const ${name} = R\"glsl(${text})glsl\";\n")
endforeach()
file(WRITE ${OUTPUT}/sources.h "/// The shaders' sources, embedded at build time.
#pragma once

namespace batten::render::shaders {

${declarations}
}  // namespace batten::render::shaders
")
file(WRITE ${OUTPUT}/sources.cpp "#include \"shaders/sources.h\"

namespace batten::render::shaders {

${definitions}
}  // namespace batten::render::shaders
")
