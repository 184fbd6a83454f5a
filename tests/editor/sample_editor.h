/// Editors with documents to try commands on.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/editor/commands/file_commands.h"
#include "app/editor/editor.h"
#include "app/editor/typed_command.h"
#include "core/document/native_file.h"

namespace batten::editor {

/// A folder that goes with the test.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "batten-test-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

/// A cubic over custom knots whose weights differ, a closed quadratic, and a locked line.
inline const char* sample_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "wave", "degree": 3, "knots": [0,0,0,0,0.2,0.5,0.75,1,1,1,1], "kind": "custom",
    "points": [[-6,-2.2],[-4.6,2.6],[-1.6,3.6],[-0.4,-2.6],[2.6,-3.2],[3.4,2.2],[6.2,2.8]], "weights": [1,1,1,1,1,2,1] },
  { "name": "ring", "degree": 2, "knots": [0,1,2,3,4,5], "points": [[0,0],[2,0],[3,2],[1,3],[-1,2]], "periodic": true },
  { "name": "line", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[5,5]], "locked": true } ] })";

/// The cubic Bézier curve (0,0) (1,2) (3,2) (4,0) over [0, 1].
inline const char* bezier_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "arch", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[0,0],[1,2],[3,2],[4,0]] } ] })";

/// Runs what a person types in the palette; what is left out is what suggests itself. A refusal is shown as the window
/// shows it.
inline bool run_typed(Editor& editor, const std::string& text) {
    const Outcome<Command> command = parse_typed_command(text, editor.state());
    if (command) return editor.run(*command);
    editor.change(ShowRefusal{command.error()});
    return false;
}

/// Opens `text` as a file; the history is empty then.
inline void open_text(Editor& editor, const std::string& text) {
    const TemporaryFolder folder;
    ASSERT_TRUE(editor.run(Open{.path = folder.write("sample.json", text)})) << editor.state().message.text;
}

inline const core::Document& document(const Editor& editor) {
    return editor.state().history.present();
}

inline const core::Curve& curve(const Editor& editor) {
    return *document(editor).active_curve()->curve;
}

inline std::vector<double> knots(const Editor& editor) {
    const auto stored = curve(editor).knots().stored();
    return {stored.begin(), stored.end()};
}

inline std::vector<core::Point> points(const Editor& editor) {
    const auto all = curve(editor).control_points();
    return {all.begin(), all.end()};
}

}  // namespace batten::editor
