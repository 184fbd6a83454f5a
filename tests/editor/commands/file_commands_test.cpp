#include "app/editor/commands/file_commands.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <iterator>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/invariance_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/shape_view_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/commands/weight_commands.h"
#include "core/base/sentence.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

class FileCommands : public ::testing::Test {
  protected:
    FileCommands() : wave_(folder_.write("wave.json", sample_text)), arch_(folder_.write("arch.json", bezier_text)) {}

    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
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
    run(ToggleWelcome{});
    EXPECT_TRUE(run(Open{.path = wave_}));
    EXPECT_EQ(state().path, wave_);
    EXPECT_EQ(state().file_name(), "wave.json");
    EXPECT_EQ(document(editor_).curves.size(), 3U);
    EXPECT_FALSE(state().is_modified());
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(state().message, (Message{"Opened wave.json", false}));
    EXPECT_EQ(state().parameter(), 0.5);
}

TEST_F(FileCommands, open_tells_of_fit_points_that_are_not_of_their_curve) {
    const std::string lost = R"({"degree":3,"knots":[0,0,0,0,3,3,3,3],"points":[[0,0],[1,0],[2,0.1],[3,0]],
        "fit":{"kind":"c2","points":[[0,0],[3,0]],"parameters":[0,3]}})";
    const auto opened = [&](const std::string& curves) {
        EXPECT_TRUE(run(
            Open{.path = folder_.write("lost.json", R"({"format":"batten","version":1,"curves":[)" + curves + "]}")}));
        return state().message.text;
    };
    EXPECT_EQ(opened(lost),
              "Opened lost.json; one curve does not go through its fit points, so that it is an ordinary curve now");
    EXPECT_EQ(opened(lost + "," + lost),
              "Opened lost.json; 2 curves do not go through their fit points, so that they are ordinary curves now");
    EXPECT_TRUE(run(AddFile{.path = folder_.path() / "lost.json"}));
    EXPECT_NE(state().message.text.find("; 2 curves do not go through their fit points"), std::string::npos)
        << state().message.text;
}

TEST_F(FileCommands, open_with_the_view_of_the_file) {
    const fs::path path = folder_.write("view.json", R"({"format":"batten","version":1,"curves":[
        {"degree":1,"knots":[0,0,2,2],"points":[[0,0],[1,1]]}], "view": {"parameter": 0.25, "overlays": ["grid","hodograph"]}})");
    EXPECT_TRUE(run(Open{.path = path}));
    EXPECT_EQ(state().parameter(), 0.25);
    for (std::size_t i = 0; i < overlay_count; ++i) {
        const auto overlay = static_cast<Overlay>(i);
        EXPECT_EQ(state().view.overlays.is_shown(overlay), overlay == Overlay::grid || overlay == Overlay::hodograph)
            << i;
    }
}

TEST_F(FileCommands, a_broken_file_changes_nothing_but_the_message) {
    run(Open{.path = wave_});
    run(SelectPoints{.points = {2}});
    const auto before = document(editor_).curves[0].curve;
    const fs::path broken = folder_.write("broken.json", R"({"format":"batten","version":1,"curves":[
        {"degree":3,"knots":[0,0,0,0,0.5,0.25,1,1,1,1],"points":[[0,0],[1,1],[2,2],[3,3],[4,4],[5,5]]}]})");
    EXPECT_FALSE(run(Open{.path = broken}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(
        state().message.text,
        "broken.json: /curves/0/knots/5: knot 5 is 0.25, less than knot 4, which is 0.5; knots must not decrease");
    EXPECT_EQ(document(editor_).curves[0].curve, before);
    EXPECT_EQ(state().path, wave_);
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{2});
    EXPECT_FALSE(run(Open{.path = (folder_.path() / "missing.json")}));
    EXPECT_EQ(state().message.text.rfind("missing.json: the file cannot be opened", 0), 0U) << state().message.text;
    EXPECT_EQ(state().recent_files, std::vector<fs::path>{wave_});
}

