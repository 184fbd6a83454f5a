#include "app/editor/commands/table_commands.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "app/editor/command_spec.h"
#include "app/editor/commands/dropped_file.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/picture_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/session.h"
#include "core/evaluate/evaluator.h"
#include "core/make/through_points.h"
#include "core/measure/nearest.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class TableCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::string& said() const { return state().message.text; }
    bool paste(const std::string& text, TableUse use, TableEnds ends = TableEnds::open) {
        return editor_.run(PointsFromTable{.text = text, .use = use, .ends = ends});
    }

    double distance_to_curve(core::Point point) const {
        return core::distance(core::nearest_point(curve(editor_), point).point, point);
    }

    Editor editor_;
};

constexpr const char* square = "x;y\n0,5;0\n2;0\n2;1,5\n0,5;1,5\n";

TEST_F(TableCommands, points_are_in_the_unit_of_the_document) {
    ASSERT_TRUE(editor_.run(SetUnits{.unit = UnitChoice::mm, .scale = 0.125}));
    ASSERT_TRUE(paste(square, TableUse::control)) << said();
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0.0625, 0}, {0.25, 0}, {0.25, 0.1875}, {0.0625, 0.1875}}));
    EXPECT_TRUE(said().ends_with("; its numbers are millimeters")) << said();
}

TEST_F(TableCommands, paste_says_where_a_table_can_be_pasted) {
    Editor editor;
    EXPECT_FALSE(editor.run(Paste{.text = square}));
    EXPECT_EQ(editor.state().message.text,
              "the clipboard holds a table of points; Edit > Paste points… makes a curve of it");
}

TEST_F(TableCommands, points_control) {
    ASSERT_TRUE(paste(square, TableUse::control)) << said();
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0.5, 0}, {2, 0}, {2, 1.5}, {0.5, 1.5}}));
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_FALSE(curve(editor_).is_periodic());
    EXPECT_EQ(said(),
              "Pasted points; 4 points in columns 1 and 2, separated by semicolons, with decimal commas; "
              "4 control points");
    ASSERT_TRUE(paste(square, TableUse::control, TableEnds::closed)) << said();
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(points(editor_).size(), 4U);
}

TEST_F(TableCommands, of_several_curves_the_first_is_read_and_the_others_are_told) {
    const char* samples = "curve,u,x,y\na,0,1,2\na,0.5,2,2\na,1,3,4\nb,0,5,6\nb,1,7,8\n";
    ASSERT_TRUE(paste(samples, TableUse::control)) << said();
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{1, 2}, {2, 2}, {3, 4}}));
    EXPECT_TRUE(said().ends_with("; the points are those of the first curve; the rows of another one are left out: 2"))
        << said();
}

TEST_F(TableCommands, points_are_passed) {
    ASSERT_TRUE(paste("0 0\n1 2\n3 1\n4 4\n6 5", TableUse::through)) << said();
    for (const core::Point point : {core::Point(0, 0), {1, 2}, {3, 1}, {4, 4}, {6, 5}})
        EXPECT_LT(distance_to_curve(point), 1e-12);
    // They can be dragged, as those of the pen.
    const core::FitPoints& fit = *document(editor_).active_curve()->fit;
    EXPECT_EQ(fit.points[3].place, core::Point(4, 4));
    EXPECT_EQ(fit.kind, core::FitKind::c2);
    EXPECT_EQ(core::through_points(fit).value(), curve(editor_));
    ASSERT_TRUE(editor_.run(MoveFitPoint{.index = 3, .position = {4, 5}})) << said();
    EXPECT_LT(distance_to_curve({4, 5}), 1e-12);
    ASSERT_TRUE(paste("0 0\n1 2\n3 1\n4 4\n0 0", TableUse::through, TableEnds::closed)) << said();
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(points(editor_).size(), 4U);
    // Two points make a line.
    ASSERT_TRUE(paste("0\t0\n1\t2", TableUse::through)) << said();
    EXPECT_LT(distance_to_curve({0.25, 0.5}), 1e-15);
}

