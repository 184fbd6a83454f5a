#include "render/cairo_painter.h"

#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>

#include "render/first_sign.h"
#include "render/label_runs.h"
#include "render/lean_path.h"
#include "render/prose.h"

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

void take_font(cairo_t* cairo, double size_px, LabelFont font, const char* family) {
    cairo_select_font_face(cairo, family, CAIRO_FONT_SLANT_NORMAL,
                           font == LabelFont::bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, size_px);
}

/// Whether the font that is taken has a glyph for `sign`.
bool has_glyph(cairo_t* cairo, std::string_view sign) {
    if (sign.size() < 2) return true;
    cairo_glyph_t* glyphs = nullptr;
    int count = 0;
    cairo_scaled_font_text_to_glyphs(cairo_get_scaled_font(cairo), 0.0, 0.0, sign.data(), static_cast<int>(sign.size()),
                                     &glyphs, &count, nullptr, nullptr, nullptr);
    const bool has_one = count > 0 && glyphs[0].index != 0;
    cairo_glyph_free(glyphs);
    return has_one;
}

constexpr const char* other_family = "DejaVu Sans";

/// Calls visit(stretch) for the stretches of `text` that are of one font, with that font taken: signs that the
/// interface's font lacks are those of another, since Cairo looks for no other font by itself.
template <class Visit>
void for_each_stretch(cairo_t* cairo, std::string_view text, double size_px, LabelFont font, const Visit& visit) {
    const char* family = font == LabelFont::number ? "JetBrains Mono" : "Inter";
    const auto is_lacking = [&](std::string_view sign) { return !has_glyph(cairo, sign); };
    while (!text.empty()) {
        take_font(cairo, size_px, font, family);
        const bool is_other = is_lacking(first_sign(text));
        std::size_t size = 0;
        while (size < text.size() && is_lacking(first_sign(text.substr(size))) == is_other)
            size += first_sign(text.substr(size)).size();
        if (is_other) take_font(cairo, size_px, font, other_family);
        visit(std::string(text.substr(0, size)));
        text.remove_prefix(size);
    }
}

double advance_of(cairo_t* cairo, std::string_view text, double size_px, LabelFont font) {
    double sum = 0.0;
    for_each_stretch(cairo, text, size_px, font, [&](const std::string& stretch) {
        cairo_text_extents_t extents{};
        cairo_text_extents(cairo, stretch.c_str(), &extents);
        sum += extents.x_advance;
    });
    return sum;
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

/// The coverage of the pixels in `range`; an empty surface for none.
Surface mask_of(const CoverageMap& map, const PixelRange& range) {
    const glm::ivec2 size = range.is_empty() ? glm::ivec2(0) : range.upper - range.lower;
    Surface mask(cairo_image_surface_create(CAIRO_FORMAT_A8, size.x, size.y));
    unsigned char* rows = cairo_image_surface_get_data(mask.get());
    if (rows == nullptr) return mask;
    const int stride = cairo_image_surface_get_stride(mask.get());
    for (int y = 0; y < size.y; ++y) {
        const auto first = static_cast<std::ptrdiff_t>(range.lower.y + y) * map.size_px().x + range.lower.x;
        std::copy_n(map.values().begin() + first, size.x, rows + static_cast<std::ptrdiff_t>(y) * stride);
    }
    cairo_surface_mark_dirty(mask.get());
    return mask;
}

/// With colors that are multiplied by their alpha.
Surface surface_of(const Image& image) {
    constexpr unsigned full = 255;
    Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
    unsigned char* rows = cairo_image_surface_get_data(surface.get());
    if (rows == nullptr) return surface;
    const int stride = cairo_image_surface_get_stride(surface.get());
    const std::uint8_t* pixel = image.rgba.data();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x, pixel += 4) {
            const auto share = [&](std::size_t c) { return (pixel[c] * unsigned{pixel[3]} + full / 2) / full; };
            const std::uint32_t value = unsigned{pixel[3]} << 24U | share(0) << 16U | share(1) << 8U | share(2);
            std::memcpy(rows + static_cast<std::ptrdiff_t>(y) * stride + 4 * static_cast<std::ptrdiff_t>(x), &value,
                        sizeof value);
        }
    cairo_surface_mark_dirty(surface.get());
    return surface;
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
        const PixelRange range = ink.map->touched();
        const Surface mask = mask_of(*ink.map, range);
        take(ink.color);
        cairo_mask_surface(cairo_, mask.get(), range.lower.x, range.lower.y);
    }

    void operator()(const ImageQuad& quad) const {
        const Image image = embedded(*quad.image);
        const Surface pixels = surface_of(image);
        const glm::dvec2 right = (quad.upper_right - quad.upper_left) / static_cast<double>(image.width);
        const glm::dvec2 down = (quad.lower_left - quad.upper_left) / static_cast<double>(image.height);
        cairo_matrix_t matrix{};
        cairo_matrix_init(&matrix, right.x, right.y, down.x, down.y, quad.upper_left.x, quad.upper_left.y);
        if (right.x * down.y == right.y * down.x) return;  // seen from its side
        cairo_save(cairo_);
        cairo_transform(cairo_, &matrix);
        cairo_set_source_surface(cairo_, pixels.get(), 0.0, 0.0);
        cairo_pattern_set_extend(cairo_get_source(cairo_), CAIRO_EXTEND_PAD);
        cairo_rectangle(cairo_, 0.0, 0.0, image.width, image.height);
        cairo_clip(cairo_);
        cairo_paint_with_alpha(cairo_, quad.opacity);
        cairo_restore(cairo_);
    }

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
        take(label.color);
        const double left = label.position.x - share_left_of(label.anchor) * set(label, 0.0, false);
        set(label, left, true);
        cairo_new_path(cairo_);
    }

    /// All of what is not cut off.
    void cover(Color color) const {
        take(color);
        cairo_paint(cairo_);
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
        cairo_new_path(cairo_);
        if (marker.shape == MarkerShape::disc)
            return cairo_arc(cairo_, marker.center.x, marker.center.y, marker.radius_px, 0.0, 2.0 * M_PI);
        for (const Pixel corner : marker_corners(marker)) cairo_line_to(cairo_, corner.x, corner.y);
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
            const double size = (is_script ? script_size : 1.0) * label.size_px;
            if (is_shown) {
                cairo_move_to(cairo_, start, label.position.y + (run.shift + baseline_drop) * label.size_px);
                for_each_stretch(cairo_, run.text, size, label.font,
                                 [&](const std::string& stretch) { cairo_show_text(cairo_, stretch.c_str()); });
            }
            end = std::max(end, start + advance_of(cairo_, run.text, size, label.font));
        }
        return end - left;
    }

    cairo_t* cairo_;
};

