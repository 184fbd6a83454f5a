/// The subcommands, which need no window, and what profile is asked for.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/editor/pointer/gesture_script.h"
#include "core/curve/knot_vector.h"
#include "exchange/code/code.h"
#include "exchange/format.h"

namespace batten::cli {

/// What a subcommand ended with; what the process returns.
enum class ExitStatus { done = 0, wrong_input = 1, wrong_usage = 2 };

/// Where a subcommand writes: results, and what is wrong. A file called "-" is standard input or output.
struct Output {
    std::ostream& results;
    std::ostream& errors;
};

struct InfoOptions {
    std::filesystem::path file;
    bool as_json = false;
};

/// Prints what the curves of a file are.
ExitStatus info(const InfoOptions& options, Output output);

struct EvalOptions {
    std::filesystem::path file;
    std::vector<std::string> at;  ///< parameters, or tables of them: "0.5", "@parameters.txt"
    std::string curve;            ///< its name or number; empty: the active one
    int derivatives = 0;          ///< how many
    bool basis = false;           ///< the basis functions instead of points
    core::Side side = core::Side::right;
    bool as_json = false;
};

/// Prints points and derivatives of a curve, or its basis functions and theirs.
ExitStatus eval(const EvalOptions& options, Output output);

struct ApplyOptions {
    std::optional<std::filesystem::path> file;  ///< none: an empty document
    std::vector<std::string> operations;        ///< names of commands, each followed by its arguments
    std::filesystem::path result;               ///< where the document is written; empty: nowhere
    std::string curve;                          ///< the one that is active at first; empty: as the file says
    bool as_json = false;
};

/// Runs commands of the editor on a file, in order, and writes the result. Nothing is written when one is refused. What
/// the commands found goes to the errors where the document is written to standard output.
ExitStatus apply(const ApplyOptions& options, Output output);

/// Prints the operations that apply() knows, with their arguments.
void list_operations(std::ostream& out);

struct CheckOptions {
    std::vector<std::filesystem::path> files;
    bool joints = false;             ///< also lists the joints
    std::optional<double> within{};  ///< how near ends must be to be one; none: a thousandth of the size
    bool as_json = false;
};

/// Says of each file whether it is valid, and what is wrong where it is not; lists its joints where they are asked for.
ExitStatus check(const CheckOptions& options, Output output);

/// The kind of Batten's own files.
struct NativeKind {};
using FileKind = std::variant<NativeKind, exchange::Format>;

struct ConvertOptions {
    std::filesystem::path file;
    std::optional<FileKind> from{};  ///< none: by the ending
    std::filesystem::path result;
    std::optional<FileKind> to{};  ///< likewise
    exchange::WriteOptions write{};
    bool as_json = false;
};

/// Reads the curves of a file and writes them to another one, of another program or of Batten's own kind; prints how
/// true the copies are and what was left out, to the errors where the file is written to standard output.
ExitStatus convert(const ConvertOptions& options, Output output);

struct HandoutOptions {
    std::filesystem::path lesson;
    std::filesystem::path result;  ///< the page that is written
};

/// Writes a lesson as a page to be printed: its texts, what its cards say, and a figure for each step.
ExitStatus handout(const HandoutOptions& options, Output output);

struct CodeOptions {
    std::filesystem::path file;
    exchange::CodeLanguage language = exchange::CodeLanguage::json;
    std::string curve;  ///< its name or number; empty: the active one
};

/// Prints a curve as text for programs and papers.
ExitStatus code(const CodeOptions& options, Output output);

struct FigureOptions {
    std::filesystem::path file;
    std::filesystem::path result;     ///< its ending decides the format; with frames a pattern, "frame-%03d.png"
    std::string format;               ///< of what goes to standard output: an ending without its dot
    std::optional<std::string> show;  ///< names of overlays and parts; none: the usual ones
    std::string at;                   ///< a parameter; empty: none is marked
    std::string curve;                ///< its name or number; empty: the active one
    std::string view;                 ///< of editor::FigureView; empty: as `show` asks for
    std::string size = "800x450";
    std::string theme = "light";
    std::string title;
    std::string animate;  ///< "u=0..1", "insert=0.5", "merge=5"; empty: a figure that stands still
    double scale = 1.0;
    bool is_transparent = false;
    std::optional<std::size_t> frames;  ///< none: 50
    std::optional<double> rate;         ///< frames a second; none: 25
};

/// Writes a picture of a curve, or the frames of an animation.
ExitStatus figure(const FigureOptions& options, Output output);

/// What `profile` is asked for. It needs the window, so that whoever has one runs it.
struct ProfileOptions {
    std::filesystem::path file;
    editor::ScriptedGesture gesture = editor::ScriptedGesture::drag;
    std::vector<std::string> commands;  ///< before the gesture, as typed in the palette
    std::size_t frame_count = 240;
    bool as_json = false;
};

}  // namespace batten::cli
