#include "app/editor/state/settings.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

Settings unusual_settings() {
    Settings settings;
    settings.window = WindowGeometry{-100, 20, 1000, 700, true};
    settings.theme = ThemeName::light;
    settings.user_scale = 1.3;
    settings.overlays.show(Overlay::hodograph, true);
    settings.overlays.show(Overlay::polygon, false);
    settings.knot_move = core::KnotMove::push;
    settings.inspector_is_open = false;
    settings.dock_is_open = false;
    settings.notation.points = PointLetter::V;
    settings.notation.numbers = NumberStyle::decimals;
    settings.inspector_width = 400.5;
    settings.cards_width = 500.0;
    settings.dock_height = 300.0;
    settings.recent_files = {"/a/wave.json", "/b/Bézier curve.json"};
    return settings;
}

TEST(Settings, read_back_as_written) {
    EXPECT_EQ(parse_settings(format_settings(unusual_settings())), unusual_settings());
    EXPECT_EQ(parse_settings(format_settings({})), Settings{});
}

TEST(Settings, keep_defaults_for_what_is_broken) {
    for (const char* text :
         {"", "nonsense", "[]", "3", "{}", R"({"theme":"pink","user_scale":"x","overlays":3,"window":[],
        "recent_files":{},"knot_move":7,"dock_height":null,"inspector_is_open":1})"})
        EXPECT_EQ(parse_settings(text), Settings{}) << text;
}

TEST(Settings, are_brought_into_range_one_by_one) {
    const Settings settings =
        parse_settings(R"({"user_scale": 99, "inspector_width": -5, "dock_height": 1e300, "theme": "light",
        "overlays": ["grid", "unheard-of", 4], "unknown": {"a": 1}, "recent_files": ["/a", "relative", 3],
        "window": {"width": 3, "height": 1e12, "x": -1e300}})");
    EXPECT_EQ(settings.user_scale, 3.0);
    EXPECT_EQ(settings.inspector_width, 240.0);
    EXPECT_EQ(settings.dock_height, 800.0);
    EXPECT_EQ(settings.theme, ThemeName::light);
    EXPECT_EQ(settings.recent_files, std::vector<std::filesystem::path>{"/a"});
    EXPECT_TRUE(settings.overlays.is_shown(Overlay::grid));
    EXPECT_FALSE(settings.overlays.is_shown(Overlay::polygon));
    ASSERT_TRUE(settings.window);
    EXPECT_EQ(*settings.window, (WindowGeometry{-32000, 0, 320, 32000, false}));
}

TEST(Settings, of_version_0_1_keep_the_window_maximized) {
    const Settings settings = parse_settings(R"({"window": {"width": 800, "height": 600, "maximised": true}})");
    ASSERT_TRUE(settings.window);
    EXPECT_TRUE(settings.window->is_maximized);
}

TEST(Settings, survive_a_start) {
    Editor editor;
    Settings settings = unusual_settings();
    editor.apply(settings);
    EXPECT_EQ(editor.state().view.interface_scale, 1.3);
    settings.window.reset();
    EXPECT_EQ(settings_of(editor.state()), settings);
}

// Sets a variable of the environment for one test.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        if (value != nullptr)
            setenv(name, value, 1);
        else
            unsetenv(name);
    }
    ~Variable() {
        if (old_)
            setenv(name_, old_->c_str(), 1);
        else
            unsetenv(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> old_;
};

TEST(Settings, lie_where_the_desktop_wants_them) {
    const Variable home("HOME", "/home/ada");
    {
        const Variable folder("XDG_CONFIG_HOME", "/conf");
        EXPECT_EQ(settings_path(), "/conf/batten/settings.json");
    }
    for (const char* unusable : {static_cast<const char*>(nullptr), "", "relative/conf"}) {
        const Variable folder("XDG_CONFIG_HOME", unusable);
        EXPECT_EQ(settings_path(), "/home/ada/.config/batten/settings.json");
        const Variable no_home("HOME", nullptr);
        EXPECT_EQ(settings_path(), "");
    }
}

TEST(Settings, are_saved_into_a_new_folder_and_loaded) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "new" / "batten" / "settings.json";
    EXPECT_EQ(load_settings(path), Settings{});
    save_settings(unusual_settings(), path);
    EXPECT_EQ(load_settings(path), unusual_settings());
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);
    save_settings(unusual_settings(), "");
    save_settings(unusual_settings(), "/proc/nowhere/settings.json");
    EXPECT_EQ(load_settings("/proc/nowhere/settings.json"), Settings{});
}

}  // namespace
}  // namespace batten::editor
