#include "exchange/cad/iges_check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/base/ascii.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "exchange/places.h"
#include "exchange/utf8_text.h"

namespace batten::exchange {

namespace {

constexpr std::size_t section_column = 72;  // of the letter of its section in a line, behind which its number stands
constexpr std::size_t field_width = 8;
constexpr std::size_t parameter_width = 64;
constexpr std::string_view sections = "SGDPT";

// The lines of one section.
struct IgesSection {
    std::vector<std::string_view> lines{};  // the first 72 columns
    std::size_t first_line = 0;             // of the file
};

using IgesSections = std::array<IgesSection, sections.size()>;

core::FileError defect_in(std::size_t line, std::string what) {
    return {line_place(line), std::move(what)};
}

std::optional<std::size_t> count_in(std::string_view field) {
    field = core::trimmed(field);
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), count);
    if (field.empty() || error != std::errc() || end != field.data() + field.size()) return std::nullopt;
    return count;
}

// Field `i` of a line, in eight columns.
std::string_view field_of(std::string_view line, std::size_t i) {
    return line.substr(std::min(line.size(), i * field_width), field_width);
}

// The lines, up to the one of section T.
std::optional<core::FileError> take_sections(std::string_view text, IgesSections& found) {
    std::size_t section = 0;
    std::size_t number = 0;
    while (!text.empty() && found.back().lines.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        const std::size_t letter = line.size() > section_column ? sections.find(line[section_column]) : sections.npos;
        if (letter == sections.npos || letter < section)
            return defect_in(number,
                             "every line of an IGES file has a letter of its section, S, G, D, P or T in this "
                             "order, in column 73");
        section = letter;
        IgesSection& lines = found[section];
        if (lines.lines.empty()) lines.first_line = number;
        lines.lines.push_back(line.substr(0, section_column));
        const auto told = count_in(line.substr(section_column + 1));
        if (told == lines.lines.size()) continue;
        return defect_in(number,
                         core::sentence("this is line {count} of section {section}, but its number is "
                                        "'{found}'; a line is missing or damaged",
                                        {{"count", lines.lines.size()},
                                         {"section", std::string(1, sections[section])},
                                         {"found", utf8_text(core::trimmed(line.substr(section_column + 1)))}}));
    }
    if (!found.back().lines.empty()) return std::nullopt;
    return defect_in(std::max<std::size_t>(number, 1),
                     "the file ends without the line T that ends every IGES file; a part is missing");
}

// The terminate line has the count of each section in eight columns: "P     12".
std::optional<core::FileError> wrong_count(const IgesSections& found) {
    const IgesSection& terminate = found.back();
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
        const std::string_view field = field_of(terminate.lines[0], i);
        const auto told = count_in(field.substr(std::min<std::size_t>(field.size(), 1)));
        if (told == found[i].lines.size()) continue;
        return defect_in(terminate.first_line,
                         core::sentence("section {section} has {count} lines, but '{told}' by the line T; a part is "
                                        "missing or damaged",
                                        {{"section", std::string(1, sections[i])},
                                         {"count", found[i].lines.size()},
                                         {"told", utf8_text(core::trimmed(field))}}));
    }
    return std::nullopt;
}

// Between parameters and behind the last one; the first two parameters of section G say which: "1H,,1H;,".
struct IgesDelimiters {
    char parameter = ',';
    char record = ';';
};

IgesDelimiters delimiters_in(const IgesSection& global) {
    IgesDelimiters delimiters;
    if (global.lines.empty()) return delimiters;
    std::string_view rest = global.lines[0];
    const auto take = [&](char& delimiter) {
        if (rest.starts_with("1H") && rest.size() > 2) {
            delimiter = rest[2];
            rest.remove_prefix(3);
        }
        rest.remove_prefix(std::min<std::size_t>(rest.size(), 1));
    };
    take(delimiters.parameter);
    take(delimiters.record);
    return delimiters;
}

// One parameter of an entity: a number, or a text, or nothing.
struct IgesParameter {
    enum class Kind { number, text, nothing, wrong, broken_number };
    Kind kind = Kind::nothing;
    double value = 0.0;
    std::size_t line = 0;  // of the file, where it begins
    std::string_view text{};
};

// Goes through the parameters of one entity.
class IgesParameters {
  public:
    IgesParameters(std::string_view text, std::size_t first_line, IgesDelimiters delimiters)
        : text_(text), first_line_(first_line), delimiters_(delimiters) {}

    // The next one; none behind the last one, and where the text ends without the delimiter of records.
    std::optional<IgesParameter> next();

    bool has_ended() const { return has_ended_; }

  private:
    IgesParameter parameter_of(std::string_view field, std::size_t begin) const;
    void end_at(std::size_t at) {
        has_ended_ = at < text_.size() && text_[at] == delimiters_.record;
        at_ = has_ended_ || at >= text_.size() ? text_.size() : at + 1;
    }

