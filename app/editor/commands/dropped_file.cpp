#include "app/editor/commands/dropped_file.h"

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/picture_commands.h"
#include "app/editor/commands/table_commands.h"
#include "app/picture/image_file.h"

namespace batten::editor {

Command command_for_file(const EditorState& state, const std::filesystem::path& path, bool is_first) {
    if (picture::is_named_as_image(path)) return picture_in_view(state, path);
    if (is_named_as_table(path)) return OpenTable{.path = path};
    if (is_first) return Open{.path = path};
    return AddFile{.path = path};
}

}  // namespace batten::editor
