#include "app/ui/interface.h"

#include <imgui.h>

#include <glm/common.hpp>

#include "app/editor/cards/cards.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/pointer/placing_step.h"
#include "app/editor/scene/ruler.h"
#include "app/ui/command_entry.h"
#include "app/ui/context_popup.h"
#include "app/ui/frame_areas.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/panel_hover.h"
#include "app/ui/panels.h"
#include "app/ui/splitters.h"

namespace batten::ui {

namespace {

using editor::CanvasIdle;
using editor::Dialog;
using editor::PlotIdle;
using editor::PointerAction;
using editor::PointerEvent;

/// What a key means to a curve that is being drawn.
std::optional<PointerAction> drawing_action(const editor::Shortcut& shortcut) {
    using editor::Key;
    if (shortcut == editor::Shortcut{Key::enter, {}}) return PointerAction::finish;
    if (shortcut == editor::Shortcut{Key::backspace, {}}) return PointerAction::take_back;
    if (shortcut == editor::Shortcut{Key::z, {.ctrl = true}}) return PointerAction::take_back;
    return std::nullopt;
}

Picture picture_at(const FrameLayout& layout, glm::dvec2 position_px) {
    if (layout.canvas.contains(position_px) || layout.rulers.contains(position_px)) return Picture::canvas;
    if (layout.plot.contains(position_px)) return Picture::plot;
    return Picture::none;
}

bool is_press(const PointerEvent& event) {
    return event.action == PointerAction::press || event.action == PointerAction::double_click;
}

void follow_canvas_size(const editor::EditorState& state, const Rectangle& canvas, editor::CommandQueue& queue) {
    const glm::dvec2 size =
        glm::max(canvas.size_px, glm::dvec2(1.0));  // as the camera has it, lest it be asked for ever
    const bool is_new = state.view.camera.size_px != size || state.view.fits_on_open;
    if (is_new) queue.change(editor::ResizeCanvas{size});
}

/// Whether a dialog that covers the window wants all keys. The welcome screen leaves those that act on the whole
/// program.
bool is_kept_from_shortcuts(const editor::EditorState& state, const editor::Shortcut& shortcut) {
    if (state.dialog == Dialog::none) return false;
    const bool is_function_key = shortcut.key >= editor::Key::f1 && shortcut.key <= editor::Key::f12;
    return state.dialog != Dialog::welcome || !(shortcut.modifiers.ctrl || is_function_key);
}

void run_shortcut(const PanelContext& context, const KeyPress& press) {
    if (is_kept_from_shortcuts(context.state, press.shortcut)) return;
    const editor::CommandSpec* spec = command_of(context.state, press);
    if (spec == &editor::Copy::spec() && !context.panels.text_at_pointer.empty())
        context.queue.run(editor::CopyText{.text = context.panels.text_at_pointer});
    else if (spec != nullptr)
        run_by_key(context, *spec);
}

FrameAreas areas_of(const PanelContext& context) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const FrameAreas areas =
        arrange({size.x, size.y}, context.state.view, context.scale, !editor::shown_cards(context.state).empty());
    if (!context.state.lesson) return with_title_line(areas, title_line_height(context, areas.canvas));
    const FrameAreas wide = with_line_over_cards(areas);
    const glm::dvec2 room(wide.title_line.size_px.x, wide.canvas.size_px.y);
    return with_title_line(wide, lesson_line_height(context, room));
}

FrameAreas place_pictures(const PanelContext& context, FrameLayout& layout) {
    FrameAreas areas = areas_of(context);
    if (context.state.view.overlays.is_shown(editor::Overlay::rulers))
        areas = with_rulers(areas, context.px(editor::ruler_width));
    layout.rulers = areas.rulers;
    layout.canvas = areas.canvas;
    layout.plot = areas.dock;
    return areas;
}

/// Whether anything can be shown in the window, which may be a single pixel.
bool has_room(const PanelContext& context, const Rectangle& window) {
    constexpr glm::dvec2 least(150.0, 100.0);
    return window.size_px.x >= context.px(least.x) && window.size_px.y >= context.px(least.y);
}

void draw_frame_panels(const PanelContext& context, const FrameAreas& areas, const std::string& hint) {
    // Dear ImGui keeps windows that stay in the back in the reverse order of their making: the edges lie over the rest.
    draw_splitters(context, areas);
    if (!context.state.view.is_presenting) {
        draw_menu_bar(context, areas.menu_bar);
        draw_tool_bar(context, areas.tool_bar);
        draw_status_bar(context, areas.status_bar, hint, context.input.frames_per_second);
    }
    if (context.state.lesson)
        draw_lesson_line(context, areas.title_line);
    else
        draw_title_line(context, areas.title_line);
    begin_panel_hover(context);
    if (areas.inspector.size_px.x > 0.0) draw_inspector(context, areas.inspector);
    draw_cards_panel(context, areas.cards);
    draw_floating_cards(context, areas.canvas);
    draw_rulers(context, areas.rulers, areas.canvas);
    settle_panel_hover(context);
}

void draw_dialogs(const PanelContext& context, const FrameAreas& areas) {
    draw_presenting(context, areas.status_bar);
    // What was chosen by keys belongs to one question.
    if (context.state.dialog != context.panels.answer.dialog) context.panels.answer = {};
    // Dialogs show errors themselves.
    if (context.state.dialog == Dialog::none) draw_notice(context, areas.canvas);
    draw_welcome_screen(context, areas.window);
    draw_file_dialog(context, areas.window);
    draw_unsaved_dialog(context, areas.window);
    draw_changed_file_dialog(context, areas.window);
    draw_recovery_dialog(context, areas.window);
    draw_command_form(context, areas.window, areas.canvas);
    draw_command_palette(context, areas.window);
    draw_key_sheet(context, areas.window);
    draw_about_dialog(context, areas.window);
    draw_work_dialog(context, areas.window, areas.canvas);
}

/// The shape that Dear ImGui's widgets ask for.
editor::Cursor widget_cursor() {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_Hand:
            return editor::Cursor::hand;
        case ImGuiMouseCursor_TextInput:
            return editor::Cursor::text;
        case ImGuiMouseCursor_ResizeEW:
            return editor::Cursor::horizontal;
        case ImGuiMouseCursor_ResizeNS:
            return editor::Cursor::vertical;
        default:
            return editor::Cursor::arrow;
    }
}

}  // namespace

