#include "app/platform/application.h"

#include <functional>
#include <iostream>
#include <utility>

#include "app/editor/recovery/journal_reader.h"
#include "app/editor/state/settings.h"
#include "app/platform/editor_window.h"
#include "app/platform/end_signals.h"

namespace batten::platform {

namespace {

int say_failure(const std::string& sentence) {
    std::cerr << "batten: " << sentence << '\n';
    return 1;
}

/// Says why the window cannot be opened, or gives it with its painter to `use`, whose exit status it returns.
int with_window(const std::optional<editor::WindowGeometry>& geometry,
                const std::function<int(Window&, render::GlPainter)>& use) {
    const auto window = Window::open(geometry);
    if (!window) return say_failure(window.error());
    auto painter = make_painter();
    if (!painter) return say_failure(painter.error());
    return use(**window, std::move(*painter));
}

}  // namespace

int run(const Options& options) {
    const EndSignals signals(&Window::wake);
    const std::filesystem::path settings_path = editor::settings_path();
    const editor::Settings settings = editor::load_settings(settings_path);
    const int status = with_window(settings.window, [&](Window& window, render::GlPainter painter) {
        EditorWindow editor_window(window, std::move(painter), settings, options, editor::recovery_folder());
        const auto ended = editor_window.run([&signals] { return signals.is_asked(); });
        editor::save_settings(editor_window.settings(), settings_path);
        return ended ? 0 : say_failure(ended.error());
    });
    signals.end_program();
    return status;
}

int profile(const ProfileOptions& options, bool as_json, std::ostream& results) {
    return with_window(std::nullopt, [&](Window& window, render::GlPainter painter) {
        const Options no_options;
        EditorWindow editor_window(window, std::move(painter), {}, no_options, {});
        const auto found = editor_window.profile(options);
        if (!found) return say_failure(found.error());
        if (as_json)
            print_json(results, *found);
        else
            print_text(results, *found);
        return 0;
    });
}

}  // namespace batten::platform
