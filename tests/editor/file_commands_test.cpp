#include <gtest/gtest.h>

#include <iterator>

#include "sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

class FileCommands : public ::testing::Test {
  protected:
    FileCommands() : wave_(folder_.write("wave.json", sample_text)), arch_(folder_.write("arch.json", bezier_text)) {}

    const EditorState& state() const { return editor_.state(); }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }
    static std::string content(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    TemporaryFolder folder_;
    fs::path wave_;
    fs::path arch_;
    Editor editor_;
};

TEST_F(FileCommands, open_a_file) {
    run("welcome");
    EXPECT_TRUE(run("open", {wave_.string()}));
    EXPECT_EQ(state().path, wave_);
    EXPECT_EQ(state().file_name(), "wave.json");
    EXPECT_EQ(document(editor_).curves.size(), 3U);
    EXPECT_FALSE(state().is_modified());
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(state().message, (Message{"Opened wave.json", false}));
    EXPECT_EQ(state().parameter(), 0.5);
}

TEST_F(FileCommands, open_with_the_view_of_the_file) {
    const fs::path path = folder_.write("view.json", R"({"format":"batten","version":1,"curves":[
        {"degree":1,"knots":[0,0,2,2],"points":[[0,0],[1,1]]}], "view": {"parameter": 0.25, "overlays": ["grid","hodograph"]}})");
    EXPECT_TRUE(run("open", {path.string()}));
    EXPECT_EQ(state().parameter(), 0.25);
    for (std::size_t i = 0; i < overlay_count; ++i) {
        const auto overlay = static_cast<Overlay>(i);
        EXPECT_EQ(state().view.overlays.is_shown(overlay), overlay == Overlay::grid || overlay == Overlay::hodograph)
            << i;
    }
}

TEST_F(FileCommands, a_broken_file_changes_nothing_but_the_message) {
    run("open", {wave_.string()});
    run("select-points", {2.0});
    const auto before = document(editor_).curves[0].curve;
    const fs::path broken = folder_.write("broken.json", R"({"format":"batten","version":1,"curves":[
        {"degree":3,"knots":[0,0,0,0,0.5,0.25,1,1,1,1],"points":[[0,0],[1,1],[2,2],[3,3],[4,4],[5,5]]}]})");
    EXPECT_FALSE(run("open", {broken.string()}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(
        state().message.text,
        "broken.json: /curves/0/knots/5: knot 5 is 0.25, less than knot 4, which is 0.5; knots must not decrease");
    EXPECT_EQ(document(editor_).curves[0].curve, before);
    EXPECT_EQ(state().path, wave_);
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{2});
    EXPECT_FALSE(run("open", {(folder_.path() / "missing.json").string()}));
    EXPECT_EQ(state().message.text.rfind("missing.json: the file cannot be opened", 0), 0U) << state().message.text;
    EXPECT_EQ(state().recent_files, std::vector<fs::path>{wave_});
}

TEST_F(FileCommands, open_without_a_path_asks_for_one) {
    run("open", {wave_.string()});
    run("set-weight", {0.0, 2.0});
    EXPECT_TRUE(run("open"));
    EXPECT_EQ(state().dialog, Dialog::open_file);
    EXPECT_EQ(state().pending, std::nullopt);
    EXPECT_TRUE(run("open", {arch_.string()}));
    EXPECT_EQ(state().dialog, Dialog::unsaved_changes);
}

TEST_F(FileCommands, save_what_was_edited_and_no_more) {
    run("open", {wave_.string()});
    run("save");
    const std::string first = content(wave_);
    run("move-points", {1.0, 0.5, 0.0});
    EXPECT_TRUE(state().is_modified());
    EXPECT_TRUE(run("save"));
    EXPECT_FALSE(state().is_modified());
    EXPECT_EQ(state().message, (Message{"Saved wave.json", false}));
    const std::string second = content(wave_);
    EXPECT_NE(first, second);
    core::Document moved = *core::parse_document(first);
    const auto saved = core::parse_document(second);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->curves[0].curve->control_points()[1].x, moved.curves[0].curve->control_points()[1].x + 0.5);
    run("undo");
    EXPECT_TRUE(state().is_modified());
    run("save");
    EXPECT_EQ(content(wave_), first);
}

