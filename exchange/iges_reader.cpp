#include "exchange/iges_reader.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "exchange/occt_process.h"

namespace batten::exchange {

namespace {

constexpr std::size_t section_column = 72;  // of the letter of its section in a line
constexpr std::array<char, 4> counted_sections{'S', 'G', 'D', 'P'};

struct SectionLines {
    std::array<std::size_t, 4> counts{};  // of counted_sections
    std::string_view terminate{};         // the line that tells them
    std::size_t line_count = 0;
};

SectionLines lines_of_sections(std::string_view text) {
    SectionLines found;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++found.line_count;
        if (line.size() <= section_column) continue;
        const auto* const section = std::ranges::find(counted_sections, line[section_column]);
        if (section != counted_sections.end())
            ++found.counts[static_cast<std::size_t>(section - counted_sections.begin())];
        if (line[section_column] == 'T') found.terminate = line;
    }
    return found;
}

// The count that the terminate line has for section `i`, in eight columns: "P     12".
std::optional<double> told_count(std::string_view terminate, std::size_t i) {
    constexpr std::size_t field_width = 8;
    std::string_view field = terminate.substr(field_width * i + 1, field_width - 1);
    field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
    const auto number = core::leading_number(field);
    return number ? std::optional(number->value) : std::nullopt;
}

// OpenCASCADE takes what is missing in a file for zeros.
std::optional<core::FileError> missing_part(std::string_view text) {
    const SectionLines found = lines_of_sections(text);
    const std::string place = core::sentence("line {line}", {{"line", found.line_count}});
    if (found.terminate.empty())
        return core::FileError{place, "the file ends without the line T that ends every IGES file; a part is missing"};
    for (std::size_t i = 0; i < counted_sections.size(); ++i) {
        const auto told = told_count(found.terminate, i);
        if (!told || *told == static_cast<double>(found.counts[i])) continue;
        return core::FileError{
            place, core::sentence("section {section} has {count} lines, but {told} by the line T; a part is missing",
                                  {{"section", std::string(1, counted_sections[i])},
                                   {"count", found.counts[i]},
                                   {"told", core::shortest_text(*told)}})};
    }
    return std::nullopt;
}

}  // namespace

core::FileResult<Imported> read_iges(std::string_view text) {
    if (auto missing = missing_part(text)) return tl::unexpected(*std::move(missing));
    return read_through_occt("iges", text);
}

}  // namespace batten::exchange
