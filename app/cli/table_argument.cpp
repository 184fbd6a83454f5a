#include "app/cli/table_argument.h"

#include <fmt/core.h>

#include <utility>

#include "app/cli/number_table.h"
#include "app/cli/standard_streams.h"
#include "core/base/sentence.h"
#include "core/document/point_table.h"

namespace batten::cli {

namespace {

bool takes_table(const editor::Field& field) {
    switch (field.kind) {
        case editor::FieldKind::positions:
        case editor::FieldKind::parameters:
        case editor::FieldKind::point_indices:
        case editor::FieldKind::curve_indices:
            return true;
        default:
            return false;
    }
}

// The word of an argument that names a table; null where it is something else.
const std::string* table_word(const editor::Field& field, const editor::Argument& argument) {
    const auto* word = std::get_if<editor::Word>(&argument);
    return word != nullptr && takes_table(field) && names_table(word->text) ? &word->text : nullptr;
}

// A table of the kinds that the window opens, as coordinates.
core::FileResult<ReadTable> parse_points(const std::string& text) {
    return core::read_point_table(text).map([](const core::PointTable& table) {
        ReadTable read{.numbers = {}, .told = core::told_of_other_curves(table)};
        for (const core::Point point : table.points) read.numbers.insert(read.numbers.end(), {point.x, point.y});
        return read;
    });
}

core::FileResult<ReadTable> parse_numbers(const std::string& text) {
    return parse_table(text).map([](std::vector<double> numbers) { return ReadTable{.numbers = std::move(numbers)}; });
}

}  // namespace

core::FileResult<ReadTable> read_table(const std::string& word, TableContent content) {
    const std::filesystem::path file = word.substr(1);
    const std::string name = shown_name(file);
    const auto text = is_standard(file) ? core::read_text(standard_input, name) : core::read_text(file);
    if (!text) return tl::unexpected(text.error());
    auto read = content == TableContent::points ? parse_points(*text) : parse_numbers(*text);
    if (read && !read->told.empty())
        read->told = core::sentence("{file}: {told}", {{"file", name}, {"told", read->told}});
    return std::move(read).map_error([&](const core::FileError& error) {
        return core::FileError{error.where.empty() ? name : fmt::format("{}: {}", name, error.where), error.what};
    });
}

std::vector<std::string> table_words(const Operation& operation) {
    std::vector<std::string> words;
    const auto fields = fields_of_arguments(*operation.spec, operation.arguments.size());
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (const std::string* word = table_word(*fields[i], operation.arguments[i])) words.push_back(*word);
    return words;
}

editor::Outcome<std::vector<std::string>> read_tables(Operation& operation, const editor::Units& units) {
    std::vector<std::string> told;
    const auto fields = fields_of_arguments(*operation.spec, operation.arguments.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::string* word = table_word(*fields[i], operation.arguments[i]);
        if (word == nullptr) continue;
        const bool are_points = fields[i]->kind == editor::FieldKind::positions;
        auto table = read_table(*word, are_points ? TableContent::points : TableContent::numbers);
        if (!table) return tl::unexpected(table.error().sentence());
        if (are_points)
            for (double& number : table->numbers) number *= editor::world_per_length(units);
        operation.arguments[i] = std::move(table->numbers);
        if (!table->told.empty()) told.push_back(std::move(table->told));
    }
    return told;
}

}  // namespace batten::cli
