/// Commands that take and record lessons.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/command.h"

namespace batten::editor {

struct OpenLesson {
    std::string name;  ///< of its file in the folder of lessons, without the ending; or the path of a file
    static const CommandSpec& spec();
};

struct NextStep {
    static const CommandSpec& spec();
};

struct PreviousStep {
    static const CommandSpec& spec();
};

/// Does the task of the step.
struct SolveTask {
    static const CommandSpec& spec();
};

struct CloseLesson {
    static const CommandSpec& spec();
};

struct RecordLesson {
    std::string title;
    static const CommandSpec& spec();
};

struct DescribeStep {
    std::string text;  ///< in the notation of render::Label
    static const CommandSpec& spec();
};

struct SaveLesson {
    std::filesystem::path path;
    static const CommandSpec& spec();
};

struct DropRecording {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
