#include "app/editor/commands/picture_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_spec.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/trace_commands.h"
#include "app/editor/session.h"
#include "core/evaluate/evaluator.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

const fs::path pictures = fs::path(BATTEN_TEST_DATA) / "pictures";
const fs::path ring = pictures / "ring_gray.png";

class PictureCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::string& said() const { return state().message.text; }
    const core::Picture& picture() const { return document(editor_).pictures.front(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    void add() {
        ASSERT_TRUE(run(AddPicture{.path = ring, .center = {10, 20}, .width = 32, .opacity = 0.5})) << said();
    }

    Editor editor_;
};

TEST_F(PictureCommands, add_a_picture_about_a_place) {
    add();
    EXPECT_EQ(picture().path, ring);
    EXPECT_EQ(picture().width, 64);
    EXPECT_EQ(picture().scale, 0.5);
    EXPECT_EQ(picture().position, core::Point(-6, 4));
    EXPECT_EQ(said(), "Added picture ring_gray.png");
    EXPECT_TRUE(document(editor_).curves.empty());
    run(Undo{});
    EXPECT_TRUE(document(editor_).pictures.empty());
    run(Redo{});
    EXPECT_EQ(document(editor_).pictures.size(), 1U);
}

TEST_F(PictureCommands, a_wrong_file_adds_nothing) {
    EXPECT_FALSE(run(AddPicture{.path = pictures / "cut_off.png", .center = {0, 0}, .width = 1, .opacity = 1}));
    EXPECT_EQ(said(), "cut_off.png: the picture is damaged or cut off and cannot be read");
    EXPECT_TRUE(document(editor_).pictures.empty());
}

TEST_F(PictureCommands, place_and_move) {
    add();
    EXPECT_TRUE(type("place-picture 0 1 2 128 90"));
    EXPECT_EQ(picture().position, core::Point(1, 2));
    EXPECT_EQ(picture().scale, 2.0);
    EXPECT_EQ(picture().rotation, 90.0);
    EXPECT_EQ(said(), "Placed the picture");
    EXPECT_TRUE(type("move-picture 0 7 8"));
    EXPECT_EQ(picture().position, core::Point(7, 8));
    EXPECT_FALSE(type("move-picture 1 7 8"));
    EXPECT_EQ(said(), "there is no picture 1; the last one is 0");
}

TEST_F(PictureCommands, two_points_and_their_distance_scale) {
    add();
    // From 4 apart to 10, about the first.
    EXPECT_TRUE(type("scale-picture 0 10 20 10 24 10"));
    EXPECT_DOUBLE_EQ(picture().scale, 1.25);
    EXPECT_EQ(picture().position, core::Point(10 - 2.5 * 16, 20 - 2.5 * 16));
    EXPECT_FALSE(type("scale-picture 0 1 1 1 1 10"));
    EXPECT_EQ(said(), "both points are the same; two different ones are needed to scale a picture");
    EXPECT_FALSE(type("scale-picture 0 1 1 2 2 0"));
}

TEST_F(PictureCommands, clicks_choose_the_two_points) {
    add();
    run(MeasurePicture{.picture = 0});
    EXPECT_EQ(said(), "Click two points of the picture whose distance you know · Escape gives up");
    editor_.change(AddGaugePoint{{10, 20}});
    EXPECT_EQ(state().dialog, Dialog::none);
    editor_.change(AddGaugePoint{{13, 24}});
    EXPECT_EQ(state().dialog, Dialog::command_form);
    EXPECT_EQ(state().form, &ScalePicture::spec());
    const std::vector<Field>& fields = state().form->fields;
    EXPECT_EQ(fields[1].initial(state()), FieldValue(core::Point(10, 20)));
    EXPECT_EQ(fields[2].initial(state()), FieldValue(core::Point(13, 24)));
    EXPECT_EQ(fields[3].initial(state()), FieldValue(5.0));
    run(CloseDialog{});
    EXPECT_FALSE(state().gauge);
    run(MeasurePicture{.picture = 0});
    type("escape");
    EXPECT_FALSE(state().gauge);
}

TEST_F(PictureCommands, a_locked_picture_stays) {
    add();
    EXPECT_TRUE(type("lock-picture"));
    EXPECT_EQ(said(), "Locked the picture");
    for (const char* command :
         {"move-picture 0 1 1", "place-picture 0 1 1 1 1", "scale-picture 0 0 0 1 1 5", "measure-picture"}) {
        EXPECT_FALSE(type(command)) << command;
        EXPECT_EQ(said(), "the picture is locked; unlock it first") << command;
    }
    // To dim, hide and remove it is no matter of its place.
    EXPECT_TRUE(type("dim-picture 0 0.25"));
    EXPECT_EQ(picture().opacity, 0.25);
    EXPECT_EQ(said(), "Set the picture's opacity to 0.25");
    EXPECT_TRUE(type("show-picture 0 no"));
    EXPECT_EQ(said(), "Hid the picture");
    EXPECT_FALSE(type("dim-picture 0 1.5"));
    EXPECT_TRUE(type("lock-picture 0 no"));
    EXPECT_EQ(said(), "Unlocked the picture");
    EXPECT_TRUE(type("remove-picture"));
    EXPECT_EQ(said(), "Removed the picture");
    EXPECT_TRUE(document(editor_).pictures.empty());
    EXPECT_FALSE(type("remove-picture"));
    EXPECT_EQ(said(), "the document has no picture; 'Add picture' adds one");
}

TEST_F(PictureCommands, pictures_of_an_added_file_come_along) {
    add();
    const TemporaryFolder folder;
    ASSERT_TRUE(run(SaveAs{.path = folder.path() / "scan.json"})) << said();
    EXPECT_FALSE(state().is_modified());
    run(NewDocument{});
    ASSERT_TRUE(run(Open{.path = folder.path() / "scan.json"})) << said();
    EXPECT_EQ(picture().path, ring);
    EXPECT_EQ(picture().position, core::Point(-6, 4));
}

double farthest_from_circle(const core::Curve& curve, core::Point center, double radius) {
    const core::Evaluator evaluator(curve);
    double most = 0.0;
    for (int k = 0; k < 500; ++k) {
        const double u = curve.domain().lower + curve.domain().length() * k / 500;
        most = std::max(most, std::abs(core::distance(evaluator.point_at(u), center) - radius));
    }
    return most;
}

// The ring of the picture: radii 12 and 24 about (32.3, 31.6) from the upper left.
TEST_F(PictureCommands, outlines_lie_where_the_picture_shows_them) {
    add();
    ASSERT_TRUE(type("place-picture 0 100 200 128 0"));
    ASSERT_TRUE(type("trace-picture")) << said();
    ASSERT_EQ(document(editor_).curves.size(), 2U);
    const core::Point center{100 + 2 * 32.3, 200 + 2 * (64 - 31.6)};
    EXPECT_LE(farthest_from_circle(*document(editor_).curves[0].curve, center, 48), 2 * 0.4);
    EXPECT_LE(farthest_from_circle(*document(editor_).curves[1].curve, center, 24), 2 * 0.4);
    EXPECT_EQ(document(editor_).curves[0].name, "ring_gray");
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_EQ(said().substr(0, 18), "Traced the picture");
    EXPECT_NE(said().find("2 outlines of what is darker than 127.5"), std::string::npos) << said();
    run(Undo{});
    EXPECT_TRUE(document(editor_).curves.empty());
}

TEST_F(PictureCommands, outlines_turn_with_the_picture) {
    add();
    ASSERT_TRUE(type("place-picture 0 0 0 64 90"));
    ASSERT_TRUE(type("trace-picture")) << said();
    const core::Point center{-(64 - 31.6), 32.3};
    EXPECT_LE(farthest_from_circle(*document(editor_).curves[0].curve, center, 24), 0.4);
}

TEST_F(PictureCommands, what_is_transparent_is_paper) {
    ASSERT_TRUE(run(TraceFile{
        .path = pictures / "ring_alpha.png", .threshold = {}, .tolerance = 0.3, .speckle = 8, .inverted = false}))
        << said();
    ASSERT_EQ(document(editor_).curves.size(), 2U);
    EXPECT_LE(farthest_from_circle(*document(editor_).curves[0].curve, {32.3, 64 - 31.6}, 24), 0.4);
    ASSERT_TRUE(run(TraceFile{
        .path = pictures / "ring_alpha.png", .threshold = {}, .tolerance = 0.3, .speckle = 8, .inverted = true}))
        << said();
    EXPECT_NE(said().find("outlines of what is lighter than"), std::string::npos) << said();
}

TEST_F(PictureCommands, refusals_of_tracing) {
    EXPECT_FALSE(type("trace-picture"));
    EXPECT_EQ(said(), "the document has no picture; 'Add picture' adds one");
    add();
    EXPECT_FALSE(type("trace-picture 0 none 0"));
    EXPECT_FALSE(type("trace-picture 0 300"));
    EXPECT_FALSE(run(TracePicture{.picture = 0, .threshold = {}, .tolerance = 0.3, .speckle = 1e9, .inverted = false}));
    EXPECT_EQ(said(), "nothing is outlined with the threshold 127.5; another one is needed");
    EXPECT_FALSE(run(
        TraceFile{.path = pictures / "none.png", .threshold = {}, .tolerance = 0.3, .speckle = 8, .inverted = false}));
    EXPECT_EQ(said(), "none.png: there is no such file");
}

TEST_F(PictureCommands, a_missing_file_is_told) {
    add();
    const TemporaryFolder folder;
    fs::copy_file(ring, folder.path() / "here.png");
    ASSERT_TRUE(run(AddPicture{.path = folder.path() / "here.png", .center = {0, 0}, .width = 1, .opacity = 1}));
    EXPECT_NE(state().pictures.of(folder.path() / "here.png").image, nullptr);
    fs::remove(folder.path() / "here.png");
    EXPECT_EQ(state().pictures.of(folder.path() / "here.png").problem, "here.png: there is no such file");
    EXPECT_FALSE(type("trace-picture"));
    EXPECT_EQ(said(), "here.png: there is no such file");
    fs::copy_file(ring, folder.path() / "here.png");
    EXPECT_NE(state().pictures.of(folder.path() / "here.png").image, nullptr);
}

TEST_F(PictureCommands, replay_of_the_log_gives_the_same) {
    add();
    type("place-picture 0 1 2 64 10");
    type("trace-picture");
    type("dim-picture 0 0.2");
    Editor replayed;
    for (const Command& command : editor_.log())
        ASSERT_TRUE(replayed.run(*parse_command(format_command(command), replayed.state())));
    EXPECT_EQ(core::format_document(document(replayed)), core::format_document(document(editor_)));
}

}  // namespace
}  // namespace batten::editor
