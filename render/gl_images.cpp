#include "render/gl_images.h"

#include <algorithm>

namespace batten::render {

namespace {

// How often the sides must be halved to fit.
int halvings_of(const Image& image) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    int halvings = 0;
    for (int side = std::max(image.width, image.height); side > std::max(most, 1); side = (side + 1) / 2) ++halvings;
    return halvings;
}

void fill(const Image& image) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace

void GlImages::upload(const std::shared_ptr<const Image>& image) {
    const auto found = shown_.find(image.get());
    // Another image may stand where one stood that is gone.
    if (found != shown_.end() && found->second.image.lock() == image) return;
    std::erase_if(shown_, [&](const auto& entry) { return entry.second.image.expired(); });
    Shown& shown = shown_[image.get()] = {make_gl_texture(), image};
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shown.texture.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    const int halvings = halvings_of(*image);
    if (halvings == 0)
        fill(*image);
    else
        fill(halved(*image, halvings));
    glBindTexture(GL_TEXTURE_2D, 0);
}

void GlImages::bind(const Image& image) const {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shown_.at(&image).texture.id());
}

}  // namespace batten::render
