#include "exchange/svg/path_data.h"

#include <array>
#include <cctype>
#include <utility>

#include "exchange/svg/arc.h"
#include "exchange/svg/decimal.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::DoubleDouble;
using core::Point;
using core::Vector;

// A point, and what it lacks by rounding of the one that the numbers of the file mean, which arcs that are nearly half
// of an ellipse magnify.
struct RoundedPoint {
    Point point{0.0, 0.0};
    Vector rest{0.0, 0.0};
};

class PathReader {
  public:
    PathReader(std::string_view text, const core::PlaneMap& map, const OutlineSink& sink)
        : text_(text),
          scanner_(text),
          map_(map),
          sink_(sink),
          is_precise_(text.find_first_of("Aa") != std::string_view::npos) {}

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

    std::optional<DoubleDouble> number() {
        const std::size_t start = scanner_.place();
        const auto value = scanner_.number();
        if (!value) return std::nullopt;
        if (!is_precise_) return *value;
        return precise_decimal(text_.substr(start, scanner_.place() - start), *value);
    }

    // Reads `count` numbers or none.
    template <std::size_t count>
    std::optional<std::array<DoubleDouble, count>> numbers() {
        std::array<DoubleDouble, count> values{};
        for (std::size_t i = 0; i < count; ++i) {
            if (i != 0) scanner_.skip_separator();
            const auto value = number();
            if (!value) return std::nullopt;
            values[i] = *value;
        }
        return values;
    }

    template <std::size_t count>
    std::optional<std::array<RoundedPoint, count>> points() {
        const auto values = numbers<2 * count>();
        if (!values) return std::nullopt;
        std::array<RoundedPoint, count> points{};
        for (std::size_t i = 0; i < count; ++i)
            points[i] = {{placed(current_.point.x, (*values)[2 * i]), placed(current_.point.y, (*values)[2 * i + 1])},
                         {rest_of(current_.point.x, current_.rest.x, (*values)[2 * i]),
                          rest_of(current_.point.y, current_.rest.y, (*values)[2 * i + 1])}};
        return points;
    }

    double placed(double current, DoubleDouble value) const { return is_relative_ ? current + value.high : value.high; }

    // What `placed` lacks.
    double rest_of(double current, double rest, DoubleDouble value) const {
        return is_relative_ ? core::exact_sum(current, value.high).low + rest + value.low : value.low;
    }

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
        if (!value) return false;
        RoundedPoint end = current_;
        end.point.x = placed(current_.point.x, (*value)[0]);
        end.rest.x = rest_of(current_.point.x, current_.rest.x, (*value)[0]);
        line_to(end);
        return true;
    }

    bool vertical() {
        const auto value = numbers<1>();
        if (!value) return false;
        RoundedPoint end = current_;
        end.point.y = placed(current_.point.y, (*value)[0]);
        end.rest.y = rest_of(current_.point.y, current_.rest.y, (*value)[0]);
        line_to(end);
        return true;
    }

    bool cubic() {
        const auto p = points<3>();
        if (p) cubic_to((*p)[0].point, (*p)[1].point, (*p)[2]);
        return p.has_value();
    }

    bool smooth_cubic() {
        const auto p = points<2>();
        if (p) cubic_to(reflected('C', 'S'), (*p)[0].point, (*p)[1]);
        return p.has_value();
    }

    bool quadratic() {
        const auto p = points<2>();
        if (p) quadratic_to((*p)[0].point, (*p)[1]);
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
        const RoundedPoint end = (*target)[0];
        const auto pieces = conic_pieces({.from = current_.point,
                                          .first_radius = (*shape)[0],
                                          .second_radius = (*shape)[1],
                                          .rotation = (*shape)[2],
                                          .is_large = *is_large,
                                          .is_positive = *is_positive,
                                          .to = end.point,
                                          .rest = end.rest - current_.rest});
        if (pieces.empty()) line_to(end);
        for (const ConicPiece& piece : pieces)
            outline().conic_to(mapped(piece.corner), piece.weight, mapped(piece.end));
        current_ = end;
        return true;
    }

    Point mapped(Point point) const { return core::mapped(map_, point); }

    // After a closed subpath the next one begins where that began.
    Outline& outline() {
        if (!outline_) outline_.emplace(mapped(current_.point));
        return *outline_;
    }

    // The last handle seen from the other side, where the command before had one of the same degree.
    Point reflected(char kind, char smooth_kind) const {
        return last_kind_ == kind || last_kind_ == smooth_kind ? current_.point + (current_.point - handle_)
                                                               : current_.point;
    }

    void line_to(const RoundedPoint& end) {
        outline().line_to(mapped(end.point));
        current_ = end;
    }

    void quadratic_to(Point corner, const RoundedPoint& end) {
        outline().quadratic_to(mapped(corner), mapped(end.point));
        handle_ = corner;
        current_ = end;
    }

    void cubic_to(Point first, Point second, const RoundedPoint& end) {
        outline().cubic_to(mapped(first), mapped(second), mapped(end.point));
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

    const std::string_view text_;
    Scanner scanner_;
    const core::PlaneMap& map_;
    const OutlineSink& sink_;
    const bool is_precise_;
    std::optional<Outline> outline_;
    RoundedPoint start_{};
    RoundedPoint current_{};
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
