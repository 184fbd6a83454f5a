#include "exchange/svg/path_data.h"

#include <array>
#include <cctype>
#include <utility>

#include "exchange/svg/arc.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::Point;
using core::Vector;

class PathReader {
  public:
    PathReader(std::string_view text, const core::PlaneMap& map, const OutlineSink& sink)
        : scanner_(text), map_(map), sink_(sink) {}

    std::optional<std::size_t> read() {
        const bool is_right = run_commands();
        const std::size_t place = scanner_.place();
        finish();
        return is_right ? std::nullopt : std::optional(place);
    }

  private:
    // False where the text goes wrong.
    bool run_commands() {
        scanner_.skip_blanks();
        while (is_wanted_ && !scanner_.is_at_end()) {
            const char command = scanner_.next();
            const bool is_move = command == 'M' || command == 'm';
            if (!has_begun_ && !is_move) return false;
            if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(command) == std::string_view::npos) return false;
            scanner_.skip();
            scanner_.skip_blanks();
            if (!run_all(command)) return false;
            scanner_.skip_blanks();
        }
        return true;
    }

    // The command with all of its arguments; false where they go wrong.
    bool run_all(char command) {
        is_relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
        char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
        if (kind == 'Z') {
            close();
            return true;
        }
        do {
            if (!run(kind)) return false;
            if (kind == 'M') kind = 'L';
            last_kind_ = kind;
            if (!is_wanted_) return true;
        } while (has_more_arguments());
        return true;
    }

    // A comma promises another argument.
    bool has_more_arguments() {
        scanner_.skip_blanks();
        if (scanner_.skip_if(',')) {
            scanner_.skip_blanks();
            return true;
        }
        const char next = scanner_.next();
        return std::isdigit(static_cast<unsigned char>(next)) != 0 || next == '+' || next == '-' || next == '.';
    }

    bool run(char kind) {
        switch (kind) {
            case 'M':
                return move();
            case 'L':
                return line();
            case 'H':
                return horizontal();
            case 'V':
                return vertical();
            case 'C':
                return cubic();
            case 'S':
                return smooth_cubic();
            case 'Q':
                return quadratic();
            case 'T':
                return smooth_quadratic();
            default:
                return arc();
        }
    }

    // Reads `count` numbers or none.
    template <std::size_t count>
    std::optional<std::array<double, count>> numbers() {
        std::array<double, count> values{};
        for (std::size_t i = 0; i < count; ++i) {
            if (i != 0) scanner_.skip_separator();
            const auto value = scanner_.number();
            if (!value) return std::nullopt;
            values[i] = *value;
        }
        return values;
    }

    template <std::size_t count>
    std::optional<std::array<Point, count>> points() {
        const auto values = numbers<2 * count>();
        if (!values) return std::nullopt;
        std::array<Point, count> points{};
        for (std::size_t i = 0; i < count; ++i) points[i] = placed((*values)[2 * i], (*values)[2 * i + 1]);
        return points;
    }

    Point placed(double x, double y) const { return is_relative_ ? current_ + Vector(x, y) : Point(x, y); }

    bool move() {
        const auto target = points<1>();
        if (!target) return false;
        finish();
        current_ = start_ = (*target)[0];
        has_begun_ = true;
        return true;
    }

    bool line() {
        const auto target = points<1>();
        if (target) line_to((*target)[0]);
        return target.has_value();
    }

    bool horizontal() {
        const auto value = numbers<1>();
        if (value) line_to({is_relative_ ? current_.x + (*value)[0] : (*value)[0], current_.y});
        return value.has_value();
    }

    bool vertical() {
        const auto value = numbers<1>();
        if (value) line_to({current_.x, is_relative_ ? current_.y + (*value)[0] : (*value)[0]});
        return value.has_value();
    }

    bool cubic() {
        const auto p = points<3>();
        if (p) cubic_to((*p)[0], (*p)[1], (*p)[2]);
        return p.has_value();
    }

    bool smooth_cubic() {
        const auto p = points<2>();
        if (p) cubic_to(reflected('C', 'S'), (*p)[0], (*p)[1]);
        return p.has_value();
    }

    bool quadratic() {
        const auto p = points<2>();
        if (p) quadratic_to((*p)[0], (*p)[1]);
        return p.has_value();
    }

    bool smooth_quadratic() {
        const auto p = points<1>();
        if (p) quadratic_to(reflected('Q', 'T'), (*p)[0]);
        return p.has_value();
    }

    // A flag is one digit, which what follows may be written against.
    std::optional<bool> flag() {
        scanner_.skip_separator();
        if (scanner_.skip_if('1')) return true;
        if (scanner_.skip_if('0')) return false;
        return std::nullopt;
    }

    bool arc() {
        const auto shape = numbers<3>();
        if (!shape) return false;
        const auto is_large = flag();
        if (!is_large) return false;
        const auto is_positive = flag();
        if (!is_positive) return false;
        scanner_.skip_separator();
        const auto target = points<1>();
        if (!target) return false;
        const Point end = (*target)[0];
        const auto pieces =
            conic_pieces({current_, (*shape)[0], (*shape)[1], (*shape)[2], *is_large, *is_positive, end});
        if (pieces.empty()) line_to(end);
        for (const ConicPiece& piece : pieces)
            outline().conic_to(mapped(piece.corner), piece.weight, mapped(piece.end));
        current_ = end;
        return true;
    }

    Point mapped(Point point) const { return core::mapped(map_, point); }

    // After a closed subpath the next one begins where that began.
    Outline& outline() {
        if (!outline_) outline_.emplace(mapped(current_));
        return *outline_;
    }

    // The last handle seen from the other side, where the command before had one of the same degree.
    Point reflected(char kind, char smooth_kind) const {
        return last_kind_ == kind || last_kind_ == smooth_kind ? current_ + (current_ - handle_) : current_;
    }

    void line_to(Point end) {
        outline().line_to(mapped(end));
        current_ = end;
    }

    void quadratic_to(Point corner, Point end) {
        outline().quadratic_to(mapped(corner), mapped(end));
        handle_ = corner;
        current_ = end;
    }

    void cubic_to(Point first, Point second, Point end) {
        outline().cubic_to(mapped(first), mapped(second), mapped(end));
        handle_ = second;
        current_ = end;
    }

    void close() {
        if (outline_) outline_->close();
        finish();
        current_ = start_;
        last_kind_ = 'Z';
    }

    void finish() {
        if (outline_ && !outline_->is_empty() && is_wanted_) is_wanted_ = sink_(*std::move(outline_));
        outline_.reset();
    }

    Scanner scanner_;
    const core::PlaneMap& map_;
    const OutlineSink& sink_;
    std::optional<Outline> outline_;
    Point start_{0.0, 0.0};
    Point current_{0.0, 0.0};
    Point handle_{0.0, 0.0};
    char last_kind_ = 'Z';
    bool is_relative_ = false;
    bool has_begun_ = false;
    bool is_wanted_ = true;
};

}  // namespace

std::optional<std::size_t> read_path_data(std::string_view text, const core::PlaneMap& map, const OutlineSink& sink) {
    return PathReader(text, map, sink).read();
}

}  // namespace batten::exchange
