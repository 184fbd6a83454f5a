#include "app/cli/frame_names.h"

#include <algorithm>
#include <regex>
#include <string>

namespace batten::cli {

namespace {

using Match = std::sregex_iterator;

/// A place for a number, or a percent sign.
const std::regex& place_or_percent() {
    static const std::regex pattern("%%|%0?([1-9]?)d");
    return pattern;
}

bool is_place(const std::smatch& match) {
    return match.str() != "%%";
}

std::string digits_of(std::size_t number, const std::smatch& place) {
    std::string digits = std::to_string(number);
    const std::size_t width = place[1].length() == 0 ? 1 : static_cast<std::size_t>(place.str(1).front() - '0');
    return digits.insert(0, width - std::min(width, digits.size()), '0');
}

}  // namespace

std::size_t frame_number_count(const std::filesystem::path& pattern) {
    const std::string name = pattern.filename().string();
    return static_cast<std::size_t>(
        std::count_if(Match(name.begin(), name.end(), place_or_percent()), Match(), is_place));
}

std::filesystem::path frame_name(const std::filesystem::path& pattern, std::size_t number) {
    const std::string name = pattern.filename().string();
    std::string result;
    auto rest = name.begin();
    for (auto match = Match(name.begin(), name.end(), place_or_percent()); match != Match(); ++match) {
        result.append(rest, (*match)[0].first).append(is_place(*match) ? digits_of(number, *match) : "%");
        rest = (*match)[0].second;
    }
    return pattern.parent_path() / result.append(rest, name.end());
}

}  // namespace batten::cli
