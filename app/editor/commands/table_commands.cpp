#include "app/editor/commands/table_commands.h"

#include <algorithm>

#include "app/editor/clipboard.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/pointer/fit_view.h"
#include "app/editor/state/show_dialog.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/ascii.h"
#include "core/base/sentence.h"
#include "core/curve/knot_kinds.h"
#include "core/document/point_table.h"
#include "core/make/fit.h"
#include "core/make/shapes.h"
#include "core/make/through_points.h"
#include "core/refine/join.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;
using core::sentence;
using Points = std::vector<core::Point>;

constexpr int usual_degree = 3;
constexpr double share_of_size = 1e-3;  // of the size of the points

/// What both commands ask for.
struct TableChoice {
    TableUse use = TableUse::through;
    std::optional<double> tolerance{};
    TableEnds ends = TableEnds::open;
    std::optional<std::size_t> x_column{};
    std::optional<std::size_t> y_column{};
};

template <class Command>
TableChoice choice_of(const Command& command) {
    return {command.use, command.tolerance, command.ends, command.x_column, command.y_column};
}

std::optional<core::TableColumns> columns_of(const TableChoice& choice) {
    if (!choice.x_column && !choice.y_column) return std::nullopt;
    core::TableColumns columns;
    columns.x = choice.x_column.value_or(columns.x);
    columns.y = choice.y_column.value_or(columns.x + 1);
    return columns;
}

int degree_for(const Points& points) {
    return std::clamp(static_cast<int>(points.size()) - 1, 1, usual_degree);
}

double tolerance_of(const TableChoice& choice, const Points& points) {
    if (choice.tolerance) return *choice.tolerance;
    core::Box box;
    for (const core::Point point : points) box.include(point);
    return share_of_size * std::max(box.size().x, box.size().y);
}

core::Result<core::Curve> controlled_by(const Points& points, bool is_periodic) {
    const int degree = is_periodic ? usual_degree : degree_for(points);
    const auto knots = core::make_knots(is_periodic ? core::KnotKind::periodic : core::KnotKind::clamped_uniform,
                                        degree, points.size());
    if (!knots) return tl::unexpected(knots.error());
    const auto stored = knots->stored();
    return core::Curve::make({.degree = degree,
                              .knots = {stored.begin(), stored.end()},
                              .points = points,
                              .periodic = is_periodic,
                              .kind = knots->kind()});
}

core::Result<core::Approximation> approximation(core::Result<core::Curve> curve) {
    return std::move(curve).map([](core::Curve made) { return core::Approximation{std::move(made), 0.0}; });
}

/// What came of a table.
struct MadeCurve {
    core::Curve curve;
    double error = 0.0;                            // of a fit
    std::shared_ptr<const core::FitPoints> fit{};  // that the curve passes
};

// The curve near to the points or controlled by them.
core::Result<core::Approximation> made_of(const Points& points, const TableChoice& choice, bool is_periodic,
                                          const core::Progress& progress) {
    const core::Ends ends = is_periodic ? core::Ends(core::ClosedEnds{}) : core::Ends(core::FreeEnds{});
    const int degree = is_periodic ? usual_degree : degree_for(points);
    if (choice.use == TableUse::control) return approximation(controlled_by(points, is_periodic));
    return core::fit_within(points, tolerance_of(choice, points), {.degree = degree, .ends = ends}, progress);
}

// A straight way back to the start, where the ends do not meet.
core::Result<core::Approximation> with_way_back(core::Approximation made, const Points& points) {
    if (points.front() == points.back()) return made;
    const auto back = core::line(points.back(), points.front());
    if (!back) return tl::unexpected(back.error());
    return core::join(made.curve, *back, core::JoinContinuity::c0, {core::CurveEnd::end, core::CurveEnd::start})
        .map([&](core::JoinedCurve joined) {
            return core::Approximation{std::move(joined.curve), made.error};
        });
}

// The points that the curve passes: as those of the pen. A curve that is closed with a corner ends where it begins.
core::Result<core::FitPoints> fit_of(Points points, TableEnds ends) {
    const bool needs_way_back = ends == TableEnds::corner && points.front() != points.back();
    const std::size_t last = points.size() - 1;
    if (needs_way_back) points.push_back(points.front());
    const core::FitForm form{.parametrization = core::Parametrization::centripetal,
                             .closed = ends == TableEnds::closed};
    auto fit = core::fit_points_at(points, form);
    if (!fit || !needs_way_back) return fit;
    return core::set_fit_joint(*fit, last, core::FitJoint::corner_straight);
}

