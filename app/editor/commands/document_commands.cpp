#include <algorithm>
#include <array>
#include <charconv>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "core/curve/knot_kinds.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

constexpr const char* which_curve = "the number of a curve, counted from 0";

Outcome<std::size_t> curve_index(const EditorState& state, double value) {
    const Outcome<std::size_t> index = index_of(value, "i");
    const std::size_t count = state.history.present().curves.size();
    if (index && *index >= count)
        return tl::unexpected("there is no curve " + std::to_string(*index) + "; the document has " +
                              std::to_string(count));
    return index;
}

const core::DocumentCurve& item(const EditorState& state, double index) {
    return state.history.present().curves[static_cast<std::size_t>(index)];
}

std::string quoted_name(const EditorState& state, double index) {
    return "'" + item(state, index).name + "'";
}

core::Result<core::Curve> clamped_curve(std::vector<core::Point> points, int degree) {
    const core::Result<core::KnotVector> knots =
        core::make_knots(core::KnotKind::clamped_uniform, degree, points.size());
    if (!knots) return tl::unexpected(knots.error());
    std::vector<double> weights(points.size(), 1.0);
    return core::Curve::make(*knots, std::move(points), std::move(weights));
}

Outcome<Edit> new_curve(const EditorState& state, const Arguments& arguments) {
    Outcome<std::vector<core::Point>> points = points_of(arguments.numbers(0), 2, "a new curve");
    if (!points) return tl::unexpected(points.error());
    const Outcome<std::size_t> degree = index_of(arguments.number(1), "degree");
    if (!degree) return tl::unexpected(degree.error());
    const auto most = static_cast<std::size_t>(points->size() - 1);
    core::Result<core::Curve> curve = clamped_curve(*std::move(points), static_cast<int>(std::min(*degree, most)));
    if (!curve) return tl::unexpected(core::describe(curve.error()));
    return with_curve(state, "curve", *std::move(curve));
}

Outcome<Edit> delete_curve(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = curve_index(state, arguments.number(0));
    if (!index) return tl::unexpected(index.error());
    return without_curve(state, *index);
}

Outcome<Edit> duplicate_curve(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = curve_index(state, arguments.number(0));
    if (!index) return tl::unexpected(index.error());
    return with_duplicate(state, *index, arguments.number(1));
}

// An edit of one entry of the document that leaves its curve alone.
template <class Change>
Outcome<Edit> change_entry(const EditorState& state, double which, Change change) {
    const Outcome<std::size_t> index = curve_index(state, which);
    if (!index) return tl::unexpected(index.error());
    Edit edit{state.history.present()};
    change(edit.document.curves[*index]);
    return edit;
}

Outcome<Edit> rename_curve(const EditorState& state, const Arguments& arguments) {
    const std::string& name = arguments.text(1);
    if (name.empty()) return tl::unexpected(Refusal("a curve needs a name; the one given is empty"));
    const std::vector<core::DocumentCurve>& curves = state.history.present().curves;
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (curves[i].name == name && static_cast<double>(i) != arguments.number(0))
            return tl::unexpected("curve " + std::to_string(i) + " is called '" + name +
                                  "' already; names must differ");
    return change_entry(state, arguments.number(0), [&name](core::DocumentCurve& curve) { curve.name = name; });
}

// "#rrggbb"
std::optional<core::DocumentColor> parsed_color(const std::string& text) {
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    std::array<std::uint8_t, 3> parts{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const char* begin = text.data() + 1 + 2 * i;
        const auto [end, error] = std::from_chars(begin, begin + 2, parts[i], 16);
        if (error != std::errc() || end != begin + 2) return std::nullopt;
    }
    return core::DocumentColor{parts[0], parts[1], parts[2]};
}

Outcome<Edit> set_color(const EditorState& state, const Arguments& arguments) {
    const std::string& text = arguments.text(1);
    const std::optional<core::DocumentColor> color = parsed_color(text);
    if (!color && text != "none")
        return tl::unexpected("the colour is '" + text + "'; it must be of the form #4c7fe0, or none");
    return change_entry(state, arguments.number(0), [&color](core::DocumentCurve& curve) { curve.color = color; });
}

Outcome<Edit> set_visible(const EditorState& state, const Arguments& arguments) {
    const bool is_on = arguments.number(1) != 0.0;
    return change_entry(state, arguments.number(0), [is_on](core::DocumentCurve& curve) { curve.visible = is_on; });
}