TEST_F(TableCommands, points_are_near) {
    std::string text = "angle,x,y\n";
    for (int k = 0; k < 2000; ++k) {
        const double angle = 2 * std::numbers::pi * k / 2000;
        text += std::to_string(k) + "," + std::to_string(10 * std::cos(angle)) + "," +
                std::to_string(7 * std::sin(angle)) + "\n";
    }
    ASSERT_TRUE(editor_.run(PointsFromTable{.text = text,
                                            .use = TableUse::fit,
                                            .tolerance = 0.01,
                                            .ends = TableEnds::closed,
                                            .x_column = 2,
                                            .y_column = 3}))
        << said();
    EXPECT_LT(points(editor_).size(), 40U);
    const core::Evaluator evaluator(curve(editor_));
    for (int k = 0; k < 400; ++k) {
        const core::Point p =
            evaluator.point_at(curve(editor_).domain().lower + curve(editor_).domain().length() * k / 400);
        EXPECT_NEAR(std::hypot(p.x / 10, p.y / 7), 1.0, 0.003);
    }
    EXPECT_NE(said().find("2000 points in columns 2 and 3, separated by commas"), std::string::npos) << said();
    EXPECT_NE(said().find("the farthest point 0.0"), std::string::npos) << said();
    const std::string plain = said().substr(said().find("the farthest point "));
    ASSERT_TRUE(run_typed(editor_, "set-units mm 0.1"));
    ASSERT_TRUE(editor_.run(PointsFromTable{.text = text,
                                            .use = TableUse::fit,
                                            .tolerance = 0.001,
                                            .ends = TableEnds::closed,
                                            .x_column = 2,
                                            .y_column = 3}));
    const std::string again = said().substr(said().find("the farthest point "));
    EXPECT_NE(again.find(" mm from the curve"), std::string::npos) << again;
    EXPECT_NEAR(std::stod(again.substr(19)), std::stod(plain.substr(19)), 1e-9) << "of points in mm";
}

// NACA 2412 by its formula (Jacobs, Ward and Pinkerton 1933), with the last coefficient of a sharp trailing edge.
core::Point naca_2412(double x, bool is_upper) {
    const double thickness =
        5 * 0.12 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
    const double camber = x < 0.4 ? 0.02 / 0.16 * (0.8 * x - x * x) : 0.02 / 0.36 * (0.2 + 0.8 * x - x * x);
    const double slope = x < 0.4 ? 0.04 / 0.16 * (0.4 - x) : 0.04 / 0.36 * (0.4 - x);
    const double angle = std::atan(slope);
    const double side = is_upper ? 1.0 : -1.0;
    return {x - side * thickness * std::sin(angle), camber + side * thickness * std::cos(angle)};
}

std::string airfoil_table() {
    std::string text = "NACA 2412\n";
    constexpr int count = 50;
    const auto append = [&](int k, bool is_upper) {
        const core::Point p = naca_2412(0.5 * (1 - std::cos(std::numbers::pi * k / count)), is_upper);
        char line[64];
        std::snprintf(line, sizeof line, " %.7f %.7f\n", p.x, p.y);
        text += line;
    };
    for (int k = count; k >= 0; --k) append(k, true);
    for (int k = 1; k <= count; ++k) append(k, false);
    return text;
}

TEST_F(TableCommands, an_airfoil_from_its_table) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.write("naca2412.dat", airfoil_table());
    for (const TableUse use : {TableUse::through, TableUse::fit}) {
        ASSERT_TRUE(editor_.run(PointsFromFile{.path = file, .use = use, .tolerance = 5e-5, .ends = TableEnds::corner}))
            << said();
        // A number that belongs to the name is not counted on.
        EXPECT_EQ(document(editor_).active_curve()->name, use == TableUse::through ? "NACA 2412" : "NACA 2412 2");
        // Closed at the trailing edge.
        EXPECT_EQ(points(editor_).front(), points(editor_).back());
        EXPECT_NEAR(points(editor_).front().x, 1.0, 1e-6);
        const core::NearestFinder finder(curve(editor_));
        double most = 0.0;
        for (int k = 0; k <= 3000; ++k)
            for (const bool is_upper : {true, false}) {
                const double x = 0.5 * (1 - std::cos(std::numbers::pi * k / 3000));
                const core::Point true_point = naca_2412(x, is_upper);
                most = std::max(most, core::distance(finder.nearest(true_point).point, true_point));
            }
        EXPECT_LT(most, 1e-4) << core::name_of(use);
    }
}

TEST_F(TableCommands, a_blunt_end_is_closed_by_a_line) {
    ASSERT_TRUE(paste("1 0.1\n0.5 0.3\n0 0\n0.5 -0.3\n1 -0.1\n", TableUse::through, TableEnds::corner)) << said();
    EXPECT_EQ(points(editor_).front(), points(editor_).back());
    EXPECT_EQ(points(editor_).front(), core::Point(1, 0.1));
    EXPECT_LT(distance_to_curve({1, -0.1}), 1e-12);
    EXPECT_LT(distance_to_curve({1, 0.03}), 1e-12);
    const core::FitPoints& fit = *document(editor_).active_curve()->fit;
    ASSERT_EQ(fit.points.size(), 6U);
    EXPECT_EQ(fit.points[4].joint, core::FitJoint::corner_straight);
}

