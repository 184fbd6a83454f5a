#include "app/cli/window_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <ostream>

#include "app/cli/command_options.h"
#include "app/cli/say.h"
#include "app/cli/usage_problem.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_frames = 100000;

bool is_among(const std::vector<fs::path>& files, const fs::path& file) {
    std::error_code absent;
    return std::ranges::any_of(files, [&](const fs::path& other) { return fs::equivalent(file, other, absent); });
}

// Each line of a log is a list.
bool holds_no_log(const fs::path& file) {
    std::error_code absent;
    if (!fs::is_regular_file(file, absent)) return false;
    const int first = std::ifstream(file).peek();
    return first != '[' && first != std::ifstream::traits_type::eof();
}

}  // namespace

void add_window_options(CLI::App& program, WindowOptions& options) {
    program.add_option("files", options.files, "Files to open; the curves of all but the first are added")
        ->type_name("FILE");
    program.add_option("--example", options.example, "Open this example, for instance circle-nurbs")->type_name("NAME");
    program.add_option("--assets", options.assets, "Folder that holds examples/")->type_name("FOLDER");
    program
        .add_option("--display-scale", options.display_scale,
                    "Window pixels per design pixel, from 0.5 to 4, instead of what the display says")
        ->check(number_within(0.5, 4.0))
        ->type_name("NUMBER");
    program.add_option("--state-report", options.state_report, "Write what is on screen to this file after each frame")
        ->type_name("FILE");
    program.add_option("--session-log", options.session_log, "Write the commands of the session to this file")
        ->type_name("FILE");
}

std::optional<std::string> problem_of_written_files(const WindowOptions& options) {
    const auto problem_of = [&](const char* option, const std::optional<fs::path>& written, bool holds_other) {
        return !written || !(holds_other || is_among(options.files, *written))
                   ? std::nullopt
                   : std::optional(
                         core::sentence("batten: {option}: '{file}' holds something else, which would be lost; name "
                                        "a file that is new, or the one of an earlier session",
                                        {{"option", option}, {"file", written->string()}}));
    };
    if (auto problem =
            problem_of("--session-log", options.session_log, options.session_log && holds_no_log(*options.session_log)))
        return problem;
    return problem_of("--state-report", options.state_report, false);
}

ProfileSubcommand::ProfileSubcommand(CLI::App& program) {
    CLI::App* command =
        add_command(program, "profile", "Make a gesture in the window, and print what its frames cost the processor");
    command->add_option("file", options_.file, "A curve file in Batten's own format")->required()->type_name("FILE");
    for (const auto& entry : core::Names<editor::ScriptedGesture>::table)
        command->add_flag_callback(
            core::sentence("--{gesture}", {{"gesture", entry.name}}),
            [this, gesture = entry.value] { gestures_.push_back(gesture); }, entry.title);
    command->add_option("--frames", options_.frame_count, "How many frames to measure, at most 100000 (default: 240)")
        ->check(whole_number(1, most_frames))
        ->type_name("N");
    command
        ->add_option("--do", options_.commands,
                     "Do this before the gesture, as typed in the palette; may be given several times")
        ->type_name("COMMAND")
        ->allow_extra_args(false);
    add_json(*command, options_.as_json);
    command_ = command;
}

std::optional<ProfileOptions> ProfileSubcommand::options(Output output) const {
    if (const auto problem = problem_of_file(*command_, options_.file.string())) {
        say(output, *problem);
        return std::nullopt;
    }
    if (gestures_.size() != 1) {
        std::vector<std::string> names;
        for (const auto& entry : core::Names<editor::ScriptedGesture>::table)
            names.push_back(core::sentence("--{gesture}", {{"gesture", entry.name}}));
        output.errors << core::sentence("batten profile: one gesture is needed: {gestures}",
                                        {{"gestures", core::listed_as_alternatives(names)}})
                      << '\n';
        return std::nullopt;
    }
    ProfileOptions result = options_;
    result.gesture = gestures_.front();
    return result;
}

}  // namespace batten::cli
