/// Writes what is on screen into a file, so that a program that drives the real window can wait for a state instead of
/// for a time.
#pragma once

#include <filesystem>

#include "app/editor/state/state.h"
#include "app/platform/frame_clock.h"
#include "app/platform/input.h"
#include "app/ui/frame.h"
#include "render/draw_list.h"

namespace batten::platform {

/// One frame as the user sees it.
struct ShownFrame {
    const editor::EditorState& state;
    const ui::FrameLayout& layout;
    const render::DrawList& canvas;
    const render::DrawList& plot;
    const Input& input;
    const FrameClock& clock;
};

/// Replaces the file by a JSON object: places of canvas, plot, insets, widgets, control points and knots in window
/// pixels, the labels drawn, message, dialog, history, file, parameter. The file is complete whenever it can be read.
void write_state_report(const ShownFrame& frame, const std::filesystem::path& path);

}  // namespace batten::platform
