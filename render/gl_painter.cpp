#include "render/gl_painter.h"

#include <array>
#include <cstddef>

#include "render/gl_images.h"
#include "render/gl_program.h"
#include "render/gl_stream.h"
#include "render/gl_textures.h"
#include "render/picture_mesh.h"
#include "shaders/sources.h"

namespace batten::render {
namespace {

using Type = GlInput::Type;

// stroke_once.frag.glsl divides the depth into 2^22 levels and uses one for each coverage, one more for having painted.
constexpr int levels_per_stroke = 257;
constexpr int strokes_per_depth_clear = (1 << 22) / levels_per_stroke;

/// A shader program with the one uniform that all have.
struct Pen {
    GlProgram program;
    GLint viewport_px = -1;
};

tl::expected<Pen, std::string> make_pen(const std::string& name, const char* vertex,
                                        std::initializer_list<const char*> fragment) {
    return make_gl_program(name, vertex, fragment).map([](GlProgram program) {
        const GLint viewport_px = glGetUniformLocation(program.id(), "viewport_px");
        return Pen{std::move(program), viewport_px};
    });
}

void set_state(const Viewport& viewport) {
    const int bottom = viewport.framebuffer_px.y - viewport.origin_px.y - viewport.size_px.y;
    glViewport(viewport.origin_px.x, bottom, viewport.size_px.x, viewport.size_px.y);
    glScissor(viewport.origin_px.x, bottom, viewport.size_px.x, viewport.size_px.y);
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_PRIMITIVE_RESTART);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDepthRange(0.0, 1.0);
}

/// Puts what was set back to what a new context has.
void reset_state(const Viewport& viewport) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    glViewport(0, 0, viewport.framebuffer_px.x, viewport.framebuffer_px.y);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void clear(Color background) {
    glClearColor(static_cast<float>(background.red) / 255.0F, static_cast<float>(background.green) / 255.0F,
                 static_cast<float>(background.blue) / 255.0F, static_cast<float>(background.alpha) / 255.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

void clear_depth() {
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace

struct GlPainter::Resources {
    Pen fill;
    Pen stroke;
    Pen stroke_once;
    Pen ink;
    Pen image;
    Pen marker;
    GLint first_level = glGetUniformLocation(stroke_once.program.id(), "first_level");
    GLint pass_shift = glGetUniformLocation(stroke_once.program.id(), "pass_shift");
    GlStream fills{sizeof(FillVertex),
                   {{Type::floats, 2, offsetof(FillVertex, position_px)},
                    {Type::floats, 1, offsetof(FillVertex, inside_px)},
                    {Type::color, 4, offsetof(FillVertex, color)}}};
    GlStream strokes{sizeof(StrokeVertex),
                     {{Type::floats, 2, offsetof(StrokeVertex, position_px)},
                      {Type::floats, 2, offsetof(StrokeVertex, along_px)},
                      {Type::floats, 2, offsetof(StrokeVertex, first_px)},
                      {Type::floats, 3, offsetof(StrokeVertex, half_width_px)},
                      {Type::color, 4, offsetof(StrokeVertex, color)}}};
    GlStream inks{sizeof(InkVertex),
                  {{Type::floats, 2, offsetof(InkVertex, position_px)},
                   {Type::floats, 2, offsetof(InkVertex, place)},
                   {Type::color, 4, offsetof(InkVertex, color)}}};
    GlTextures maps{};
    GlStream image_parts{sizeof(ImageVertex),
                         {{Type::floats, 2, offsetof(ImageVertex, position_px)},
                          {Type::floats, 2, offsetof(ImageVertex, place)},
                          {Type::floats, 1, offsetof(ImageVertex, opacity)}}};
    GlImages images{};
    GlStream markers{sizeof(MarkerVertex),
                     {{Type::floats, 2, offsetof(MarkerVertex, position_px)},
                      {Type::floats, 2, offsetof(MarkerVertex, local_px)},
                      {Type::floats, 3, offsetof(MarkerVertex, roundness)},
                      {Type::color, 4, offsetof(MarkerVertex, fill)},
                      {Type::color, 4, offsetof(MarkerVertex, outline)}}};
    PictureMesh picture{};
    int strokes_once = 0;          // painted in this frame
    std::size_t maps_shown = 0;    // painted in this frame
    std::size_t images_shown = 0;  // painted in this frame

    void upload() {
        fills.upload(picture.fills);
        strokes.upload(picture.strokes);
        inks.upload(picture.inks);
        maps.clear();
        for (const auto& map : picture.maps) maps.upload(map);
        image_parts.upload(picture.image_parts);
        for (const auto& shown : picture.images) images.upload(shown);
        markers.upload(picture.markers);
    }

    void begin(glm::ivec2 size_px) {
        for (const Pen* pen : {&fill, &stroke, &stroke_once, &ink, &image, &marker}) {
            glUseProgram(pen->program.id());
            glUniform2f(pen->viewport_px, static_cast<float>(size_px.x), static_cast<float>(size_px.y));
        }
        strokes_once = 0;
        maps_shown = 0;
        images_shown = 0;
    }

    void draw(const Run& run) {
        switch (run.kind) {
            case RunKind::fill:
                return draw_with(fill, fills, run);
            case RunKind::stroke:
                return draw_with(stroke, strokes, run);
            case RunKind::stroke_once:
                return draw_once(run);
            case RunKind::ink:
                maps.bind(maps_shown++);
                return draw_with(ink, inks, run);
            case RunKind::image:
                images.bind(*picture.images[images_shown++]);
                return draw_with(image, image_parts, run);
            case RunKind::marker:
                return draw_with(marker, markers, run);
        }
    }

    static void draw_with(const Pen& pen, const GlStream& stream, const Run& run) {
        glUseProgram(pen.program.id());
        stream.draw(run.first, run.count);
    }

    void draw_once(const Run& run) {
        const int stroke_of_clear = strokes_once++ % strokes_per_depth_clear;
        if (stroke_of_clear == 0) clear_depth();
        glUseProgram(stroke_once.program.id());
        glUniform1f(first_level, static_cast<float>(stroke_of_clear * levels_per_stroke));
        glEnable(GL_DEPTH_TEST);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glUniform1f(pass_shift, 0.0F);
        strokes.draw(run.first, run.count);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glUniform1f(pass_shift, 1.0F);
        strokes.draw(run.first, run.count);
        glDisable(GL_DEPTH_TEST);
    }
};

GlPainter::GlPainter(std::unique_ptr<Resources> resources) : resources_(std::move(resources)) {}
GlPainter::GlPainter(GlPainter&&) noexcept = default;
GlPainter& GlPainter::operator=(GlPainter&&) noexcept = default;
GlPainter::~GlPainter() = default;

tl::expected<GlPainter, std::string> GlPainter::make() {
    auto fill = make_pen("fill", shaders::fill_vert, {shaders::fill_frag});
    if (!fill) return tl::unexpected(fill.error());
    auto stroke = make_pen("stroke", shaders::stroke_vert, {shaders::stroke_coverage, shaders::stroke_frag});
    if (!stroke) return tl::unexpected(stroke.error());
    auto once = make_pen("stroke_once", shaders::stroke_vert, {shaders::stroke_coverage, shaders::stroke_once_frag});
    if (!once) return tl::unexpected(once.error());
    auto ink = make_pen("ink", shaders::ink_vert, {shaders::ink_frag});
    if (!ink) return tl::unexpected(ink.error());
    auto image = make_pen("image", shaders::image_vert, {shaders::image_frag});
    if (!image) return tl::unexpected(image.error());
    auto marker = make_pen("marker", shaders::marker_vert, {shaders::marker_frag});
    if (!marker) return tl::unexpected(marker.error());
    return GlPainter(std::make_unique<Resources>(Resources{std::move(*fill), std::move(*stroke), std::move(*once),
                                                           std::move(*ink), std::move(*image), std::move(*marker)}));
}

void GlPainter::paint(const DrawList& list, const Viewport& viewport, Color background, float scale) {
    upload(list, viewport, scale);
    draw(viewport, background);
}

void GlPainter::upload(const DrawList& list, const Viewport& viewport, float scale) {
    build_picture(resources_->picture, list, viewport.size_px, scale);
    resources_->upload();
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void GlPainter::draw(const Viewport& viewport, Color background) {
    if (viewport.size_px.x <= 0 || viewport.size_px.y <= 0) return;
    set_state(viewport);
    clear(background);
    resources_->begin(viewport.size_px);
    for (const Run& run : resources_->picture.runs) resources_->draw(run);
    reset_state(viewport);
}

std::size_t GlPainter::vertex_count() const {
    const PictureMesh& picture = resources_->picture;
    return picture.fills.vertices.size() + picture.strokes.vertices.size() + picture.inks.vertices.size() +
           picture.image_parts.vertices.size() + picture.markers.vertices.size();
}

}  // namespace batten::render
