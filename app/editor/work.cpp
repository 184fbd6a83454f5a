#include "app/editor/work.h"

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <new>

#include "app/editor/command_spec.h"
#include "app/editor/commands/trace_commands.h"

namespace batten::editor {

namespace {

// Thrown by the progress of work that is canceled, and caught where the work began.
struct Canceled {};

constexpr double not_told = -1.0;

bool is_visible_step(double from, double to) {
    constexpr double steps = 100.0;
    return std::floor(steps * from) != std::floor(steps * to);
}

}  // namespace

// What both threads see; the result is the worker's until it has finished.
struct Work::Shared {
    std::atomic<double> share = not_told;
    std::mutex sketch_mutex;
    Sketch sketch;
    Outcome<WorkResult> result = tl::unexpected(Refusal());
    std::mutex mutex;
    std::condition_variable ended;
    bool is_finished = false;
};

namespace {

std::size_t points_in(const core::Document& document) {
    std::size_t count = 0;
    for (const core::DocumentCurve& entry : document.curves) count += entry.curve->control_points().size();
    return count;
}

// How many points a file of this size may have.
std::size_t points_in_file(const std::filesystem::path& path) {
    constexpr std::uintmax_t usual_bytes = 64;
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    return error ? 0 : static_cast<std::size_t>(bytes / usual_bytes);
}

std::size_t points_in_pending(const std::optional<Pending>& pending) {
    const Open* open = pending ? std::get_if<Open>(&*pending) : nullptr;
    return open != nullptr && open->path ? points_in_file(*open->path) : 0;
}

// One case for each type of value that can be large.
struct SizeOf {
    FieldKind kind;

    std::size_t operator()(const std::string& text) const {
        return kind == FieldKind::file ? points_in_file(text) : text.size();
    }
    template <class Item>
    std::size_t operator()(const std::vector<Item>& items) const {
        return items.size();
    }
    template <class Value>
    std::size_t operator()(const Value&) const {
        return 0;
    }
};

}  // namespace

Work::Work(const EditorState& state, std::function<bool(EditorState&)> run, std::function<void()> wake)
    : shared_(std::make_shared<Shared>()) {
    thread_ = std::jthread([shared = shared_, copy = state, run = std::move(run),
                            wake = std::move(wake)](const std::stop_token& stop) mutable {
        bool is_past_canceling = false;
        copy.desktop.read_clipboard = nullptr;
        copy.desktop.write_clipboard = nullptr;
        copy.progress = [&](double share) {
            if (stop.stop_requested() && !is_past_canceling) throw Canceled{};
            is_past_canceling = share >= 1.0;
            if (is_visible_step(shared->share.exchange(share), share)) wake();
        };
        copy.points_read = [&](std::span<const core::Point> points) {
            const std::lock_guard lock(shared->sketch_mutex);
            shared->sketch.add(points);
        };
        try {
            const bool is_done = run(copy);
            if (stop.stop_requested() && !is_past_canceling) throw Canceled{};
            copy.progress = nullptr;
            copy.points_read = nullptr;
            shared->result = WorkResult{std::move(copy), is_done};
        } catch (const Canceled&) {
            shared->result = tl::unexpected(Refusal("canceled; nothing has changed"));
        } catch (const std::bad_alloc&) {
            shared->result = tl::unexpected(Refusal("there is not enough memory; nothing has changed"));
        }
        {
            const std::lock_guard lock(shared->mutex);
            shared->is_finished = true;
        }
        shared->ended.notify_all();
        wake();
    });
}

Work::~Work() = default;

std::optional<double> Work::share() const {
    const double share = shared_->share;
    return share == not_told ? std::nullopt : std::optional(share);
}

Sketch Work::sketch() const {
    const std::lock_guard lock(shared_->sketch_mutex);
    return shared_->sketch;
}

void Work::cancel() {
    is_canceled_ = true;
    thread_.request_stop();
}

bool Work::wait_for(std::chrono::milliseconds time) const {
    std::unique_lock lock(shared_->mutex);
    return shared_->ended.wait_for(lock, time, [&] { return shared_->is_finished; });
}

Outcome<WorkResult> Work::take() {
    return std::move(shared_->result);
}

namespace {

std::size_t pixels_in_pictures(const core::Document& document) {
    std::size_t count = 0;
    for (const core::Picture& picture : document.pictures)
        count += static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    return count;
}

}  // namespace

bool is_large(const EditorState& state, const Command& command) {
    constexpr std::size_t least = 2000;
    constexpr std::size_t pixels_as_a_point = 500;
    std::size_t size = points_in(state.history.present()) + points_in_pending(state.pending);
    for (const Field& field : command.spec().fields)
        size += std::visit(SizeOf{field.kind}, field.get(command.fields()));
    if (command.as<TracePicture>() != nullptr) size += pixels_in_pictures(state.history.present()) / pixels_as_a_point;
    return size >= least;
}

}  // namespace batten::editor
