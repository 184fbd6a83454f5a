#include <fmt/format.h>

#include "core/base/number_text.h"
#include "exchange/code/languages.h"

namespace batten::exchange {

namespace {

constexpr const char* letters = "MLQC";
constexpr const char* closing = " Z";

// Downward; 0 has no sign, which would say nothing in a picture.
void append_svg_point(std::string& text, core::Point point) {
    text += ' ';
    core::append_shortest_text(text, point.x + 0.0);
    text += ' ';
    core::append_shortest_text(text, 0.0 - point.y);
}

}  // namespace

std::string svg_path_text(const CubicPieces& pieces) {
    std::string text;
    for (const CubicPiece& piece : pieces.pieces) {
        if (piece.is_first) {
            text += text.empty() ? "M" : " M";
            append_svg_point(text, piece.points.front());
        }
        text += ' ';
        text += letters[piece.degree];
        for (const core::Point& point : piece.control_points().subspan(1)) append_svg_point(text, point);
    }
    if (pieces.is_closed) text += closing;
    return text;
}

}  // namespace batten::exchange
