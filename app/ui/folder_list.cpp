#include "app/ui/folder_list.h"

#include <algorithm>

#include "core/base/sentence.h"

namespace batten::ui {

namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::directory_entry& entry) {
    std::error_code error;
    return entry.is_directory(error);
}

bool is_offered(const fs::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    if (name.empty() || name.front() == '.') return false;
    return is_folder(entry) || entry.path().extension() == ".json";
}

}  // namespace

FolderContent read_folder(const fs::path& folder) {
    FolderContent content;
    std::error_code error;
    content.folder = fs::weakly_canonical(folder, error);
    fs::directory_iterator iterator(content.folder, fs::directory_options::skip_permission_denied, error);
    if (error) {
        content.problem = core::sentence("{folder} cannot be read: {reason}",
                                         {{"folder", content.folder.string()}, {"reason", error.message()}});
        return content;
    }
    for (const fs::directory_iterator end; iterator != end && !error; iterator.increment(error)) {
        if (is_offered(*iterator)) content.entries.push_back(*iterator);
    }
    std::sort(content.entries.begin(), content.entries.end(),
              [](const fs::directory_entry& a, const fs::directory_entry& b) {
                  const bool a_is_folder = is_folder(a);
                  return a_is_folder != is_folder(b) ? a_is_folder : a.path() < b.path();
              });
    return content;
}

}  // namespace batten::ui
