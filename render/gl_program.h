/// Compiles and links shaders.
#pragma once

#include <initializer_list>
#include <string>
#include <tl/expected.hpp>

#include "render/gl_object.h"

namespace batten::render {

/// A program of one vertex shader and a fragment shader put together from several sources, all in GLSL 3.30 without the
/// #version line. The error is one sentence with `name` and the driver's message.
[[nodiscard]] tl::expected<GlProgram, std::string> make_gl_program(const std::string& name, const char* vertex_source,
                                                                   std::initializer_list<const char*> fragment_sources);

}  // namespace batten::render
