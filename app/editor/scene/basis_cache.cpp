#include "app/editor/scene/basis_cache.h"

#include "app/editor/derived/derived.h"

namespace batten::editor {

namespace {

// Where the parameter runs through very many functions.
constexpr std::size_t most_singles = 4096;

}  // namespace

void BasisCache::follow(const core::KnotVector& knots, const PlotLayout& layout) {
    if (singles_.size() > most_singles) singles_.clear();
    if (key_ && share_arrays(key_->first, knots) && key_->second == layout) return;
    key_ = {knots, layout};
    all_.reset();
    singles_.clear();
    chosen_.reset();
}

}  // namespace batten::editor
