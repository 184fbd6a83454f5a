/// Maps of coverage on the graphics side.
#pragma once

#include <memory>
#include <vector>

#include "render/coverage_map.h"
#include "render/gl_object.h"

namespace batten::render {

/// Textures that are used again from frame to frame.
class GlTextures {
  public:
    /// Begins anew: the maps uploaded from here on are number 0, 1...
    void clear() { count_ = 0; }

    /// Uploads what is touched of a map, unless the one of this number is still the same.
    void upload(const std::shared_ptr<const CoverageMap>& map);

    void bind(std::size_t number) const;

  private:
    struct Shown {
        GlTexture texture;
        std::shared_ptr<const CoverageMap> map;
    };

    std::vector<Shown> shown_;
    std::size_t count_ = 0;
};

}  // namespace batten::render