TEST_F(FileCommands, open_without_a_path_asks_for_one) {
    run(Open{.path = wave_});
    run(SetWeight{.index = 0, .weight = 2.0});
    EXPECT_TRUE(run(Open{}));
    EXPECT_EQ(state().dialog, Dialog::open_file);
    EXPECT_FALSE(state().pending);
    EXPECT_TRUE(run(Open{.path = arch_}));
    EXPECT_EQ(state().dialog, Dialog::unsaved_changes);
}

TEST_F(FileCommands, save_what_was_edited_and_no_more) {
    run(Open{.path = wave_});
    run(Save{});
    const std::string first = content(wave_);
    run(MovePoints{.points = {1}, .offset = {0.5, 0.0}});
    EXPECT_TRUE(state().is_modified());
    EXPECT_TRUE(run(Save{}));
    EXPECT_FALSE(state().is_modified());
    EXPECT_EQ(state().message, (Message{"Saved wave.json", false}));
    const std::string second = content(wave_);
    EXPECT_NE(first, second);
    core::Document moved = *core::parse_document(first);
    const auto saved = core::parse_document(second);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->curves[0].curve->control_points()[1].x, moved.curves[0].curve->control_points()[1].x + 0.5);
    run(Undo{});
    EXPECT_TRUE(state().is_modified());
    run(Save{});
    EXPECT_EQ(content(wave_), first);
}

TEST_F(FileCommands, save_the_view_too) {
    run(Open{.path = wave_});
    run(ActivateCurve{.index = 1});
    run(SetParameter{.u = 3.5});
    run(ToggleOverlay<Overlay::grid>{});
    run(ToggleOverlay<Overlay::hodograph>{});
    run(Save{});
    Editor other;
    other.run(Open{.path = wave_});
    EXPECT_EQ(other.state().parameter(), 3.5);
    EXPECT_EQ(other.state().view.overlays, state().view.overlays);
    EXPECT_EQ(document(other).active, 1U);
}

TEST_F(FileCommands, save_the_forms_of_views_too) {
    run(Open{.path = wave_});
    const std::string plain = content(wave_);
    run(Save{});
    EXPECT_EQ(content(wave_).find("forms"), std::string::npos) << "as they begin";
    run(SetCombScale{.factor = 2.0});
    run(SetPartCount{.count = 7});
    run(PutLine{.first = {0, 1}, .second = {2, 3}});
    run(ShowMap{.kind = ShownMapKind::shear, .amount = 0.25});
    run(SetBlossomValues{.by_value = true});
    run(SetOrbit{.yaw = 30.0, .pitch = 10.0, .zoom = 2.0});
    run(Save{});
    Editor other;
    other.run(Open{.path = wave_});
    const View& view = other.state().view;
    EXPECT_EQ(view.shape.comb_factor, 2.0);
    EXPECT_EQ(view.shape.part_count, 7);
    EXPECT_EQ(view.shape.line, (ProbeLine{{0, 1}, {2, 3}}));
    EXPECT_EQ(view.shown_map, (ShownMap{ShownMapKind::shear, 0.25}));
    EXPECT_TRUE(view.blossom_values);
    EXPECT_EQ(view.orbit, state().view.orbit);
    other.run(Open{.path = folder_.write("plain.json", plain)});
    EXPECT_EQ(other.state().view.shape.part_count, 10) << "every document has its own";
    EXPECT_FALSE(other.state().view.blossom_values);
    EXPECT_FALSE(other.run(
        Open{.path = folder_.write("bad.json",
                                   R"({"format":"batten","version":1,"curves":[],"view":{"forms":{"parts":0}}})")}));
    EXPECT_EQ(other.state().message.text, "bad.json: /view/forms/parts: this must be from 1 to 200");
}

