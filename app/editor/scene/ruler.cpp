#include "app/editor/scene/ruler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "app/editor/pointer/grid_step.h"
#include "app/editor/scene/grid_number.h"
#include "app/editor/scene/multiples.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/words/length.h"

namespace batten::editor {

namespace {

constexpr double label_size = 10.5;  // design pixels
constexpr double label_gap = 10.0;   // between a label and the next tick that has one
constexpr double label_start = 3.0;  // behind its tick
constexpr double least_fine_px = 4.0;
constexpr double least_label_gap = 5.0;  // where there would be too few labels otherwise
constexpr int least_labels = 3;

/// Whether `step` is one of `digits` times a power of ten.
bool has_digits_of(double step, std::span<const double> digits) {
    const double decade = std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    return std::ranges::any_of(digits, [&](double digit) { return std::abs(step / decade - digit) < 1e-6; });
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
        const core::Point first(render::world_from_screen(camera, {0.0, camera.size_px.y}));
        const core::Point last(render::world_from_screen(camera, {camera.size_px.x, 0.0}));
        lower_ = (axis == RulerAxis::x ? first.x : first.y) / world_per_unit_;
        upper_ = (axis == RulerAxis::x ? last.x : last.y) / world_per_unit_;
    }

    std::vector<RulerTick> ticks() {
        const GridSteps steps = unit_grid_steps(state_);
        const bool has_room = steps.fine * px_per_unit_ >= px(least_fine_px);
        const Multiples shown = multiples(lower_, upper_, has_room ? steps.fine : steps.minor);
        const double labeled = labeled_step(steps.major, shown.step);
        std::vector<RulerTick> result;
        for (int k = 0; k < shown.count; ++k) result.push_back(tick(shown, k, steps, labeled));
        return result;
    }

  private:
    double px(double design_px) const { return design_px * state_.view.interface_scale; }
    double length() const {
        return axis_ == RulerAxis::x ? state_.view.camera.size_px.x : state_.view.camera.size_px.y;
    }

    double place_of(double value) const {
        const double world = value * world_per_unit_;
        const glm::dvec2 place = render::screen_from_world(state_.view.camera, {world, world});
        return axis_ == RulerAxis::x ? place.x : place.y;
    }

    double width_px(const std::string& label) const {
        return text_size(label, px(label_size), render::LabelFont::number).x;
    }

    /// To the right of its tick or, turned, above it.
    bool is_whole(const std::string& label, double place_px) const {
        const double reach = px(label_start) + width_px(label);
        return axis_ == RulerAxis::x ? place_px >= 0.0 && place_px + reach <= length()
                                     : place_px <= length() && place_px - reach >= 0.0;
    }

    std::string label_of(double value, double step) const {
        return grid_number_text(std::round(value / step) * step, step, state_.shown().units);
    }

    /// What labels at the multiples of a step would be.
    struct Labels {
        double widest_px = 0.0;
        int whole = 0;  ///< are not cut
    };

    Labels labels_at(double step) const {
        Labels labels;
        const Multiples shown = multiples(lower_, upper_, step);
        for (int k = 0; k < shown.count; ++k) {
            const std::string label = label_of(shown.value(k), step);
            labels.widest_px = std::max(labels.widest_px, width_px(label));
            labels.whole += is_whole(label, place_of(shown.value(k))) ? 1 : 0;
        }
        return labels;
    }

    /// The step of the labels: that of the major lines, or where these are too near a multiple of it; a finer one where
    /// there would be too few. `tick` is the step of the ticks.
    double labeled_step(double major, double tick) const {
        const double room = labels_at(major).widest_px + px(label_gap);
        const double usual = major * round_number_from(room / (major * px_per_unit_));
        if (labels_at(usual).whole >= least_labels) return usual;
        constexpr std::array usual_digits{1.0, 2.0, 5.0};
        constexpr std::array more_digits{1.0, 1.25, 1.5, 2.0, 2.5, 4.0, 5.0, 6.25, 7.5, 8.0};
        if (const auto finer = finer_step(usual, tick, usual_digits, label_gap)) return *finer;
        return finer_step(usual, tick, more_digits, least_label_gap).value_or(usual);
    }

    /// The largest multiple of `tick` below `step` that begins with such a digit and has labels enough, which do not
    /// touch; inches are halved.
    std::optional<double> finer_step(double step, double tick, std::span<const double> digits, double gap) const {
        const bool is_halved = is_inch_fraction(step, state_.shown().units);
        for (double count = std::round(step / tick) - 1.0; count >= 1.0; count -= 1.0) {
            const double finer = count * tick;
            const bool is_round =
                is_halved ? is_inch_fraction(finer, state_.shown().units) : has_digits_of(finer, digits);
            if (!is_round) continue;
            const Labels labels = labels_at(finer);
            if (labels.widest_px + px(gap) > finer * px_per_unit_) return std::nullopt;
            if (labels.whole >= least_labels) return finer;
        }
        return std::nullopt;
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
        std::string label = label_of(shown.value(k), labeled);
        if (!is_whole(label, made.place_px)) return made;
        made.length = 1.0;
        made.label = std::move(label);
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
