#include "app/editor/commands/combine_commands.h"

#include <algorithm>
#include <cmath>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/length.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/measure/area.h"
#include "core/measure/continuity.h"
#include "core/shape/combine.h"

namespace batten::editor {

namespace {

using core::sentence;

Refusal not_closed(const std::string& name) {
    return sentence("'{name}' is not closed and encloses nothing; its ends must meet", {{"name", name}});
}

// What stands between commas, without the spaces around.
std::vector<std::string> divided_at_commas(const std::string& text) {
    constexpr const char* spaces = " \t";
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::size_t first = text.find_first_not_of(spaces, begin);
        if (first < end) words.push_back(text.substr(first, text.find_last_not_of(spaces, end - 1) + 1 - first));
        begin = end + 1;
    }
    return words;
}

Outcome<std::vector<std::size_t>> curves_named(const EditorState& state, const std::string& names) {
    const core::Document& document = state.history.present();
    // A name may have commas in it.
    if (const auto one = core::curve_meant_by(document, names)) return std::vector{*one};
    std::vector<std::size_t> found;
    for (const std::string& name : divided_at_commas(names)) {
        const Outcome<std::size_t> index = curve_named(state, name);
        if (!index) return tl::unexpected(index.error());
        found.push_back(*index);
    }
    return ascending(std::move(found));
}

std::vector<std::size_t> other_shapes(const core::Document& document) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (i != document.active && document.curves[i].visible && core::is_closed(*document.curves[i].curve))
            found.push_back(i);
    return found;
}

// The other curves, which are not locked, closed, and not the active one.
Outcome<std::vector<std::size_t>> meant_curves(const EditorState& state, const std::optional<std::string>& names) {
    const core::Document& document = state.history.present();
    Outcome<std::vector<std::size_t>> others = names ? curves_named(state, *names) : other_shapes(document);
    if (!others) return others;
    if (!core::is_closed(*document.active_curve()->curve))
        return tl::unexpected(not_closed(document.active_curve()->name));
    for (const std::size_t i : *others) {
        const core::DocumentCurve& entry = document.curves[i];
        if (i == document.active)
            return tl::unexpected(sentence("'{name}' is the active curve; name another one", {{"name", entry.name}}));
        if (std::optional<Refusal> refusal = locked(entry)) return tl::unexpected(*std::move(refusal));
        if (!core::is_closed(*entry.curve)) return tl::unexpected(not_closed(entry.name));
    }
    return others;
}

struct Measured {
    double area = 0.0;
    core::Vector moment{0.0, 0.0};
};

// Added up about `origin`, near which the numbers keep their digits.
core::Result<Measured> measured(const std::vector<core::Curve>& boundary, core::Point origin) {
    Measured sum;
    for (const core::Curve& curve : boundary) {
        const auto area = core::enclosed_area(curve);
        if (!area) return core::refuse(area.error());
        sum.area += area->signed_area;
        if (area->centroid) sum.moment += area->signed_area * (*area->centroid - origin);
    }
    return sum;
}

// The boundary in place of the active curve and the others.
Edit with_boundary(const EditorState& state, std::vector<core::Curve> boundary,
                   const std::vector<std::size_t>& others) {
    const std::size_t active = state.history.present().active;
    const std::size_t added = boundary.size() - 1;
    Edit edit = with_parts(state, std::move(boundary));
    std::vector<core::DocumentCurve>& curves = edit.document.curves;
    for (auto other = others.rbegin(); other != others.rend(); ++other) {
        curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(*other < active ? *other : *other + added));
        if (*other < active) --edit.document.active;
    }
    return edit;
}

Outcome<Edit> combined(const EditorState& state, const std::optional<std::string>& names, core::InsideRule rule,
                       core::ShapeOperation operation) {
    const Outcome<std::vector<std::size_t>> others = meant_curves(state, names);
    if (!others) return tl::unexpected(others.error());
    const core::Document& document = state.history.present();
    // A curve by itself has a union: its outline without crossings.
    if (others->empty() && operation != core::ShapeOperation::unite)
        return tl::unexpected(std::string("there is no other closed curve; a second one is needed"));
    core::Shape second{{}, rule};
    for (const std::size_t i : *others) second.curves.push_back(*document.curves[i].curve);
    auto boundary = core::combine({{active_curve(state)}, rule}, second, operation, state.progress);
    if (!boundary) return refused(state, boundary.error());
    if (boundary->empty())
        return tl::unexpected(sentence("nothing would be left of '{name}'", {{"name", document.active_curve()->name}}));
    const auto sum = measured(*boundary, core::Point(0.0, 0.0));
    Edit edit = with_boundary(state, *boundary, *others);
    if (sum && std::isfinite(sum->area))
        edit.remark = sentence({.one = "one closed curve encloses the area {area}",
                                .many = "{count} closed curves enclose the area {area}"},
                               boundary->size(), {{"area", area_words(document.units, sum->area)}});
    return edit;
}

