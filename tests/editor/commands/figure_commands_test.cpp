#include "app/editor/commands/figure_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_spec.h"
#include "app/editor/commands/overlay_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

/// What the desktop is asked to write.
struct Asked {
    std::filesystem::path path;
    FigureForm form;
    std::size_t times = 0;
};

class FigureCommands : public ::testing::Test {
  protected:
    FigureCommands() {
        Desktop desktop;
        desktop.write_figure = [this](const EditorState&, const std::filesystem::path& path,
                                      const FigureForm& form) -> tl::expected<std::vector<std::string>, std::string> {
            asked_ = {path, form, asked_.times + 1};
            if (path.extension() == ".doc")
                return tl::unexpected(std::string("'wave.doc' has the ending of no figure"));
            return lacks_;
        };
        editor_ = Editor(desktop);
    }

    TemporaryFolder folder_;
    Asked asked_;
    std::vector<std::string> lacks_;
    Editor editor_;
};

TEST_F(FigureCommands, ask_the_desktop_for_what_was_chosen) {
    ASSERT_TRUE(editor_.run(Open{.path = folder_.write("wave.json", sample_text)}));
    EXPECT_TRUE(run_typed(editor_, "export-figure /tmp/a.png both 300 300 2 \"A wave\" dark on"))
        << editor_.state().message.text;
    EXPECT_EQ(asked_.path, "/tmp/a.png");
    EXPECT_EQ(asked_.form.view, FigureView::both);
    EXPECT_EQ(asked_.form.size_px, glm::dvec2(300.0, 300.0));
    EXPECT_EQ(asked_.form.scale, 2.0);
    EXPECT_TRUE(asked_.form.is_transparent);
    EXPECT_EQ(asked_.form.title, "A wave");
    EXPECT_EQ(editor_.state().message.text, "Exported a.png");
    EXPECT_TRUE(editor_.run(ExportFigure{.path = "/tmp/b.svg"}));
    EXPECT_EQ(asked_.form.view, FigureView::curve);
    EXPECT_FALSE(asked_.form.is_transparent);
}

TEST_F(FigureCommands, take_a_size_and_the_colors_that_are_typed) {
    ASSERT_TRUE(editor_.run(Open{.path = folder_.write("wave.json", sample_text)}));
    editor_.change(ResizeCanvas{{1200.0, 800.0}});
    EXPECT_TRUE(editor_.run(ExportFigure{.path = "/tmp/b.svg"}));
    EXPECT_FALSE(asked_.form.size_px);
    EXPECT_TRUE(editor_.run(ExportFigure{.path = "/tmp/b.svg", .width = 300.0, .theme = FigureTheme::high_contrast}));
    EXPECT_EQ(asked_.form.size_px, glm::dvec2(300.0, 200.0)) << "the height follows";
    EXPECT_EQ(asked_.form.theme, FigureTheme::high_contrast);
    EXPECT_TRUE(editor_.run(ExportFigure{.path = "/tmp/b.svg", .height = 400.0}));
    EXPECT_EQ(asked_.form.size_px, glm::dvec2(600.0, 400.0));
    EXPECT_TRUE(editor_.run(ExportFigure{.path = "/tmp/b.svg", .width = 100.0, .height = 400.0}));
    EXPECT_EQ(asked_.form.size_px, glm::dvec2(100.0, 400.0));
    EXPECT_FALSE(run_typed(editor_, "export-figure a.svg curve 0"));
}

TEST_F(FigureCommands, tell_what_the_file_lacks) {
    ASSERT_TRUE(editor_.run(Open{.path = folder_.write("wave.json", sample_text)}));
    lacks_ = {"there was no room for the label P1; a larger figure may have it"};
    EXPECT_TRUE(editor_.run(ExportFigure{.path = "/tmp/b.svg"}));
    EXPECT_EQ(editor_.state().message.text,
              "Exported b.svg; there was no room for the label P1; a larger figure may have it");
}

TEST_F(FigureCommands, say_what_the_desktop_refuses) {
    ASSERT_TRUE(editor_.run(Open{.path = folder_.write("wave.json", sample_text)}));
    EXPECT_FALSE(editor_.run(ExportFigure{.path = "wave.doc"}));
    EXPECT_NE(editor_.state().message.text.find("has the ending of no figure"), std::string::npos);
}

TEST_F(FigureCommands, need_a_curve_and_a_scale_within_limits) {
    EXPECT_FALSE(editor_.run(ExportFigure{.path = "/tmp/a.svg"}));
    EXPECT_NE(editor_.state().message.text.find("there is no visible curve to be shown"), std::string::npos);
    ASSERT_TRUE(editor_.run(Open{.path = folder_.write("wave.json", sample_text)}));
    for (const char* scale : {"0", "-1", "9", "nan"})
        EXPECT_FALSE(run_typed(editor_, std::string("export-figure a.svg curve 300 200 ") + scale)) << scale;
    EXPECT_EQ(asked_.times, 0U);
}

TEST_F(FigureCommands, replace_a_file_only_where_that_is_chosen) {
    ASSERT_TRUE(editor_.run(Open{.path = folder_.write("wave.json", sample_text)}));
    const std::filesystem::path drawing = folder_.write("wave.svg", "drawn elsewhere");
    EXPECT_FALSE(editor_.run(ExportFigure{.path = drawing}));
    EXPECT_EQ(editor_.state().message.text, "wave.svg is there already; choose 'replace', or another name");
    EXPECT_EQ(asked_.times, 0U);
    EXPECT_TRUE(editor_.run(ExportFigure{.path = drawing, .replace = true}));
    EXPECT_EQ(asked_.path, drawing);
    folder_.write("wave figure.svg", "of yesterday");
    const Field& path = ExportFigure::spec().fields.front();
    EXPECT_EQ(std::get<std::string>(path.initial(editor_.state())), folder_.path() / "wave figure 2.svg");
}

TEST_F(FigureCommands, refuse_a_height_that_presses_the_plots_flat) {
    ASSERT_TRUE(editor_.run(Open{.path = folder_.write("wave.json", sample_text)}));
    ExportFigure command{.path = folder_.path() / "low.svg", .view = FigureView::both, .width = 300.0, .height = 239.0};
    EXPECT_FALSE(editor_.run(command));
    EXPECT_EQ(editor_.state().message.text, "with these parts a figure needs a height of at least 240 pixels");
    EXPECT_EQ(asked_.times, 0u);
    command.height = 240.0;
    EXPECT_TRUE(editor_.run(command));
    command.title = "N";
    EXPECT_FALSE(editor_.run(command));
    command.view = FigureView::curve;
    EXPECT_TRUE(editor_.run(command));
    EXPECT_EQ(asked_.times, 2u);
}

}  // namespace
}  // namespace batten::editor
