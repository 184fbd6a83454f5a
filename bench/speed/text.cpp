// A curve read from the text of its file and written to it; beside it the JSON library alone, the numbers alone, and
// copying the same bytes, which nothing that reads or writes them can undercut.
#include <array>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/document/native_file.h"
#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

Numbers numbers_of(const core::Document& document) {
    return ControlPoints()(*document.curves.front().curve);
}

Numbers numbers_in(const std::string& text) {
    return numbers_of(core::parse_document(text).value());
}

// Every number of the text, in its order.
Numbers all_numbers(const std::string& text) {
    Numbers numbers;
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at < end;) {
        double value = 0.0;
        const auto [behind, error] = std::from_chars(at, end, value);
        if (error == std::errc()) numbers.push_back(value);
        at = behind == at ? at + 1 : behind;
    }
    return numbers;
}

std::string text_of(const Numbers& numbers) {
    std::string text;
    for (const double number : numbers) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
        text += ',';
    }
    return text;
}

}  // namespace

void add_text(Contests& contests) {
    for (const std::size_t n : {1000UL, 100'000UL, 1'000'000UL}) {
        core::Document document;
        document.curves.emplace_back().curve = std::make_shared<const core::Curve>(spiral(n, 3, true));
        const std::string text = core::format_document(document);
        const Numbers numbers = all_numbers(text);
        const auto same = [expected = numbers_of(document)](const auto&) { return expected; };
        const auto points = static_cast<double>(n);

        Contest reading("read_document/n:" + std::to_string(n), points, 0.0);
        reading.enter(
            "Batten", [text] { return core::parse_document(text).value(); }, numbers_of);
        reading.enter(
            "JSON_library", [text] { return nlohmann::json::parse(text); }, same);
        reading.enter(
            "numbers_alone", [text] { return all_numbers(text); }, same);
        reading.enter(
            "copying", [text] { return text; }, same);
        contests.push_back(std::move(reading));

        Contest writing("write_document/n:" + std::to_string(n), points, 0.0);
        writing.enter(
            "Batten", [document] { return core::format_document(document); }, numbers_in);
        writing.enter(
            "JSON_library", [json = nlohmann::json::parse(text)] { return json.dump(); }, same);
        writing.enter(
            "numbers_alone", [numbers] { return text_of(numbers); }, same);
        writing.enter(
            "copying", [text] { return text; }, same);
        contests.push_back(std::move(writing));
    }
}

}  // namespace batten::bench
