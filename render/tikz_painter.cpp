#include "render/tikz_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "render/label_runs.h"
#include "render/lean_path.h"
#include "render/tex_definitions.h"
#include "render/tex_text.h"

namespace batten::render {

namespace {

constexpr double bp_per_px = 0.75;     // bp is 1/72 of an inch
constexpr double usual_label_bp = 10;  // of the font of a document
constexpr double opaque_alpha = 255.0;
constexpr std::uint8_t dark_ink = 128;
constexpr std::size_t places_a_line = 6;

std::string length_of(double px) {
    return fmt::format("{}bp", short_number(bp_per_px * px));
}

/// The colors of a figure by numbers, in the order in which they come.
class Palette {
  public:
    std::string name(Color color) {
        color.alpha = static_cast<std::uint8_t>(opaque_alpha);
        const auto found = std::ranges::find(colors_, color);
        const auto index = found - colors_.begin();
        if (found == colors_.end()) colors_.push_back(color);
        return fmt::format("batten{}", index);
    }

    std::string definitions() const {
        std::string text;
        for (std::size_t i = 0; i < colors_.size(); ++i)
            text += fmt::format("\\definecolor{{batten{}}}{{RGB}}{{{},{},{}}}\n", i, colors_[i].red, colors_[i].green,
                                colors_[i].blue);
        return text;
    }

  private:
    std::vector<Color> colors_;
};

std::string path_of(const std::vector<Pixel>& points, bool is_closed) {
    std::string path;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) path += i % places_a_line == 0 ? "\n--" : "--";
        path += fmt::format("({})", short_place(points[i], ','));
    }
    return fmt::format("{}{}", path, is_closed ? "--cycle" : "");
}

const char* side_of(Anchor anchor) {
    switch (anchor) {
        case Anchor::left:
            return "base west";
        case Anchor::center:
            return "base";
        case Anchor::right:
            break;
    }
    return "base east";
}

/// Writes one command of TikZ for each.
class TikzPainter {
  public:
    TikzPainter(std::string& text, Palette& palette, bool is_prose)
        : text_(text), palette_(palette), is_prose_(is_prose) {}

    void operator()(const Polyline& line) {
        std::vector<Pixel> points = lean_points(line.points);
        if (points.empty() || line.color.alpha == 0) return;
        if (points.size() == 1) points.push_back(points.front());
        const std::string style =
            fmt::format("{},line join=round{}", stroke_of(line.color, line.width_px),
                        line.dash_px > 0.0F ? dashes_of(line.dash_px, line.gap_px) : ",line cap=round");
        add("\\draw[{}] {};\n", style, path_of(points, line.is_closed));
    }

    void operator()(const Fill& fill) {
        if (fill.points.size() < 3 || fill.color.alpha == 0) return;
        add("\\fill[{}] {};\n", fill_of(fill.color), path_of(lean_points(fill.points), true));
    }

    void operator()(const Region& region) {
        std::string path;
        for (const std::vector<Pixel>& loop : region.loops->loops)
            if (!loop.empty()) path += path_of(lean_points(loop), true) + '\n';
        const bool is_even_odd = region.loops->rule == FillRule::even_odd;
        if (!path.empty())
            add("\\fill[{},{}] {};\n", fill_of(region.color), is_even_odd ? "even odd rule" : "nonzero rule", path);
    }

    /// The pixels that are at least half covered, row by row: TikZ has no pictures of pixels.
    void operator()(const Ink& ink) {
        const PixelRange range = ink.map->touched();
        for (int y = range.lower.y; y < range.upper.y; ++y) {
            const std::string row = dark_parts(*ink.map, range, y);
            if (!row.empty()) add("\\fill[{}] {};\n", fill_of(ink.color), row);
        }
    }

    void operator()(const ImageQuad&) { add("% An image is left out: TikZ has none.\n"); }

    void operator()(const Marker& marker) {
        const bool has_outline = marker.outline.alpha > 0 && marker.outline_px > 0.0F;
        if (marker.fill.alpha == 0 && !has_outline) return;
        std::string style = marker.fill.alpha > 0 ? fill_of(marker.fill) + ',' : "";
        if (has_outline) style += stroke_of(marker.outline, marker.outline_px);
        if (has_outline && marker.dash_px > 0.0F) style += dashes_of(marker.dash_px, marker.dash_px);
        if (marker.shape == MarkerShape::disc)
            add("\\path[{}] ({}) circle[radius={}];\n", style, short_place(marker.center, ','),
                short_number(marker.radius_px));
        else
            add("\\path[{}] {};\n", style, path_of(marker_corners(marker), true));
    }

