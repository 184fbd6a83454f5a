#include "app/ui/lesson_list.h"

#include "app/editor/example_files.h"
#include "app/editor/lesson/lesson_file.h"

namespace batten::ui {

const std::vector<LessonEntry>& lessons_of(const PanelContext& context) {
    std::optional<std::vector<LessonEntry>>& lessons = context.panels.lessons;
    if (lessons) return *lessons;
    lessons.emplace();
    for (const std::filesystem::path& path : editor::example_files(context.state.desktop.lessons))
        if (const auto lesson = editor::load_lesson(path)) lessons->push_back({lesson->name, lesson->title});
    return *lessons;
}

}  // namespace batten::ui
