#include "app/editor/state/settings.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/editor/state/user_folder.h"
#include "app/editor/state/user_scale.h"
#include "core/document/file_text.h"
#include "core/document/json_check.h"

namespace batten::editor {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr double least_window = 320.0;
constexpr double most_window = 32000.0;

// The member `name` of an object, or null.
Json member(const Json& object, const char* name) {
    return object.is_object() ? object.value(name, Json()) : Json();
}

void read(const Json& object, const char* name, bool& value) {
    const Json found = member(object, name);
    if (found.is_boolean()) value = found.get<bool>();
}

// Brought into `allowed`.
void read(const Json& object, const char* name, double& value, core::Interval allowed) {
    const Json found = member(object, name);
    if (found.is_number()) value = allowed.clamp(found.get<double>());
}

void read(const Json& object, const char* name, int& value, core::Interval allowed) {
    double number = value;
    read(object, name, number, allowed);
    value = static_cast<int>(number);
}

template <core::HasNames Enum>
void read_named(const Json& object, const char* name, Enum& value) {
    const Json found = member(object, name);
    if (!found.is_string()) return;
    value = core::value_named<Enum>(found.get<std::string>()).value_or(value);
}

std::optional<WindowGeometry> window_of(const Json& object) {
    if (!object.is_object()) return std::nullopt;
    WindowGeometry window;
    constexpr core::Interval positions{-most_window, most_window};
    constexpr core::Interval sizes{least_window, most_window};
    read(object, "x", window.x, positions);
    read(object, "y", window.y, positions);
    read(object, "width", window.width, sizes);
    read(object, "height", window.height, sizes);
    read(object, "maximised", window.is_maximized);  // as version 0.1 wrote it
    read(object, "maximized", window.is_maximized);
    return window;
}

Json json_of(const WindowGeometry& window) {
    return {{"x", window.x},
            {"y", window.y},
            {"width", window.width},
            {"height", window.height},
            {"maximized", window.is_maximized}};
}

void read_overlays(const Json& names, Overlays& overlays) {
    if (!names.is_array()) return;
    for (std::size_t i = 0; i < overlay_count; ++i) overlays.show(static_cast<Overlay>(i), false);
    for (const Json& name : names) {
        const std::optional<Overlay> overlay =
            name.is_string() ? core::value_named<Overlay>(name.get<std::string>()) : std::nullopt;
        if (overlay) overlays.show(*overlay, true);
    }
}

void read_notation(const Json& object, Notation& notation) {
    if (!object.is_object()) return;
    std::map<std::string, std::string> names;
    for (const auto& [name, value] : object.items())
        if (value.is_string()) names[name] = value.get<std::string>();
    notation = notation_named(names);
}

Json json_of(const Overlays& overlays) {
    Json names = Json::array();
    for (std::size_t i = 0; i < overlay_count; ++i)
        if (overlays.is_chosen(static_cast<Overlay>(i))) names.push_back(core::name_of(static_cast<Overlay>(i)));
    return names;
}

void read_paths(const Json& list, std::vector<fs::path>& paths) {
    if (!list.is_array()) return;
    for (const Json& item : list) {
        const fs::path path = item.is_string() ? fs::path(item.get<std::string>()) : fs::path();
        if (path.is_absolute() && paths.size() < most_recent_files) paths.push_back(path);
    }
}

void read_snap(const Json& object, SnapSettings& snap) {
    if (!object.is_object()) return;
    read(object, "angle_step", snap.angle_step, {least_angle_step, greatest_angle_step});
    for (const core::Named<SnapKind>& kind : core::Names<SnapKind>::table) {
        bool on = snap.kinds.has(kind.value);
        read(object, kind.name, on);
        snap.kinds.set(kind.value, on);
    }
}

Json json_of(const SnapSettings& snap) {
    Json json = Json::object();
    for (const core::Named<SnapKind>& kind : core::Names<SnapKind>::table) json[kind.name] = snap.kinds.has(kind.value);
    json["angle_step"] = snap.angle_step;
    return json;
}

Json json_of(const std::vector<fs::path>& paths) {
    Json list = Json::array();
    for (const fs::path& path : paths) list.push_back(path.string());
    return list;
}

}  // namespace

