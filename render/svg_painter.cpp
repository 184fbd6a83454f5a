#include "render/svg_painter.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/cairo_painter.h"
#include "render/label_runs.h"
#include "render/lean_path.h"
#include "render/prose.h"
#include "render/xml_text.h"

namespace batten::render {

namespace {

constexpr double full_opacity = 255.0;

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::string_view three = bytes.substr(i, 3);
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= three.size() ? digits[bits >> (18U - 6U * k) & 63U] : '=';
    }
    return text;
}

/// fill="#4c7fe0" fill-opacity="0.5", for `role` fill or stroke.
std::string paint_of(std::string_view role, Color color) {
    if (color.alpha == 0) return fmt::format(" {}=\"none\"", role);
    std::string text = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", role, color.red, color.green, color.blue);
    if (color.alpha < full_opacity) text += fmt::format(" {}-opacity=\"{:.3g}\"", role, color.alpha / full_opacity);
    return text;
}

std::string data_of(const std::vector<Pixel>& points, bool is_closed) {
    std::string data;
    for (std::size_t i = 0; i < points.size(); ++i) {
        data += i == 0 ? 'M' : i == 1 ? 'L' : ' ';
        data += short_place(points[i]);
    }
    // A line of one point is a dot, which its caps make.
    const char* end = points.size() == 1 ? "h0" : "";
    return fmt::format("{}{}{}", data, end, is_closed ? "Z" : "");
}

std::string dashes_of(double dash, double gap) {
    return dash > 0.0 ? fmt::format(" stroke-dasharray=\"{} {}\"", short_number(dash), short_number(gap)) : "";
}

const char* anchor_of(Anchor anchor) {
    switch (anchor) {
        case Anchor::left:
            return "";
        case Anchor::center:
            return " text-anchor=\"middle\"";
        case Anchor::right:
            break;
    }
    return " text-anchor=\"end\"";
}

const char* font_of(LabelFont font) {
    switch (font) {
        case LabelFont::text:
            return "";
        case LabelFont::bold:
            return " font-weight=\"bold\"";
        case LabelFont::number:
            break;
    }
    return " font-family=\"'JetBrains Mono', 'DejaVu Sans Mono', monospace\"";
}

/// Writes one element for each command.
class SvgPainter {
  public:
    explicit SvgPainter(std::string& text) : text_(text) {}

    void operator()(const Polyline& line) {
        const std::vector<Pixel> points = lean_points(line.points);
        if (points.empty() || line.color.alpha == 0) return;
        add("<path d=\"{}\" fill=\"none\"{} stroke-width=\"{}\" stroke-linejoin=\"round\" stroke-linecap=\"{}\"{}/>\n",
            data_of(points, line.is_closed), paint_of("stroke", line.color), short_number(line.width_px),
            line.dash_px > 0.0F ? "butt" : "round", dashes_of(line.dash_px, line.gap_px));
    }

    void operator()(const Fill& fill) {
        if (fill.points.size() < 3 || fill.color.alpha == 0) return;
        add("<path d=\"{}\"{}/>\n", data_of(lean_points(fill.points), true), paint_of("fill", fill.color));
    }

    void operator()(const Region& region) {
        std::string data;
        for (const std::vector<Pixel>& loop : region.loops->loops)
            if (!loop.empty()) data += data_of(lean_points(loop), true);
        const bool is_even_odd = region.loops->rule == FillRule::even_odd;
        add("<path d=\"{}\"{}{}/>\n", data, paint_of("fill", region.color),
            is_even_odd ? " fill-rule=\"evenodd\"" : "");
    }

    void operator()(const Ink& ink) {
        const PixelRange range = ink.map->touched();
        const FigureBytes png = png_bytes(ink);
        if (range.is_empty() || !png) return;
        add("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" xlink:href=\"data:image/png;base64,{}\"/>\n",
            range.lower.x, range.lower.y, range.upper.x - range.lower.x, range.upper.y - range.lower.y, base64(*png));
    }

    void operator()(const ImageQuad& quad) {
        const Image image = embedded(*quad.image);
        const FigureBytes png = png_bytes(image);
        if (!png) return;
        const glm::dvec2 right = (quad.upper_right - quad.upper_left) / static_cast<double>(image.width);
        const glm::dvec2 down = (quad.lower_left - quad.upper_left) / static_cast<double>(image.height);
        add("<image width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" opacity=\"{:.3g}\" "
            "transform=\"matrix({:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g})\" "
            "xlink:href=\"data:image/png;base64,{}\"/>\n",
            image.width, image.height, quad.opacity, right.x, right.y, down.x, down.y, quad.upper_left.x,
            quad.upper_left.y, base64(*png));
    }

