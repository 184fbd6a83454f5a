#include "app/editor/commands/picture_list.h"

#include "core/base/sentence.h"

namespace batten::editor {

std::optional<Refusal> no_picture(const EditorState& state) {
    if (!state.history.present().pictures.empty()) return std::nullopt;
    return "the document has no picture; 'Add picture' adds one";
}

std::optional<Refusal> no_such_picture(const EditorState& state, std::size_t index) {
    const std::size_t count = state.history.present().pictures.size();
    if (index < count) return std::nullopt;
    return core::sentence("there is no picture {index}; the last one is {last}",
                          {{"index", index}, {"last", static_cast<std::ptrdiff_t>(count) - 1}});
}

std::optional<std::size_t> present_picture(const EditorState& state) {
    const std::size_t count = state.history.present().pictures.size();
    if (state.gauge && state.gauge->picture < count) return state.gauge->picture;
    return count == 0 ? std::nullopt : std::optional(count - 1);
}

}  // namespace batten::editor
