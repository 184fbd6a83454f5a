#include "app/cli/movie.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/document/file_text.h"

namespace batten::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* program = "ffmpeg";
constexpr const char* messages = "messages.txt";

struct SpawnActions {
    SpawnActions() { posix_spawn_file_actions_init(&actions); }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;

    posix_spawn_file_actions_t actions{};
};

/// Runs ffmpeg in `folder`, without a shell; 0, or the number of the error why it could not be run, or -1 where it
/// failed.
int run_in(const fs::path& folder, std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    SpawnActions spawn;
    posix_spawn_file_actions_addchdir_np(&spawn.actions, folder.c_str());
    posix_spawn_file_actions_addopen(&spawn.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&spawn.actions, STDOUT_FILENO, messages, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&spawn.actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = 0;
    if (const int error = posix_spawnp(&child, program, &spawn.actions, nullptr, arguments.data(), environ); error != 0)
        return error;
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return errno;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : -1;
}

std::vector<std::string> words_for(MovieFormat format, double rate) {
    std::vector<std::string> words{
        program, "-nostdin", "-loglevel", "error", "-framerate", core::shortest_text(rate), "-i", "frame-%06d.png"};
    const auto add = [&](std::initializer_list<const char*> more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    if (format == MovieFormat::gif)
        add({"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "movie.gif"});
    else  // its sides are even numbers of pixels
        add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "movie.mp4"});
    return words;
}

std::string reason_of(int error) {
    if (error == ENOENT)
        return "ffmpeg is not installed; GIF and MP4 need it, and frames such as frame-%03d.png do not";
    return core::sentence("ffmpeg cannot be run: {reason}", {{"reason", std::strerror(error)}});
}

std::string file_name_of(std::size_t frame) {
    constexpr std::size_t digits = 6;
    std::string number = std::to_string(frame);
    number.insert(0, digits - std::min(digits, number.size()), '0');
    return core::sentence("frame-{number}.png", {{"number", number}});
}

}  // namespace

tl::expected<MovieMaker, std::string> MovieMaker::make() {
    std::error_code error;
    std::string folder = (fs::temp_directory_path(error) / "batten-XXXXXX").string();
    if (error || mkdtemp(folder.data()) == nullptr)
        return tl::unexpected(
            core::sentence("there is no place for the frames of a movie in {folder}", {{"folder", folder}}));
    MovieMaker maker(folder);
    if (const int status = run_in(maker.folder_, {program, "-version"}); status != 0)
        return tl::unexpected(reason_of(status < 0 ? ENOENT : status));
    return maker;
}

MovieMaker::MovieMaker(MovieMaker&& other) noexcept
    : folder_(std::exchange(other.folder_, fs::path())), count_(other.count_) {}

MovieMaker::~MovieMaker() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

tl::expected<void, std::string> MovieMaker::add(std::string_view png) {
    std::ofstream file(folder_ / file_name_of(count_++), std::ios::binary);
    file << png << std::flush;
    if (file) return {};
    return tl::unexpected(core::sentence("frame {number} of the movie cannot be written to {folder}",
                                         {{"number", count_}, {"folder", folder_.string()}}));
}

tl::expected<std::string, std::string> MovieMaker::movie(MovieFormat format, double rate) const {
    const int status = run_in(folder_, words_for(format, rate));
    if (status > 0) return tl::unexpected(reason_of(status));
    if (status < 0)
        return tl::unexpected(
            core::sentence("ffmpeg cannot make the movie: {reason}",
                           {{"reason", core::read_bytes(folder_ / messages).value_or(std::string())}}));
    return core::read_bytes(folder_ / (format == MovieFormat::gif ? "movie.gif" : "movie.mp4"))
        .map_error([](const core::FileError& error) { return error.sentence(); });
}

}  // namespace batten::cli
