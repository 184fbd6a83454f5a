#include "app/ui/folder_list.h"

#include <algorithm>

#include "core/base/ascii.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

namespace fs = std::filesystem;

// Takes the digits off the front of `rest`; returns them without leading zeros.
std::string_view take_number(std::string_view& rest) {
    const std::size_t end = std::min(rest.find_first_not_of("0123456789"), rest.size());
    std::string_view digits = rest.substr(0, end);
    rest.remove_prefix(end);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
}

// Below 0, 0 or above it, as numbers of that many digits are.
int compare_numbers(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
    return a.compare(b);
}

// The same for names, of which a number is one letter.
int compare_names(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty()) {
        if (core::is_digit(a.front()) && core::is_digit(b.front())) {
            const int order = compare_numbers(take_number(a), take_number(b));
            if (order != 0) return order;
        } else {
            const int order = static_cast<unsigned char>(core::small_letter(a.front())) -
                              static_cast<unsigned char>(core::small_letter(b.front()));
            if (order != 0) return order;
            a.remove_prefix(1);
            b.remove_prefix(1);
        }
    }
    return static_cast<int>(!a.empty()) - static_cast<int>(!b.empty());
}

// What files are sorted by: "wave" stands before "wave 2".
std::string_view stem_of(const FolderEntry& entry) {
    const std::string_view name = entry.name;
    return entry.is_folder ? name : name.substr(0, name.rfind('.'));
}

bool stands_before(const FolderEntry& a, const FolderEntry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : comes_before(stem_of(a), stem_of(b));
}

bool has_ending(const fs::path& path, const std::vector<std::string>& endings) {
    const std::string ending = core::in_small_letters(path.extension().string());
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

bool comes_before(std::string_view a, std::string_view b) {
    const int order = compare_names(a, b);
    return order != 0 ? order < 0 : a < b;
}

FolderContent read_folder(const fs::path& folder, const std::vector<std::string>& endings) {
    FolderContent content;
    std::error_code error;
    content.folder = fs::weakly_canonical(folder, error);
    if (error) content.folder = folder;
    fs::directory_iterator iterator(content.folder, error);
    if (error == std::errc::no_such_file_or_directory) {
        content.is_missing = true;
        content.problem = core::sentence("there is no folder {folder}", {{"folder", content.folder.string()}});
        return content;
    }
    if (error) {
        content.problem = core::sentence("{folder} cannot be read: {reason}",
                                         {{"folder", content.folder.string()}, {"reason", error.message()}});
        return content;
    }
    for (const fs::directory_iterator end; iterator != end && !error; iterator.increment(error)) {
        std::error_code ignored;
        FolderEntry entry{iterator->path().filename().string(), iterator->is_directory(ignored)};
        const bool is_hidden = entry.name.front() == '.';
        if (!is_hidden && (entry.is_folder || has_ending(entry.name, endings)))
            content.entries.push_back(std::move(entry));
    }
    std::sort(content.entries.begin(), content.entries.end(), stands_before);
    return content;
}

std::vector<std::size_t> entries_with(const std::vector<FolderEntry>& entries, std::string_view text) {
    const auto are_same = [](char a, char b) { return core::small_letter(a) == core::small_letter(b); };
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string& name = entries[i].name;
        const bool has_text = std::search(name.begin(), name.end(), text.begin(), text.end(), are_same) != name.end();
        if (has_text || text.empty()) found.push_back(i);
    }
    return found;
}

}  // namespace batten::ui
