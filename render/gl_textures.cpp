#include "render/gl_textures.h"

namespace batten::render {

namespace {

void unpack_from(int row_length, glm::ivec2 lower, int alignment) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, row_length);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, lower.y);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, lower.x);
}

GlTexture make_map_texture() {
    GlTexture texture = make_gl_texture();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

void GlTextures::upload(const std::shared_ptr<const CoverageMap>& map) {
    if (count_ == shown_.size()) shown_.push_back({make_map_texture(), nullptr});
    Shown& shown = shown_[count_++];
    if (shown.map == map) return;
    shown.map = map;
    const PixelRange touched = map->touched();
    const glm::ivec2 extent = touched.upper - touched.lower;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shown.texture.id());
    unpack_from(map->size_px().x, touched.lower, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, extent.x, extent.y, 0, GL_RED, GL_UNSIGNED_BYTE, map->values().data());
    unpack_from(0, {0, 0}, 4);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void GlTextures::bind(std::size_t number) const {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shown_[number].texture.id());
}

}  // namespace batten::render
