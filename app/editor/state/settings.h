/// What is remembered between starts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/state/state.h"

namespace batten::editor {

inline constexpr std::size_t most_recent_files = 10;

struct WindowGeometry {
    int x = 0;
    int y = 0;
    int width = 1440;
    int height = 900;
    bool is_maximized = false;
    bool operator==(const WindowGeometry&) const = default;
};

struct Settings {
    std::optional<WindowGeometry> window{};
    ThemeName theme = ThemeName::dark;
    double user_scale = 1.0;
    Overlays overlays;
    Notation notation;
    core::KnotMove knot_move = core::KnotMove::snap;
    SnapSettings snap;
    PenMode pen_mode = PenMode::through_c2;
    bool inspector_is_open = true;
    bool dock_is_open = true;
    double inspector_width = 340.0;
    double cards_width = 360.0;
    double dock_height = 260.0;
    std::vector<std::filesystem::path> recent_files;
    bool operator==(const Settings&) const = default;
};

/// The settings in `text`; what is missing or out of range keeps its default, so that a broken file never stops a
/// start.
Settings parse_settings(const std::string& text);
std::string format_settings(const Settings& settings);

/// The settings that `state` has now; the window's geometry is the caller's.
Settings settings_of(const EditorState& state);

/// Makes `state` look as `settings` say, but for the window's geometry.
void apply_settings(EditorState& state, const Settings& settings);

/// The file in which settings are kept: $XDG_CONFIG_HOME/batten/settings.json, else under ~/.config; empty without a
/// home.
std::filesystem::path settings_path();

/// Reads, and writes by way of a temporary file. A failure to write is not an error for the user.
Settings load_settings(const std::filesystem::path& path);
void save_settings(const Settings& settings, const std::filesystem::path& path);

}  // namespace batten::editor