Outcome<Edit> unite(const EditorState& state, const Unite& command) {
    return combined(state, command.others, command.rule, core::ShapeOperation::unite);
}

Outcome<Edit> subtract(const EditorState& state, const Subtract& command) {
    return combined(state, command.others, command.rule, core::ShapeOperation::subtract);
}

Outcome<Edit> intersect_shapes(const EditorState& state, const IntersectShapes& command) {
    return combined(state, command.others, command.rule, core::ShapeOperation::intersect);
}

Outcome<Edit> exclude_shapes(const EditorState& state, const ExcludeShapes& command) {
    return combined(state, command.others, command.rule, core::ShapeOperation::exclude);
}

Outcome<void> find_centroid(EditorState& state, const FindCentroid& command) {
    const core::Curve& curve = active_curve(state);
    const auto boundary = core::combine({{curve}, command.rule}, {}, core::ShapeOperation::unite, state.progress);
    if (!boundary) return refused(state, boundary.error());
    const core::Point origin = curve.control_points().front();
    const auto sum = measured(*boundary, origin);
    if (!sum) return refused(state, sum.error());
    if (!(sum->area > 0.0)) return tl::unexpected(std::string("the curve encloses no area and has no centroid"));
    const core::Point centroid = origin + sum->moment / sum->area;
    Finding row{.label = "centroid", .point = centroid, .numbers = {{"area", sum->area, 0.0, 2}}};
    add_numbers(row, "centroid", centroid, 0.0);
    std::string summary = sentence("The centroid of {name} is {place}",
                                   {active_name(state), {"place", place_words(units_of(state), centroid)}});
    return show_rows(state, "Centroid", std::move(summary), {std::move(row)});
}

template <class Command>
std::vector<Field> shape_fields() {
    return {field::text<&Command::others>("others", "names of other curves, with commas; without any, all closed ones"),
            field::choice<&Command::rule>("rule", "what counts as inside").usually(core::InsideRule::non_zero)};
}

}  // namespace

const CommandSpec& Unite::spec() {
    static const CommandSpec spec{.name = "union",
                                  .title = "Union",
                                  .explanation =
                                      "Makes one outline of what the active and other closed curves enclose; by itself "
                                      "a curve loses its crossings.",
                                  .synonyms = "unite merge boolean shape add",
                                  .group = CommandGroup::curve,
                                  .submenu = "Closed shapes",
                                  .fields = shape_fields<Unite>(),
                                  .refusal = no_editable_curve,
                                  .run = body_of<unite>,
                                  .at_work = "Making the union",
                                  .done = "Made the union"};
    return spec;
}

const CommandSpec& Subtract::spec() {
    static const CommandSpec spec{
        .name = "difference",
        .title = "Difference",
        .explanation = "Takes what other closed curves enclose away from what the active one encloses.",
        .synonyms = "subtract cut boolean shape minus",
        .group = CommandGroup::curve,
        .submenu = "Closed shapes",
        .fields = shape_fields<Subtract>(),
        .refusal = no_editable_curve,
        .run = body_of<subtract>,
        .at_work = "Making the difference",
        .done = "Made the difference"};
    return spec;
}

const CommandSpec& IntersectShapes::spec() {
    static const CommandSpec spec{.name = "intersection",
                                  .title = "Intersection",
                                  .explanation = "Keeps what both the active curve and other closed curves enclose.",
                                  .synonyms = "common boolean shape and",
                                  .group = CommandGroup::curve,
                                  .submenu = "Closed shapes",
                                  .fields = shape_fields<IntersectShapes>(),
                                  .refusal = no_editable_curve,
                                  .run = body_of<intersect_shapes>,
                                  .at_work = "Making the intersection",
                                  .done = "Made the intersection"};
    return spec;
}

const CommandSpec& ExcludeShapes::spec() {
    static const CommandSpec spec{
        .name = "exclusion",
        .title = "Exclusion",
        .explanation = "Keeps what either the active curve or other closed curves enclose, but not both.",
        .synonyms = "xor symmetric difference boolean shape",
        .group = CommandGroup::curve,
        .submenu = "Closed shapes",
        .fields = shape_fields<ExcludeShapes>(),
        .refusal = no_editable_curve,
        .run = body_of<exclude_shapes>,
        .at_work = "Making the exclusion",
        .done = "Made the exclusion"};
    return spec;
}

const CommandSpec& FindCentroid::spec() {
    static const CommandSpec spec{
        .name = "centroid",
        .title = "Centroid",
        .explanation = "Finds the centroid and the area of what a closed curve encloses, each place counted once.",
        .synonyms = "center of gravity mass area",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields =
            {field::choice<&FindCentroid::rule>("rule", "what counts as inside").usually(core::InsideRule::non_zero)},
        .refusal = no_curve,
        .run = body_of<find_centroid>};
    return spec;
}

void add_combine_commands(CommandTable& table) {
    add_all<Unite, Subtract, IntersectShapes, ExcludeShapes, FindCentroid>(table);
}

}  // namespace batten::editor