    std::string_view text_;
    std::size_t first_line_;
    IgesDelimiters delimiters_;
    std::size_t at_ = 0;
    bool has_ended_ = false;
};

// "7Hexample" begins with its length.
std::size_t length_of_text(std::string_view text) {
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
    if (error != std::errc() || end == text.data() + text.size() || *end != 'H') return 0;
    const auto head = static_cast<std::size_t>(end - text.data()) + 1;
    return std::min(text.size(), length) + head;
}

std::optional<IgesParameter> IgesParameters::next() {
    const std::size_t begin = std::min(text_.find_first_not_of(' ', at_), text_.size());
    if (begin == text_.size()) return std::nullopt;
    const std::size_t length = length_of_text(text_.substr(begin));
    const std::string ends{delimiters_.parameter, delimiters_.record};
    const std::size_t end = std::min(text_.find_first_of(ends, std::min(begin + length, text_.size())), text_.size());
    IgesParameter parameter = parameter_of(core::trimmed(text_.substr(begin, end - begin)), begin);
    const std::size_t behind = std::min(begin + length, text_.size());
    if (length > 0)
        parameter.kind = core::trimmed(text_.substr(behind, end - behind)).empty() ? IgesParameter::Kind::text
                                                                                   : IgesParameter::Kind::wrong;
    end_at(end);
    return parameter;
}

IgesParameter IgesParameters::parameter_of(std::string_view field, std::size_t begin) const {
    IgesParameter parameter{.line = first_line_ + begin / parameter_width, .text = field};
    if (field.empty()) return parameter;
    parameter.kind = IgesParameter::Kind::wrong;
    std::string digits(field);
    std::ranges::replace(digits, 'D', 'E');
    const auto number = core::leading_number(digits);
    if (!number || number->length != digits.size()) return parameter;
    const bool is_in_one_line = begin / parameter_width == (begin + field.size() - 1) / parameter_width;
    parameter.kind = is_in_one_line ? IgesParameter::Kind::number : IgesParameter::Kind::broken_number;
    parameter.value = number->value;
    return parameter;
}

constexpr std::size_t b_spline_curve = 126;

// How many numbers of their own the entities have that are read as curves, beside splines.
std::size_t numbers_needed(std::size_t type) {
    constexpr std::size_t circular_arc = 100;
    constexpr std::size_t conic_arc = 104;
    constexpr std::size_t line = 110;
    if (type == circular_arc) return 7;
    if (type == conic_arc) return 11;
    return type == line ? 6 : 0;
}

// Counts the numbers of an entity up to the first gap. A B-spline curve has by its first two, K and M: K + M + 2 knots,
// K + 1 weights, 3(K + 1) coordinates and two ends, behind the four flags of the shape.
class NumberCount {
  public:
    explicit NumberCount(std::size_t type) : type_(type), first_number_(type == b_spline_curve ? 7 : 1) {}

    void take(const IgesParameter& parameter) {
        const bool is_number = parameter.kind == IgesParameter::Kind::number;
        if (index_ == 1) k_ = is_number ? count_of(parameter.value) : 0;
        if (index_ == 2) m_ = is_number ? count_of(parameter.value) : 0;
        if (index_++ < first_number_ || has_gap_) return;
        has_gap_ = !is_number;
        if (is_number) ++numbers_;
    }

    std::optional<std::string> defect() const { return type_ == b_spline_curve ? defect_of_spline() : too_few(); }

  private:
    static std::size_t count_of(double value) {
        constexpr double most = 1e8;
        return value >= 1.0 && value <= most && std::trunc(value) == value ? static_cast<std::size_t>(value) : 0;
    }

    std::optional<std::string> too_few() const {
        const std::size_t needed = numbers_needed(type_);
        if (numbers_ >= needed) return std::nullopt;
        return core::sentence(
            "the entity {type} begins with {found} numbers, but it needs {needed}; the next one is missing, or left to "
            "a default, which is not read",
            {{"type", type_}, {"found", numbers_}, {"needed", needed}});
    }

    std::optional<std::string> defect_of_spline() const {
        if (k_ == 0 || m_ == 0) return "the B-spline curve does not begin with its numbers K and M";
        const std::size_t needed = k_ + m_ + 2 + 4 * (k_ + 1) + 2;
        if (numbers_ >= needed) return std::nullopt;
        return core::sentence(
            "the B-spline curve has {found} numbers behind its flags, but with K = {k} and M = {m} it needs {needed}: "
            "knots, weights, coordinates and ends; a part is missing or damaged",
            {{"found", numbers_}, {"k", k_}, {"m", m_}, {"needed", needed}});
    }

    std::size_t type_;
    std::size_t first_number_;
    std::size_t index_ = 0;
    std::size_t k_ = 0;
    std::size_t m_ = 0;
    std::size_t numbers_ = 0;
    bool has_gap_ = false;
};

