/// A command as a value: one of the structs of commands/, with what the table says about it. So a session is a list of
/// commands, which can be logged, replayed and tested.
#pragma once

#include <concepts>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "app/editor/state/view_change.h"

namespace batten::editor {

struct CommandSpec;

/// A struct that the command table describes.
template <class C>
concept DescribedCommand = requires {
    { C::spec() } -> std::same_as<const CommandSpec&>;
};

class Command {
  public:
    template <DescribedCommand C>
    Command(C command)  // NOLINT(google-explicit-constructor): queue.run(InsertKnot{.u = 0.5})
        : spec_(&C::spec()), fields_(std::make_shared<const C>(std::move(command))) {}

    /// `fields` is the struct that `spec` describes.
    Command(const CommandSpec& spec, std::shared_ptr<const void> fields) : spec_(&spec), fields_(std::move(fields)) {}

    const CommandSpec& spec() const { return *spec_; }

    /// The struct that spec() describes.
    const void* fields() const { return fields_.get(); }

    /// The struct as what it is; null where the command is another one.
    template <DescribedCommand C>
    const C* as() const {
        return spec_ == &C::spec() ? static_cast<const C*>(fields_.get()) : nullptr;
    }

  private:
    const CommandSpec* spec_;
    std::shared_ptr<const void> fields_;
};

/// Whether a command is meant or only shown.
enum class Phase {
    commit,  ///< do it, as one step of the history
    preview  ///< show what it would do to the committed document; replaces an earlier preview
};

struct CommandRequest {
    Command command;
    Phase phase = Phase::commit;
};

/// Drops the preview.
struct CancelPreview {};

/// Stops the command that works beside the interface.
struct CancelWork {};

using Request = std::variant<CommandRequest, CancelPreview, CancelWork, ViewChange>;

/// What the interface asks for during a frame; the editor runs it afterward, in order.
class CommandQueue {
  public:
    void run(Command command) { requests_.emplace_back(CommandRequest{std::move(command)}); }
    void preview(Command command) { requests_.emplace_back(CommandRequest{std::move(command), Phase::preview}); }
    void cancel_preview() { requests_.emplace_back(CancelPreview{}); }
    void cancel_work() { requests_.emplace_back(CancelWork{}); }
    void change(ViewChange change) { requests_.emplace_back(std::move(change)); }

    bool is_empty() const { return requests_.empty(); }

    /// The requests so far; the queue is empty afterward.
    std::vector<Request> take() { return std::exchange(requests_, {}); }

  private:
    std::vector<Request> requests_;
};

}  // namespace batten::editor
