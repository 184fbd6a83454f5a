#include "render/label_runs.h"

#include <algorithm>

namespace batten::render {

namespace {

constexpr double script_shift = 0.3;
constexpr double deep_shift = 0.38;  // of stacked ones, where the upper one would reach into the lower one

double shift_of(Script script, double size) {
    return script == Script::none ? 0.0 : script == Script::sub ? size : -size;
}

/// Whether a part of it is below the line on which letters stand.
bool is_deep(std::string_view script) {
    return script.find_first_of("()[]|,;gjpqy") != std::string_view::npos;
}

bool starts_script(std::string_view text) {
    return text.starts_with("_{") || text.starts_with("^{");
}

/// Takes the next run off `rest`.
LabelRun take_run(std::string_view& rest) {
    if (starts_script(rest)) {
        const std::size_t end = std::min(rest.find('}'), rest.size());
        const LabelRun run{rest.substr(2, end - 2), rest[0] == '_' ? Script::sub : Script::super};
        rest.remove_prefix(std::min(end + 1, rest.size()));
        return run;
    }
    std::size_t length = 1;
    while (length < rest.size() && !starts_script(rest.substr(length))) ++length;
    const LabelRun run{rest.substr(0, length), Script::none};
    rest.remove_prefix(length);
    return run;
}

}  // namespace

std::vector<LabelRun> label_runs(std::string_view text) {
    std::vector<LabelRun> runs;
    Script last = Script::none;
    while (!text.empty()) {
        LabelRun run = take_run(text);
        run.is_stacked = last != Script::none && run.script != Script::none && run.script != last;
        last = run.is_stacked ? Script::none : run.script;
        run.shift = shift_of(run.script, script_shift);
        if (run.is_stacked && is_deep(run.script == Script::super ? run.text : runs.back().text)) {
            run.shift = shift_of(run.script, deep_shift);
            runs.back().shift = -run.shift;
        }
        runs.push_back(run);
    }
    return runs;
}

}  // namespace batten::render
