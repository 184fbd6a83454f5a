#include "exchange/svg/path_text.h"

#include <array>

#include "core/base/number_text.h"

namespace batten::exchange {

namespace {

// 0 has no sign, which would say nothing in a picture.
void append_number(std::string& text, double value) {
    text += ' ';
    core::append_shortest_text(text, value + 0.0);
}

void append_point(std::string& text, core::Point point) {
    append_number(text, point.x);
    append_number(text, 0.0 - point.y);
}

void append_piece(std::string& text, const PathPiece& piece) {
    constexpr std::array<char, 4> letters{'A', 'L', 'Q', 'C'};
    text += letters[static_cast<std::size_t>(piece.degree)];
    if (piece.degree == 0) {
        append_number(text, piece.radius);
        append_number(text, piece.radius);
        // Counterclockwise with y upward is negative with y downward.
        text += piece.is_counterclockwise ? " 0 0 0" : " 0 0 1";
    }
    for (const core::Point point : piece.control_points().subspan(1)) append_point(text, point);
}

}  // namespace

std::string path_text(const PathPieces& pieces) {
    constexpr const char* closing = " Z";
    std::string text;
    for (const PathPiece& piece : pieces.pieces) {
        if (piece.is_first) {
            text += text.empty() ? "M" : " M";
            append_point(text, piece.start());
        }
        text += ' ';
        append_piece(text, piece);
        if (piece.closes) text += closing;
    }
    return text;
}

}  // namespace batten::exchange
