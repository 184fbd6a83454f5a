#include "app/editor/pointer/place_text.h"

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/direction.h"
#include "app/editor/pointer/typed_place.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "core/base/sentence.h"

namespace batten::editor {
namespace {

using core::sentence;

std::string angle_text(core::Vector way) {
    return number_text(degrees_of(way));
}

std::string with_caret(const TypedPlace& typed, std::size_t field) {
    return typed.active == field ? sentence("{text}|", {{"text", typed.texts[field]}}) : typed.texts[field];
}

/// What a single length means; null where more may be typed.
const char* pattern_of(TypedFor typed_for) {
    switch (typed_for) {
        case TypedFor::radius:
            return "radius {length}";
        case TypedFor::distance:
        case TypedFor::sides:
            return "distance {length}";
        case TypedFor::x:
            return "x {length}";
        case TypedFor::y:
            return "y {length}";
        case TypedFor::place:
        case TypedFor::factors:
        case TypedFor::angle:
            break;
    }
    return nullptr;
}

}  // namespace

std::string length_text(const EditorState& state, double value) {
    constexpr int least_digits = 3;
    constexpr int most_digits = 15;
    const double tenths = std::abs(value) * state.view.camera.scale * 10.0;
    const double digits = tenths > 1.0 && std::isfinite(tenths) ? std::ceil(std::log10(tenths)) : 0.0;
    const Units& units = state.shown().units;
    return with_unit(
        units, number_text(in_units(units, value), std::clamp(static_cast<int>(digits), least_digits, most_digits)));
}

std::string reading_of(const EditorState& state, const ShownPlace& place) {
    if (!place.reading.empty()) return place.reading;
    if (!place.from)
        return sentence("x {x} · y {y}",
                        {{"x", length_text(state, place.position.x)}, {"y", length_text(state, place.position.y)}});
    const core::Vector way = place.position - *place.from;
    return sentence("{length} ∠ {angle}° · dx {dx} · dy {dy}",
                    {{"length", length_text(state, core::robust_length(way))},
                     {"angle", angle_text(way)},
                     {"dx", length_text(state, way.x)},
                     {"dy", length_text(state, way.y)}});
}

std::string typed_reading(const TypedPlace& typed, TypedFor typed_for) {
    if (typed.is_empty()) return {};
    if (typed_for == TypedFor::angle) return sentence("angle {angle}", {{"angle", with_caret(typed, 0)}});
    if (typed_for == TypedFor::factors)
        return sentence("factor {first} · along y {second}",
                        {{"first", with_caret(typed, 0)}, {"second", with_caret(typed, 1)}});
    if (typed_for == TypedFor::sides && (typed.active == 1 || !typed.texts[1].empty()))
        return sentence("first {first} · second {second}",
                        {{"first", with_caret(typed, 0)}, {"second", with_caret(typed, 1)}});
    const bool is_whole = typed.active == 0 && typed.texts[1].empty();
    const bool names_itself = typed.texts[0].find_first_of("@<,;") != std::string::npos;
    if (is_whole && names_itself) return with_caret(typed, 0);
    if (const char* pattern = pattern_of(typed_for); pattern != nullptr && is_whole && !typed.has_offsets)
        return core::filled_as_needed(pattern, {{"length", with_caret(typed, 0)}});
    return sentence("{first_name} {first} · {second_name} {second}", {{"first_name", title_of_field(typed, 0)},
                                                                      {"first", with_caret(typed, 0)},
                                                                      {"second_name", title_of_field(typed, 1)},
                                                                      {"second", with_caret(typed, 1)}});
}

std::string typed_problem(const EditorState& state) {
    const Placing& placing = state.placing;
    if (placing.typed.is_empty()) return {};
    const core::Point anywhere = placing.place ? placing.place->position : core::Point(0.0, 0.0);
    return typed_problem(placing, anywhere, state.shown().units);
}

}  // namespace batten::editor
