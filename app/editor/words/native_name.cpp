#include "app/editor/words/native_name.h"

#include <algorithm>

#include "core/base/ascii.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

bool is_letter_or_digit(char c) {
    return core::is_letter(c) || core::is_digit(c);
}

bool is_small_letter(char c) {
    return std::islower(static_cast<unsigned char>(c)) != 0;
}

// Endings are short, but for some words.
constexpr std::size_t longest = 5;
constexpr std::size_t longest_word = 10;

bool is_ending(const std::string& text) {
    if (std::all_of(text.begin(), text.end(), is_small_letter)) return text.size() <= longest_word;
    return text.size() <= longest && std::all_of(text.begin(), text.end(), is_letter_or_digit) &&
           std::any_of(text.begin(), text.end(), core::is_letter);
}

// "svg" for "wave.svg"; empty where what stands behind the last dot is no ending.
std::string ending_of(const std::filesystem::path& path) {
    const std::string behind = path.extension().string();
    return behind.size() > 1 && is_ending(behind.substr(1)) ? behind.substr(1) : std::string();
}

bool is_native(const std::string& ending) {
    return core::in_small_letters(ending) == "json";
}

// "wave.json" for "wave.svg", and "wave.bak.json" for "wave.json.bak", which is beside "wave.json".
std::filesystem::path native_instead(const std::filesystem::path& path) {
    const std::filesystem::path stem = path.stem();
    std::filesystem::path native = stem;
    if (is_native(ending_of(stem))) native = stem.stem().concat(path.extension().string());
    return native += ".json";
}

// Of files for other programs: ".svg, .dxf or .csv".
std::string other_endings() {
    std::vector<std::string> endings;
    for (const exchange::FormatSpec& spec : exchange::all_formats())
        if (spec.write != nullptr) endings.push_back(spec.endings.front());
    return core::listed_as_alternatives(endings);
}

// Of a name that ends like a file of another kind.
std::optional<Refusal> refused_ending(const std::filesystem::path& path, const char* pattern) {
    const std::string name = path.filename().string();
    if (name.starts_with('.') && name.size() <= longest + 1 && is_ending(name.substr(1)))
        return core::sentence("'{name}' is an ending without a name; name it 'curves.json'", {{"name", name}});
    const std::string ending = ending_of(path);
    if (ending.empty() || is_native(ending)) return std::nullopt;
    const std::filesystem::path native = native_instead(path);
    return core::filled_as_needed(
        pattern, {{"name", name}, {"ending", ending}, {"native", native.string()}, {"others", other_endings()}});
}

}  // namespace

std::optional<Refusal> foreign_ending(const std::filesystem::path& path) {
    return refused_ending(path,
                          "'{name}' ends in .{ending}, and curves are not written to such files; name it '{native}'");
}

std::optional<Refusal> foreign_result(const std::filesystem::path& path) {
    if (exchange::format_of(path)) return std::nullopt;
    if (!is_named_as_figure(path))
        return refused_ending(
            path,
            "'{name}' ends in .{ending}, and curves are not written to such files; name it '{native}', "
            "or with {others}");
    return core::sentence("'{name}' is a picture, as 'batten figure' writes it; a file with curves is '{native}'",
                          {{"name", path.filename().string()}, {"native", native_instead(path).string()}});
}

Outcome<std::filesystem::path> native_path(const std::filesystem::path& path) {
    if (std::optional<Refusal> refusal = foreign_ending(path)) return tl::unexpected(*std::move(refusal));
    std::filesystem::path result = path;
    if (!is_native(ending_of(path))) result += ".json";
    return result;
}

bool is_named_as_figure(const std::filesystem::path& path) {
    const std::string ending = core::in_small_letters(ending_of(path));
    return ending == "pdf" || ending == "png" || ending == "tex";
}

Outcome<SavedName> saved_name(const std::filesystem::path& path, std::optional<exchange::Format> format) {
    if (!format) format = exchange::format_of(path);
    if (!format && is_named_as_figure(path)) return SavedName{path, std::nullopt, true};
    if (!format)
        return native_path(path).map([](std::filesystem::path native) { return SavedName{std::move(native)}; });
    if (exchange::format_of(path) == format) return SavedName{path, format};
    // A name that is another kind's would be taken for a file of that kind.
    std::filesystem::path named = path;
    if (is_native(ending_of(path)) || exchange::format_of(path)) named.replace_extension();
    if (ending_of(named).empty()) named += exchange::spec_of(*format).endings.front();
    return SavedName{std::move(named), format};
}

}  // namespace batten::editor
