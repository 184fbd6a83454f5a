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
            return curve.degree() < 5 ? Command{"elevate", {}} : Command{"reduce", {}};
        case 10:
            return {"reduce", {}};
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

Command RandomSession::closing_command(const EditorState& state, const core::Curve& curve) {
    static constexpr const char* ends[]{"start", "end", "both", "middle"};
    static constexpr const char* findings[]{"closing",       "collinear-runs", "conic-form",     "cubic-matrix",
                                            "anticentroids", "ferguson",       "blossom-labels", "greville-points"};
    // Each of these may add points.
    if (curve.control_points().size() > 25) return {"delete-points", {std::vector<double>{3.0}}};
    switch (below(8)) {
        case 0:
            return {"to-periodic", {between(-0.1, 2)}};
        case 1:
            return {"to-wrapped", {}};
        case 2:
            return {"to-clamped", {}};
        case 3:
            return {"move-seam", {parameter(state)}};
        case 4:
            return {below(2) == 0 ? "double-end" : "triple-end", {ends[below(4)]}};
        case 5:
            return {"phantom-end", {}};
        case 6:
            return {"straighten", {index(curve.control_points().size()), index(curve.control_points().size())}};
        default:
            return {findings[below(8)], {}};
    }
}

Command RandomSession::refinement_command(const EditorState& state, const core::Curve& curve) {
    // Inserting and raising in turn would make curves of thousands of points.
    if (curve.control_points().size() > 25 || curve.degree() > 6) return {"remove-knots", {between(-0.1, 2)}};
    switch (below(9)) {
        case 0:
            return {"insert-knots", {std::vector<double>{parameter(state), parameter(state)}}};
        case 1:
            return {"remove-knot", {parameter(state), static_cast<double>(below(3)), between(-0.1, 2)}};
        case 2:
            return {"remove-knots", {between(-0.1, 2)}};
        case 3:
            return {"merge-knots", {between(-0.05, 0.2)}};
        case 4:
            return {"reparametrize", {between(-2, 1), between(0, 4)}};
        case 5:
            return {"normalize", {}};
        case 6:
            return {"clamp", {below(2) == 0 ? "start" : "both"}};
        case 7:
            return {"unclamp", {below(2) == 0 ? "end" : "both"}};
        default:
            return {"to-bezier", {}};
    }
}

Command RandomSession::piece_command(const EditorState& state, const core::Curve& curve) {
    static constexpr const char* continuities[]{"C0", "C1", "C2", "G1", "G2", "C3"};
    if (state.history.present().curves.size() > 6 || curve.control_points().size() > 40 || curve.degree() > 6)
        return {"sub-curve", {parameter(state), parameter(state)}};
    switch (below(8)) {
        case 0:
            return {"split", {parameter(state)}};
        case 1:
            return {"sub-curve", {parameter(state), parameter(state)}};
        case 2:
            return curve.control_points().size() < 8 ? Command{"bezier-pieces", {}} : Command{"reverse", {}};
        case 3:
            return {"join-pieces", {between(-0.1, 20)}};
        case 4:
        case 5:
            return {"join", {"name " + std::to_string(below(5)), continuities[below(std::size(continuities))]}};
        case 6:
            return {below(2) == 0 ? "extend" : "extend-straight", {between(-1, 4), below(2) == 0 ? "start" : "end"}};
        default:
            return {"extend-parameter", {between(-0.1, 1), below(2) == 0 ? "start" : "end"}};
    }
}

Command RandomSession::making_command() {
    static constexpr const char* shapes[]{"line",    "polyline",     "polygon",  "circle",    "arc",
                                          "ellipse", "elliptic-arc", "parabola", "hyperbola", "conic"};
    switch (below(4)) {
        case 0:
            return {"arc", {between(-5, 5), 0.0, between(-0.2, 3), 30.0, between(-400, 400)}};
        case 1:
            return {"conic", {std::vector<double>{0, 0, between(-2, 2), 1, 3, between(-1, 1)}, between(-0.2, 3)}};
        case 2:
            return {"polygon", {between(-5, 5), 0.0, 1.5, static_cast<double>(below(9))}};
        default:
            return {shapes[below(10)], {}};
    }
}

