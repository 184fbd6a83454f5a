#include "exchange/svg/transform_text.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::PlaneMap;
using core::Point;

// "(1 2, 3)"
std::optional<std::vector<double>> transform_arguments(Scanner& scanner) {
    constexpr std::size_t most = 6;
    scanner.skip_blanks();
    if (!scanner.skip_if('(')) return std::nullopt;
    scanner.skip_blanks();
    std::vector<double> values;
    while (!scanner.skip_if(')')) {
        const auto value = scanner.number();
        if (!value || values.size() == most) return std::nullopt;
        values.push_back(*value);
        scanner.skip_separator();
    }
    return values;
}

double slope_of(double degrees) {
    return std::tan(degrees * (std::numbers::pi / 180.0));
}

std::optional<PlaneMap> named_transform(std::string_view name, const std::vector<double>& v) {
    const Point origin{0.0, 0.0};
    const std::size_t count = v.size();
    if (name == "matrix" && count == 6)
        return PlaneMap{.rows = {{{v[0], v[2], v[4]}, {v[1], v[3], v[5]}, {0.0, 0.0, 1.0}}}, .pivot = origin};
    if (name == "translate" && (count == 1 || count == 2)) return core::translation({v[0], count == 2 ? v[1] : 0.0});
    if (name == "scale" && (count == 1 || count == 2)) return core::scaling(v[0], v[count - 1], origin);
    if (name == "rotate" && count == 1) return core::rotation(v[0], origin);
    if (name == "rotate" && count == 3) return core::about_origin(core::rotation(v[0], {v[1], v[2]}));
    if (name == "skewX" && count == 1) return core::shearing(slope_of(v[0]), 0.0, origin);
    if (name == "skewY" && count == 1) return core::shearing(0.0, slope_of(v[0]), origin);
    return std::nullopt;
}

}  // namespace

PlaneMap chained(const PlaneMap& outer, const PlaneMap& inner) {
    PlaneMap map;
    map.pivot = {0.0, 0.0};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            map.rows[i][j] = outer.rows[i][0] * inner.rows[0][j] + outer.rows[i][1] * inner.rows[1][j] +
                             (j == 2 ? outer.rows[i][2] : 0.0);
    return map;
}

std::optional<PlaneMap> read_transform(std::string_view text) {
    Scanner scanner(text);
    PlaneMap map;
    for (scanner.skip_separator(); !scanner.is_at_end(); scanner.skip_separator()) {
        const std::string_view name = scanner.word();
        const auto values = transform_arguments(scanner);
        const auto next = values ? named_transform(name, *values) : std::nullopt;
        if (!next) return std::nullopt;
        map = chained(map, *next);
    }
    return map;
}

}  // namespace batten::exchange
