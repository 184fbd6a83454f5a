#include "app/editor/scene/ruler.h"

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/grid_step.h"
#include "app/editor/scene/grid.h"
#include "app/editor/scene/multiples.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/words/length.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double label_size = 10.5;  // design pixels
constexpr double label_gap = 10.0;   // between a label and the next tick that has one
constexpr double label_start = 3.0;  // behind its tick
constexpr double least_fine_px = 4.0;

bool has_inches(const Units& units) {
    return units && units->unit == core::LengthUnit::inch;
}

// The whole part and the binary fraction of a number of inches.
std::string mixed_number(double value) {
    const double size = std::abs(value);
    const double whole = std::floor(size);
    double over = size - whole;
    double under = 1.0;
    while (over != std::floor(over)) {
        over *= 2.0;
        under *= 2.0;
    }
    const char* sign = value < 0.0 ? "−" : "";
    const core::Place number("whole", grid_number_text(whole, 1.0));
    if (over == 0.0) return core::sentence("{sign}{whole}", {{"sign", sign}, number});
    const core::Place numerator("over", static_cast<std::size_t>(over));
    const core::Place denominator("under", static_cast<std::size_t>(under));
    if (whole == 0.0) return core::sentence("{sign}{over}/{under}", {{"sign", sign}, numerator, denominator});
    return core::sentence("{sign}{whole} {over}/{under}", {{"sign", sign}, number, numerator, denominator});
}

/// The ticks of one ruler.
class TickRow {
  public:
    TickRow(const EditorState& state, RulerAxis axis)
        : state_(state),
          axis_(axis),
          world_per_unit_(world_per_length(state.shown().units)),
          px_per_unit_(state.view.camera.scale * world_per_unit_) {
        const render::Camera& camera = state.view.camera;
        const core::Point first(render::world_from_screen(camera, {-room_px(), camera.size_px.y + room_px()}));
        const core::Point last(render::world_from_screen(camera, {camera.size_px.x, 0.0}));
        lower_ = (axis == RulerAxis::x ? first.x : first.y) / world_per_unit_;
        upper_ = (axis == RulerAxis::x ? last.x : last.y) / world_per_unit_;
    }

    std::vector<RulerTick> ticks() {
        const GridSteps world = canvas_grid_steps(state_);
        const GridSteps steps{world.major / world_per_unit_, world.minor / world_per_unit_,
                              world.fine / world_per_unit_};
        const bool has_room = steps.fine * px_per_unit_ >= px(least_fine_px);
        const Multiples shown = multiples(lower_, upper_, has_room ? steps.fine : steps.minor);
        const double labeled = labeled_step(steps.major);
        std::vector<RulerTick> result;
        for (int k = 0; k < shown.count; ++k) result.push_back(tick(shown, k, steps, labeled));
        return result;
    }

  private:
    double px(double design_px) const { return design_px * state_.view.interface_scale; }
    /// Before the edge, where labels begin that reach into the picture.
    double room_px() const { return px(200.0); }

    double place_of(double value) const {
        const double world = value * world_per_unit_;
        const glm::dvec2 place = render::screen_from_world(state_.view.camera, {world, world});
        return axis_ == RulerAxis::x ? place.x : place.y;
    }

    /// The step of the labels: that of the major lines, or where these are too near a multiple of it.
    double labeled_step(double major) const {
        double widest = 0.0;
        const Multiples shown = multiples(lower_, upper_, major);
        for (int k = 0; k < shown.count; ++k)
            widest = std::max(widest, text_size(ruler_number(shown.value(k), major, state_.shown().units),
                                                px(label_size), render::LabelFont::number)
                                          .x);
        return major * round_number_from((widest + px(label_gap)) / (major * px_per_unit_));
    }

    RulerTick tick(const Multiples& shown, int k, const GridSteps& steps, double labeled) const {
        constexpr double major_length = 0.6;
        constexpr double minor_length = 0.35;
        constexpr double fine_length = 0.2;
        const auto is_multiple_of = [&](double step) {
            return std::fmod(shown.index(k), std::round(step / shown.step)) == 0.0;
        };
        RulerTick made{place_of(shown.value(k)), fine_length, {}};
        if (is_multiple_of(steps.minor)) made.length = minor_length;
        if (is_multiple_of(steps.major)) made.length = major_length;
        if (!is_multiple_of(labeled)) return made;
        made.length = 1.0;
        const double value = std::round(shown.value(k) / labeled) * labeled;
        made.label = ruler_number(value, labeled, state_.shown().units);
        return made;
    }

    const EditorState& state_;
    RulerAxis axis_;
    double world_per_unit_;
    double px_per_unit_;
    double lower_ = 0.0;
    double upper_ = 0.0;
};

}  // namespace

std::vector<RulerTick> ruler_ticks(const EditorState& state, RulerAxis axis) {
    return TickRow(state, axis).ticks();
}

std::string ruler_number(double value, double step, const Units& units) {
    constexpr double least_fraction = 1.0 / 1024.0;
    if (has_inches(units) && step >= least_fraction && std::abs(value) < 1e6) return mixed_number(value);
    // Parts of an inch that are no fractions here take a digit more than decimal steps.
    return grid_number_text(value, has_inches(units) ? step / 10.0 : step);
}

std::string ruler_corner(const EditorState& state) {
    return state.shown().units ? unit_ending(state.shown().units).substr(1) : std::string();
}

std::optional<RulerAxis> ruler_at(const EditorState& state, glm::dvec2 position_px) {
    if (!state.view.overlays.is_shown(Overlay::rulers)) return std::nullopt;
    if (position_px.y < 0.0) return RulerAxis::x;
    if (position_px.x < 0.0) return RulerAxis::y;
    return std::nullopt;
}

bool is_in_ruler_corner(const EditorState& state, glm::dvec2 position_px) {
    return ruler_at(state, position_px).has_value() && position_px.x < 0.0 && position_px.y < 0.0;
}

}  // namespace batten::editor
