#include "app/editor/commands/arranging_commands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/array_commands.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/map_selected.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"
#include "core/edit/point_edit.h"
#include "core/measure/arc_length.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

using core::sentence;

// What is arranged: control points, or whole curves, each with its box.
struct Item {
    std::size_t curve = 0;
    std::optional<std::size_t> point{};
    core::Box box{};
};

core::Box box_of(core::Point point) {
    core::Box box;
    box.include(point);
    return box;
}

Outcome<Item> whole_item(const core::Document& document, std::size_t curve) {
    const core::DocumentCurve& entry = document.curves[curve];
    if (std::optional<Refusal> refusal = locked(entry)) return tl::unexpected(*std::move(refusal));
    const core::Box box = core::tight_box(*entry.curve);
    if (box.is_empty())
        return tl::unexpected(sentence("the box of '{name}' cannot be computed", {{"name", entry.name}}));
    return Item{curve, std::nullopt, box};
}

// Each point that is not pinned, and each curve that is selected as a whole.
Outcome<std::vector<Item>> selected_items(const EditorState& state) {
    if (std::optional<Refusal> refusal = nothing_to_map(state)) return tl::unexpected(*std::move(refusal));
    const core::Document& document = state.history.present();
    std::vector<Item> items;
    for (const SelectedPart& part : selected_parts(state)) {
        if (part.is_whole()) {
            auto item = whole_item(document, part.curve);
            if (!item) return tl::unexpected(item.error());
            items.push_back(*std::move(item));
            continue;
        }
        const auto points = free_points(document.curves[part.curve], part.points);
        if (!points) return tl::unexpected(points.error());
        for (const std::size_t i : *points)
            items.push_back({part.curve, i, box_of(document.curves[part.curve].curve->control_points()[i])});
    }
    return items;
}

Outcome<std::vector<Item>> visible_items(const EditorState& state) {
    std::vector<Item> items;
    const core::Document& document = state.history.present();
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        if (!document.curves[i].visible) continue;
        auto item = whole_item(document, i);
        if (!item) return tl::unexpected(item.error());
        items.push_back(*std::move(item));
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
            ? sentence("at least {least} control points or curves must be selected that are not pinned, not {count}",
                       {count, needed})
            : sentence("at least {least} curves must be visible, not {count}", {count, needed}));
}

// Moves the points of one curve, which follow each other in `items` from `first` on; the item behind them.
Outcome<std::size_t> move_points_of(const Units& units, core::DocumentCurve& entry, const std::vector<Item>& items,
                                    const std::vector<core::Vector>& offsets, std::size_t first) {
    core::CurveDefinition definition = entry.curve->definition();
    std::size_t k = first;
    for (; k < items.size() && items[k].point && items[k].curve == items[first].curve; ++k)
        definition.points[*items[k].point] += offsets[k];
    auto moved = core::Curve::make(std::move(definition));
    if (!moved) return refused(units, moved.error());
    replace_curve(entry, std::make_shared<const core::Curve>(*std::move(moved)));
    return k;
}

// The committed document with every item moved by its offset; those of one curve stand together.
Outcome<Edit> with_moved(const EditorState& state, const std::vector<Item>& items,
                         const std::vector<core::Vector>& offsets) {
    Edit edit{state.history.present()};
    for (std::size_t k = 0; k < items.size();) {
        core::DocumentCurve& entry = edit.document.curves[items[k].curve];
        if (items[k].point) {
            const auto next = move_points_of(edit.document.units, entry, items, offsets, k);
            if (!next) return tl::unexpected(next.error());
            k = *next;
            continue;
        }
        if (offsets[k] != core::Vector(0.0, 0.0))
            if (const auto moved = map_entry(entry, core::translation(offsets[k])); !moved)
                return refused(state, moved.error());
        ++k;
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
    return with_moved(state, *items, offsets);
}

Outcome<Edit> distribute(const EditorState& state, const Distribute& command) {
    const auto items = items_of(state, command.what, 3);
    if (!items) return tl::unexpected(items.error());
    const bool is_horizontal = command.direction == Direction::horizontal;
    const auto place = [&](const Item& item) {
        const core::Point middle = core::middle(item.box.lower, item.box.upper);
        return is_horizontal ? middle.x : middle.y;
    };
    std::vector<std::size_t> order(items->size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return place((*items)[k]); });
    const double first = place((*items)[order.front()]);
    const double last = place((*items)[order.back()]);
    std::vector<core::Vector> offsets(items->size(), core::Vector(0.0, 0.0));
    for (std::size_t k = 1; k + 1 < order.size(); ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(order.size() - 1);
        const double by = first + share * (last - first) - place((*items)[order[k]]);
        offsets[order[k]] = is_horizontal ? core::Vector(by, 0.0) : core::Vector(0.0, by);
    }
    return with_moved(state, *items, offsets);
}