TEST_F(FileCommands, take_the_notation_of_a_document_and_go_back_to_the_usual_one) {
    Notation usual;
    usual.points = PointLetter::B;
    run(SetNotation{usual.points, usual.parameter, usual.degree, usual.triangles, usual.numbers});
    const fs::path lecture = folder_.write("lecture.json", R"({"format": "batten", "version": 1, "curves": [],
        "view": {"notation": {"points": "V", "parameter": "t", "color": "red"}}})");
    run(Open{.path = lecture});
    EXPECT_EQ(state().view.notation.points, PointLetter::V);
    EXPECT_EQ(state().view.notation.parameter, ParameterLetter::t);
    EXPECT_EQ(state().view.usual_notation, usual);
    run(SaveAs{.path = lecture});
    const auto saved = core::load_document(lecture);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->view.notation.at("points"), "V");
    EXPECT_EQ(saved->view.notation.at("color"), "red");
    run(Open{.path = folder_.write("plain.json", R"({"format": "batten", "version": 1, "curves": []})")});
    EXPECT_EQ(state().view.notation, usual);
}

TEST_F(FileCommands, keep_overlays_of_a_later_version) {
    const fs::path path = folder_.write("later.json", R"({"format":"batten","version":1,"curves":[],
        "view": {"overlays": ["grid","shadow"]}})");
    run(Open{.path = path});
    run(Save{});
    const auto saved = core::parse_document(content(path));
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->view.overlays, (std::vector<std::string>{"grid", "shadow"}));
}

