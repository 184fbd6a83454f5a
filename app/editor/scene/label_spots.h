/// On which side of their points the labels of an animation stood in the frame before, so that they can stay there.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "app/editor/scene/label_layout.h"

namespace batten::editor {

/// Where a label stood, seen from its point.
struct LabelSpot {
    LabelSide side = LabelSide::upper_right;
    double distance = 0.0;  ///< design pixels
};

/// Labels are told apart by their texts without the numbers that change, and by their order among those of one text.
class LabelSpots {
  public:
    using Key = std::pair<std::string, std::size_t>;

    void begin_frame() { counts_.clear(); }

    /// The next label with that text in this frame.
    Key next(std::string_view text);

    /// Where it stood when it was last seen; none where it is new.
    std::optional<LabelSpot> spot(const Key& key) const;
    void put(const Key& key, const LabelSpot& spot) { spots_[key] = spot; }

  private:
    std::map<std::string, std::size_t> counts_;
    std::map<Key, LabelSpot> spots_;
};

}  // namespace batten::editor
