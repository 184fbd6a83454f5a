// The editor as a stream of commands, sensible and senseless, chosen by the bytes.

#include <cmath>
#include <memory>
#include <utility>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/editor.h"
#include "app/editor/recovery/document_pieces.h"
#include "app/editor/recovery/piece_delta.h"
#include "app/editor/state/same_document.h"
#include "core/document/native_file.h"
#include "tests/editor/random_session.h"
#include "tests/fuzz/sample_state.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

namespace {

constexpr int most_requests = 60;

// Which curve is active is not undone.
std::string undone_text(core::Document document) {
    document.active = 0;
    return core::format_document(document);
}

// The document of every step of the history, the oldest one first.
std::vector<std::string> texts_of_history(editor::Editor& editor) {
    while (editor.state().history.can_redo()) require(editor.run(editor::Redo{}), "what can be redone is");
    std::vector<std::string> texts{undone_text(editor.state().history.present())};
    while (editor.state().history.can_undo()) {
        require(editor.run(editor::Undo{}), "what can be undone is");
        texts.insert(texts.begin(), undone_text(editor.state().history.present()));
    }
    return texts;
}

// The journal as a session would leave it, replayed as far as it goes.
class Journal {
  public:
    void follow(const core::Document& document) {
        const std::string delta = editor::delta_between(replayed_, editor::pieces_of(document));
        auto pieces = editor::with_delta(replayed_, delta);
        require(pieces.has_value(), "what the journal tells follows on what it told before");
        replayed_ = *std::move(pieces);
        const auto found = editor::document_of(replayed_);
        require(found.has_value(), "the journal has a document");
        require(editor::is_same_document(*found, document), "the journal has the same document");
    }

  private:
    editor::DocumentPieces replayed_;
};

void require_sound_selection(const editor::EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    require(std::isfinite(state.parameter()), "the parameter is a number");
    if (active == nullptr) return require(state.selection == editor::Selection{}, "nothing is selected of no curve");
    const auto& points = state.selection.points;
    require(points.empty() || points.back() < active->curve->control_points().size(), "what is selected exists");
    require(!state.selection.knot || *state.selection.knot < active->curve->knots().stored().size(),
            "the selected knot exists");
}

}  // namespace

void run(std::string_view bytes) {
    editor::RandomSession session([&bytes] {
        std::uint32_t number = 0;
        for (int i = 0; i < 2 && !bytes.empty(); ++i) {
            number = number << 8U | static_cast<unsigned char>(bytes.front());
            bytes.remove_prefix(1);
        }
        return number;
    });
    editor::Editor editor = sample_editor();
    const std::string start = undone_text(editor.state().history.present());
    Journal journal;
    std::shared_ptr<const void> version;
    for (int i = 0; i < most_requests && !bytes.empty(); ++i) {
        editor.perform(session.next(editor.state()));
        require_sound_selection(editor.state());
        // Half of all requests leave the document as it was, which need not be looked at again.
        if (std::exchange(version, editor.state().history.version()) == editor.state().history.version()) continue;
        require_sound(editor.state().history.present());
        journal.follow(editor.state().history.present());
    }
    const std::vector<std::string> texts = texts_of_history(editor);
    require(texts.front() == start, "all that was done is undone");
    require(texts_of_history(editor) == texts, "what is done again is the same");
}

}  // namespace batten::fuzz