TEST_F(FileCommands, save_as_another_file) {
    run(Open{.path = wave_});
    EXPECT_TRUE(run(SaveAs{.path = (folder_.path() / "copy")}));
    EXPECT_EQ(state().path, folder_.path() / "copy.json");
    EXPECT_TRUE(fs::exists(folder_.path() / "copy.json"));
    EXPECT_EQ(state().recent_files, (std::vector<fs::path>{folder_.path() / "copy.json", wave_}));
    EXPECT_FALSE(run(SaveAs{.path = (folder_.path() / "no" / "such" / "folder.json")}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(state().path, folder_.path() / "copy.json");
    EXPECT_TRUE(run(SaveAs{}));
    EXPECT_EQ(state().dialog, Dialog::save_file);
}

TEST_F(FileCommands, a_foreign_ending_is_not_given_curves) {
    run(Open{.path = wave_});
    for (const char* name : {"wave.ai", "wave.PDF", "wave.txt", "wave.3dm", "wave.json.gz", "wave.geojson"}) {
        EXPECT_FALSE(run(SaveAs{.path = folder_.path() / name})) << name;
        EXPECT_FALSE(fs::exists(folder_.path() / name)) << name;
    }
    EXPECT_FALSE(run(SaveAs{.path = folder_.path() / "v1.2.ai"}));
    EXPECT_EQ(state().message.text,
              "'v1.2.ai' ends in .ai, and curves are not written to such files; name it 'v1.2.json'");
    EXPECT_EQ(state().path, wave_);
}

TEST_F(FileCommands, advice_for_a_name_is_a_name_of_its_own) {
    run(Open{.path = wave_});
    EXPECT_FALSE(run(SaveAs{.path = folder_.path() / "x.json.bak"}));
    EXPECT_EQ(state().message.text,
              "'x.json.bak' ends in .bak, and curves are not written to such files; name it 'x.bak.json'");
    for (const char* name : {".svg", ".json"}) {
        EXPECT_FALSE(run(SaveAs{.path = folder_.path() / name}));
        EXPECT_EQ(state().message.text,
                  core::sentence("'{name}' is an ending without a name; name it 'curves.json'", {{"name", name}}));
        EXPECT_FALSE(fs::exists(folder_.path() / name)) << name;
    }
}

TEST_F(FileCommands, a_name_without_an_ending_is_given_one) {
    run(Open{.path = wave_});
    for (const auto& [typed, expected] :
         {std::pair("wave 1.5", "wave 1.5.json"), std::pair("St. Gallen", "St. Gallen.json"),
          std::pair("WAVE.JSON", "WAVE.JSON"), std::pair("out.Yk3xQz", "out.Yk3xQz.json"),
          std::pair(".hidden", ".hidden.json")}) {
        EXPECT_TRUE(run(SaveAs{.path = folder_.path() / typed})) << state().message.text;
        EXPECT_EQ(state().path, folder_.path() / expected);
    }
}

TEST_F(FileCommands, a_pipe_does_not_keep_the_window_waiting) {
    const fs::path pipe = folder_.path() / "pipe.json";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const bool runs : {run(Open{.path = pipe}), run(AddFile{.path = pipe})}) {
        EXPECT_FALSE(runs);
        EXPECT_EQ(state().message.text, "pipe.json: this is not an ordinary file, so it cannot be opened");
    }
}

TEST_F(FileCommands, a_folder_that_is_gone_ends_nothing) {
    const fs::path before = fs::current_path();
    fs::create_directory(folder_.path() / "gone");
    fs::current_path(folder_.path() / "gone");
    fs::remove(folder_.path() / "gone");
    EXPECT_FALSE(run(Open{.path = "wave.json"}));
    EXPECT_FALSE(run(SaveAs{.path = "wave.json"}));
    fs::current_path(before);
    EXPECT_TRUE(state().message.is_error);
}

TEST_F(FileCommands, ask_about_unsaved_changes) {
    run(Open{.path = wave_});
    run(SetWeight{.index = 0, .weight = 2.0});
    for (const Pending& pending :
         std::vector<Pending>{NewDocument{}, Open{.path = arch_}, Quit{}, OpenExample{.name = "arch"}}) {
        EXPECT_TRUE(editor_.run(std::visit([](const auto& command) { return Command(command); }, pending)));
        EXPECT_EQ(state().dialog, Dialog::unsaved_changes);
        ASSERT_TRUE(state().pending);
        EXPECT_EQ(state().pending->index(), pending.index());
        EXPECT_EQ(state().path, wave_);
        EXPECT_TRUE(run(AnswerUnsaved{.answer = UnsavedAnswer::cancel}));
        EXPECT_EQ(state().dialog, Dialog::none);
        EXPECT_FALSE(state().pending);
        EXPECT_FALSE(state().wants_quit);
        EXPECT_TRUE(state().is_modified());
    }
    EXPECT_FALSE(run(AnswerUnsaved{.answer = UnsavedAnswer::discard}));
    run(Quit{});
    EXPECT_FALSE(type("answer-unsaved maybe"));
    EXPECT_EQ(state().dialog, Dialog::unsaved_changes);
    EXPECT_TRUE(run(AnswerUnsaved{.answer = UnsavedAnswer::discard}));
    EXPECT_TRUE(state().wants_quit);
}

TEST_F(FileCommands, ask_nothing_where_the_document_is_as_it_was) {
    Desktop desktop;
    desktop.examples = folder_.path();
    Editor editor(desktop);
    editor.run(OpenExample{.name = "wave"});
    const core::Point place = points(editor)[1];
    for (const Command& command :
         std::vector<Command>{SetParameter{.u = 0.7}, SelectPoints{.points = {2}}, ToggleOverlay<Overlay::hull>{},
                              ActivateCurve{.index = 1}, ActivateCurve{.index = 0},
                              SetPoint{.index = 1, .position = {5.0, 5.0}}, SetPoint{.index = 1, .position = place}}) {
        ASSERT_TRUE(editor.run(command)) << editor.state().message.text;
    }
    EXPECT_EQ(editor.state().history.undo_count(), 2U);
    EXPECT_FALSE(editor.state().is_modified());
    EXPECT_TRUE(editor.run(OpenExample{.name = "arch"}));
    EXPECT_EQ(editor.state().dialog, Dialog::none);
    EXPECT_EQ(document(editor).curves[0].name, "arch");
    editor.run(SetPoint{.index = 1, .position = {5.0, 5.0}});
    EXPECT_TRUE(editor.run(OpenExample{.name = "wave"}));
    EXPECT_EQ(editor.state().dialog, Dialog::unsaved_changes);
}

TEST_F(FileCommands, save_before_going_on) {
    run(Open{.path = wave_});
    run(SetWeight{.index = 0, .weight = 2.0});
    run(Open{.path = arch_});
    EXPECT_TRUE(run(AnswerUnsaved{.answer = UnsavedAnswer::save}));
    EXPECT_EQ(state().path, arch_);
    EXPECT_EQ(core::load_document(wave_)->curves[0].curve->weights()[0], 2.0);
}

TEST_F(FileCommands, save_an_untitled_document_before_going_on) {
    run(NewCurve{.points = {{0, 0}, {1, 1}}});
    run(Quit{});
    EXPECT_TRUE(run(AnswerUnsaved{.answer = UnsavedAnswer::save}));
    EXPECT_EQ(state().dialog, Dialog::save_file);
    EXPECT_FALSE(state().wants_quit);
    EXPECT_TRUE(run(SaveAs{.path = (folder_.path() / "line.json")}));
    EXPECT_TRUE(state().wants_quit);
    EXPECT_EQ(state().dialog, Dialog::none);
}

TEST_F(FileCommands, a_failed_saving_gives_up_what_waited) {
    const fs::path path = folder_.path() / "gone" / "wave.json";
    fs::create_directory(path.parent_path());
    fs::copy_file(wave_, path);
    run(Open{.path = path});
    run(SetWeight{.index = 0, .weight = 2.0});
    fs::remove_all(path.parent_path());
    run(Quit{});
    EXPECT_FALSE(run(AnswerUnsaved{.answer = UnsavedAnswer::save}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_TRUE(state().is_modified());
    EXPECT_TRUE(run(SaveAs{.path = (folder_.path() / "kept.json")}));
    EXPECT_FALSE(state().wants_quit);
}

TEST_F(FileCommands, a_failed_opening_after_discard_keeps_the_changes) {
    run(Open{.path = wave_});
    run(SetWeight{.index = 0, .weight = 2.0});
    run(Open{.path = (folder_.path() / "missing.json")});
    EXPECT_FALSE(run(AnswerUnsaved{.answer = UnsavedAnswer::discard}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_TRUE(state().is_modified());
    EXPECT_EQ(curve(editor_).weights()[0], 2.0);
}

TEST_F(FileCommands, begin_a_new_document) {
    run(Open{.path = wave_});
    run(SelectPoints{.points = {1}});
    EXPECT_TRUE(run(NewDocument{}));
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
    EXPECT_TRUE(editor.run(OpenExample{.name = "arch"}));
    EXPECT_EQ(document(editor).curves[0].name, "arch");
    EXPECT_EQ(editor.state().path, "");
    EXPECT_FALSE(editor.state().is_modified());
    EXPECT_TRUE(editor.state().recent_files.empty());
    EXPECT_TRUE(editor.run(Save{}));
    EXPECT_EQ(editor.state().dialog, Dialog::save_file);
    for (const std::string& name :
         {std::string("nothing"), std::string(), std::string("../wave"), (folder_.path() / "arch").string()}) {
        EXPECT_FALSE(editor.run(OpenExample{.name = name})) << name;
        EXPECT_EQ(editor.state().message.text, "there is no example called '" + name + "'");
    }
}

TEST_F(FileCommands, remember_ten_recent_files_newest_first) {
    std::vector<fs::path> expected;
    for (int i = 0; i < 12; ++i) {
        const fs::path path = folder_.write("file" + std::to_string(i) + ".json", bezier_text);
        run(Open{.path = path});
        expected.insert(expected.begin(), path);
    }
    expected.resize(10);
    EXPECT_EQ(state().recent_files, expected);
    run(Open{.path = expected[4]});
    EXPECT_EQ(state().recent_files.size(), 10U);
    EXPECT_EQ(state().recent_files[0], expected[4]);
    EXPECT_EQ(state().recent_files[1], expected[0]);
}

TEST_F(FileCommands, curves_of_one_name_are_told_apart) {
    const auto line = [](const char* name) {
        return std::string(R"({ "name": ")") + name +
               R"(", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,1]] })";
    };
    const std::string text = R"({ "format": "batten", "version": 1, "curves": [)" + line("a") + "," + line("a") + "," +
                             line("a 2") + "," + line("a") + "] }";
    EXPECT_TRUE(run(Open{.path = folder_.write("same.json", text)}));
    std::vector<std::string> names;
    for (const core::DocumentCurve& entry : document(editor_).curves) names.push_back(entry.name);
    EXPECT_EQ(names, (std::vector<std::string>{"a", "a 3", "a 2", "a 4"}));
    EXPECT_FALSE(state().is_modified());
}

// Of both files the joint has the number 0.
TEST_F(FileCommands, marked_joints_of_a_file_that_is_added_stay_its_own) {
    const char* text = R"({ "format": "batten", "version": 1, "curves": [
      { "name": "a", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,0]],
        "joints": [{"end": "end", "joint": 0, "mark": "corner"}] },
      { "name": "b", "degree": 1, "knots": [0,0,1,1], "points": [[1,0],[2,1]],
        "joints": [{"end": "start", "joint": 0, "mark": "corner"}] } ] })";
    const std::filesystem::path path = folder_.write("joint.json", text);
    EXPECT_TRUE(run(Open{.path = path}));
    EXPECT_TRUE(run(AddFile{.path = path}));
    std::vector<std::size_t> numbers;
    for (const core::DocumentCurve& entry : document(editor_).curves)
        for (const core::EndMark& mark : entry.joints.ends) numbers.push_back(mark.joint);
    EXPECT_EQ(numbers, (std::vector<std::size_t>{0, 0, 1, 1}));
}

