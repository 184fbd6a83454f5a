/// Random commands, sensible and senseless, for tests of whole sessions.
#pragma once

#include <functional>
#include <initializer_list>
#include <random>
#include <string>

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"
#include "core/make/fit_points.h"

namespace batten::editor {

/// Makes one request after another; the same seed makes the same ones on every system.
class RandomSession {
  public:
    explicit RandomSession(unsigned seed) : generator_(std::mt19937(seed)) {}

    /// Takes its numbers from `generator`.
    explicit RandomSession(std::function<std::uint32_t()> generator) : generator_(std::move(generator)) {}

    /// A request about the document of `state`: mostly commits, some previews, cancels and changes of the view; about
    /// one in ten cannot be done.
    Request next(const EditorState& state);

  private:
    std::size_t below(std::size_t count) { return generator_() % count; }
    /// A multiple of 1/1024 within [lower, upper).
    double between(double lower, double upper);
    /// With coordinates within [-reach, reach).
    core::Point point(double reach);
    core::Vector vector(double reach);
    template <core::HasNames Enum>
    Enum any() {
        return static_cast<Enum>(below(core::Names<Enum>::table.size()));
    }
    std::string name() { return "name " + std::to_string(below(5)); }
    std::size_t index(std::size_t count);
    double parameter(const EditorState& state);
    std::vector<std::size_t> indices(std::size_t count);
    std::vector<double> typed_knots(const core::Curve& curve);

    /// The command with what suggests itself.
    Command suggested(const EditorState& state, const CommandSpec& spec);
    Command one_of(const EditorState& state, std::initializer_list<std::reference_wrapper<const CommandSpec>> specs);

    Command command(const EditorState& state);
    Command shape_command(const EditorState& state, const core::Curve& curve);
    Command knot_command(const EditorState& state, const core::Curve& curve);
    Command closing_command(const EditorState& state, const core::Curve& curve);
    Command refinement_command(const EditorState& state, const core::Curve& curve);
    Command piece_command(const EditorState& state, const core::Curve& curve);
    Command joint_command(const EditorState& state);
    Command making_command(const EditorState& state);
    Command guide_command();
    Command fitting_command();
    Command fit_point_command(const EditorState& state, const core::FitPoints& fit);
    Command moving_command(const EditorState& state, const core::Curve& curve);
    Command transform_command();
    Command picture_command(const EditorState& state);
    Command table_command();
    Command question_command(const EditorState& state);
    Command measuring_command(const EditorState& state);
    Command document_command(const EditorState& state);
    std::string parts(const EditorState& state);
    Command several_command(const EditorState& state);
    Command form_command();
    Command axis_pick_command();
    Command view_command(const EditorState& state);
    ViewChange view_change(const EditorState& state);

    std::function<std::uint32_t()> generator_;
};

}  // namespace batten::editor
