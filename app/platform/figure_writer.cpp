#include "app/platform/figure_writer.h"

#include "app/editor/scene/figure_scene.h"
#include "core/base/sentence.h"
#include "core/document/file_text.h"
#include "render/figure_file.h"

namespace batten::platform {

tl::expected<void, std::string> write_figure(const editor::EditorState& state, const std::filesystem::path& path,
                                             const editor::FigureForm& form) {
    const auto format = render::figure_format(path);
    if (!format)
        return tl::unexpected(
            core::sentence("'{file}' has the ending of no figure; .svg, .pdf, .png and .tex are the endings of figures",
                           {{"file", path.filename().string()}}));
    editor::FigureForm pixels = form;
    if (*format != render::FigureFormat::png) pixels.scale = 1.0;  // the others can be enlarged as they are
    return render::figure_bytes(editor::window_figure(state, pixels), *format).and_then([&](const std::string& bytes) {
        core::tell(state.progress, 1, 1);  // from here on it is not stopped
        return core::replace_text(path, bytes).map_error([](const core::FileError& error) { return error.sentence(); });
    });
}

}  // namespace batten::platform