TEST_F(FileCommands, add_the_curves_of_a_file) {
    run(Open{.path = arch_});
    EXPECT_TRUE(run(AddFile{.path = wave_}));
    EXPECT_TRUE(run(AddFile{.path = arch_}));
    ASSERT_EQ(document(editor_).curves.size(), 5U);
    EXPECT_EQ(document(editor_).curves[4].name, "arch 2");
    EXPECT_EQ(document(editor_).active, 4U);
    EXPECT_EQ(state().history.undo_label(), "Add file arch.json");
    EXPECT_EQ(state().path, arch_);
    EXPECT_FALSE(run(AddFile{.path = "/nowhere.json"}));
    run(Undo{});
    run(Undo{});
    EXPECT_FALSE(state().is_modified());
}

// A line of an inch with a guide, a picture and a mirror, in a document of inches, one of which is `scale`.
std::string inch_text(const char* scale) {
    return core::sentence(R"({{ "format": "batten", "version": 1, "curves": [
      {{ "name": "a", "degree": 1, "knots": [0,0,1,1], "points": [[1,2],[2,2]],
        "symmetry": {{"group": 0, "place": 0, "center": [3,0], "mirror": 90}} }},
      {{ "name": "b", "degree": 1, "knots": [0,0,1,1], "points": [[5,2],[4,2]],
        "symmetry": {{"group": 0, "place": 1, "center": [3,0], "mirror": 90}} }} ],
      "pictures": [{{ "path": "scan.png", "width": 100, "height": 50, "position": [-1,4], "scale": 0.01 }}],
      "guides": [{{ "point": [0,3], "angle": 0 }}],
      "units": {{ "unit": "inch", "scale": {scale} }} }})",
                          {{"scale", scale}});
}

