#include "app/editor/commands/file_acts.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/editor/commands/added_curves.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/commands/loaded_file.h"
#include "app/editor/lesson/lesson_steps.h"
#include "app/editor/pointer/fit_view.h"
#include "app/editor/recovery/journal_reader.h"
#include "app/editor/state/settings.h"
#include "app/editor/state/show_dialog.h"
#include "app/editor/state/view_forms.h"
#include "core/base/sentence.h"
#include "core/document/native_file.h"
#include "exchange/curve_file.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

using core::sentence;

void remember(std::vector<fs::path>& recent_files, const fs::path& path) {
    recent_files.erase(std::remove(recent_files.begin(), recent_files.end(), path), recent_files.end());
    recent_files.insert(recent_files.begin(), path);
    if (recent_files.size() > most_recent_files) recent_files.resize(most_recent_files);
}

void take_view(View& view, const core::Document& document) {
    const core::DocumentCurve* active = document.active_curve();
    const core::Interval domain = active != nullptr ? active->curve->domain() : core::Interval{};
    view.parameter = document.view.parameter.value_or(domain.lower + 0.5 * domain.length());
    view.level.reset();
    view.notation = document.view.notation.empty() ? view.usual_notation : notation_named(document.view.notation);
    view.plot_range.reset();
    take_forms(view, read_forms(document.view.unknown_members).value_or(ViewForms{}));
    view.playback.is_playing = false;
    if (!document.view.overlays) return;
    const std::vector<std::string>& shown = *document.view.overlays;
    for (std::size_t i = 0; i < overlay_count; ++i) {
        const auto overlay = static_cast<Overlay>(i);
        view.overlays.show(overlay, std::find(shown.begin(), shown.end(), core::name_of(overlay)) != shown.end());
    }
}

// What was done, and then the remarks.
std::string told_of(std::string done, const std::vector<std::string>& remarks) {
    std::vector<std::string> told{std::move(done)};
    told.insert(told.end(), remarks.begin(), remarks.end());
    return *told_in_turn(told);
}

Outcome<void> open_file(EditorState& state, const fs::path& path, std::optional<exchange::Format> format) {
    const std::optional<core::FileStamp> stamp = core::file_stamp(path);  // before, so that no change goes unseen
    Outcome<LoadedFile> file = load_file(path, format, {state.progress, state.points_read});
    if (!file) return tl::unexpected(file.error());
    show_document(state, std::move(file->document), file->is_foreign ? fs::path() : path);
    if (file->is_foreign) {
        state.source = path;
        state.source_has_more = file->has_more;
    } else {
        state.stamp = stamp;
    }
    remember(state.recent_files, path);
    state.message = {told_of(sentence("Opened {file}", {{"file", path.filename().string()}}), file->remarks), false};
    return {};
}

Outcome<void> show_example(EditorState& state, const std::string& name) {
    // A name, not a path: nothing outside the folder of examples is an example.
    const fs::path path = state.desktop.examples / fmt::format("{}.json", name);
    std::error_code error;
    if (name.empty() || fs::path(name).has_parent_path() || !fs::is_regular_file(path, error))
        return tl::unexpected(sentence("there is no example called '{name}'", {{"name", name}}));
    Outcome<LoadedFile> file = load_file(path, std::nullopt, {state.progress, state.points_read});
    if (!file) return tl::unexpected(file.error());
    show_document(state, std::move(file->document), {});
    state.message = {sentence("Opened example {name}", {{"name", name}}), false};
    return {};
}

// What was said of a document that came back.
std::string told_of_recovery(const Recoverable& found) {
    if (found.file.empty()) return "Recovered the document; it is not saved yet";
    return sentence("Recovered {file}; it is not saved yet", {{"file", found.file.filename().string()}});
}

Outcome<void> recover(EditorState& state, const fs::path& journal) {
    const auto offered = std::ranges::find(state.recoverable, journal, &Recoverable::journal);
    if (offered == state.recoverable.end()) return tl::unexpected(Refusal("there is no such document to recover"));
    const Recoverable found = *offered;
    Outcome<core::Document> document = document_of_journal(*found.held, state.progress);
    if (!document) return tl::unexpected(document.error());
    state.recoverable.erase(offered);
    show_document(state, *std::move(document), found.file);
    state.history.mark_unsaved();
    state.stamp = found.stamp;
    state.recovered = found;
    state.message = {told_of_recovery(found), false};
    return {};
}

bool is_bare(const core::Document& document) {
    return document.curves.empty() && document.pictures.empty() && document.guides.empty() && !document.units;
}

// What both hold, the curves of `added` under names that are not in use; the last one is active.
core::Document joined(core::Document document, core::Document added) {
    if (is_bare(document)) document.units = added.units;
    add_curves(document, std::move(added.curves));
    document.active = document.curves.empty() ? 0 : document.curves.size() - 1;
    document.pictures.insert(document.pictures.end(), added.pictures.begin(), added.pictures.end());
    document.guides.insert(document.guides.end(), added.guides.begin(), added.guides.end());
    return document;
}

