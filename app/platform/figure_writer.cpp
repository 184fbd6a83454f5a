#include "app/platform/figure_writer.h"

#include "app/editor/scene/figure_scene.h"
#include "app/editor/words/figure_notes.h"
#include "core/base/sentence.h"
#include "core/document/file_text.h"
#include "render/figure_file.h"

namespace batten::platform {

tl::expected<std::vector<std::string>, std::string> write_figure(const editor::EditorState& state,
                                                                 const std::filesystem::path& path,
                                                                 const editor::FigureForm& form) {
    const auto format = render::figure_format(path);
    if (!format)
        return tl::unexpected(
            core::sentence("'{file}' has the ending of no figure; .svg, .pdf, .png and .tex are the endings of figures",
                           {{"file", path.filename().string()}}));
    editor::FigureForm shown = form;
    if (!render::has_pixels(*format)) {
        shown.scale = 1.0;
        shown.fineness = editor::fineness_to_enlarge;
    }
    const render::Figure figure = editor::window_figure(state, shown);
    const auto bytes = render::figure_bytes(figure, *format);
    if (!bytes) return tl::unexpected(bytes.error());
    core::tell(state.progress, 1, 1);  // from here on it is not stopped
    if (const auto written = core::replace_text(path, *bytes); !written)
        return tl::unexpected(written.error().sentence());
    return editor::figure_notes(render::figure_losses(figure, *format));
}

}  // namespace batten::platform
