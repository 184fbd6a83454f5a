#include "app/ui/file_choice.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace batten::ui {

namespace {

namespace fs = std::filesystem;

// "~/curves/" of "~/curves/wa"; all of "~".
std::string folder_part(const std::string& typed) {
    if (typed == "~") return typed;
    const std::size_t slash = typed.rfind('/');
    return slash == std::string::npos ? std::string() : typed.substr(0, slash + 1);
}

std::string name_part(const std::string& typed) {
    return typed.substr(folder_part(typed).size());
}

// With the slash that "~" lacks.
std::string in_folder(const std::string& folder, const std::string& name) {
    return folder == "~" ? (fs::path(folder) / name).string() : folder + name;
}

void show_all(FileChoice& choice) {
    choice.shown.resize(choice.listed.entries.size());
    std::iota(choice.shown.begin(), choice.shown.end(), std::size_t{0});
    choice.chosen.reset();
}

// The row of the file that is called `name` but for its ending, else the first one.
std::size_t best_row(const FileChoice& choice, const std::string& name) {
    const auto is_named = [&](std::size_t entry) { return choice.listed.entries[entry].name == name + ".json"; };
    const auto row = std::find_if(choice.shown.begin(), choice.shown.end(), is_named);
    return row == choice.shown.end() ? 0 : static_cast<std::size_t>(row - choice.shown.begin());
}

}  // namespace

fs::path meant_path(const fs::path& folder, const std::string& typed) {
    const bool is_from_home = typed == "~" || typed.starts_with("~/");
    const char* home = is_from_home ? std::getenv("HOME") : nullptr;
    if (home == nullptr) return folder / typed;
    return typed.size() > 2 ? fs::path(home) / typed.substr(2) : fs::path(home);
}

std::string enter_folder(FileChoice& choice, const fs::path& folder, const std::string& typed) {
    FolderContent content = read_folder(folder, choice.endings);
    if (!content.problem.empty()) return content.problem;
    std::vector<std::string> endings = std::move(choice.endings);
    choice = {};
    choice.endings = std::move(endings);
    choice.folder = content.folder;
    choice.listed = std::move(content);
    choice.typed = typed;
    show_all(choice);
    return {};
}

void follow_typed(FileChoice& choice, bool chooses_best) {
    const std::string before = folder_part(std::exchange(choice.filter, choice.typed));
    const std::string folder = folder_part(choice.typed);
    const std::string name = name_part(choice.typed);
    if (folder != before) choice.listed = read_folder(meant_path(choice.folder, folder), choice.endings);
    choice.shown = entries_with(choice.listed.entries, name);
    choice.chosen.reset();
    choice.is_led_by_keys = false;
    if (chooses_best && !name.empty() && !choice.shown.empty()) choice.chosen = best_row(choice, name);
}

void choose(FileChoice& choice, std::size_t index) {
    choice.chosen = index;
    choice.typed = in_folder(folder_part(choice.filter), choice.listed.entries[choice.shown[index]].name);
}

void move_choice(FileChoice& choice, std::ptrdiff_t rows) {
    if (choice.shown.empty() || rows == 0) return;
    const auto last = static_cast<std::ptrdiff_t>(choice.shown.size()) - 1;
    const std::ptrdiff_t outside = rows > 0 ? -1 : last + 1;
    const std::ptrdiff_t before = choice.chosen ? static_cast<std::ptrdiff_t>(*choice.chosen) : outside;
    choose(choice, static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(before + rows, 0, last)));
    choice.is_led_by_keys = true;
}

std::optional<fs::path> chosen_path(const FileChoice& choice) {
    if (!choice.chosen) return std::nullopt;
    return choice.listed.folder / choice.listed.entries[choice.shown[*choice.chosen]].name;
}

}  // namespace batten::ui