Command RandomSession::fitting_command() {
    std::vector<double> coordinates;
    for (std::size_t i = 3 + below(6); i > 0; --i)
        coordinates.insert(coordinates.end(), {between(-5, 5), between(-5, 5)});
    if (below(10) == 0) coordinates.insert(coordinates.end(), {1.0, 1.0, 1.0, 1.0});
    switch (below(6)) {
        case 0:
            return {"interpolate", {coordinates, static_cast<double>(below(6))}};
        case 1:
            return {"interpolate-closed", {coordinates, static_cast<double>(below(6)), "uniform"}};
        case 2:
            return {"interpolate-natural", {coordinates}};
        case 3:
            return {"interpolate-tangents",
                    {std::vector<double>{between(-9, 9), 1}, std::vector<double>{0, 0}, coordinates}};
        case 4:
            return {"fit-points", {static_cast<double>(below(9)), coordinates}};
        default:
            return {"fit-points-within", {between(-0.2, 2), coordinates, 3.0, static_cast<double>(below(2))}};
    }
}

Command RandomSession::moving_command(const EditorState& state, const core::Curve& curve) {
    if (curve.control_points().size() > 25) return {"delete-points", {std::vector<double>{3.0}}};
    switch (below(5)) {
        case 0:
            return {"move-curve-point", {parameter(state), between(-9, 9), between(-9, 9)}};
        case 1:
            return {"set-tangent", {parameter(state), between(-9, 9), between(-9, 9)}};
        case 2:
            return {"move-point-and-tangent",
                    {parameter(state), between(-9, 9), between(-9, 9), between(-9, 9), between(-9, 9)}};
        case 3:
            return {"fair", {between(-0.1, 0.5)}};
        default:
            return {"offset", {between(-1, 1), 0.05}};
    }
}

Command RandomSession::measuring_command(const EditorState& state) {
    static constexpr const char* simple[]{"continuity", "inflections", "curvature-extrema", "cusps",
                                          "bounds",     "span-hulls",  "arc-length",        "area",
                                          "evaluate",   "intersect",   "self-intersections"};
    switch (below(5)) {
        case 0:
            return {"point-at-length", {between(-1, 30)}};
        case 1:
            return {"nearest", {between(-9, 9), between(-9, 9)}};
        case 2:
            return {below(2) == 0 ? "intersect-line" : "intersect-segment",
                    {between(-9, 9), between(-9, 9), between(-9, 9), between(-9, 9)}};
        case 3:
            return {"arc-length", {parameter(state), parameter(state)}};
        default:
            return {simple[below(std::size(simple))], {}};
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
    const std::size_t group = below(22);
    if (group < 3) return {"undo", {}};
    if (group < 5) return {"redo", {}};
    if (group < 9) return view_command(state);
    if (active == nullptr || group < 12)
        return below(4) != 0 || state.history.present().curves.size() > 6 ? document_command(state)
               : below(2) == 0                                            ? making_command()
                                                                          : fitting_command();
    if (group == 12) return closing_command(state, *active->curve);
    if (group == 14 && below(2) == 0) return measuring_command(state);
    if (group == 13) return moving_command(state, *active->curve);
    if (group == 20) return refinement_command(state, *active->curve);
    if (group == 21) return piece_command(state, *active->curve);
    return group < 16 ? shape_command(*active->curve) : knot_command(state, *active->curve);
}

Request RandomSession::next(const EditorState& state) {
    const std::size_t chance = below(20);
    if (chance == 0) return Request({}, Phase::cancel);
    return Request(command(state), chance < 6 ? Phase::preview : Phase::commit);
}

}  // namespace batten::editor