Interface::Interface() : panels_(std::make_unique<PanelState>()) {}

Interface::~Interface() = default;

PanelContext Interface::context_of(const editor::EditorState& state, const FrameInput& input, const Fonts& fonts,
                                   editor::CommandQueue& queue, FrameLayout& layout) const {
    return {state,          fonts, editor::shown_theme(state.view), state.view.interface_scale, queue, *panels_,
            layout.widgets, input};
}

void Interface::take_pointer(const editor::EditorState& state, const FrameInput& input, const Fonts& fonts,
                             editor::CommandQueue& queue) {
    FrameLayout layout;
    const PanelContext context = context_of(state, input, fonts, queue, layout);
    const FrameAreas areas = place_pictures(context, layout);
    follow_canvas_size(state, areas.canvas, queue);
    canvas_mode_ = editor::with_present_tool(std::move(canvas_mode_), state, queue);
    dispatch_pointer(context, layout);
}

FrameLayout Interface::draw(const editor::EditorState& state, const FrameInput& input, const Fonts& fonts,
                            editor::CommandQueue& queue) {
    FrameLayout layout;
    const PanelContext context = context_of(state, input, fonts, queue, layout);
    const FrameAreas areas = place_pictures(context, layout);
    dispatch_keys(context);
    panels_->text_at_pointer.clear();
    const std::string hint = panels_->pointer.hovered == Picture::plot ? editor::plot_hint(plot_mode_, state)
                                                                       : editor::canvas_hint(canvas_mode_, state);
    if (has_room(context, areas.window)) {
        draw_frame_panels(context, areas, hint);
        draw_dialogs(context, areas);
        draw_context_menu(context);
    }
    layout.cursor = cursor(state);
    return layout;
}

editor::Cursor Interface::cursor(const editor::EditorState& state) const {
    const PointerState& pointer = panels_->pointer;
    switch (pointer.hovered) {
        case Picture::canvas:
            return editor::canvas_cursor(canvas_mode_, state, pointer.space_is_held);
        case Picture::plot:
            return editor::plot_cursor(plot_mode_, state, pointer.space_is_held);
        case Picture::none:
            break;
    }
    return widget_cursor();
}

bool Interface::is_animating() const {
    const bool waits_for_keyboard = panels_->field.is_typing && !panels_->field.has_keyboard;
    return panels_->palette.was_submitted || waits_for_keyboard;
}

void Interface::send(Picture picture, const PointerEvent& event, const editor::EditorState& state,
                     const FrameLayout& layout, editor::CommandQueue& queue) {
    PointerEvent local = event;
    if (picture == Picture::canvas) {
        local.position_px -= layout.canvas.origin_px;
        canvas_mode_ = editor::step_canvas(canvas_mode_, local, state, queue);
    } else if (picture == Picture::plot) {
        local.position_px -= layout.plot.origin_px;
        plot_mode_ = editor::step_plot(plot_mode_, local, state, layout.plot.size_px, queue);
    }
}

bool Interface::is_at_rest(Picture picture) const {
    if (picture == Picture::canvas) return editor::is_at_rest(canvas_mode_);
    return picture == Picture::plot && std::holds_alternative<PlotIdle>(plot_mode_);
}

void Interface::open_picture_menu(const PanelContext& context, const FrameLayout& layout, Picture picture,
                                  glm::dvec2 position_px) const {
    const editor::EditorState& state = context.state;
    if (picture == Picture::canvas) {
        const glm::dvec2 local = position_px - layout.canvas.origin_px;
        const bool has_pen = state.tool == editor::Tool::draw_curve;
        const editor::Hover hit = has_pen ? editor::HoveredNothing{} : editor::hit_canvas(state, local);
        const core::Point place(render::world_from_screen(state.view.camera, local));
        open_context_menu(context, editor::OnCanvas{hit, place});
    } else if (picture == Picture::plot) {
        const glm::dvec2 local = position_px - layout.plot.origin_px;
        const editor::PlotLayout plot = editor::plot_layout(state, layout.plot.size_px);
        open_context_menu(context,
                          editor::OnPlot{editor::hit_plot(state, plot, local), parameter_from_x(plot, local.x)});
    }
}