    void operator()(const Marker& marker) {
        const bool has_outline = marker.outline.alpha > 0 && marker.outline_px > 0.0F;
        if (marker.fill.alpha == 0 && !has_outline) return;
        std::string style = paint_of("fill", marker.fill);
        if (has_outline)
            style += fmt::format("{} stroke-width=\"{}\"{}", paint_of("stroke", marker.outline),
                                 short_number(marker.outline_px), dashes_of(marker.dash_px, marker.dash_px));
        if (marker.shape == MarkerShape::disc)
            add("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", short_number(marker.center.x),
                short_number(marker.center.y), short_number(marker.radius_px), style);
        else
            add("<path d=\"{}\"{}/>\n", data_of(marker_corners(marker), true), style);
    }

    void operator()(const Label& label) {
        const double y = label.position.y + baseline_drop * label.size_px;
        add(R"(<text x="{}" y="{}" font-size="{}"{}{}{}>)", short_number(label.position.x), short_number(y),
            short_number(label.size_px), paint_of("fill", label.color), anchor_of(label.anchor), font_of(label.font));
        Line line;
        for (const LabelRun& run : label_runs(label.text)) write(label, run, line);
        add("</text>\n");
    }

  private:
    template <typename... Values>
    void add(fmt::format_string<Values...> pattern, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), pattern, std::forward<Values>(values)...);
    }

    /// How far below the line of the letters the last run stands, how wide it is where it is a script, and how far the
    /// next one is moved to the right.
    struct Line {
        double shift = 0.0;
        double script_width = 0.0;
        double lead = 0.0;
    };

    void write(const Label& label, const LabelRun& run, Line& line) {
        const bool is_script = run.script != Script::none;
        const double size = (is_script ? script_size : 1.0) * label.size_px;
        const double width = is_script ? text_width(run.text, size, label.font) : 0.0;
        if (run.is_stacked) line.lead -= line.script_width;
        write_run(run, {.shift = (run.shift - line.shift) * label.size_px, .script_width = 0.0, .lead = line.lead},
                  size);
        // What follows two scripts begins behind the wider one.
        line = {run.shift, width, run.is_stacked ? std::max(0.0, line.script_width - width) : 0.0};
    }

    void write_run(const LabelRun& run, const Line& moved, double size) {
        const std::string text = xml_text(run.text);
        if (run.script == Script::none && moved.shift == 0.0 && moved.lead == 0.0) {
            text_ += text;
            return;
        }
        add("<tspan");
        if (moved.lead != 0.0) add(" dx=\"{}\"", short_number(moved.lead));
        if (moved.shift != 0.0) add(" dy=\"{}\"", short_number(moved.shift));
        if (run.script != Script::none) add(" font-size=\"{}\"", short_number(size));
        add(">{}</tspan>", text);
    }

    std::string& text_;
};

void write_part(std::string& text, const FigurePart& part) {
    const glm::dvec2 size = part.box.upper_px - part.box.lower_px;
    // An SVG within another is cut to its box.
    fmt::format_to(std::back_inserter(text), "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n",
                   short_number(part.box.lower_px.x), short_number(part.box.lower_px.y), short_number(size.x),
                   short_number(size.y));
    if (part.ground)
        fmt::format_to(std::back_inserter(text), "<rect width=\"100%\" height=\"100%\"{}/>\n",
                       paint_of("fill", *part.ground));
    SvgPainter painter(text);
    for (const DrawCommand& command : set_list(part).commands) std::visit(painter, command);
    fmt::format_to(std::back_inserter(text), "</svg>\n");
}

}  // namespace

std::string svg_text(const Figure& figure) {
    const std::string width = short_number(figure.size_px.x);
    const std::string height = short_number(figure.size_px.y);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{}\" "
        "height=\"{}\" "
        "viewBox=\"0 0 {} {}\" font-family=\"Inter, 'DejaVu Sans', sans-serif\" xml:space=\"preserve\">\n",
        width, height, width, height);
    if (!figure.title.empty()) text += fmt::format("<title>{}</title>\n", xml_text(figure.title));
    for (const FigurePart& part : figure.parts) write_part(text, part);
    fmt::format_to(std::back_inserter(text), "</svg>\n");
    return text;
}

}  // namespace batten::render
