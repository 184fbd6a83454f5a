/// Images on the graphics side.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "render/gl_object.h"
#include "render/image.h"

namespace batten::render {

/// Textures that stay as long as somebody holds the image.
class GlImages {
  public:
    /// Uploads the image unless it is there; one that is larger than textures may be is halved until it fits.
    void upload(const std::shared_ptr<const Image>& image);

    void bind(const Image& image) const;

  private:
    struct Shown {
        GlTexture texture;
        std::weak_ptr<const Image> image;
    };
    std::unordered_map<const Image*, Shown> shown_;
};

}  // namespace batten::render