TEST_F(FileCommands, lengths_of_a_file_that_is_added_stay_what_they_are) {
    run(Open{.path = arch_});
    run(SetUnits{.unit = UnitChoice::mm, .scale = 2.0});
    EXPECT_TRUE(run(AddFile{.path = folder_.write("inches.json", inch_text("1"))}));
    EXPECT_TRUE(
        state().message.text.ends_with("its coordinates were multiplied by 50.8, so that lengths stay what they are"))
        << state().message.text;
    const core::Document& both = document(editor_);
    ASSERT_EQ(both.curves.size(), 3U);
    EXPECT_EQ(both.units->unit, core::LengthUnit::mm);
    EXPECT_NEAR(both.curves[1].curve->control_points()[0].x, 50.8, 1e-12);
    EXPECT_NEAR(both.curves[1].curve->control_points()[0].y, 101.6, 1e-12);
    EXPECT_NEAR(both.curves[2].curve->control_points()[0].x, 254.0, 1e-12);
    EXPECT_NEAR(both.curves[2].symmetry->center.x, 152.4, 1e-12);
    EXPECT_NEAR(both.guides.at(0).point.y, 152.4, 1e-12);
    EXPECT_NEAR(both.pictures.at(0).position.x, -50.8, 1e-12);
    EXPECT_NEAR(both.pictures.at(0).scale, 0.508, 1e-14);
}