// An entity in the directory, and where its parameters are.
struct IgesEntity {
    std::size_t type = 0;
    std::size_t directory_line = 0;  // of the file
    std::size_t first = 0;           // of its lines in section P, from 0
    std::size_t count = 0;
};

std::optional<IgesEntity> entity_in(const IgesSections& found, std::size_t i) {
    const IgesSection& directory = found[2];
    const std::string_view first = directory.lines[i];
    const std::string_view second = directory.lines[i + 1];
    const auto type = count_in(field_of(first, 0));
    const auto pointer = count_in(field_of(first, 1));
    const auto count = count_in(field_of(second, 3));
    const std::size_t lines = found[3].lines.size();
    if (!type || count_in(field_of(second, 0)) != type || !pointer || !count) return std::nullopt;
    if (*pointer == 0 || *pointer > lines || *count == 0 || *count > lines - (*pointer - 1)) return std::nullopt;
    return IgesEntity{*type, directory.first_line + i, *pointer - 1, *count};
}

// Entities whose parameters are statements of a language, not numbers and texts.
bool is_macro(std::size_t type) {
    constexpr std::size_t macro_definition = 306;
    constexpr std::size_t first_macro = 600;
    return type == macro_definition || type >= first_macro;
}

std::optional<core::FileError> wrong_parameters(const IgesSections& found, const IgesEntity& entity,
                                                IgesDelimiters delimiters) {
    std::string text;
    const IgesSection& lines = found[3];
    for (std::size_t i = entity.first; i < entity.first + entity.count; ++i)
        text.append(lines.lines[i].substr(0, parameter_width));
    const std::size_t first_line = lines.first_line + entity.first;
    IgesParameters parameters(text, first_line, delimiters);
    NumberCount numbers(entity.type);
    bool is_first = true;
    while (const auto parameter = parameters.next()) {
        if (parameter->kind == IgesParameter::Kind::wrong)
            return defect_in(parameter->line, core::sentence("found '{found}' where a finite number or a text must be",
                                                             {{"found", utf8_text(parameter->text.substr(0, 40))}}));
        if (parameter->kind == IgesParameter::Kind::broken_number)
            return defect_in(parameter->line,
                             core::sentence("the number '{found}' goes on in the next line, which only texts may",
                                            {{"found", utf8_text(parameter->text.substr(0, 40))}}));
        if (is_first && parameter->value != static_cast<double>(entity.type))
            return defect_in(first_line,
                             core::sentence("the parameters do not begin with {type}, as line {line} has it of them",
                                            {{"type", entity.type}, {"line", entity.directory_line}}));
        is_first = false;
        numbers.take(*parameter);
    }
    if (!parameters.has_ended())
        return defect_in(first_line, "the parameters of this entity have no end; a part is missing or damaged");
    if (auto defect = numbers.defect()) return defect_in(first_line, *std::move(defect));
    return std::nullopt;
}

// Hands each entity that is no macro, with its number, to `look`, which may end it with a defect.
std::optional<core::FileError> look_at_entities(
    const IgesSections& found,
    const std::function<std::optional<core::FileError>(std::size_t number, const IgesEntity& entity)>& look) {
    const IgesSection& directory = found[2];
    std::size_t taken = 0;
    for (std::size_t i = 0; i < directory.lines.size(); i += 2) {
        const auto entity = i + 1 < directory.lines.size() ? entity_in(found, i) : std::nullopt;
        if (!entity)
            return defect_in(directory.first_line + i,
                             "the directory does not say what this entity is and which lines of section P it has");
        taken += entity->count;
        if (taken > found[3].lines.size())
            return defect_in(directory.first_line + i,
                             "by the directory, entities have more lines in section P than there are");
        if (is_macro(entity->type)) continue;
        if (auto defect = look(i / 2, *entity)) return defect;
    }
    return std::nullopt;
}

}  // namespace

std::optional<core::FileError> iges_defect(std::string_view text) {
    IgesSections found;
    if (auto defect = take_sections(text, found)) return defect;
    if (auto defect = wrong_count(found)) return defect;
    const IgesDelimiters delimiters = delimiters_in(found[1]);
    return look_at_entities(found, [&](std::size_t /*number*/, const IgesEntity& entity) {
        return wrong_parameters(found, entity, delimiters);
    });
}

std::vector<std::size_t> damaged_iges_entities(std::string_view text) {
    IgesSections found;
    if (take_sections(text, found)) return {};
    const IgesDelimiters delimiters = delimiters_in(found[1]);
    std::vector<std::size_t> damaged;
    const auto defect =
        look_at_entities(found, [&](std::size_t number, const IgesEntity& entity) -> std::optional<core::FileError> {
            if (wrong_parameters(found, entity, delimiters)) damaged.push_back(number);
            return std::nullopt;
        });
    return defect ? std::vector<std::size_t>() : damaged;
}

}  // namespace batten::exchange
