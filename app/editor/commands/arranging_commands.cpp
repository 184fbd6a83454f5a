#include "app/editor/commands/arranging_commands.h"

#include <algorithm>
#include <cmath>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/words/formula.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/point_edit.h"
#include "core/measure/arc_length.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr double most_copies = 10'000.0;

// What is arranged: control points of the active curve, or whole curves, each with its box.
struct Item {
    std::size_t index = 0;
    core::Box box{};
};

core::Box box_of(core::Point point) {
    core::Box box;
    box.include(point);
    return box;
}

Outcome<std::vector<Item>> selected_items(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_points(state)) return tl::unexpected(*std::move(refusal));
    const auto points = free_points(state, state.selection.points);
    if (!points) return tl::unexpected(points.error());
    std::vector<Item> items;
    for (const std::size_t i : *points) items.push_back({i, box_of(active_curve(state).control_points()[i])});
    return items;
}

Outcome<std::vector<Item>> visible_items(const EditorState& state) {
    std::vector<Item> items;
    const auto& curves = state.history.present().curves;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (!curves[i].visible) continue;
        if (std::optional<Refusal> refusal = locked(curves[i])) return tl::unexpected(*std::move(refusal));
        const core::Box box = core::tight_box(*curves[i].curve);
        if (box.is_empty())
            return tl::unexpected(sentence("the box of '{name}' cannot be computed", {{"name", curves[i].name}}));
        items.push_back({i, box});
    }
    return items;
}

Outcome<std::vector<Item>> items_of(const EditorState& state, Arranged what, std::size_t least) {
    auto items = what == Arranged::points ? selected_items(state) : visible_items(state);
    if (!items || items->size() >= least) return items;
    const core::Place count("count", items->size());
    const core::Place needed("least", least);
    return tl::unexpected(
        what == Arranged::points
            ? sentence("at least {least} control points must be selected that are not pinned, not {count}",
                       {count, needed})
            : sentence("at least {least} curves must be visible, not {count}", {count, needed}));
}

// The committed document with every item moved by its offset.
Outcome<Edit> with_moved(const EditorState& state, Arranged what, const std::vector<Item>& items,
                         const std::vector<core::Vector>& offsets) {
    Edit edit{state.history.present()};
    if (what == Arranged::points) {
        core::CurveDefinition definition = active_curve(state).definition();
        for (std::size_t k = 0; k < items.size(); ++k) definition.points[items[k].index] += offsets[k];
        return edit_active(state, core::Curve::make(std::move(definition)));
    }
    for (std::size_t k = 0; k < items.size(); ++k) {
        core::DocumentCurve& entry = edit.document.curves[items[k].index];
        if (offsets[k] == core::Vector(0.0, 0.0)) continue;
        if (const auto moved = map_entry(entry, core::translation(offsets[k])); !moved)
            return tl::unexpected(core::describe(moved.error()));
    }
    return edit;
}

core::Vector offset_to(Alignment at, const core::Box& box, const core::Box& whole) {
    const core::Point middle = core::middle(box.lower, box.upper);
    const core::Point middle_of_whole = core::middle(whole.lower, whole.upper);
    switch (at) {
        case Alignment::left:
            return {whole.lower.x - box.lower.x, 0.0};
        case Alignment::center:
            return {middle_of_whole.x - middle.x, 0.0};
        case Alignment::right:
            return {whole.upper.x - box.upper.x, 0.0};
        case Alignment::top:
            return {0.0, whole.upper.y - box.upper.y};
        case Alignment::middle:
            return {0.0, middle_of_whole.y - middle.y};
        case Alignment::bottom:
            return {0.0, whole.lower.y - box.lower.y};
    }
    return {0.0, 0.0};
}

Outcome<Edit> align(const EditorState& state, const Align& command) {
    const auto items = items_of(state, command.what, 2);
    if (!items) return tl::unexpected(items.error());
    core::Box whole;
    for (const Item& item : *items) {
        whole.include(item.box.lower);
        whole.include(item.box.upper);
    }
    std::vector<core::Vector> offsets;
    for (const Item& item : *items) offsets.push_back(offset_to(command.at, item.box, whole));
    return with_moved(state, command.what, *items, offsets);
}