TEST_F(FileCommands, plain_numbers_stay_what_they_are_beside_lengths) {
    run(Open{.path = arch_});
    EXPECT_TRUE(run(AddFile{.path = folder_.write("inches.json", inch_text("1"))}));
    EXPECT_EQ(document(editor_).curves[1].curve->control_points()[0], core::Point(1.0, 2.0));
    EXPECT_FALSE(document(editor_).units);
}

TEST_F(FileCommands, an_empty_document_takes_the_units_of_what_is_added) {
    EXPECT_TRUE(run(AddFile{.path = folder_.write("inches.json", inch_text("3"))}));
    EXPECT_EQ(document(editor_).curves[0].curve->control_points()[0], core::Point(1.0, 2.0));
    ASSERT_TRUE(document(editor_).units);
    EXPECT_EQ(document(editor_).units->unit, core::LengthUnit::inch);
    EXPECT_EQ(document(editor_).units->scale, 3.0);
}

TEST_F(FileCommands, a_curve_that_becomes_too_large_in_the_units_is_not_added) {
    run(Open{.path = arch_});
    run(SetUnits{.unit = UnitChoice::mm, .scale = 1e9});
    const std::string text = R"({ "format": "batten", "version": 1, "curves": [
      { "name": "far", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1e300,0]] } ],
      "units": { "unit": "inch", "scale": 1e-9 } })";
    EXPECT_FALSE(run(AddFile{.path = folder_.write("far.json", text)}));
    EXPECT_TRUE(state().message.text.starts_with("far.json: 'far' cannot be measured in millimeters: "))
        << state().message.text;
    EXPECT_EQ(document(editor_).curves.size(), 1U);
}

TEST_F(FileCommands, lengths_of_curves_that_are_pasted_stay_what_they_are) {
    run(Open{.path = folder_.write("inches.json", inch_text("1"))});
    run(Copy{});
    const std::string copied = state().clipboard;
    run(Open{.path = arch_});
    run(SetUnits{.unit = UnitChoice::mm, .scale = 1.0});
    EXPECT_TRUE(run(Paste{.text = copied}));
    EXPECT_NEAR(document(editor_).curves[1].curve->control_points()[1].x, 50.8, 1e-12);
    EXPECT_TRUE(run(PasteBeside{.text = copied, .shift = 1.0}));
    EXPECT_NEAR(document(editor_).curves[2].curve->control_points()[1].x, 51.8, 1e-12);
}

TEST_F(FileCommands, a_figure_is_a_picture_and_no_saving) {
    Desktop desktop;
    std::vector<fs::path> written;
    desktop.write_figure = [&written](const EditorState&, const fs::path& path, const FigureForm&) {
        written.push_back(path);
        return tl::expected<std::vector<std::string>, std::string>();
    };
    editor_ = Editor(desktop);
    EXPECT_FALSE(run(SaveAs{.path = folder_.path() / "nothing.pdf"}));
    EXPECT_EQ(state().message.text, "there is no visible curve to be shown");
    run(Open{.path = wave_});
    run(DeletePoints{.points = {1}});
    run(SaveAs{});
    for (const char* name : {"wave.pdf", "wave.PNG", "wave.tex"})
        EXPECT_TRUE(run(SaveAs{.path = folder_.path() / name}));
    EXPECT_EQ(written, (std::vector<fs::path>{folder_.path() / "wave.pdf", folder_.path() / "wave.PNG",
                                              folder_.path() / "wave.tex"}));
    EXPECT_EQ(state().path, wave_);
    EXPECT_TRUE(state().is_modified());
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(state().message.text, "Exported wave.tex");
}

