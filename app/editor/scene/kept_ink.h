/// The ink of a line, kept from one picture to the next.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "core/evaluate/strip_tree.h"
#include "render/camera.h"
#include "render/coverage_map.h"

namespace batten::editor {

/// Where and how a line is painted.
struct InkPlace {
    render::Camera camera;
    glm::ivec2 size_px{};
    render::InkStyle style;

    bool operator==(const InkPlace&) const = default;
};

/// Paints a line into maps.
struct InkPainter {
    /// The line as far as it is in `view`, without the parts `left_out`.
    std::function<void(render::CoverageMap& map, const core::Box& view, std::span<const std::size_t> left_out)> paint;
    std::function<void(render::CoverageMap& map, std::size_t part)> paint_part;
};

/// While parts of a line change again and again they are painted over the rest, which lasts. What else changes is
/// painted anew where it was. When the view moves by whole pixels, so does what was seen.
class KeptInk {
  public:
    using Map = std::shared_ptr<const render::CoverageMap>;

    /// Brings the ink up to date. `above`, which may be null, will be painted over it. Cost: nothing where nothing
    /// changed; a copy, and the parts that changed where they did before, what is near them, and what comes into view;
    /// else all.
    void follow(const core::StripChange& change, const InkPlace& place, const KeptInk* above,
                const InkPainter& painter);

    const Map& whole() const { return whole_; }

  private:
    /// The line without the parts that keep changing.
    struct Lasting {
        Map map;
        Map previous;        ///< what, moved by `shift`, may have more ink than `map` only in `region`; may be null
        glm::ivec2 shift{};  ///< in pixels
        core::Box region;
    };

    /// Where something may be seen through `above`, which has moved by `shift`, that was covered; none where nobody
    /// knows.
    std::optional<core::Box> uncovered(const KeptInk* above, glm::ivec2 shift) const;
    void paint_all(const KeptInk* above, const InkPainter& painter);
    void repaint(const Map& source, glm::ivec2 shift, const core::Box& region, const KeptInk* above,
                 const InkPainter& painter);

    InkPlace place_;
    std::uint64_t number_ = 0;        // of the change that is painted
    std::vector<std::size_t> loose_;  // the parts that keep changing, ascending
    Lasting lasting_;
    Map above_;  // what lasts of that
    Map whole_;
};

}  // namespace batten::editor
