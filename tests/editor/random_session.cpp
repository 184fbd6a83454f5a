#include "random_session.h"

namespace batten::editor {

double RandomSession::between(double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(below(1024)) / 1024.0;
}

// Once in a while one that there is not.
double RandomSession::index(std::size_t count) {
    return static_cast<double>(below(20) == 0 ? count + below(3) : below(std::max<std::size_t>(count, 1)));
}

double RandomSession::parameter(const EditorState& state) {
    const core::Curve* curve =
        state.history.present().active_curve() ? state.history.present().active_curve()->curve.get() : nullptr;
    const core::Interval domain = curve != nullptr ? curve->domain() : core::Interval{0.0, 1.0};
    if (below(20) == 0) return domain.upper + 1.0;
    if (below(10) == 0) return below(2) == 0 ? domain.lower : domain.upper;
    return between(domain.lower, domain.upper);
}

std::vector<double> RandomSession::indices(std::size_t count) {
    std::vector<double> result;
    for (std::size_t i = 1 + below(3); i > 0; --i) result.push_back(index(count));
    return result;
}

// The knots stretched, or, once in a while, in a wrong order.
std::vector<double> RandomSession::typed_knots(const core::Curve& curve) {
    const auto stored = curve.knots().stored();
    std::vector<double> knots(stored.begin(), stored.end());
    for (double& knot : knots) knot = 2.0 * knot - 1.0;
    if (below(4) == 0) std::swap(knots.front(), knots.back());
    return knots;
}

Command RandomSession::shape_command(const core::Curve& curve) {
    const std::size_t n = curve.control_points().size();
    switch (below(12)) {
        case 0:
            return {"move-points", {indices(n), between(-2, 2), between(-2, 2)}};
        case 1:
            return {"set-point", {index(n), between(-9, 9), between(-9, 9)}};
        case 2:
            return {"set-weight", {index(n), between(-0.2, 4)}};
        case 3:
            return {"add-point", {index(n + 1), between(-9, 9), between(-9, 9)}};
        case 4:
            return {"delete-points", {indices(n)}};
        case 5:
            return {"nudge", {between(-1, 1), between(-1, 1)}};
        case 6:
            return {below(2) == 0 ? "nudge-left" : "nudge-up-far", {}};
        case 7:
            return {"delete", {}};
        case 8:
            // Degrees stay small, so that a session of hundreds of commands stays fast.
            return {"set-degree", {static_cast<double>(below(6))}};
        case 9:
            return curve.degree() < 5 ? Command{"elevate-degree", {}} : Command{"reduce-degree", {}};
        case 10:
            return {"reduce-degree", {}};
        default:
            return {"toggle-closed", {}};
    }
}

Command RandomSession::knot_command(const EditorState& state, const core::Curve& curve) {
    const std::size_t count = curve.knots().stored().size();
    static constexpr const char* kinds[]{"uniform",  "clamped-uniform", "bezier", "piecewise-bezier",
                                         "periodic", "custom",          "odd"};
    static constexpr const char* modes[]{"stop", "push", "snap"};
    switch (below(9)) {
        case 0:
            return {"insert-knot", {parameter(state)}};
        case 1:
            return {"insert-knot", {}};
        case 2:
            return count < 25 ? Command{"insert-midpoints", {}} : Command{"delete-knot", {index(count)}};
        case 3:
            return {"raise-knot", {index(count)}};
        case 4:
            return {"move-knot", {index(count), parameter(state), modes[below(3)], between(0, 0.2)}};
        case 5:
            return {"set-knot", {index(count), parameter(state)}};
        case 6:
            return {"delete-knot", {index(count)}};
        case 7:
            return {"set-kind", {kinds[below(7)]}};
        default:
            return {"set-knots", {typed_knots(curve)}};
    }
}

Command RandomSession::document_command(const EditorState& state) {
    const std::size_t count = state.history.present().curves.size();
    // Not too many curves, or too few.
    if (count > 6) return {"delete-curve", {index(count)}};
    switch (below(11)) {
        case 0:
            return {"new-curve",
                    {std::vector<double>{between(-5, 0), 0, 1, between(0, 5), 2, 2, 3, between(-5, 0), 5, 1}}};
        case 1:
            return {"delete-curve", {index(count)}};
        case 2:
            return {"duplicate-curve", {index(count)}};
        case 3:
            return {"rename-curve", {index(count), "name " + std::to_string(below(5))}};
        case 4:
            return {"set-curve-color", {index(count), below(2) == 0 ? "#e69f00" : "none"}};
        case 5:
            return {"set-curve-visible", {index(count), static_cast<double>(below(2))}};
        case 6:
            return {"set-curve-locked", {index(count), static_cast<double>(below(4) == 0)}};
        case 7:
            return {"cut", {}};
        case 8:
            return {"copy", {}};
        case 9:
            return {"paste", {}};
        default:
            return {"duplicate", {}};
    }
}

Command RandomSession::view_command(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    const std::size_t n = active != nullptr ? active->curve->control_points().size() : 0;
    switch (below(12)) {
        case 0:
            return {"select-points", {indices(n)}};
        case 1:
            return {"select-knot", {index(n)}};
        case 2:
            return {"select-all", {}};
        case 3:
            return {"select-none", {}};
        case 4:
            return {"activate-curve", {index(state.history.present().curves.size())}};
        case 5:
            return {"set-parameter", {parameter(state)}};
        case 6:
            return {"toggle-play", {}};
        case 7:
            return {"advance", {between(0, 20)}};
        case 8:
            return {"zoom-camera", {between(0.5, 2.0), 10.0, 20.0}};
        case 9:
            return {"hover", {"point", index(n)}};
        case 10:
            return {"set-level", {static_cast<double>(below(5)) - 1.0}};
        default:
            return {"escape", {}};
    }
}

Command RandomSession::command(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    const std::size_t group = below(20);
    if (group < 3) return {"undo", {}};
    if (group < 5) return {"redo", {}};
    if (group < 9) return view_command(state);
    if (active == nullptr || group < 12) return document_command(state);
    return group < 16 ? shape_command(*active->curve) : knot_command(state, *active->curve);
}

Request RandomSession::next(const EditorState& state) {
    const std::size_t chance = below(20);
    if (chance == 0) return Request({}, Phase::cancel);
    return Request(command(state), chance < 6 ? Phase::preview : Phase::commit);
}

}  // namespace batten::editor
