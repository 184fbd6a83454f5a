#include "render/gl_program.h"

#include <fmt/core.h>

#include <vector>

namespace batten::render {
namespace {

/// The driver's message about a shader or a program, without the line ends at its end.
template <typename QueryLength, typename QueryText>
std::string message_of(GLuint id, QueryLength query_length, QueryText query_text) {
    GLint length = 0;
    query_length(id, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    if (length > 0) query_text(id, length, nullptr, text.data());
    const std::size_t last = text.find_last_not_of(std::string("\0\n\r ", 4));
    return last == std::string::npos ? "no message" : text.substr(0, last + 1);
}

tl::expected<GlShader, std::string> compile(const std::string& name, GLenum stage, std::vector<const char*> sources) {
    sources.insert(sources.begin(), "#version 330 core\n");
    GlShader shader(glCreateShader(stage));
    glShaderSource(shader.id(), static_cast<GLsizei>(sources.size()), sources.data(), nullptr);
    glCompileShader(shader.id());
    GLint is_compiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled == GL_TRUE) return shader;
    const char* pattern = stage == GL_VERTEX_SHADER ? "The vertex shader \"{}\" does not compile: {}"
                                                    : "The fragment shader \"{}\" does not compile: {}";
    return tl::unexpected(
        fmt::format(fmt::runtime(pattern), name, message_of(shader.id(), glGetShaderiv, glGetShaderInfoLog)));
}

}  // namespace

tl::expected<GlProgram, std::string> make_gl_program(const std::string& name, const char* vertex_source,
                                                     std::initializer_list<const char*> fragment_sources) {
    const auto vertex = compile(name, GL_VERTEX_SHADER, {vertex_source});
    if (!vertex) return tl::unexpected(vertex.error());
    const auto fragment = compile(name, GL_FRAGMENT_SHADER, fragment_sources);
    if (!fragment) return tl::unexpected(fragment.error());

    GlProgram program(glCreateProgram());
    glAttachShader(program.id(), vertex->id());
    glAttachShader(program.id(), fragment->id());
    glLinkProgram(program.id());
    glDetachShader(program.id(), vertex->id());
    glDetachShader(program.id(), fragment->id());
    GLint is_linked = GL_FALSE;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &is_linked);
    if (is_linked == GL_TRUE) return program;
    return tl::unexpected(fmt::format("The shader program \"{}\" does not link: {}", name,
                                      message_of(program.id(), glGetProgramiv, glGetProgramInfoLog)));
}

}  // namespace batten::render