core::Result<MadeCurve> passing(const Points& points, TableEnds ends, const core::Progress& progress) {
    auto fit = fit_of(points, ends);
    if (!fit) return tl::unexpected(fit.error());
    auto curve = core::through_points(*fit, progress);
    if (!curve) return tl::unexpected(curve.error());
    return MadeCurve{*std::move(curve), 0.0, std::make_shared<const core::FitPoints>(*std::move(fit))};
}

core::Result<MadeCurve> curve_of(Points points, const TableChoice& choice, const core::Progress& progress) {
    const bool is_periodic = choice.ends == TableEnds::closed;
    // A closed curve returns by itself.
    if (is_periodic && points.size() > 1 && points.front() == points.back()) points.pop_back();
    if (choice.use == TableUse::through) return passing(points, choice.ends, progress);
    auto made = made_of(points, choice, is_periodic, progress);
    if (made && choice.ends == TableEnds::corner) made = with_way_back(*std::move(made), points);
    return std::move(made).map([](core::Approximation found) {
        return MadeCurve{std::move(found.curve), found.error};
    });
}

const char* pattern_of_reading(const core::PointTable& table) {
    if (table.has_decimal_commas)
        return "{read} points in columns {x} and {y}, separated by {separator}, with decimal commas";
    return "{read} points in columns {x} and {y}, separated by {separator}";
}

// How the table was read, and what came of it.
std::string remark_of(const Units& units, const core::PointTable& table, const MadeCurve& made, TableUse use) {
    const std::string reading = sentence(pattern_of_reading(table), {{"read", table.points.size()},
                                                                     {"x", table.columns.x},
                                                                     {"y", table.columns.y},
                                                                     {"separator", core::title_of(table.separator)}});
    const core::Place count("count", made.curve.control_points().size());
    if (use != TableUse::fit) return sentence("{reading}; {count} control points", {{"reading", reading}, count});
    return sentence("{reading}; {count} control points, the farthest point {error} from the curve",
                    {{"reading", reading}, count, {"error", bound_words(units, made.error)}});
}

// A name for the curve that keeps the number in the name of an airfoil.
std::string free_name(const core::Document& document, const std::string& wish) {
    if (!core::index_of_curve(document, wish)) return wish;
    return core::unused_name(document, sentence("{name} 2", {{"name", wish}}));
}

Outcome<Edit> with_points(const EditorState& state, std::string_view text, const TableChoice& choice,
                          const std::string& name) {
    core::FileResult<core::PointTable> table = core::read_point_table(text, columns_of(choice));
    if (!table) return tl::unexpected(table.error().where.empty() ? table.error().what : table.error().sentence());
    const Units& units = state.history.present().units;
    for (core::Point& point : table->points)
        point = core::Point(0.0, 0.0) + world_per_length(units) * core::vector_to(point);
    core::Result<MadeCurve> made = curve_of(table->points, choice, state.progress);
    if (!made) return refused(state, made.error());
    std::string remark = remark_of(units_of(state), *table, *made, choice.use);
    if (units)
        remark =
            sentence("{remark}; its numbers are {unit}", {{"remark", remark}, {"unit", core::title_of(units->unit)}});
    if (const std::string told = core::told_of_other_curves(*table); !told.empty())
        remark = sentence("{remark}; {told}", {{"remark", remark}, {"told", told}});
    const std::string wish = table->title.empty() ? name : free_name(state.history.present(), table->title);
    Edit edit = with_curve(state, wish, std::move(made->curve));
    edit.document.curves.back().fit = std::move(made->fit);
    edit.remark = std::move(remark);
    return edit;
}

Outcome<Edit> points_from_table(const EditorState& state, const PointsFromTable& command) {
    return with_points(state, command.text, choice_of(command), "points");
}

Outcome<Edit> points_from_file(const EditorState& state, const PointsFromFile& command) {
    const fs::path path = absolute_path(command.path);
    const core::FileResult<std::string> text = core::read_text(path);
    if (!text)
        return tl::unexpected(
            sentence("{file}: {what}", {{"file", path.filename().string()}, {"what", text.error().what}}));
    return with_points(state, *text, choice_of(command), path.stem().string()).map_error([&](const Refusal& refusal) {
        return sentence("{file}: {what}", {{"file", path.filename().string()}, {"what", refusal}});
    });
}

// The form of the command, over a view of all that it would make.
void ask_about(EditorState& state, const CommandSpec& form, const Outcome<Edit>& made) {
    if (made) {
        state.preview = made->document;
        fit_view(state);
        state.preview.reset();
    }
    show_dialog(state, Dialog::command_form);
    state.form = &form;
}