TEST_F(FileCommands, a_copy_for_another_program_is_no_saving) {
    run(Open{.path = wave_});
    run(DeletePoints{.points = {1}});
    const fs::path copy = folder_.path() / "copy.dxf";
    EXPECT_TRUE(run(SaveAs{.path = copy}));
    EXPECT_EQ(state().message.text, "Exported copy.dxf; its curves are exact");
    EXPECT_EQ(state().path, wave_);
    EXPECT_TRUE(state().is_modified());
    EXPECT_TRUE(run(SaveAs{.path = folder_.path() / "named", .format = exchange::Format::rhino}));
    EXPECT_TRUE(fs::exists(folder_.path() / "named.rhino.json"));
}

TEST_F(FileCommands, a_file_of_another_program_is_no_file_to_save_to) {
    run(Open{.path = wave_});
    const fs::path copy = folder_.path() / "copy.dxf";
    const core::Curve before = *document(editor_).curves[0].curve;
    run(SaveAs{.path = copy});
    EXPECT_TRUE(run(Open{.path = copy}));
    EXPECT_EQ(state().path, "");
    EXPECT_EQ(state().source, copy);
    EXPECT_EQ(state().file_name(), "copy.dxf");
    EXPECT_FALSE(state().is_modified());
    EXPECT_EQ(*document(editor_).curves[0].curve, before);
    EXPECT_TRUE(state().message.text.starts_with("Opened copy.dxf; its curves are exact")) << state().message.text;
    run(Save{});
    EXPECT_EQ(state().dialog, Dialog::save_file);
    EXPECT_TRUE(run(SaveAs{.path = folder_.path() / "own.json"}));
    EXPECT_EQ(state().source, "");
    EXPECT_EQ(state().file_name(), "own.json");
    EXPECT_FALSE(run(Open{.path = copy, .format = exchange::Format::svg}));
    EXPECT_TRUE(state().message.text.starts_with("copy.dxf: ")) << state().message.text;
    EXPECT_FALSE(run(Open{.path = folder_.write("points.csv", "0,0\n1,1\n")}));
    EXPECT_EQ(state().message.text, "points.csv: a table of points is opened by File > Open table…");
    EXPECT_TRUE(run(AddFile{.path = copy}));
    EXPECT_EQ(document(editor_).curves.size(), 6U);
}

TEST_F(FileCommands, a_copy_does_not_take_the_place_of_the_document) {
    run(Open{.path = wave_});
    const std::string before = content(wave_);
    EXPECT_TRUE(run(SaveAs{.path = wave_, .format = exchange::Format::rhino}));
    EXPECT_TRUE(fs::exists(folder_.path() / "wave.rhino.json"));
    EXPECT_EQ(content(wave_), before);
    EXPECT_TRUE(run(SaveAs{.path = folder_.path() / "wave.svg", .format = exchange::Format::dxf}));
    EXPECT_TRUE(fs::exists(folder_.path() / "wave.dxf"));
    fs::create_symlink(wave_, folder_.path() / "link.dxf");
    EXPECT_FALSE(run(SaveAs{.path = folder_.path() / "link.dxf"}));
    EXPECT_EQ(state().message.text, "link.dxf is the document itself; a copy for another program needs another name");
    EXPECT_EQ(content(wave_), before);
}

TEST_F(FileCommands, save_as_under_the_same_name_asks_about_what_another_program_changed) {
    run(Open{.path = wave_});
    run(DeletePoints{.points = {1}});
    folder_.write("wave.json", bezier_text);
    EXPECT_TRUE(run(SaveAs{.path = wave_}));
    EXPECT_EQ(state().dialog, Dialog::changed_file);
    EXPECT_EQ(content(wave_), bezier_text);
}

}  // namespace
}  // namespace batten::editor
