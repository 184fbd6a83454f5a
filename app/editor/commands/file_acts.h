/// What the file commands do once nothing stands in the way.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/command_spec.h"
#include "app/editor/state/figure.h"
#include "app/editor/state/state.h"
#include "exchange/format.h"

namespace batten::editor {

/// `path` from the folder in which the program works; as it is where that folder is gone.
std::filesystem::path absolute_path(const std::filesystem::path& path);

/// Does what the command asks for, whether or not there are unsaved changes. A file is read
/// and checked completely before anything changes.
Outcome<void> proceed(EditorState& state, const Pending& command);

/// The same once unsaved changes are saved or given up; asks about them first.
Outcome<void> ask_or_proceed(EditorState& state, Pending command);

/// Opens `document`, read from `path` (empty: from no file): a new history, nothing selected, all of it in view.
void show_document(EditorState& state, core::Document document, const std::filesystem::path& path);

/// The committed document with what the file at `path`, read as `format` (load_file), holds beside its own, as long as
/// it is there where both have units.
Outcome<Edit> with_curves_of(const EditorState& state, const std::filesystem::path& path,
                             std::optional<exchange::Format> format);

/// Saves the document, with the view as it is, to the absolute `path`, which becomes the document's own.
Outcome<void> save_document_to(EditorState& state, const std::filesystem::path& path);

/// Writes a copy of the visible curves for another program; the document keeps its own file and what is unsaved.
Outcome<void> export_document_to(EditorState& state, const std::filesystem::path& path, exchange::Format format);

/// Writes what the canvas shows as a figure, of the kind that the ending of `path` says.
Outcome<void> export_figure_to(EditorState& state, const std::filesystem::path& path, const FigureForm& form = {});

}  // namespace batten::editor
