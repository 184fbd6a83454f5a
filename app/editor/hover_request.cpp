#include "app/editor/hover_request.h"

namespace batten::editor {
namespace {

Command named(const char* kind, std::vector<double> values = {}) {
    return {"hover", {kind, std::move(values)}};
}

Command named(const char* kind, std::size_t index) {
    return named(kind, std::vector{static_cast<double>(index)});
}

/// One case for each kind of hovered thing.
struct CommandOf {
    Command operator()(const HoveredNothing&) const { return named("none"); }
    Command operator()(const HoveredPoint& h) const { return named("point", h.index); }
    Command operator()(const HoveredWeightRing& h) const { return named("ring", h.index); }
    Command operator()(const HoveredKnot& h) const { return named("knot", h.index); }
    Command operator()(const HoveredSpan& h) const { return named("span", h.span); }
    Command operator()(const HoveredCell& h) const {
        return named("cell", std::vector{static_cast<double>(h.level), static_cast<double>(h.index)});
    }
    Command operator()(const HoveredParameter&) const { return named("parameter"); }
    Command operator()(const HoveredCurve& h) const { return named("curve", std::vector{h.u}); }
    Command operator()(const HoveredLeg& h) const { return named("leg", h.index); }
    Command operator()(const HoveredOtherCurve& h) const { return named("other", h.index); }
    Command operator()(const HoveredBasis& h) const { return named("basis", h.index); }
};

}  // namespace

Command hover_command(const Hover& hover) {
    return std::visit(CommandOf{}, hover);
}

void request_hover(const Hover& hover, const EditorState& state, CommandQueue& queue) {
    if (hover == state.hover) return;
    Command command = hover_command(hover);
    queue.run(std::move(command.name), std::move(command.arguments));
}

}  // namespace batten::editor