void paint(cairo_t* cairo, const FigurePart& part) {
    const glm::dvec2 size = part.box.upper_px - part.box.lower_px;
    cairo_save(cairo);
    cairo_translate(cairo, part.box.lower_px.x, part.box.lower_px.y);
    cairo_rectangle(cairo, 0.0, 0.0, size.x, size.y);
    cairo_clip(cairo);
    const Painter painter(cairo);
    if (part.ground) painter.cover(*part.ground);
    for (const DrawCommand& command : set_list(part).commands) std::visit(painter, command);
    cairo_restore(cairo);
}

/// What is wrong with them, if anything is.
std::optional<std::string> problem_of(cairo_t* cairo, cairo_surface_t* surface) {
    for (const cairo_status_t status : {cairo_status(cairo), cairo_surface_status(surface)})
        if (status != CAIRO_STATUS_SUCCESS) return cairo_status_to_string(status);
    return std::nullopt;
}

/// Paints the figure on a surface, `scale` of its units for each pixel of the figure.
std::optional<std::string> paint(cairo_surface_t* surface, const Figure& figure, double scale) {
    const Context cairo(cairo_create(surface));
    cairo_scale(cairo.get(), scale, scale);
    // Letters stand where a window of any scale has them.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(cairo.get(), options);
    cairo_font_options_destroy(options);
    for (const FigurePart& part : figure.parts) paint(cairo.get(), part);
    return problem_of(cairo.get(), surface);
}

FigureBytes png_bytes(cairo_surface_t* surface) {
    std::string bytes;
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append, &bytes);
    if (status != CAIRO_STATUS_SUCCESS) return tl::unexpected(std::string(cairo_status_to_string(status)));
    return bytes;
}

}  // namespace

FigureBytes pdf_bytes(const Figure& figure) {
    constexpr double points_per_px = 0.75;
    std::string bytes;
    const glm::dvec2 size = points_per_px * figure.size_px;
    const Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, size.x, size.y));
    if (!figure.title.empty())
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, figure.title.c_str());
    if (auto problem = paint(surface.get(), figure, points_per_px)) return tl::unexpected(*std::move(problem));
    cairo_surface_finish(surface.get());
    const cairo_status_t status = cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS) return tl::unexpected(std::string(cairo_status_to_string(status)));
    return bytes;
}

FigureBytes png_bytes(const Figure& figure) {
    constexpr double rounding_px = 1e-6;
    const auto whole = [](double side) { return static_cast<int>(std::max(1.0, std::ceil(side - rounding_px))); };
    const Surface surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, whole(figure.size_px.x), whole(figure.size_px.y)));
    if (auto problem = paint(surface.get(), figure, 1.0)) return tl::unexpected(*std::move(problem));
    return png_bytes(surface.get());
}

FigureBytes png_bytes(const Ink& ink) {
    const PixelRange range = ink.map->touched();
    const glm::ivec2 size = range.is_empty() ? glm::ivec2(1) : range.upper - range.lower;
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.x, size.y));
    const Context cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -range.lower.x, -range.lower.y);
    Painter{cairo.get()}(ink);
    if (auto problem = problem_of(cairo.get(), surface.get())) return tl::unexpected(*std::move(problem));
    return png_bytes(surface.get());
}

FigureBytes png_bytes(const Image& image) {
    return png_bytes(surface_of(image).get());
}

double text_width(std::string_view text, double size_px, LabelFont font) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
    const Context cairo(cairo_create(surface.get()));
    return advance_of(cairo.get(), text, size_px, font);
}

std::vector<std::string> letters_without_font(std::string_view label) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
    const Context cairo(cairo_create(surface.get()));
    std::vector<std::string> letters;
    for_each_stretch(cairo.get(), label, 1.0, LabelFont::text, [&](std::string_view stretch) {
        for (; !stretch.empty(); stretch.remove_prefix(first_sign(stretch).size()))
            if (!has_glyph(cairo.get(), first_sign(stretch))) letters.emplace_back(first_sign(stretch));
    });
    return letters;
}

}  // namespace batten::render
