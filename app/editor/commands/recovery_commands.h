/// Commands about documents that sessions left unsaved.
#pragma once

#include <filesystem>

namespace batten::editor {

struct CommandSpec;

/// Opens the dialog that offers them.
struct ShowRecovery {
    static const CommandSpec& spec();
};

struct Recover {
    std::filesystem::path journal;  ///< of a document that is offered
    static const CommandSpec& spec();
};

struct DiscardRecovery {
    std::filesystem::path journal;  ///< likewise
    static const CommandSpec& spec();
};

/// Leaves the dialog; the documents stay for the next time.
struct LeaveRecovery {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
