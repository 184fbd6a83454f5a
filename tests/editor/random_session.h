/// Random commands, sensible and senseless, for tests of whole sessions.
#pragma once

#include <random>

#include "app/editor/command.h"
#include "app/editor/state.h"

namespace batten::editor {

/// Makes one request after another; the same seed makes the same ones on every system.
class RandomSession {
  public:
    explicit RandomSession(unsigned seed) : generator_(seed) {}

    /// A request about the document of `state`: mostly commits, some previews and cancels; about one in ten cannot be
    /// done.
    Request next(const EditorState& state);

  private:
    std::size_t below(std::size_t count) { return generator_() % count; }
    /// A multiple of 1/1024 within [lower, upper).
    double between(double lower, double upper);
    double index(std::size_t count);
    double parameter(const EditorState& state);
    std::vector<double> indices(std::size_t count);
    std::vector<double> typed_knots(const core::Curve& curve);
    Command command(const EditorState& state);
    Command shape_command(const core::Curve& curve);
    Command knot_command(const EditorState& state, const core::Curve& curve);
    Command closing_command(const EditorState& state, const core::Curve& curve);
    Command refinement_command(const EditorState& state, const core::Curve& curve);
    Command piece_command(const EditorState& state, const core::Curve& curve);
    Command making_command();
    Command fitting_command();
    Command moving_command(const EditorState& state, const core::Curve& curve);
    Command measuring_command(const EditorState& state);
    Command document_command(const EditorState& state);
    Command view_command(const EditorState& state);

    std::mt19937 generator_;
};

}  // namespace batten::editor
