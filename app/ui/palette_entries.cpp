#include "app/ui/palette_entries.h"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "app/editor/command_table.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/knot_question_commands.h"
#include "app/editor/words/knot_text.h"
#include "app/ui/example_list.h"
#include "app/ui/fuzzy_match.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

using editor::CommandSpec;

// A name, and a word of a synonym or of an explanation, count less than the title.
constexpr int name_loss = 1;
constexpr int synonym_loss = 3;
constexpr int explanation_loss = 8;

struct Match {
    PaletteEntry entry;
    Beginning of_title;
    Beginning of_name;
    int score;

    auto rank() const { return std::tuple(std::max(of_title, of_name), of_title, score); }
};

std::vector<PaletteEntry> all_entries(const PanelContext& context) {
    std::vector<PaletteEntry> entries;
    for (const CommandSpec& spec : editor::command_table())
        if (spec.offered.palette) entries.push_back({&spec, {}, spec.title, spec.name});
    for (const Example& example : examples_of(context))
        entries.push_back({&editor::OpenExample::spec(), example.name,
                           core::sentence("Example: {title}", {{"title", title_of(example)}}), example.name});
    return entries;
}

std::optional<int> lowered(std::optional<int> score, int loss) {
    return score ? std::optional(*score - loss) : std::nullopt;
}

std::optional<int> score_of_example(const std::string& typed, const PaletteEntry& entry) {
    const std::string name = core::sentence("example {name}", {{"name", entry.example}});
    return std::max({fuzzy_score(typed, entry.title), lowered(fuzzy_score(typed, entry.name), name_loss),
                     fuzzy_score(typed, name), lowered(word_score(typed, entry.spec->synonyms), synonym_loss)});
}

std::optional<int> score_of_command(const std::string& typed, const PaletteEntry& entry) {
    const std::string names = fmt::format("{} {}", entry.title, entry.spec->synonyms);
    const std::string everything = fmt::format("{} {}", names, entry.spec->explanation);
    return std::max({fuzzy_score(typed, entry.title), lowered(fuzzy_score(typed, entry.name), name_loss),
                     lowered(word_score(typed, names), synonym_loss),
                     lowered(word_score(typed, everything), explanation_loss)});
}

std::optional<int> score_of(const std::string& typed, const PaletteEntry& entry) {
    return entry.example.empty() ? score_of_command(typed, entry) : score_of_example(typed, entry);
}

}  // namespace

std::vector<PaletteEntry> find_entries(const PanelContext& context, const std::string& typed) {
    if (const CommandSpec* spec = spec_being_typed(typed)) return {{spec, {}, spec->title, spec->name}};
    std::vector<Match> matches;
    for (PaletteEntry& entry : all_entries(context))
        if (const std::optional<int> score = score_of(typed, entry)) {
            const Beginning of_title = beginning_of(typed, entry.title);
            const Beginning of_name = beginning_of(typed, entry.name);
            matches.push_back({std::move(entry), of_title, of_name, *score});
        }
    std::ranges::stable_sort(matches, [](const Match& a, const Match& b) { return a.rank() > b.rank(); });
    std::vector<PaletteEntry> entries;
    for (Match& match : matches) entries.push_back(std::move(match.entry));
    return entries;
}

const CommandSpec* spec_being_typed(const std::string& typed) {
    if (editor::is_typed_vector(typed)) return &editor::SampleCurve::spec();
    const std::size_t space = typed.find(' ');
    if (space == std::string::npos) return nullptr;
    const CommandSpec* spec = editor::find_command(typed.substr(0, space));
    return spec != nullptr && spec->offered.palette && !spec->fields.empty() ? spec : nullptr;
}

}  // namespace batten::ui
