#include "app/cli/frame_names.h"

#include <algorithm>
#include <regex>
#include <string>

namespace batten::cli {

namespace {

const std::regex& number_place() {
    static const std::regex place("%0?([1-9]?)d");
    return place;
}

}  // namespace

bool has_frame_number(const std::filesystem::path& pattern) {
    const std::string name = pattern.filename().string();
    return std::distance(std::sregex_iterator(name.begin(), name.end(), number_place()), std::sregex_iterator()) == 1;
}

std::filesystem::path frame_name(const std::filesystem::path& pattern, std::size_t number) {
    const std::string name = pattern.filename().string();
    std::smatch place;
    if (!std::regex_search(name, place, number_place())) return pattern;
    std::string digits = std::to_string(number);
    const std::size_t width = place[1].length() == 0 ? 1 : static_cast<std::size_t>(place.str(1).front() - '0');
    digits.insert(0, width - std::min(width, digits.size()), '0');
    return pattern.parent_path() / place.prefix().str().append(digits).append(place.suffix());
}

}  // namespace batten::cli
