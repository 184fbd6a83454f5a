#include "app/editor/words/length.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "app/editor/fields/expression.h"
#include "app/editor/state/state.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

const char* sign_of(core::LengthUnit unit) {
    return unit == core::LengthUnit::inch ? "in" : core::name_of(unit);
}

tl::expected<double, std::string> in_world(const core::DocumentUnits& units, double length) {
    const double world = length * units.scale;
    if (!std::isfinite(world)) return tl::make_unexpected("the result is too large for a number");
    return world;
}

}  // namespace

const Units& units_of(const EditorState& state) {
    return state.history.present().units;
}

double world_per_length(const Units& units) {
    return units ? units->scale : 1.0;
}

double in_units(const Units& units, double world) {
    return world / world_per_length(units);
}

core::Point in_units(const Units& units, core::Point world) {
    return {in_units(units, world.x), in_units(units, world.y)};
}

double in_units(const Units& units, double world, int power) {
    return world / std::pow(world_per_length(units), power);
}

std::string with_unit(const Units& units, const std::string& number) {
    if (!units) return number;
    return core::sentence("{number} {unit}", {{"number", number}, {"unit", sign_of(units->unit)}});
}

std::string with_unit(const Units& units, const std::string& number, int power) {
    if (!units || power < 1 || power > 2) return number;
    if (power == 1) return with_unit(units, number);
    return core::sentence("{number} {unit}²", {{"number", number}, {"unit", sign_of(units->unit)}});
}

std::string message_text(double value) {
    constexpr int digits = std::numeric_limits<double>::digits10;
    const auto rounded = core::leading_number(fmt::format("{:.{}g}", value, digits));
    return core::shortest_text(rounded ? rounded->value : value);
}

std::string quantity_words(const Units& units, double world, int power) {
    return with_unit(units, message_text(in_units(units, world, power)), power);
}

std::string length_words(const Units& units, double world) {
    return quantity_words(units, world, 1);
}

std::string area_words(const Units& units, double world) {
    return quantity_words(units, world, 2);
}

std::string unit_ending(const Units& units) {
    return units ? fmt::format(" {}", sign_of(units->unit)) : std::string();
}

tl::expected<double, std::string> parse_length(std::string_view text, const Units& units) {
    if (!units) return parse_expression(text);
    const core::DocumentUnits unit_alone{.unit = units->unit};
    return parse_expression(text, ExpressionUnit::number, &unit_alone).and_then([&](double length) {
        return in_world(*units, length);
    });
}

tl::expected<std::vector<double>, std::string> parse_lengths(std::string_view text, const Units& units) {
    if (!units) return parse_expressions(text);
    const core::DocumentUnits unit_alone{.unit = units->unit};
    auto lengths = parse_expressions(text, &unit_alone);
    if (!lengths) return lengths;
    for (double& length : *lengths) {
        const auto world = in_world(*units, length);
        if (!world) return tl::make_unexpected(world.error());
        length = *world;
    }
    return lengths;
}

}  // namespace batten::editor
