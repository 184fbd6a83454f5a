/// A fixture for commands that find something.
#pragma once

#include "app/editor/command_spec.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {

class FindingFixture : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::vector<Finding>& rows() const { return state().findings->rows; }

    /// Runs a command that is to find something.
    void find(const Command& command) {
        ASSERT_TRUE(editor_.run(command)) << command.spec().name << ": " << state().message.text;
        ASSERT_TRUE(state().findings.has_value());
    }

    /// The sentence of a command that is to be refused.
    std::string refused(const Command& command) {
        EXPECT_FALSE(editor_.run(command)) << command.spec().name;
        return state().message.text;
    }

    /// The number called `name` of a row.
    double number(std::size_t row, const std::string& name) const {
        for (const FoundNumber& found : rows()[row].numbers)
            if (found.name == name) return found.value;
        ADD_FAILURE() << "no number " << name;
        return 0.0;
    }

    Editor editor_;
};

}  // namespace batten::editor