// The overlays shown, and those that a newer version knows.
std::vector<std::string> overlay_names(const EditorState& state) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < overlay_count; ++i)
        if (state.view.overlays.is_chosen(static_cast<Overlay>(i)))
            names.emplace_back(core::name_of(static_cast<Overlay>(i)));
    for (const std::string& name : state.history.present().view.overlays.value_or(std::vector<std::string>{}))
        if (!core::value_named<Overlay>(name)) names.push_back(name);
    return names;
}

// One case for each command that may have waited.
struct Proceed {
    EditorState& state;

    Outcome<void> operator()(const NewDocument&) const {
        show_document(state, {}, {});
        return {};
    }
    Outcome<void> operator()(const Open& command) const {
        return open_file(state, absolute_path(*command.path), command.format);
    }
    Outcome<void> operator()(const OpenExample& command) const { return show_example(state, command.name); }
    Outcome<void> operator()(const OpenLesson& command) const { return open_lesson(state, command.name); }
    Outcome<void> operator()(const Recover& command) const { return recover(state, command.journal); }
    Outcome<void> operator()(const Quit&) const {
        state.wants_quit = true;
        return {};
    }
};

// Of several notes the first one.
std::string exported_message(const std::string& file, const std::vector<std::string>& notes) {
    if (notes.empty()) return sentence("Exported {file}", {{"file", file}});
    return sentence("Exported {file}; {note}", {{"file", file}, {"note", notes.front()}});
}

}  // namespace

fs::path absolute_path(const fs::path& path) {
    std::error_code error;
    const fs::path result = fs::absolute(path, error);
    return error ? path : result;
}

void show_document(EditorState& state, core::Document document, const fs::path& path) {
    tell_names_apart(document);
    take_view(state.view, document);
    state.history = History(std::move(document));
    state.preview.reset();
    state.ghost.reset();
    state.findings.reset();
    state.lesson.reset();
    state.selection = {};
    state.pivot.reset();
    state.axis_pick.reset();
    state.hover = HoveredNothing{};
    state.path = path;
    state.source.clear();
    state.stamp.reset();
    state.recovered.reset();
    state.view.title_is_open = true;
    show_dialog(state, Dialog::none);
    fit_view(state);
    state.view.fits_on_open = true;  // again in the canvas that the title leaves
}

Outcome<void> proceed(EditorState& state, const Pending& command) {
    return std::visit(Proceed{state}, command);
}

Outcome<void> ask_or_proceed(EditorState& state, Pending command) {
    if (!state.is_modified()) return proceed(state, command);
    show_dialog(state, Dialog::unsaved_changes);
    state.pending = std::move(command);
    return {};
}

Outcome<Edit> with_curves_of(const EditorState& state, const fs::path& path, std::optional<exchange::Format> format) {
    Outcome<LoadedFile> added = load_file(path, format, {state.progress});
    if (!added) return tl::unexpected(added.error());
    if (added->document.curves.empty()) return tl::unexpected(file_refusal(path, {"", "the file has no curves"}));
    Outcome<std::optional<std::string>> converted = convert_units(added->document, units_of(state));
    if (!converted) return tl::unexpected(file_refusal(path, {"", converted.error()}));
    Edit edit{joined(state.history.present(), std::move(added->document)), Selection{}};
    if (*converted) added->remarks.insert(added->remarks.begin(), **std::move(converted));
    edit.remark = told_in_turn(added->remarks);
    return edit;
}

Outcome<void> export_document_to(EditorState& state, const fs::path& path, exchange::Format format) {
    const core::Document& document = state.history.present();
    const core::FileResult<exchange::Report> saved = exchange::save_curves(document, path, format, {}, state.progress);
    if (!saved) return tl::unexpected(file_refusal(path, saved.error()));
    state.message = {told_of(sentence("Exported {file}", {{"file", path.filename().string()}}),
                             report_words(units_of(state), *saved)),
                     false};
    return {};
}

Outcome<void> export_figure_to(EditorState& state, const fs::path& path, const FigureForm& form) {
    if (!state.desktop.write_figure) return tl::unexpected(Refusal("figures cannot be written here"));
    if (state.visible_active_curve() == nullptr)
        return tl::unexpected(Refusal("there is no visible curve to be shown"));
    const auto written = state.desktop.write_figure(state, path, form);
    if (!written) return tl::unexpected(written.error());
    state.message = {exported_message(path.filename().string(), *written), false};
    return {};
}

Outcome<void> save_document_to(EditorState& state, const fs::path& path) {
    core::Document document = state.history.present();
    document.view.parameter = state.parameter();
    document.view.overlays = overlay_names(state);
    document.view.unknown_members = with_forms(document.view.unknown_members, forms_of(state.view));
    if (!document.view.notation.empty() || state.view.notation != Notation{}) {
        std::map<std::string, std::string> names = names_of(state.view.notation);
        names.merge(document.view.notation);
        document.view.notation = std::move(names);
    }
    const core::FileResult<core::FileStamp> saved = core::save_document(document, path, state.progress);
    if (!saved) return tl::unexpected(file_refusal(path, saved.error()));
    state.path = path;
    state.source.clear();
    state.stamp = *saved;
    state.history.mark_saved();
    remember(state.recent_files, path);
    state.message = {sentence("Saved {file}", {{"file", path.filename().string()}}), false};
    return {};
}

}  // namespace batten::editor
