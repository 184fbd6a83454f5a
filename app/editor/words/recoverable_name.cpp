#include "app/editor/words/recoverable_name.h"

#include <algorithm>

namespace batten::editor {

std::string recoverable_name(const Recoverable& document, std::span<const Recoverable> all) {
    if (document.file.empty()) return "untitled";
    const std::filesystem::path name = document.file.filename();
    const bool is_ambiguous = std::ranges::any_of(
        all, [&](const Recoverable& other) { return other.file != document.file && other.file.filename() == name; });
    return is_ambiguous ? (document.file.parent_path().filename() / name).string() : name.string();
}

}  // namespace batten::editor
