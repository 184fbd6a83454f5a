/// The whole interface of one frame: panels around the canvas, dialogs over it.
#pragma once

#include <memory>

#include "app/editor/editor.h"
#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/plot_mode.h"
#include "app/ui/fonts.h"
#include "app/ui/frame.h"
#include "render/draw_list.h"

namespace batten::ui {

struct PanelContext;
struct PanelState;
enum class Picture;

/// What the interface itself remembers between frames: pointer modes, half-typed texts, open lists. Nothing of the
/// document.
class Interface {
  public:
    Interface();
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// Turns what the pointer did to the pictures, and the window's size, into requests; to be run before draw(), so
    /// that panels and pictures of one frame show the same state. Needs a Dear ImGui frame that was begun.
    void take_pointer(const editor::EditorState& state, const FrameInput& input, const Fonts& fonts,
                      editor::CommandQueue& queue);

    /// Draws all panels and turns the rest of the input into requests; to be run after the pictures are made.
    FrameLayout draw(const editor::EditorState& state, const FrameInput& input, const Fonts& fonts,
                     editor::CommandQueue& queue);

    const editor::CanvasMode& canvas_mode() const { return canvas_mode_; }
    const editor::PlotMode& plot_mode() const { return plot_mode_; }

    /// Whether something moves by itself, so that another frame is due without input.
    bool is_animating() const;

  private:
    PanelContext context_of(const editor::EditorState& state, const FrameInput& input, const Fonts& fonts,
                            editor::CommandQueue& queue, FrameLayout& layout) const;
    void dispatch_pointer(const PanelContext& context, const FrameLayout& layout);
    bool is_at_rest(Picture picture) const;
    void open_picture_menu(const PanelContext& context, const FrameLayout& layout, Picture picture,
                           glm::dvec2 position_px) const;
    void dispatch_keys(const PanelContext& context);
    editor::Cursor cursor(const editor::EditorState& state) const;
    bool escape_gesture(const PanelContext& context);
    bool takes_back_drag(const PanelContext& context, const KeyPress& press) const;
    /// Offers a key or a character to the gesture on the canvas; whether it takes it.
    bool send_key(const PanelContext& context, const KeyPress& press);
    void send(Picture picture, const editor::PointerEvent& event, const editor::EditorState& state,
              const FrameLayout& layout, editor::CommandQueue& queue);

    editor::CanvasMode canvas_mode_;
    editor::PlotMode plot_mode_;
    std::unique_ptr<PanelState> panels_;
};

/// Adds the labels of a picture at `place` to the current frame, below all panels.
void draw_labels(const render::DrawList& picture, const Rectangle& place, const Fonts& fonts);

}  // namespace batten::ui