Settings parse_settings(const std::string& text) {
    Settings settings;
    if (!core::check_json(text)) return settings;
    const Json json = Json::parse(text, nullptr, false);
    settings.window = window_of(member(json, "window"));
    read_named(json, "theme", settings.theme);
    read(json, "user_scale", settings.user_scale, user_scales);
    read_overlays(member(json, "overlays"), settings.overlays);
    read_notation(member(json, "notation"), settings.notation);
    read_named(json, "knot_move", settings.knot_move);
    read_snap(member(json, "snap"), settings.snap);
    read_named(json, "pen_mode", settings.pen_mode);
    read(json, "inspector_is_open", settings.inspector_is_open);
    read(json, "dock_is_open", settings.dock_is_open);
    read(json, "inspector_width", settings.inspector_width, inspector_widths);
    read(json, "cards_width", settings.cards_width, cards_widths);
    read(json, "dock_height", settings.dock_height, dock_heights);
    read_paths(member(json, "recent_files"), settings.recent_files);
    return settings;
}

std::string format_settings(const Settings& settings) {
    Json json = Json::object();
    if (settings.window) json["window"] = json_of(*settings.window);
    json["theme"] = core::name_of(settings.theme);
    json["user_scale"] = settings.user_scale;
    json["overlays"] = json_of(settings.overlays);
    json["notation"] = names_of(settings.notation);
    json["knot_move"] = core::name_of(settings.knot_move);
    json["snap"] = json_of(settings.snap);
    json["pen_mode"] = core::name_of(settings.pen_mode);
    json["inspector_is_open"] = settings.inspector_is_open;
    json["dock_is_open"] = settings.dock_is_open;
    json["inspector_width"] = settings.inspector_width;
    json["cards_width"] = settings.cards_width;
    json["dock_height"] = settings.dock_height;
    json["recent_files"] = json_of(settings.recent_files);
    return fmt::format("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Settings settings_of(const EditorState& state) {
    const View& view = state.view;
    return {.theme = view.theme,
            .user_scale = view.user_scale,
            .overlays = view.overlays,
            .notation = view.usual_notation,
            .knot_move = view.knot_move,
            .snap = view.snap,
            .pen_mode = view.pen_mode,
            .inspector_is_open = view.inspector_is_open,
            .dock_is_open = view.dock_is_open,
            .inspector_width = view.inspector_width,
            .cards_width = view.cards_width,
            .dock_height = view.dock_height,
            .recent_files = state.recent_files};
}

void apply_settings(EditorState& state, const Settings& settings) {
    View& view = state.view;
    view.theme = settings.theme;
    set_user_scale(view, settings.user_scale);
    view.overlays = settings.overlays;
    view.notation = settings.notation;
    view.usual_notation = settings.notation;
    view.cards_width = settings.cards_width;
    view.knot_move = settings.knot_move;
    view.snap = settings.snap;
    view.pen_mode = settings.pen_mode;
    view.inspector_is_open = settings.inspector_is_open;
    view.dock_is_open = settings.dock_is_open;
    view.inspector_width = settings.inspector_width;
    view.dock_height = settings.dock_height;
    state.recent_files = settings.recent_files;
}

fs::path settings_path() {
    const fs::path folder = user_folder("XDG_CONFIG_HOME", ".config");
    if (folder.empty()) return {};
    return folder / "batten" / "settings.json";
}

Settings load_settings(const fs::path& path) {
    return parse_settings(core::read_text(path).value_or(""));
}

void save_settings(const Settings& settings, const fs::path& path) {
    if (path.empty()) return;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    // Batten works as well where nothing can be remembered.
    static_cast<void>(core::replace_text(path, format_settings(settings)));
}

}  // namespace batten::editor
