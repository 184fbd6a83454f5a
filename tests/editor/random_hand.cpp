#include "tests/editor/random_hand.h"

#include <string_view>

#include "app/editor/command_reader.h"
#include "app/editor/commands/joint_tool_commands.h"
#include "app/editor/commands/pen_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/fit_point_drag.h"
#include "core/evaluate/evaluate.h"
#include "render/camera.h"

namespace batten::editor::test {

namespace {

constexpr std::array typed_places{"1.5\t30\n", "x1\t-2\n", "@1,-0.5\n", "2<45\n",
                                  "3,4\n",     "1/3\n",    "<90\n",     "sqrt(2)\n"};
constexpr std::array some_modifiers{Modifiers{}, Modifiers{}, Modifiers{}, ctrl, shift, alt};

}  // namespace

glm::dvec2 RandomHand::somewhere() {
    const auto x = static_cast<double>(below(1281));
    return {x, static_cast<double>(below(721))};
}

glm::dvec2 RandomHand::at(core::Point place) const {
    return render::screen_from_world(editor_.state().view.camera, place);
}

// Something of the active curve that can be dragged, or a place beside it.
core::Point RandomHand::grip() {
    const core::DocumentCurve* active = editor_.state().history.present().active_curve();
    if (active == nullptr) return {};
    if (active->fit != nullptr && below(4) != 0) {
        const std::size_t i = below(active->fit->points.size());
        return below(3) == 0 ? handle_tip(*active->fit, i, HandleEnd::ahead) : active->fit->points[i].place;
    }
    const core::Curve& curve = *active->curve;
    if (below(3) != 0) return curve.control_points()[below(curve.control_points().size())];
    return core::point_at(curve, curve.domain().lower + curve.domain().length() * static_cast<double>(below(65)) / 64);
}

// Tab and Enter as themselves.
void RandomHand::type_place(glm::dvec2 place) {
    for (const char character : std::string_view(typed_places[below(typed_places.size())])) {
        PointerEvent event;
        event.action = PointerAction::key;
        event.position_px = place;
        if (character == '\t')
            event.key = Key::tab;
        else if (character == '\n')
            event.key = Key::enter;
        else
            event.character = static_cast<char32_t>(character);
        pointer_.send(event);
    }
}

void RandomHand::drag() {
    const glm::dvec2 from = at(grip());
    const glm::dvec2 to = below(2) == 0 ? somewhere() : from + 0.1 * (somewhere() - glm::dvec2(640.0, 360.0));
    pointer_.modifiers = some_modifiers[below(some_modifiers.size())];
    pointer_.move(from);
    pointer_.press(from);
    pointer_.move(to);
    if (below(8) == 0) pointer_.escape(to);
    if (below(3) == 0) type_place(to);
    pointer_.release(to);
    pointer_.modifiers = {};
}

void RandomHand::drag_guide() {
    const auto& guides = editor_.state().history.present().guides;
    if (guides.empty()) return drag();
    const glm::dvec2 from = at(guides[below(guides.size())].point);
    pointer_.drag(from, somewhere());
}

void RandomHand::double_click_fit_curve() {
    pointer_.double_click(at(grip()));
}

void RandomHand::draw_with_pen() {
    editor_.run(SetPenMode{.mode = static_cast<PenMode>(below(core::Names<PenMode>::table.size()))});
    editor_.run(SetTool{.tool = Tool::draw_curve});
    for (std::size_t i = 3 + below(4); i > 0; --i) {
        const glm::dvec2 place = somewhere();
        pointer_.move(place);
        if (below(4) == 0)
            type_place(place);
        else
            below(3) == 0 ? pointer_.drag(place, somewhere()) : pointer_.click(place);
    }
    if (below(4) == 0) pointer_.send(PointerAction::take_back, {});
    pointer_.send(PointerAction::finish, {});
}

void RandomHand::draw_shape() {
    editor_.run(*read_command(draw_shape_spec(static_cast<ShapeKind>(below(shape_kind_count))), editor_.state()));
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 place = somewhere();
        pointer_.move(place);
        if (below(4) == 0)
            type_place(place);
        else
            pointer_.click(place);
    }
}

void RandomHand::draw_stroke() {
    editor_.run(SetTool{.tool = Tool::pencil});
    glm::dvec2 place = below(2) == 0 ? at(grip()) : somewhere();
    pointer_.press(place);
    const glm::dvec2 step = 0.05 * (somewhere() - place);
    for (int i = 0; i < 20; ++i) {
        place += step + glm::dvec2(static_cast<double>(below(9)) - 4.0, static_cast<double>(below(9)) - 4.0);
        pointer_.move(place);
    }
    pointer_.release(place);
}

void RandomHand::use_joint_tool() {
    editor_.run(*read_command(joint_operation_spec(static_cast<JointOperation>(below(joint_operation_count))),
                              editor_.state()));
    for (int i = 0; i < 2; ++i) {
        const auto& curves = editor_.state().history.present().curves;
        if (curves.empty()) return;
        const core::Curve& curve = *curves[below(curves.size())].curve;
        const glm::dvec2 place = at(core::point_at(curve, below(2) == 0 ? curve.domain().lower : curve.domain().upper));
        pointer_.move(place);
        pointer_.click(place);
    }
}

void RandomHand::gesture() {
    const std::size_t count = editor_.state().history.present().curves.size();
    if (count > 0 && below(2) == 0) editor_.run(ActivateCurve{.index = below(count)});
    editor_.run(SetTool{.tool = Tool::select});
    const std::size_t chance = below(20);
    if (chance < 12 || count > 9) return drag();
    if (chance < 14) return drag_guide();
    if (chance < 16) return double_click_fit_curve();
    if (chance == 16) return draw_with_pen();
    if (chance == 17) return draw_shape();
    if (chance == 18) return draw_stroke();
    use_joint_tool();
}

}  // namespace batten::editor::test
