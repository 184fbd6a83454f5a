#include "render/gl_images.h"

#include <algorithm>

namespace batten::render {

namespace {

constexpr int opaque = 255;

// How often the sides must be halved to fit.
int halvings_of(const Image& image) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    int halvings = 0;
    for (int side = std::max(image.width, image.height); side > std::max(most, 1); side = (side + 1) / 2) ++halvings;
    return halvings;
}

// So that what is between pixels is a mean of what is seen of them: a transparent pixel has no color of its own.
std::vector<std::uint8_t> premultiplied(const Image& image) {
    std::vector<std::uint8_t> rgba = image.rgba;
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
        for (std::size_t k = 0; k < 3 && rgba[i + 3] < opaque; ++k)
            rgba[i + k] = static_cast<std::uint8_t>((rgba[i + k] * rgba[i + 3] + opaque / 2) / opaque);
    return rgba;
}

void fill(const Image& image) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 premultiplied(image).data());
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
