/// What a command's description says: its names and explanation, where it is offered, its fields, and what it does.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/fields/field.h"
#include "app/editor/state/drawn_stroke.h"
#include "app/editor/state/faired_part.h"
#include "app/editor/state/key.h"
#include "app/editor/state/nudge_burst.h"
#include "app/editor/state/selection.h"
#include "core/base/names.h"
#include "core/document/document.h"

namespace batten::editor {

/// What a command does to the shape of a curve.
enum class ShapeEffect { none, keeps, changes };

/// Where a command is listed. The groups up to `help` are the menus, in order.
enum class CommandGroup { file, edit, make, curve, construct, analyze, view, watch, help, gesture };

/// Who is offered a command.
struct Offer {
    bool menu = true;
    bool palette = true;
    bool scripts = true;    ///< as an operation of the command line
    bool key_sheet = true;  ///< where it has a shortcut
};
inline constexpr Offer everywhere{};
inline constexpr Offer in_the_window{.scripts = false};
inline constexpr Offer nowhere{.menu = false, .palette = false, .scripts = false, .key_sheet = false};

/// The document after an edit, and the selection where the edit changes it.
struct Edit {
    core::Document document;
    std::optional<Selection> selection{};
    std::optional<std::string> clipboard{};  ///< text for the clipboard once the edit is committed
    std::optional<double> error{};           ///< how far off the result really is, where the edit knows it
    std::optional<std::string> remark{};     ///< what else is to be said of what was done, as whole sentences
    std::optional<NudgeBurst> burst{};       ///< of a nudge; one of several extends the step before
    std::optional<DrawnStroke> stroke{};     ///< from which the edit came; its step is not told yet
    std::optional<FairedPart> faired{};      ///< what the edit faired; its step is not told yet
    bool extends = false;                    ///< replaces the step before, as what it led to
    bool only_adds = false;  ///< the old part of the curve stays, with its parameters, and a part is new
};

/// What a step is called in the history, "Move P₅", and what is said when it is done, "Moved P₅".
struct StepTexts {
    std::string step;
    std::string done;
};

/// What a command does, given its struct. One of `edit` and `act` is there: an edit makes a new document from the
/// committed one and becomes a step of the history; an act changes what is not undone (view, selection, files).
struct CommandBody {
    std::shared_ptr<void> (*make)() = nullptr;  ///< a struct whose fields are all to be set
    Outcome<Edit> (*edit)(const EditorState& state, const void* command) = nullptr;
    Outcome<void> (*act)(EditorState& state, const void* command) = nullptr;
};

struct CommandSpec {
    const char* name;           ///< "insert-knot", as in logs and on the command line
    const char* title;          ///< "Insert knot", as in menus
    const char* explanation;    ///< one sentence
    const char* synonyms = "";  ///< further words by which the palette finds it
    CommandGroup group;
    const char* submenu = nullptr;  ///< of the group's menu, "Knots"; it stands where its first command does
    Offer offered = everywhere;
    ShapeEffect effect = ShapeEffect::none;
    Shortcut shortcut{};
    Shortcut second_shortcut{};
    std::vector<Field> fields{};

    /// Why the command cannot be run now, as a sentence; null where it always can.
    std::optional<Refusal> (*refusal)(const EditorState&) = nullptr;
    /// Whether there is nothing for it to do, which is said without alarm; null where every refusal is one.
    bool (*is_idle)(const EditorState&) = nullptr;
    /// What it would do now, for tips; null where that is what the explanation says.
    std::string (*aim)(const EditorState&) = nullptr;
    /// Whether the command shows a check mark now; null where it is not a switch.
    bool (*is_checked)(const EditorState&) = nullptr;

    CommandBody run{};

    /// What is said while the command takes long, "Opening {path}"; it then works beside the interface. Null for what
    /// never takes long.
    const char* at_work = nullptr;

    /// The step's name in the history, "Insert knot {u}", where that is not the title, and what is said when it is
    /// done, "Inserted knot {u}". The places are the names of fields. Edits have them, or `texts` in their place, given
    /// the state before and the edit. Numbers are written in full (core::shortest_text): reading_text shortens them.
    const char* step = nullptr;
    const char* done = nullptr;
    StepTexts (*texts)(const EditorState& state, const void* command, const Edit& edit) = nullptr;

    /// Whether it is said where a shape-changing edit takes smoothness that the curve had at its knots; not where it is
    /// what the user does, as by moving a control point.
    bool tells_smoothness = false;

    bool is_logged = true;  ///< false for what only opens and closes dialogs
};

namespace detail {

template <auto function>
struct BodyOf;
template <class C, Outcome<Edit> (*function)(const EditorState&, const C&)>
struct BodyOf<function> {
    static constexpr CommandBody body{
        .make = []() -> std::shared_ptr<void> { return std::make_shared<C>(); },
        .edit = [](const EditorState& state, const void* c) { return function(state, *static_cast<const C*>(c)); }};
};
template <class C, Outcome<void> (*function)(EditorState&, const C&)>
struct BodyOf<function> {
    static constexpr CommandBody body{
        .make = []() -> std::shared_ptr<void> { return std::make_shared<C>(); },
        .act = [](EditorState& state, const void* c) { return function(state, *static_cast<const C*>(c)); }};
};

template <auto function>
struct TextsOf;
template <class C, StepTexts (*function)(const EditorState&, const C&)>
struct TextsOf<function> {
    static StepTexts texts(const EditorState& state, const void* c, const Edit&) {
        return function(state, *static_cast<const C*>(c));
    }
};
template <class C, StepTexts (*function)(const EditorState&, const C&, const core::Curve&)>
struct TextsOf<function> {
    static StepTexts texts(const EditorState& state, const void* c, const Edit& edit) {
        return function(state, *static_cast<const C*>(c), *edit.document.active_curve()->curve);
    }
};

}  // namespace detail

/// The body of the command that `function` takes: Outcome<Edit>(const EditorState&, const InsertKnot&), or
/// Outcome<void>(EditorState&, const SetTool&).
template <auto function>
inline constexpr CommandBody body_of = detail::BodyOf<function>::body;

/// The texts of a step by StepTexts(const EditorState&, const InsertKnot&), or with the curve that the edit gives as a
/// third argument.
template <auto function>
inline constexpr auto texts_of = &detail::TextsOf<function>::texts;

/// Whether there is nothing for the command to do now, which is no alarm.
inline bool is_idle(const CommandSpec& spec, const EditorState& state) {
    return spec.is_idle != nullptr && spec.is_idle(state);
}

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::ShapeEffect> {
    using enum editor::ShapeEffect;
    static constexpr std::array table{Named{none, "none", ""}, Named{keeps, "keeps", "keeps the shape"},
                                      Named{changes, "changes", "changes the shape"}};
};

template <>
struct Names<editor::CommandGroup> {
    using enum editor::CommandGroup;
    static constexpr std::array table{Named{file, "file", "File"},
                                      Named{edit, "edit", "Edit"},
                                      Named{make, "make", "Make"},
                                      Named{curve, "curve", "Curve"},
                                      Named{construct, "construct", "Construct"},
                                      Named{analyze, "analyze", "Analyze"},
                                      Named{view, "view", "View"},
                                      Named{watch, "watch", "Watch"},
                                      Named{help, "help", "Help"},
                                      Named{gesture, "gesture", ""}};
};

}  // namespace batten::core
