/// Commands that open, save and leave documents.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "app/editor/command.h"
#include "core/base/names.h"
#include "exchange/format.h"

namespace batten::editor {

/// What to do with unsaved changes.
enum class UnsavedAnswer { save, discard, cancel };

/// What to do where another program changed the file that is to be saved.
enum class ChangedAnswer { overwrite, save_as, cancel };

struct NewDocument {
    static const CommandSpec& spec();
};

struct Open {
    std::optional<std::filesystem::path> path{};  ///< none: asks for one
    std::optional<exchange::Format> format{};     ///< none: by its ending
    static const CommandSpec& spec();
};

struct AddFile {
    std::filesystem::path path;
    std::optional<exchange::Format> format{};  ///< none: by its ending
    static const CommandSpec& spec();
};

struct OpenExample {
    std::string name;  ///< of its file, without the ending
    static const CommandSpec& spec();
};

struct Save {
    static const CommandSpec& spec();
};

struct SaveAs {
    std::optional<std::filesystem::path> path{};  ///< none: asks for one
    std::optional<exchange::Format> format{};     ///< none: by its ending
    static const CommandSpec& spec();
};

struct AnswerUnsaved {
    UnsavedAnswer answer;
    static const CommandSpec& spec();
};

struct AnswerChanged {
    ChangedAnswer answer;
    static const CommandSpec& spec();
};

struct Quit {
    static const CommandSpec& spec();
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::UnsavedAnswer> {
    using enum editor::UnsavedAnswer;
    static constexpr std::array table{Named{save, "save", "save"}, Named{discard, "discard", "discard"},
                                      Named{cancel, "cancel", "cancel"}};
};

template <>
struct Names<editor::ChangedAnswer> {
    using enum editor::ChangedAnswer;
    static constexpr std::array table{Named{overwrite, "overwrite", "overwrite"},
                                      Named{save_as, "save-as", "save as another file"},
                                      Named{cancel, "cancel", "cancel"}};
};

}  // namespace batten::core