// By how much a curve is to be scaled about its beginning, which stays.
Outcome<core::PlaneMap> scaled_to(const core::DocumentCurve& entry, double wanted) {
    const core::Integral length = core::arc_length(*entry.curve);
    if (!core::is_sharp(length) || length.value == 0.0)
        return tl::unexpected(sentence("'{name}' has no length that could be set", {{"name", entry.name}}));
    const double factor = wanted / length.value;
    return core::scaling(factor, factor, entry.curve->control_points().front());
}

std::optional<Refusal> nothing_to_scale(const EditorState& state) {
    return state.selection.is_over_curves() ? nothing_to_map(state) : no_editable_curve(state);
}

Outcome<Edit> set_length(const EditorState& state, const SetLength& command) {
    if (!(command.length > 0.0))
        return refused(state, {.code = core::CurveErrorCode::length_not_positive, .value = command.length});
    SelectedParts wholes;
    std::vector<core::PlaneMap> maps;
    for (const std::size_t i : curves_meant(state)) {
        const auto map = scaled_to(state.history.present().curves[i], command.length);
        if (!map) return tl::unexpected(map.error());
        wholes.push_back({i});
        maps.push_back(*map);
    }
    return map_parts(state, wholes, maps);
}

StepTexts texts_of_length(const EditorState& state, const SetLength& command) {
    const core::Place length("length", length_words(units_of(state), command.length));
    return {SetLength::spec().title,
            curves_meant(state).size() == 1
                ? sentence("Set length to {length}", {length})
                : sentence("Set length of each of {curves} to {length}", {names_of_meant(state), length})};
}

Outcome<Edit> set_distance(const EditorState& state, const SetDistance& command) {
    const auto points = active_curve(state).control_points();
    const core::Vector way = points[command.to] - points[command.from];
    const double now = core::length(way);
    if (!(command.distance > 0.0))
        return refused(state, {.code = core::CurveErrorCode::length_not_positive, .value = command.distance});
    if (now == 0.0)
        return tl::unexpected(Refusal("the two control points are one place; there is no direction between them"));
    if (const auto free = free_points(state, {command.to}); !free) return tl::unexpected(free.error());
    return edit_active(state, core::set_control_point(active_curve(state), command.to,
                                                      points[command.from] + command.distance / now * way));
}

StepTexts texts_of_distance(const EditorState& state, const SetDistance& command) {
    const core::Place from("from", point_text(command.from));
    const core::Place to("to", point_text(command.to));
    return {sentence("Set distance of {to} from {from}", {to, from}),
            sentence("Moved {to} to the distance {distance} from {from}",
                     {to, {"distance", length_words(units_of(state), command.distance)}, from})};
}

Arranged what_there_is(const EditorState& state) {
    return state.selection.points.size() > 1 || state.selection.is_over_curves() ? Arranged::points : Arranged::curves;
}

std::optional<double> length_now(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    return core::arc_length(active_curve(state)).value;
}

}  // namespace

const CommandSpec& Align::spec() {
    static const CommandSpec spec{
        .name = "align",
        .title = "Align",
        .explanation = "Puts what is selected, or the visible curves, in line; whole curves by their boxes.",
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
        .explanation = "Puts what is selected, or the visible curves, at even distances; whole curves by their boxes.",
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

const CommandSpec& SetLength::spec() {
    static const CommandSpec spec{
        .name = "set-length",
        .title = "Set length",
        .explanation = "Scales the curve, or each that is selected, about its first control point to a given length.",
        .synonyms = "arc size scale",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .effect = ShapeEffect::changes,
        .fields =
            {field::length<&SetLength::length>("length", "of the whole curve, above 0").beginning_with<length_now>()},
        .refusal = nothing_to_scale,
        .run = body_of<set_length>,
        .texts = texts_of<texts_of_length>};
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
