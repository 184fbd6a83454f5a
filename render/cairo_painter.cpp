#include "render/cairo_painter.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "render/label_runs.h"

namespace batten::render {

namespace {

struct Destroyed {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Context = std::unique_ptr<cairo_t, Destroyed>;
using Surface = std::unique_ptr<cairo_surface_t, Destroyed>;

constexpr double most_component = 255.0;

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

double share_left_of(Anchor anchor) {
    switch (anchor) {
        case Anchor::left:
            return 0.0;
        case Anchor::center:
            return 0.5;
        case Anchor::right:
            break;
    }
    return 1.0;
}

/// Paints one command after another.
class Painter {
  public:
    explicit Painter(cairo_t* cairo) : cairo_(cairo) {}

    void operator()(const Polyline& line) const {
        if (line.points.empty()) return;
        trace(line.points);
        if (line.is_closed) cairo_close_path(cairo_);
        const std::array<double, 2> dashes{line.dash_px, line.gap_px};
        const bool is_dashed = line.dash_px > 0.0F;
        cairo_set_dash(cairo_, dashes.data(), is_dashed ? 2 : 0, 0.0);
        cairo_set_line_cap(cairo_, is_dashed ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
        stroke(line.color, line.width_px);
    }

    void operator()(const Fill& fill) const {
        if (fill.points.size() < 3) return;
        trace(fill.points);
        take(fill.color);
        cairo_fill(cairo_);
    }

    void operator()(const Region& region) const {
        cairo_new_path(cairo_);
        for (const std::vector<glm::vec2>& loop : region.loops->loops) {
            cairo_new_sub_path(cairo_);
            for (const glm::vec2 point : loop) cairo_line_to(cairo_, point.x, point.y);
            cairo_close_path(cairo_);
        }
        const bool is_even_odd = region.loops->rule == FillRule::even_odd;
        cairo_set_fill_rule(cairo_, is_even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
        take(region.color);
        cairo_fill(cairo_);
        cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_WINDING);
    }

    void operator()(const Ink& ink) const {
        const glm::ivec2 size = ink.map->size_px();
        const Surface mask(cairo_image_surface_create(CAIRO_FORMAT_A8, size.x, size.y));
        if (cairo_surface_status(mask.get()) != CAIRO_STATUS_SUCCESS) return;
        unsigned char* rows = cairo_image_surface_get_data(mask.get());
        const int stride = cairo_image_surface_get_stride(mask.get());
        for (int y = 0; y < size.y; ++y)
            std::copy_n(ink.map->values().begin() + static_cast<std::ptrdiff_t>(y) * size.x, size.x,
                        rows + static_cast<std::ptrdiff_t>(y) * stride);
        cairo_surface_mark_dirty(mask.get());
        take(ink.color);
        cairo_mask_surface(cairo_, mask.get(), 0.0, 0.0);
    }

    void operator()(const ImageQuad&) const {}  // drawn by, never shown

    void operator()(const Marker& marker) const {
        trace_shape(marker);
        take(marker.fill);
        if (marker.fill.alpha > 0) cairo_fill_preserve(cairo_);
        if (marker.outline.alpha == 0 || marker.outline_px <= 0.0F) return cairo_new_path(cairo_);
        const double dash = marker.dash_px;
        cairo_set_dash(cairo_, &dash, dash > 0.0 ? 1 : 0, 0.0);
        cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_BUTT);
        stroke(marker.outline, marker.outline_px);
    }

    void operator()(const Label& label) const {
        const bool is_bold = label.font == LabelFont::bold;
        cairo_select_font_face(cairo_, label.font == LabelFont::number ? "JetBrains Mono" : "Inter",
                               CAIRO_FONT_SLANT_NORMAL, is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        take(label.color);
        const double left = label.position.x - share_left_of(label.anchor) * set(label, 0.0, false);
        set(label, left, true);
        cairo_new_path(cairo_);
    }

  private:
    void take(Color color) const {
        cairo_set_source_rgba(cairo_, color.red / most_component, color.green / most_component,
                              color.blue / most_component, color.alpha / most_component);
    }

    void trace(const std::vector<Pixel>& points) const {
        cairo_new_path(cairo_);
        for (const Pixel point : points) cairo_line_to(cairo_, point.x, point.y);
    }

    void trace_shape(const Marker& marker) const {
        const Pixel c = marker.center;
        const double r = marker.radius_px;
        cairo_new_path(cairo_);
        switch (marker.shape) {
            case MarkerShape::disc:
                return cairo_arc(cairo_, c.x, c.y, r, 0.0, 2.0 * M_PI);
            case MarkerShape::square:
                return cairo_rectangle(cairo_, c.x - r, c.y - r, 2.0 * r, 2.0 * r);
            case MarkerShape::diamond:
                break;
        }
        for (const glm::dvec2 corner : {glm::dvec2(-r, 0.0), {0.0, -r}, {r, 0.0}, {0.0, r}})
            cairo_line_to(cairo_, c.x + corner.x, c.y + corner.y);
        cairo_close_path(cairo_);
    }

    void stroke(Color color, double width_px) const {
        take(color);
        cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_width(cairo_, width_px);
        cairo_stroke(cairo_);
    }

    /// Sets the label from `left` on, or only measures it; returns its width.
    double set(const Label& label, double left, bool is_shown) const {
        double start = left;
        double end = left;
        for (const LabelRun& run : label_runs(label.text)) {
            if (!run.is_stacked) start = end;
            const bool is_script = run.script != Script::none;
            cairo_set_font_size(cairo_, (is_script ? script_size : 1.0) * label.size_px);
            cairo_font_extents_t font{};
            cairo_font_extents(cairo_, &font);
            const std::string text(run.text);
            cairo_text_extents_t extents{};
            cairo_text_extents(cairo_, text.c_str(), &extents);
            const double shift = !is_script ? 0.0 : run.script == Script::sub ? script_shift : -script_shift;
            // The middle of ascent and descent is at the label's position.
            const double y = label.position.y + shift * label.size_px + 0.5 * (font.ascent - font.descent);
            if (is_shown) {
                cairo_move_to(cairo_, start, y);
                cairo_show_text(cairo_, text.c_str());
            }
            end = std::max(end, start + extents.x_advance);
        }
        return end - left;
    }

    cairo_t* cairo_;
};

}  // namespace

tl::expected<std::string, std::string> svg_text(const DrawList& picture, glm::dvec2 size_px, Color background) {
    std::string text;
    const Surface surface(cairo_svg_surface_create_for_stream(append, &text, size_px.x, size_px.y));
    const Context cairo(cairo_create(surface.get()));
    const Painter painter(cairo.get());
    painter(Fill{{{0.0F, 0.0F},
                  {static_cast<float>(size_px.x), 0.0F},
                  glm::vec2(size_px),
                  {0.0F, static_cast<float>(size_px.y)}},
                 background});
    for (const DrawCommand& command : picture.commands) std::visit(painter, command);
    cairo_surface_finish(surface.get());
    for (const cairo_status_t status : {cairo_status(cairo.get()), cairo_surface_status(surface.get())})
        if (status != CAIRO_STATUS_SUCCESS) return tl::unexpected(std::string(cairo_status_to_string(status)));
    return text;
}

}  // namespace batten::render
