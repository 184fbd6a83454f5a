/// Undo, redo, the clipboard, and deleting what is selected.
#pragma once

#include <string>

#include "app/editor/command.h"

namespace batten::editor {

struct Undo {
    static const CommandSpec& spec();
};

struct Redo {
    static const CommandSpec& spec();
};

struct Cut {
    static const CommandSpec& spec();
};

struct Copy {
    static const CommandSpec& spec();
};

/// The curves keep their place.
struct Paste {
    std::string text;  ///< curves as in a file
    static const CommandSpec& spec();
};

/// The curves land beside their originals, where these are in the document.
struct PasteBeside {
    std::string text;  ///< curves as in a file
    double shift;      ///< to the right and down
    static const CommandSpec& spec();
};

struct CopyText {
    std::string text;
    static const CommandSpec& spec();
};

struct Duplicate {
    double shift;  ///< to the right and down
    static const CommandSpec& spec();
};

struct Delete {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
