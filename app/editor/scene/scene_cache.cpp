#include "app/editor/scene/scene_cache.h"

#include <cmath>

#include "core/evaluate/hodograph.h"

namespace batten::editor {

namespace {

KeptCurve& followed(std::unique_ptr<KeptCurve>& kept, const std::shared_ptr<const core::Curve>& curve) {
    if (kept == nullptr) kept = std::make_unique<KeptCurve>(curve);
    kept->follow(curve);
    return *kept;
}

}  // namespace

core::PolygonStrips& KeptCurve::polygon() {
    if (!polygon_) polygon_.emplace(strips_.curve());
    polygon_->follow(strips_.curve());
    return *polygon_;
}

core::CurveStrips* KeptCurve::hodograph(std::size_t order) {
    auto& [differentiated, strips] = hodographs_[order - 1];
    if (differentiated != strips_.curve()) {
        differentiated = strips_.curve();
        ++hodograph_count_;
        auto made = order == 1 ? core::hodograph(*differentiated) : core::second_hodograph(*differentiated);
        if (!made)
            strips.reset();
        else if (auto curve = std::make_shared<const core::Curve>(*std::move(made)); strips)
            strips->follow(std::move(curve));
        else
            strips.emplace(std::move(curve));
    }
    return strips ? &*strips : nullptr;
}

const std::vector<std::vector<core::LiftedSample>>& KeptCurve::lifted(const core::LiftView& view,
                                                                      const core::LiftedFineness& fineness) {
    if (lifted_curve_ != strips_.curve() || lifted_view_ != view || lifted_fineness_ != fineness) {
        lifted_curve_ = strips_.curve();
        lifted_view_ = view;
        lifted_fineness_ = fineness;
        lifted_ = core::lifted_samples(*lifted_curve_, view, fineness);
        // Where numbers on the way are too large for doubles nothing can be shown.
        for (auto& run : lifted_)
            std::erase_if(run, [](const core::LiftedSample& sample) {
                return !core::is_finite(sample.point) || !std::isfinite(sample.weight);
            });
        std::erase_if(lifted_, [](const auto& run) { return run.empty(); });
    }
    return lifted_;
}

KeptCurve& SceneCache::curve(std::size_t index, const std::shared_ptr<const core::Curve>& curve) {
    if (index >= curves_.size()) curves_.resize(index + 1);
    return followed(curves_[index], curve);
}

KeptCurve& SceneCache::ghost(const std::shared_ptr<const core::Curve>& curve) {
    return followed(ghost_, curve);
}

void SceneCache::forget_beyond(std::size_t count) {
    if (curves_.size() > count) curves_.resize(count);
}

}  // namespace batten::editor
