/// A command as data: a name and its arguments, so that a session can be logged, replayed and tested.
#pragma once

#include <concepts>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/argument.h"

namespace batten::editor {

struct CommandSpec;

/// A struct that the command table describes.
template <class C>
concept DescribedCommand = requires {
    { C::spec() } -> std::same_as<const CommandSpec&>;
};

struct Command {
    std::string name;  ///< as in the command table, "insert-knot"
    std::vector<Argument> arguments;

    Command() = default;
    Command(std::string command_name, std::vector<Argument> given)
        : name(std::move(command_name)), arguments(std::move(given)) {}
    template <DescribedCommand C>
    Command(const C& command) : Command(C::spec(), &command) {}  // NOLINT(google-explicit-constructor)

    bool operator==(const Command&) const = default;

  private:
    Command(const CommandSpec& spec, const void* command);
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
    void run(Command command) { requests_.emplace_back(std::move(command), Phase::commit); }
    void preview(Command command) { requests_.emplace_back(std::move(command), Phase::preview); }
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