Outcome<Edit> set_locked(const EditorState& state, const Arguments& arguments) {
    const bool is_on = arguments.number(1) != 0.0;
    return change_entry(state, arguments.number(0), [is_on](core::DocumentCurve& curve) { curve.locked = is_on; });
}

std::optional<Argument> cubic(const EditorState&) {
    return 3.0;
}

void add_curve_list(std::vector<CommandSpec>& table) {
    table.push_back(
        {.name = "new-curve",
         .title = "New curve",
         .explanation = "Adds a clamped uniform curve through its first and last point and makes it active.",
         .group = CommandGroup::make,
         .parameters = {{"coordinates", Kind::numbers, "x and y of each control point"},
                        {"degree", Kind::number, "lowered where there are too few points", cubic}},
         .edit = new_curve,
         .label = [](const EditorState&, const Arguments&) { return std::string("Draw curve"); }});
    table.push_back({.name = "delete-curve",
                     .title = "Delete curve",
                     .explanation = "Removes a curve from the document.",
                     .group = CommandGroup::curve,
                     .parameters = {{"i", Kind::number, which_curve, active_index}},
                     .refusal = no_curve,
                     .edit = delete_curve,
                     .label = [](const EditorState& state, const Arguments& arguments) {
                         return "Delete curve " + quoted_name(state, arguments.number(0));
                     }});
    table.push_back({.name = "duplicate-curve",
                     .title = "Duplicate curve",
                     .explanation = "Adds a copy of a curve, shifted a little, and makes it active.",
                     .group = CommandGroup::curve,
                     .parameters = {{"i", Kind::number, which_curve, active_index},
                                    {"shift", Kind::number, "how far to the right and down", grid_step}},
                     .refusal = no_curve,
                     .edit = duplicate_curve,
                     .label = [](const EditorState& state, const Arguments& arguments) {
                         return "Duplicate curve " + quoted_name(state, arguments.number(0));
                     }});
}

void add_entries(std::vector<CommandSpec>& table) {
    table.push_back({.name = "rename-curve",
                     .title = "Rename curve",
                     .explanation = "Gives a curve another name.",
                     .group = CommandGroup::curve,
                     .parameters = {{"i", Kind::number, which_curve}, {"name", Kind::text, "its new name"}},
                     .refusal = no_curve,
                     .edit = rename_curve,
                     .label = [](const EditorState& state, const Arguments& arguments) {
                         return "Rename curve " + quoted_name(state, arguments.number(0));
                     }});
    table.push_back(
        {.name = "set-curve-color",
         .title = "Set colour of curve",
         .explanation = "Gives a curve a colour of its own, or the usual one.",
         .group = CommandGroup::curve,
         .parameters = {{"i", Kind::number, which_curve}, {"color", Kind::text, "of the form #4c7fe0, or none"}},
         .refusal = no_curve,
         .edit = set_color,
         .label = [](const EditorState& state, const Arguments& arguments) {
             return "Set colour of " + quoted_name(state, arguments.number(0));
         }});
    table.push_back(
        {.name = "set-curve-visible",
         .title = "Show or hide curve",
         .explanation = "Shows a curve, or hides it.",
         .group = CommandGroup::curve,
         .parameters = {{"i", Kind::number, which_curve}, {"visible", Kind::number, "1 to show it, 0 to hide it"}},
         .refusal = no_curve,
         .edit = set_visible,
         .label = [](const EditorState& state, const Arguments& arguments) {
             return (arguments.number(1) != 0.0 ? "Show curve " : "Hide curve ") +
                    quoted_name(state, arguments.number(0));
         }});
    table.push_back(
        {.name = "set-curve-locked",
         .title = "Lock or unlock curve",
         .explanation = "Protects a curve from changes of its shape, or allows them again.",
         .group = CommandGroup::curve,
         .parameters = {{"i", Kind::number, which_curve}, {"locked", Kind::number, "1 to lock it, 0 to unlock it"}},
         .refusal = no_curve,
         .edit = set_locked,
         .label = [](const EditorState& state, const Arguments& arguments) {
             return (arguments.number(1) != 0.0 ? "Lock curve " : "Unlock curve ") +
                    quoted_name(state, arguments.number(0));
         }});
}

}  // namespace

void add_document_commands(std::vector<CommandSpec>& table) {
    add_curve_list(table);
    add_entries(table);
}

}  // namespace batten::editor
