/// Everything the editor knows, as one plain value that only commands change.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/lesson_commands.h"
#include "app/editor/commands/recovery_commands.h"
#include "app/editor/derived/derived.h"
#include "app/editor/derived/knot_quiz.h"
#include "app/editor/derived/loaded_pictures.h"
#include "app/editor/derived/measured.h"
#include "app/editor/lesson/lesson.h"
#include "app/editor/sketch.h"
#include "app/editor/state/axis_pick.h"
#include "app/editor/state/dialog.h"
#include "app/editor/state/drawn_stroke.h"
#include "app/editor/state/faired_part.h"
#include "app/editor/state/findings.h"
#include "app/editor/state/history.h"
#include "app/editor/state/nudge_burst.h"
#include "app/editor/state/picture_gauge.h"
#include "app/editor/state/placing.h"
#include "app/editor/state/recoverable.h"
#include "app/editor/state/selection.h"
#include "app/editor/state/transform_pivot.h"
#include "app/editor/state/view.h"
#include "core/base/progress.h"
#include "core/document/file_stamp.h"
#include "core/document/native_file.h"

namespace batten::editor {

/// A sentence for the status bar; errors also stay as a notice on the canvas until dismissed or followed by another
/// command.
struct Message {
    std::string text;
    bool is_error = false;
    bool operator==(const Message&) const = default;
};

/// The active curve before a shape-changing edit, and how far the new one is from it.
struct Ghost {
    std::shared_ptr<const core::Curve> curve;
    double deviation = 0.0;
};

/// The knot that came in last, once, without changing the shape: how it cut the corners of the polygon stays in sight
/// as long as the parameter stays where it was.
struct InsertedKnot {
    double u = 0.0;
    double parameter = 0.0;  ///< of the view, then
};

/// What is told of a command that works beside the interface.
struct AtWork {
    std::string text;             ///< "Opening wave.json"
    std::optional<double> share;  ///< how much is done, from 0 to 1; none where that is not known
    bool is_canceled = false;     ///< it will stop as soon as it can
    Sketch sketch{};              ///< of the file that is being opened; stands for the document on the canvas
};

struct EditorState;

/// What the editor asks of the desktop; replaced in tests.
struct Desktop {
    std::function<std::string()> read_clipboard;
    std::function<void(const std::string&)> write_clipboard;
    /// Has Editor::follow_work called soon; is called from other threads. Without it no command works beside the
    /// interface.
    std::function<void()> wake;
    /// Writes what the view shows to a file and returns sentences on what the file lacks; the error is one, too.
    std::function<tl::expected<std::vector<std::string>, std::string>(const EditorState&, const std::filesystem::path&,
                                                                      const FigureForm&)>
        write_figure;
    std::filesystem::path examples;  ///< the folder of the example files
    std::filesystem::path lessons;   ///< the folder of the lessons
};

/// What begins another document or none, and so asks about unsaved changes first.
using Pending = std::variant<NewDocument, Open, OpenExample, OpenLesson, Recover, Quit>;

struct EditorState {
    History history;                        ///< its present is the committed document
    std::optional<core::Document> preview;  ///< what the gesture under way would make
    std::optional<Ghost> ghost;
    Derived derived;                           ///< of the curves that are shown
    Measured measured;                         ///< of the curves that are shown, by the views of their shape
    LoadedPictures pictures;                   ///< the files of the pictures
    std::optional<PictureGauge> gauge;         ///< while two points of a picture are clicked
    std::filesystem::path table;               ///< the file whose points are asked about
    std::optional<InsertedKnot> inserted;      ///< into the active curve
    std::optional<Findings> findings;          ///< of the committed document
    std::optional<LessonRun> lesson;           ///< that is being taken
    std::optional<LessonRecording> recording;  ///< of a lesson, from what is done
    Selection selection;                       ///< of the committed document, even while a preview is shown
    std::optional<NudgeBurst> burst;           ///< the last step, where it is nudges and nothing was done since
    std::optional<DrawnStroke> stroke;         ///< of the last step, where it came of one
    std::optional<FairedPart> faired;          ///< by the last step, where it faired a part
    std::optional<double> now;                 ///< seconds on the clock of the desktop; none where nobody tells it
    Hover hover;
    Placing placing;
    std::optional<TransformPivot> pivot;  ///< of the transform box, where one was chosen
    std::optional<AxisPick> axis_pick;    ///< while an axis or a center is chosen by clicks
    View view;
    std::optional<KnotQuiz> quiz;  ///< on knot vectors, while one is under way
    Tool tool = Tool::select;
    std::size_t tool_changes = 0;  ///< how often another tool was taken; what was begun with a tool is left with it
    Dialog dialog = Dialog::none;
    const CommandSpec* form = nullptr;  ///< whose fields Dialog::command_form asks for
    std::optional<Pending> pending;     ///< waits until unsaved changes are saved or given up
    std::optional<AtWork> at_work;      ///< what Dialog::at_work tells
    core::Progress progress;            ///< is told how far a long command is; may stop it
    core::PointsRead points_read;       ///< is told what is read of the file that is being opened
    Message message;
    std::filesystem::path path;            ///< empty for a document without a file
    std::filesystem::path source;          ///< the file of another program that it was read from; empty for most
    bool source_has_more = false;          ///< than what could be read, which a file in its place would not have
    std::optional<core::FileStamp> stamp;  ///< of that file when it was read or written; none where that is not known
    std::vector<Recoverable> recoverable;  ///< what sessions that did not end well left unsaved
    std::optional<Recoverable> recovered;  ///< of which the document came; its journal goes on with it
    std::vector<std::filesystem::path> recent_files;
    bool wants_quit = false;
    Desktop desktop;
    std::string clipboard;  ///< what was copied last, for where the desktop has no clipboard

    /// What is shown: the preview of a gesture, else the committed document.
    const core::Document& shown() const { return preview ? *preview : history.present(); }

    /// The active curve that is shown; null when the document is empty.
    const core::Curve* active_curve() const {
        const core::DocumentCurve* item = shown().active_curve();
        return item == nullptr ? nullptr : item->curve.get();
    }

    /// The same; null, too, when it is hidden.
    const core::Curve* visible_active_curve() const {
        const core::DocumentCurve* item = shown().active_curve();
        return item != nullptr && item->visible ? item->curve.get() : nullptr;
    }

    /// The parameter brought into the domain of the shown active curve.
    double parameter() const;

    bool is_modified() const { return !history.is_saved(); }

    /// "wave.json", or "untitled".
    std::string file_name() const;
};

/// Takes `tool` in place of the present one.
void take_tool(EditorState& state, Tool tool);

}  // namespace batten::editor