void Interface::dispatch_pointer(const PanelContext& context, const FrameLayout& layout) {
    const editor::EditorState& state = context.state;
    editor::CommandQueue& queue = context.queue;
    PointerState& pointer = panels_->pointer;
    const bool is_covered = ImGui::GetIO().WantCaptureMouse;
    for (const PointerEvent& event : context.input.pointer_events) {
        pointer.space_is_held = event.space_is_held;
        const bool is_outside = is_covered || event.action == PointerAction::leave;
        const Picture under = is_outside ? Picture::none : picture_at(layout, event.position_px);
        const Picture target = pointer.captured != Picture::none ? pointer.captured : under;
        if (target != pointer.hovered) {
            PointerEvent leave = event;
            leave.action = PointerAction::leave;
            send(pointer.hovered, leave, state, layout, queue);
        }
        pointer.hovered = target;
        pointer.canvas_px.reset();
        if (target == Picture::canvas) {
            pointer.canvas_px = event.position_px - layout.canvas.origin_px;
            pointer.last_canvas_px = *pointer.canvas_px;
        }
        if (is_press(event) && pointer.captured == Picture::none) {
            pointer.captured = under;
            pointer.button = event.button;
        }
        const bool was_at_rest = is_at_rest(target);
        if (event.action != PointerAction::leave) send(target, event, state, layout, queue);
        const bool is_end = event.action == PointerAction::release && event.button == pointer.button;
        if (is_end) pointer.captured = Picture::none;
        // A right click ends a drawing, and interrupts no drag.
        const bool asks = event.action == PointerAction::release && event.button == editor::PointerButton::right &&
                          was_at_rest && is_at_rest(target);
        if (asks) open_picture_menu(context, layout, target, event.position_px);
    }
}

bool Interface::escape_gesture(const PanelContext& context) {
    // A dialog is closed first, and does that itself.
    if (context.state.dialog != Dialog::none) return false;
    PointerEvent event;
    event.action = PointerAction::escape;
    event.position_px = panels_->pointer.last_canvas_px;
    const bool is_typing = !context.state.placing.typed.is_empty();
    if (is_typing || !std::holds_alternative<CanvasIdle>(canvas_mode_)) {
        canvas_mode_ = editor::step_canvas(canvas_mode_, event, context.state, context.queue);
        return true;
    }
    if (!std::holds_alternative<PlotIdle>(plot_mode_)) {
        plot_mode_ =
            editor::step_plot(plot_mode_, event, context.state, context.state.view.camera.size_px, context.queue);
        return true;
    }
    return false;
}

bool Interface::send_key(const PanelContext& context, const KeyPress& press) {
    PointerEvent event;
    event.action = PointerAction::key;
    event.position_px = panels_->pointer.last_canvas_px;
    // Shift is what it takes to type some characters.
    event.modifiers = {press.shortcut.modifiers.ctrl, false, press.shortcut.modifiers.alt};
    event.key = press.shortcut.key;
    event.character = press.character;
    if (!editor::takes_key(canvas_mode_, context.state, event)) return false;
    canvas_mode_ = editor::step_canvas(canvas_mode_, event, context.state, context.queue);
    return true;
}

/// Whether Ctrl+Z is about what is being dragged, which is no step yet.
bool Interface::takes_back_drag(const PanelContext& context, const KeyPress& press) const {
    const bool is_dragging = context.panels.pointer.captured != Picture::none;
    return is_dragging && context.state.placing.typed.is_empty() &&
           drawing_action(press.shortcut) == PointerAction::take_back && press.shortcut.modifiers.ctrl &&
           !editor::listens_to_drawing_keys(canvas_mode_, context.state);
}

void Interface::dispatch_keys(const PanelContext& context) {
    for (const KeyPress& press : context.input.key_presses) {
        const bool is_escape = press.shortcut == editor::Shortcut{editor::Key::escape, {}};
        const std::optional<PointerAction> to_drawing = drawing_action(press.shortcut);
        if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
            if (is_escape) close_popups();
        } else if (ImGui::GetIO().WantTextInput || ImGui::IsAnyItemActive()) {
            continue;  // the widget answers to its keys
        } else if ((is_escape || takes_back_drag(context, press)) && escape_gesture(context)) {
            continue;
        } else if (send_key(context, press) || press.character != 0) {
            continue;
        } else if (to_drawing && editor::listens_to_drawing_keys(canvas_mode_, context.state)) {
            PointerEvent key;
            key.action = *to_drawing;
            canvas_mode_ = editor::step_canvas(canvas_mode_, key, context.state, context.queue);
        } else if (panels_->pointer.captured == Picture::none) {
            run_shortcut(context, press);
        }
    }
}

}  // namespace batten::ui