    /// As `command` says, with a name for `next` where that goes on a label.
    void paint(const DrawCommand& command, const DrawCommand* next) {
        const auto* label = next == nullptr ? nullptr : std::get_if<Label>(next);
        goes_on_ = is_gone_on_;
        is_gone_on_ = std::holds_alternative<Label>(command) && label != nullptr && label->gap_px > 0.0F;
        std::visit(*this, command);
    }

    void operator()(const Label& label) {
        const std::string text = is_prose_ ? tex_prose(label.text) : tex_text(label.text);
        // Bold formulas need a group of their own within a node.
        const bool is_bold = label.font == LabelFont::bold;
        add("\\node[anchor={},inner sep=0pt,text={}{},scale={}]{} at ({}) {{{}}};\n", side_of(label.anchor),
            palette_.name(label.color), opacity_of("text", label.color),
            short_number(bp_per_px * label.size_px / usual_label_bp), is_gone_on_ ? " (battenword)" : "",
            place_of(label), is_bold ? fmt::format("{{\\bfseries\\boldmath {}}}", text) : text);
    }

  private:
    template <typename... Values>
    void add(fmt::format_string<Values...> pattern, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), pattern, std::forward<Values>(values)...);
    }

    /// Behind the label before, as wide as the fonts of the paper make that.
    std::string place_of(const Label& label) const {
        if (goes_on_ && label.anchor == Anchor::left)
            return fmt::format("[xshift={}]battenword.base east", length_of(label.gap_px));
        if (goes_on_ && label.anchor == Anchor::right)
            return fmt::format("[xshift={}]battenword.base west", length_of(-label.gap_px));
        return short_place({label.position.x, label.position.y + baseline_drop * label.size_px}, ',');
    }

    static std::string dark_parts(const CoverageMap& map, const PixelRange& range, int y) {
        std::string row;
        std::size_t parts = 0;
        for (int x = range.lower.x; x < range.upper.x; ++x) {
            const int first = x;
            while (x < range.upper.x && map.coverage({x, y}) >= dark_ink) ++x;
            if (x == first) continue;
            row += fmt::format("({},{})rectangle({},{})", first, y, x, y + 1);
            if (++parts % places_a_line == 0) row += '\n';
        }
        return row;
    }

    static std::string opacity_of(std::string_view role, Color color) {
        return color.alpha < opaque_alpha ? fmt::format(",{} opacity={:.3g}", role, color.alpha / opaque_alpha) : "";
    }

    static std::string dashes_of(double dash, double gap) {
        return fmt::format(",dash pattern=on {} off {}", length_of(dash), length_of(gap));
    }

    std::string fill_of(Color color) {
        return fmt::format("fill={}{}", palette_.name(color), opacity_of("fill", color));
    }

    std::string stroke_of(Color color, double width_px) {
        return fmt::format("draw={}{},line width={}", palette_.name(color), opacity_of("draw", color),
                           length_of(width_px));
    }

    std::string& text_;
    Palette& palette_;
    bool is_prose_;
    bool goes_on_ = false;     ///< the label before has a name
    bool is_gone_on_ = false;  ///< this one needs one
};

std::string part_text(Palette& palette, const FigurePart& part) {
    const std::string corner = short_place(part.box.upper_px - part.box.lower_px, ',');
    std::string text = fmt::format("\\begin{{scope}}[shift={{({})}}]\n\\clip (0,0) rectangle ({});\n",
                                   short_place(part.box.lower_px, ','), corner);
    if (part.ground) text += fmt::format("\\fill[{}] (0,0) rectangle ({});\n", palette.name(*part.ground), corner);
    TikzPainter painter(text, palette, part.is_prose);
    const std::vector<DrawCommand>& commands = part.list.commands;
    for (std::size_t i = 0; i < commands.size(); ++i)
        painter.paint(commands[i], i + 1 < commands.size() ? &commands[i + 1] : nullptr);
    fmt::format_to(std::back_inserter(text), "\\end{{scope}}\n");
    return text;
}

}  // namespace

std::string tikz_text(const Figure& figure) {
    Palette palette;
    std::string parts;
    for (const FigurePart& part : figure.parts) parts += part_text(palette, part);
    return fmt::format(
        "% Needs \\usepackage{{tikz}}.\n{}\\begin{{tikzpicture}}[x=0.75bp,y=-0.75bp]\n{}"
        "\\useasboundingbox (0,0) rectangle ({});\n{}\\end{{tikzpicture}}\n",
        tex_definitions(parts), palette.definitions(), short_place(figure.size_px, ','), parts);
}

}  // namespace batten::render