Outcome<Edit> distribute(const EditorState& state, const Distribute& command) {
    auto items = items_of(state, command.what, 3);
    if (!items) return tl::unexpected(items.error());
    const bool is_horizontal = command.direction == Direction::horizontal;
    const auto place = [&](const Item& item) {
        const core::Point middle = core::middle(item.box.lower, item.box.upper);
        return is_horizontal ? middle.x : middle.y;
    };
    std::ranges::stable_sort(*items, {}, place);
    const double first = place(items->front());
    const double last = place(items->back());
    std::vector<core::Vector> offsets;
    for (std::size_t k = 0; k < items->size(); ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(items->size() - 1);
        const double by = k == 0 || k + 1 == items->size() ? 0.0 : first + share * (last - first) - place((*items)[k]);
        offsets.push_back(is_horizontal ? core::Vector(by, 0.0) : core::Vector(0.0, by));
    }
    return with_moved(state, command.what, *items, offsets);
}

// Copies of the active curve, number k mapped by `map_of(k)`, behind it in the list; the curve stays active.
template <class MapOf>
Outcome<Edit> with_copies(const EditorState& state, std::size_t count, MapOf map_of) {
    Edit edit{state.history.present()};
    const core::DocumentCurve original = *edit.document.active_curve();
    if (auto refusal = too_many_copies(state, count)) return tl::unexpected(*std::move(refusal));
    core::FreeNames names(edit.document);
    for (std::size_t k = 1; k < count; ++k) {
        core::tell(state.progress, k, count);
        core::DocumentCurve copy = original;
        if (const auto mapped = map_entry(copy, map_of(static_cast<double>(k))); !mapped)
            return tl::unexpected(core::describe(mapped.error()));
        copy.name = names.take(original.name);
        copy.locked = false;
        edit.document.curves.push_back(std::move(copy));
    }
    return edit;
}

Outcome<Edit> linear_array(const EditorState& state, const LinearArray& command) {
    return with_copies(state, command.count, [&](double k) { return core::translation(k * command.step); });
}

Outcome<Edit> polar_array(const EditorState& state, const PolarArray& command) {
    return with_copies(state, command.count,
                       [&](double k) { return core::rotation(k * command.step, command.center); });
}

// Scaled about its beginning, which stays.
Outcome<Edit> set_length(const EditorState& state, const SetLength& command) {
    const core::Curve& curve = active_curve(state);
    const core::Integral length = core::arc_length(curve);
    if (!(command.length > 0.0))
        return tl::unexpected(
            core::describe({.code = core::CurveErrorCode::length_not_positive, .value = command.length}));
    if (!core::is_sharp(length) || length.value == 0.0)
        return tl::unexpected(Refusal("the curve has no length that could be set"));
    const double factor = command.length / length.value;
    return map_active(state, core::scaling(factor, factor, curve.control_points().front()));
}

Outcome<Edit> set_distance(const EditorState& state, const SetDistance& command) {
    const auto points = active_curve(state).control_points();
    const core::Vector way = points[command.to] - points[command.from];
    const double now = core::length(way);
    if (!(command.distance > 0.0))
        return tl::unexpected(
            core::describe({.code = core::CurveErrorCode::length_not_positive, .value = command.distance}));
    if (now == 0.0)
        return tl::unexpected(Refusal("the two control points are one place; there is no direction between them"));
    if (const auto free = free_points(state, {command.to}); !free) return tl::unexpected(free.error());
    return edit_active(state, core::set_control_point(active_curve(state), command.to,
                                                      points[command.from] + command.distance / now * way));
}

StepTexts texts_of_distance(const EditorState&, const SetDistance& command) {
    const core::Place from("from", point_text(command.from));
    const core::Place to("to", point_text(command.to));
    return {sentence("Set distance of {to} from {from}", {to, from}),
            sentence("Moved {to} to the distance {distance} from {from}",
                     {to, {"distance", core::shortest_text(command.distance)}, from})};
}

Arranged what_there_is(const EditorState& state) {
    return state.selection.points.size() > 1 ? Arranged::points : Arranged::curves;
}

std::optional<double> length_now(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    return core::arc_length(active_curve(state)).value;
}

std::optional<core::Point> box_middle(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    const core::Box box = core::tight_box(active_curve(state));
    return core::middle(box.lower, box.upper);
}

}  // namespace