TEST_F(TableCommands, wrong_tables_change_nothing) {
    EXPECT_FALSE(paste("1;2\n3;x\n5;6", TableUse::through));
    EXPECT_EQ(said(), "line 2, column 2: 'x' is not a finite number; this table has decimal points");
    EXPECT_FALSE(paste("", TableUse::through));
    EXPECT_EQ(said(), "no line with two numbers was found; a table of points has x and y in two of its columns");
    EXPECT_FALSE(paste("nan\tnan\n1\t2\n3\t4", TableUse::through));
    EXPECT_EQ(said(), "line 1, column 1: 'nan' is not a finite number; this table has decimal points");
    EXPECT_FALSE(paste("1,234.5\t2\n3\t4", TableUse::through));
    EXPECT_EQ(said(), "line 1, column 1: '1,234.5' has thousands separators, which are not read");
    EXPECT_FALSE(paste("1 2\n", TableUse::through));
    EXPECT_FALSE(paste("1 2\n1 2\n", TableUse::through));
    EXPECT_FALSE(editor_.run(PointsFromTable{.text = "1 2\n3 4", .x_column = 3}));
    EXPECT_EQ(said(), "line 1, column 3: the line has 2 columns");
    EXPECT_FALSE(editor_.run(PointsFromFile{.path = "/no/such.csv"}));
    EXPECT_EQ(said().substr(0, 9), "such.csv:");
    const TemporaryFolder folder;
    EXPECT_FALSE(editor_.run(PointsFromFile{.path = folder.write("words.csv", "only words\n")}));
    EXPECT_EQ(said().substr(0, 36), "words.csv: no line with two numbers ");
    EXPECT_TRUE(document(editor_).curves.empty());
}

TEST_F(TableCommands, opening_a_table_asks_what_its_points_are) {
    editor_.run(OpenTable{});
    EXPECT_EQ(state().dialog, Dialog::open_table);
    editor_.run(OpenTable{.path = "/tmp/points.csv"});
    EXPECT_EQ(state().dialog, Dialog::command_form);
    EXPECT_EQ(state().form, &PointsFromFile::spec());
    EXPECT_EQ(state().form->fields.front().initial(state()), FieldValue(std::string("/tmp/points.csv")));
}

TEST_F(TableCommands, what_is_asked_about_is_in_view) {
    const TemporaryFolder folder;
    editor_.run(OpenTable{.path = folder.write("hull.csv", "0;1000\n20000;4000\n30000;3000\n")});
    const render::Camera& camera = state().view.camera;
    for (const core::Point point : {core::Point(0, 1000), {20000, 4000}, {30000, 3000}}) {
        const glm::dvec2 place = render::screen_from_world(camera, point);
        EXPECT_TRUE(place.x > 0 && place.y > 0 && place.x < camera.size_px.x && place.y < camera.size_px.y);
    }
    EXPECT_FALSE(state().preview);
    EXPECT_FALSE(editor_.run(PastePoints{}));
    EXPECT_EQ(said(), "no line with two numbers was found; a table of points has x and y in two of its columns");
    editor_.run(CopyText{.text = "1\t2\n3\t4\n"});
    EXPECT_TRUE(editor_.run(PastePoints{}));
    EXPECT_EQ(state().form, &PointsFromTable::spec());
    EXPECT_EQ(state().form->fields.front().suggestion(state()), FieldValue(std::string("1\t2\n3\t4\n")));
}

TEST_F(TableCommands, names_say_what_a_file_is) {
    EXPECT_NE(command_for_file(state(), "a.csv", true).as<OpenTable>(), nullptr);
    EXPECT_NE(command_for_file(state(), "b.DAT", false).as<OpenTable>(), nullptr);
    EXPECT_NE(command_for_file(state(), "c.png", true).as<AddPicture>(), nullptr);
    EXPECT_NE(command_for_file(state(), "d.json", true).as<Open>(), nullptr);
    EXPECT_NE(command_for_file(state(), "d.json", false).as<AddFile>(), nullptr);
}

TEST_F(TableCommands, a_preview_tells_what_would_come) {
    editor_.run(PointsFromTable{.text = square, .use = TableUse::through}, Phase::preview);
    EXPECT_EQ(said(), "4 points in columns 1 and 2, separated by semicolons, with decimal commas; 6 control points");
    EXPECT_FALSE(state().message.is_error);
    EXPECT_TRUE(document(editor_).curves.empty());
}

TEST_F(TableCommands, the_log_keeps_what_was_pasted) {
    ASSERT_TRUE(paste(square, TableUse::fit, TableEnds::closed)) << said();
    Editor replayed;
    ASSERT_TRUE(replayed.run(*parse_command(format_command(editor_.log().back()), replayed.state())));
    EXPECT_EQ(core::format_document(document(replayed)), core::format_document(document(editor_)));
    editor_.run(Undo{});
    EXPECT_TRUE(document(editor_).curves.empty());
}

}  // namespace
}  // namespace batten::editor
