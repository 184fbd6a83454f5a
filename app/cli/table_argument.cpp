#include "app/cli/table_argument.h"

#include <fmt/core.h>

#include "app/cli/number_table.h"
#include "app/cli/standard_streams.h"
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
core::FileResult<std::vector<double>> parse_points(const std::string& text) {
    return core::read_point_table(text).map([](const core::PointTable& table) {
        std::vector<double> coordinates;
        for (const core::Point point : table.points) coordinates.insert(coordinates.end(), {point.x, point.y});
        return coordinates;
    });
}

}  // namespace

core::FileResult<std::vector<double>> read_table(const std::string& word, TableContent content) {
    const std::filesystem::path file = word.substr(1);
    const std::string name = shown_name(file);
    const auto text = is_standard(file) ? core::read_text(standard_input, name) : core::read_text(file);
    if (!text) return tl::unexpected(text.error());
    auto numbers = content == TableContent::points ? parse_points(*text) : parse_table(*text);
    return std::move(numbers).map_error([&](const core::FileError& error) {
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

editor::Outcome<void> read_tables(Operation& operation, const editor::Units& units) {
    const auto fields = fields_of_arguments(*operation.spec, operation.arguments.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::string* word = table_word(*fields[i], operation.arguments[i]);
        if (word == nullptr) continue;
        const bool are_points = fields[i]->kind == editor::FieldKind::positions;
        auto numbers = read_table(*word, are_points ? TableContent::points : TableContent::numbers);
        if (!numbers) return tl::unexpected(numbers.error().sentence());
        if (are_points)
            for (double& number : *numbers) number *= editor::world_per_length(units);
        operation.arguments[i] = *std::move(numbers);
    }
    return {};
}

}  // namespace batten::cli
