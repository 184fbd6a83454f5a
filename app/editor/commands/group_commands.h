/// Groups of curves by name, and the order of curves in the list.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "core/document/document.h"

namespace batten::editor {

struct GroupCurves {
    std::string name;
    std::vector<std::size_t> curves;
    static const CommandSpec& spec();
};

struct UngroupCurves {
    std::vector<std::size_t> curves;
    static const CommandSpec& spec();
};

struct RenameGroup {
    std::string group;
    std::string name;
    static const CommandSpec& spec();
};

struct MoveCurve {
    std::size_t from;
    std::size_t to;
    std::optional<std::string> group{};  ///< that it then belongs to, "" for none; none: it stays in its own
    static const CommandSpec& spec();
};

struct MoveGroup {
    std::string group;
    std::optional<std::size_t> before{};  ///< the curve that stands next then; none: the group comes last
    static const CommandSpec& spec();
};

/// The curves of the committed document that are in the group, ascending.
std::vector<std::size_t> curves_of_group(const core::Document& document, const std::string& group);

}  // namespace batten::editor