TEST_F(FileCommands, save_the_view_too) {
    run("open", {wave_.string()});
    run("activate-curve", {1.0});
    run("set-parameter", {3.5});
    run("toggle-grid");
    run("toggle-hodograph");
    run("save");
    Editor other;
    other.run({"open", {wave_.string()}});
    EXPECT_EQ(other.state().parameter(), 3.5);
    EXPECT_EQ(other.state().view.overlays, state().view.overlays);
    EXPECT_EQ(document(other).active, 1U);
}

TEST_F(FileCommands, keep_overlays_of_a_later_version) {
    const fs::path path = folder_.write("later.json", R"({"format":"batten","version":1,"curves":[],
        "view": {"overlays": ["grid","shadow"]}})");
    run("open", {path.string()});
    run("save");
    const auto saved = core::parse_document(content(path));
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->view.overlays, (std::vector<std::string>{"grid", "shadow"}));
}

TEST_F(FileCommands, save_as_another_file) {
    run("open", {wave_.string()});
    EXPECT_TRUE(run("save-as", {(folder_.path() / "copy").string()}));
    EXPECT_EQ(state().path, folder_.path() / "copy.json");
    EXPECT_TRUE(fs::exists(folder_.path() / "copy.json"));
    EXPECT_EQ(state().recent_files, (std::vector<fs::path>{folder_.path() / "copy.json", wave_}));
    EXPECT_FALSE(run("save-as", {(folder_.path() / "no" / "such" / "folder.json").string()}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(state().path, folder_.path() / "copy.json");
    EXPECT_TRUE(run("save-as"));
    EXPECT_EQ(state().dialog, Dialog::save_file);
}

TEST_F(FileCommands, ask_about_unsaved_changes) {
    run("open", {wave_.string()});
    run("set-weight", {0.0, 2.0});
    for (const Command& command : {Command{"new", {}}, Command{"open", {arch_.string()}}, Command{"quit", {}},
                                   Command{"open-example", {"arch"}}}) {
        EXPECT_TRUE(editor_.run(command));
        EXPECT_EQ(state().dialog, Dialog::unsaved_changes);
        EXPECT_EQ(state().pending, command);
        EXPECT_EQ(state().path, wave_);
        EXPECT_TRUE(run("answer-unsaved", {"cancel"}));
        EXPECT_EQ(state().dialog, Dialog::none);
        EXPECT_EQ(state().pending, std::nullopt);
        EXPECT_FALSE(state().wants_quit);
        EXPECT_TRUE(state().is_modified());
    }
    EXPECT_FALSE(run("answer-unsaved", {"discard"}));
    run("quit");
    EXPECT_FALSE(run("answer-unsaved", {"maybe"}));
    EXPECT_EQ(state().dialog, Dialog::unsaved_changes);
    EXPECT_TRUE(run("answer-unsaved", {"discard"}));
    EXPECT_TRUE(state().wants_quit);
}

TEST_F(FileCommands, save_before_going_on) {
    run("open", {wave_.string()});
    run("set-weight", {0.0, 2.0});
    run("open", {arch_.string()});
    EXPECT_TRUE(run("answer-unsaved", {"save"}));
    EXPECT_EQ(state().path, arch_);
    EXPECT_EQ(core::load_document(wave_)->curves[0].curve->weights()[0], 2.0);
}

TEST_F(FileCommands, save_an_untitled_document_before_going_on) {
    run("new-curve", {std::vector<double>{0, 0, 1, 1}});
    run("quit");
    EXPECT_TRUE(run("answer-unsaved", {"save"}));
    EXPECT_EQ(state().dialog, Dialog::save_file);
    EXPECT_FALSE(state().wants_quit);
    EXPECT_TRUE(run("save-as", {(folder_.path() / "line.json").string()}));
    EXPECT_TRUE(state().wants_quit);
    EXPECT_EQ(state().dialog, Dialog::none);
}

TEST_F(FileCommands, a_failed_saving_gives_up_what_waited) {
    const fs::path path = folder_.path() / "gone" / "wave.json";
    fs::create_directory(path.parent_path());
    fs::copy_file(wave_, path);
    run("open", {path.string()});
    run("set-weight", {0.0, 2.0});
    fs::remove_all(path.parent_path());
    run("quit");
    EXPECT_FALSE(run("answer-unsaved", {"save"}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_TRUE(state().is_modified());
    EXPECT_TRUE(run("save-as", {(folder_.path() / "kept.json").string()}));
    EXPECT_FALSE(state().wants_quit);
}

TEST_F(FileCommands, a_failed_opening_after_discard_keeps_the_changes) {
    run("open", {wave_.string()});
    run("set-weight", {0.0, 2.0});
    run("open", {(folder_.path() / "missing.json").string()});
    EXPECT_FALSE(run("answer-unsaved", {"discard"}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_TRUE(state().is_modified());
    EXPECT_EQ(curve(editor_).weights()[0], 2.0);
}

TEST_F(FileCommands, begin_a_new_document) {
    run("open", {wave_.string()});
    run("select-points", {1.0});
    EXPECT_TRUE(run("new"));
    EXPECT_EQ(state().active_curve(), nullptr);
    EXPECT_EQ(state().file_name(), "untitled");
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_FALSE(state().is_modified());
    EXPECT_FALSE(state().history.can_undo());
}

TEST_F(FileCommands, open_an_example_as_untitled) {
    Desktop desktop;
    desktop.examples = folder_.path();
    Editor editor(desktop);
    EXPECT_TRUE(editor.run({"open-example", {"arch"}}));
    EXPECT_EQ(document(editor).curves[0].name, "arch");
    EXPECT_EQ(editor.state().path, "");
    EXPECT_FALSE(editor.state().is_modified());
    EXPECT_TRUE(editor.state().recent_files.empty());
    EXPECT_TRUE(editor.run({"save", {}}));
    EXPECT_EQ(editor.state().dialog, Dialog::save_file);
    for (const std::string& name :
         {std::string("nothing"), std::string(), std::string("../wave"), (folder_.path() / "arch").string()}) {
        EXPECT_FALSE(editor.run({"open-example", {name}})) << name;
        EXPECT_EQ(editor.state().message.text, "there is no example called '" + name + "'");
    }
}

TEST_F(FileCommands, remember_ten_recent_files_newest_first) {
    std::vector<fs::path> expected;
    for (int i = 0; i < 12; ++i) {
        const fs::path path = folder_.write("file" + std::to_string(i) + ".json", bezier_text);
        run("open", {path.string()});
        expected.insert(expected.begin(), path);
    }
    expected.resize(10);
    EXPECT_EQ(state().recent_files, expected);
    run("open", {expected[4].string()});
    EXPECT_EQ(state().recent_files.size(), 10U);
    EXPECT_EQ(state().recent_files[0], expected[4]);
    EXPECT_EQ(state().recent_files[1], expected[0]);
}

TEST_F(FileCommands, add_the_curves_of_a_file) {
    run("open", {arch_.string()});
    EXPECT_TRUE(run("add-file", {wave_.string()}));
    EXPECT_TRUE(run("add-file", {arch_.string()}));
    ASSERT_EQ(document(editor_).curves.size(), 5U);
    EXPECT_EQ(document(editor_).curves[4].name, "arch 2");
    EXPECT_EQ(document(editor_).active, 4U);
    EXPECT_EQ(state().history.undo_label(), "Add file arch.json");
    EXPECT_EQ(state().path, arch_);
    EXPECT_FALSE(run("add-file", {"/nowhere.json"}));
    run("undo");
    run("undo");
    EXPECT_FALSE(state().is_modified());
}

}  // namespace
}  // namespace batten::editor
