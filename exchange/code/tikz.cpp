#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "exchange/code/languages.h"

namespace batten::exchange {

namespace {

// In centimeters: what TeX can hold is 575.
constexpr double farthest = 500.0;
constexpr double smallest_side = 0.01;
constexpr double new_side = 10.0;

constexpr const char* end_of_path = ";\n";

// Where places of the plane are in the drawing.
struct Placing {
    core::Point middle{0.0, 0.0};
    double scale = 1.0;

    bool is_same() const { return scale == 1.0 && middle == core::Point(0.0, 0.0); }
    core::Point operator()(core::Point point) const {
        return is_same() ? point : core::tip_of(scale * (point - middle));
    }
};

Placing placing_of(const core::Curve& curve) {
    const core::Box box = core::control_box(curve);
    const double most =
        std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x), std::abs(box.upper.y)});
    const double side = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
    if (most <= farthest && (side >= smallest_side || side == 0.0)) return {};
    return {core::middle(box.lower, box.upper), side > 0.0 ? std::min(new_side / side, 1e300) : 1.0};
}

// TeX knows no exponents; digits beyond its own precision are dropped by it.
std::string decimal_text(double value) {
    std::array<char, 400> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0, std::chars_format::fixed);
    return {digits.data(), end.ptr};
}

std::string tikz_point(core::Point point) {
    return fmt::format("({},{})", decimal_text(point.x), decimal_text(point.y));
}

// TikZ has no quadratic pieces.
std::array<core::Point, 2> handles_of(const PathPiece& piece) {
    const auto& p = piece.points;
    if (piece.degree == 3) return {p[1], p[2]};
    return {p[0] + 2.0 / 3.0 * (p[1] - p[0]), p[2] + 2.0 / 3.0 * (p[1] - p[2])};
}

std::string step_text(const PathPiece& piece, const Placing& placing) {
    const std::string end = piece.closes ? "cycle" : tikz_point(placing(piece.end()));
    if (piece.degree == 1) return fmt::format("\n  -- {}", end);
    const auto handles = handles_of(piece);
    return fmt::format("\n  .. controls {} and {} .. {}", tikz_point(placing(handles[0])),
                       tikz_point(placing(handles[1])), end);
}

std::string path_of(const PathPieces& pieces, const Placing& placing) {
    std::string text;
    for (const PathPiece& piece : pieces.pieces) {
        if (piece.is_first) text += (text.empty() ? "\\draw " : "\n  ") + tikz_point(placing(piece.start()));
        text += step_text(piece, placing);
    }
    text += end_of_path;
    return text;
}

std::string placing_comment(const Placing& placing) {
    return core::sentence("% Moved so that ({x}, {y}) is at (0, 0), and multiplied by {scale}.\n",
                          {{"x", core::shortest_text(placing.middle.x)},
                           {"y", core::shortest_text(placing.middle.y)},
                           {"scale", core::shortest_text(placing.scale)}});
}

}  // namespace

std::string tikz_text(const core::DocumentCurve& entry, const PathPieces& pieces) {
    const Placing placing = placing_of(*entry.curve);
    std::string text = core::sentence("% {heading}\n", {{"heading", heading(entry)}});
    if (pieces.error > 0.0)
        text += core::sentence("% Cubics that are nowhere farther than {error} from it.\n",
                               {{"error", core::shortest_text(pieces.error)}});
    if (!placing.is_same()) text += placing_comment(placing);
    return text + path_of(pieces, placing);
}

}  // namespace batten::exchange