const CommandSpec& Align::spec() {
    static const CommandSpec spec{
        .name = "align",
        .title = "Align",
        .explanation = "Puts the selected control points, or the visible curves by their boxes, in line.",
        .synonyms = "arrange line up",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .effect = ShapeEffect::changes,
        .fields = {field::choice<&Align::at>("at", "the edge or middle of the box around them all"),
                   field::choice<&Align::what>("what", "what is moved").suggesting<what_there_is>()},
        .refusal = no_curve,
        .run = body_of<align>,
        .step = "Align {what}",
        .done = "Aligned {what} at the {at}"};
    return spec;
}

const CommandSpec& Distribute::spec() {
    static const CommandSpec spec{
        .name = "distribute",
        .title = "Distribute",
        .explanation = "Puts the selected control points, or the visible curves by their boxes, at even distances.",
        .synonyms = "arrange space evenly",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .effect = ShapeEffect::changes,
        .fields = {field::choice<&Distribute::direction>("direction", "along which they are moved"),
                   field::choice<&Distribute::what>("what", "what is moved").suggesting<what_there_is>()},
        .refusal = no_curve,
        .run = body_of<distribute>,
        .step = "Distribute {what}",
        .done = "Distributed {what} {direction}"};
    return spec;
}

const CommandSpec& LinearArray::spec() {
    static const CommandSpec spec{
        .name = "array",
        .title = "Array along a line",
        .explanation = "Adds copies of the active curve, each one step further.",
        .synonyms = "copies repeat pattern row",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .fields = {field::count<&LinearArray::count>("count", "how many there shall be, with the curve itself")
                       .at_least(2.0)
                       .at_most(most_copies),
                   field::vector<&LinearArray::step>({"dx", "each one to the right"}, {"dy", "each one upwards"})},
        .refusal = no_curve,
        .run = body_of<linear_array>,
        .at_work = "Copying the curve",
        .done = "Made a row of {count} curves"};
    return spec;
}

const CommandSpec& PolarArray::spec() {
    static const CommandSpec spec{
        .name = "array-polar",
        .title = "Array around a point",
        .explanation = "Adds copies of the active curve, each turned one step further around a point.",
        .synonyms = "copies repeat pattern ring rotate",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .fields = {field::count<&PolarArray::count>("count", "how many there shall be, with the curve itself")
                       .at_least(2.0)
                       .at_most(most_copies),
                   field::position<&PolarArray::center>({"x", "x of the center"}, {"y", "y of the center"})
                       .beginning_with<box_middle>(),
                   field::angle<&PolarArray::step>("step", "from one to the next, counterclockwise")},
        .refusal = no_curve,
        .run = body_of<polar_array>,
        .at_work = "Copying the curve",
        .done = "Made a ring of {count} curves"};
    return spec;
}

const CommandSpec& SetLength::spec() {
    static const CommandSpec spec{
        .name = "set-length",
        .title = "Set length",
        .explanation = "Scales the curve about its first control point, so that it has a given length.",
        .synonyms = "arc size scale",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .effect = ShapeEffect::changes,
        .fields =
            {field::length<&SetLength::length>("length", "of the whole curve, above 0").beginning_with<length_now>()},
        .refusal = no_editable_curve,
        .run = body_of<set_length>,
        .done = "Set length to {length}"};
    return spec;
}

const CommandSpec& SetDistance::spec() {
    static const CommandSpec spec{
        .name = "set-distance",
        .title = "Set distance of two points",
        .explanation = "Moves a control point along its line to another one, to a given distance from it.",
        .synonyms = "leg length dimension",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .effect = ShapeEffect::changes,
        .fields = {field::point_index<&SetDistance::from>("from", "the control point that stays, counted from 0")
                       .beginning_with<suggest::first_selected_point>(),
                   field::point_index<&SetDistance::to>("to", "the control point that moves")
                       .beginning_with<suggest::last_selected_point>(),
                   field::length<&SetDistance::distance>("distance", "between them, above 0")},
        .refusal = no_editable_curve,
        .run = body_of<set_distance>,
        .texts = texts_of<texts_of_distance>};
    return spec;
}

void add_arranging_commands(CommandTable& table) {
    add_all<Align, Distribute, LinearArray, PolarArray, SetLength, SetDistance>(table);
}

}  // namespace batten::editor
