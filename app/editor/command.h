/// A command as data: a name and its arguments, so that a session can be logged, replayed and tested.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace batten::editor {

/// A number, a text, or a list of numbers (indices, coordinates).
using Argument = std::variant<double, std::string, std::vector<double>>;

struct Command {
    std::string name;  ///< as in the command table, "insert-knot"
    std::vector<Argument> arguments;

    bool operator==(const Command&) const = default;
};

/// Whether a command is meant or only shown.
enum class Phase {
    commit,   ///< do it, as one step of the history
    preview,  ///< show what it would do to the committed document; replaces an earlier preview
    cancel    ///< drop the preview; the command is ignored
};

struct Request {
    // A constructor, so that run({"open", {path}}) can only mean a command.
    explicit Request(Command asked, Phase meant = Phase::commit) : command(std::move(asked)), phase(meant) {}

    Command command;
    Phase phase;
};

/// What the interface asks for during a frame; the editor runs it afterwards, in order.
class CommandQueue {
  public:
    void run(std::string name, std::vector<Argument> arguments = {}) {
        requests_.emplace_back(Command{std::move(name), std::move(arguments)}, Phase::commit);
    }
    void preview(std::string name, std::vector<Argument> arguments = {}) {
        requests_.emplace_back(Command{std::move(name), std::move(arguments)}, Phase::preview);
    }
    void cancel_preview() { requests_.emplace_back(Command{}, Phase::cancel); }

    bool is_empty() const { return requests_.empty(); }

    /// The requests so far; the queue is empty afterwards.
    std::vector<Request> take() { return std::exchange(requests_, {}); }

  private:
    std::vector<Request> requests_;
};

}  // namespace batten::editor