Outcome<void> open_table(EditorState& state, const OpenTable& command) {
    if (!command.path) {
        show_dialog(state, Dialog::open_table);
        return {};
    }
    state.table = absolute_path(*command.path);
    ask_about(state, PointsFromFile::spec(), points_from_file(state, {.path = state.table}));
    return {};
}

Outcome<void> paste_points(EditorState& state, const PastePoints&) {
    const Outcome<Edit> made = points_from_table(state, {.text = read_clipboard(state)});
    if (!made) return tl::unexpected(made.error());
    ask_about(state, PointsFromTable::spec(), made);
    return {};
}

std::string text_to_paste(const EditorState& state) {
    return read_clipboard(state);
}

std::optional<fs::path> file_to_open(const EditorState& state) {
    return state.table.empty() ? std::nullopt : std::optional(state.table);
}

template <class Command>
std::vector<Field> table_fields(Field source) {
    return {
        std::move(source),
        field::choice<&Command::use>("use", "what the points are to the curve").usually(TableUse::through),
        field::length<&Command::tolerance>("tolerance",
                                           "how near a fit comes; left out, a thousandth of the size of the points")
            .above(0.0)
            .absent_as("usual"),
        field::choice<&Command::ends>("ends", "whether and how the curve returns to the first point")
            .usually(TableEnds::open),
        field::count<&Command::x_column>(
            "x", "the column of x, from 1; left out, the one named x, or the first one of numbers")
            .at_least(1.0)
            .absent_as("first"),
        field::count<&Command::y_column>("y", "the column of y; left out, the one named y, or the next one of numbers")
            .at_least(1.0)
            .absent_as("next")};
}

}  // namespace

bool is_named_as_table(const fs::path& path) {
    const std::string ending = core::in_small_letters(path.extension().string());
    return ending == ".csv" || ending == ".dat" || ending == ".tsv" || ending == ".txt";
}

const CommandSpec& PointsFromTable::spec() {
    static const CommandSpec spec{
        .name = "points-from-table",
        .title = "Points from table",
        .explanation = "Adds a curve through, near or controlled by points that were copied, as from a spreadsheet.",
        .synonyms = "table csv import spreadsheet",
        .group = CommandGroup::edit,
        .offered = {.menu = false, .palette = false},
        .fields = table_fields<PointsFromTable>(
            field::text<&PointsFromTable::text>("text", "lines with x and y").suggesting<text_to_paste>().unasked()),
        .run = body_of<points_from_table>,
        .at_work = "Making a curve from points",
        .step = "Paste points",
        .done = "Pasted points"};
    return spec;
}

const CommandSpec& PointsFromFile::spec() {
    static const CommandSpec spec{
        .name = "points-from-file",
        .title = "Points from file",
        .explanation = "Adds a curve through, near or controlled by the points in a table or an airfoil's coordinates.",
        .synonyms = "table csv dat import airfoil",
        .group = CommandGroup::file,
        .offered = {.menu = false},
        .fields = table_fields<PointsFromFile>(
            field::file<&PointsFromFile::path>("path", "the file: CSV, .dat or text").beginning_with<file_to_open>()),
        .run = body_of<points_from_file>,
        .at_work = "Making a curve from {path}",
        .step = "Points from {path}",
        .done = "Read {path}"};
    return spec;
}

const CommandSpec& OpenTable::spec() {
    static const CommandSpec spec{
        .name = "open-table",
        .title = "Open table…",
        .explanation = "Opens a table of points or an airfoil's coordinates, and asks what the points are.",
        .synonyms = "csv dat import airfoil spreadsheet",
        .group = CommandGroup::file,
        .offered = in_the_window,
        .fields = {field::file<&OpenTable::path>("path", "the file; left out: asks for one").absent_as("").unasked()},
        .run = body_of<open_table>,
        .is_logged = false};
    return spec;
}

const CommandSpec& PastePoints::spec() {
    static const CommandSpec spec{
        .name = "paste-points",
        .title = "Paste points…",
        .explanation = "Asks what the points are that were copied, as from a spreadsheet, and makes a curve of them.",
        .synonyms = "table csv import spreadsheet",
        .group = CommandGroup::edit,
        .offered = in_the_window,
        .run = body_of<paste_points>,
        .is_logged = false};
    return spec;
}

void add_table_commands(CommandTable& table) {
    add_all<OpenTable, PointsFromFile, PastePoints, PointsFromTable>(table);
}

}  // namespace batten::editor
