#include "app/editor/example_files.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> ordered_names(const fs::path& folder) {
    std::vector<std::string> names;
    std::ifstream file(folder / "order.txt");
    for (std::string line; std::getline(file, line);) names.push_back(line);
    return names;
}

}  // namespace

std::vector<fs::path> example_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    const std::vector<std::string> names = ordered_names(folder);
    const auto rank = [&names](const fs::path& file) {
        return std::find(names.begin(), names.end(), file.stem().string()) - names.begin();
    };
    std::stable_sort(files.begin(), files.end(),
                     [&rank](const fs::path& a, const fs::path& b) { return rank(a) < rank(b); });
    return files;
}

}  // namespace batten::editor
