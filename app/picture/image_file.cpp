#include "app/picture/image_file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "app/picture/stb_image.h"
#include "core/base/ascii.h"
#include "core/base/sentence.h"

namespace batten::picture {

namespace {

namespace fs = std::filesystem;
using core::sentence;

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

constexpr int channels = 4;

std::string refusal(const char* pattern, const fs::path& path) {
    return sentence(pattern, {{"file", path.filename().string()}});
}

tl::expected<void, std::string> check_size(const fs::path& path, int width, int height) {
    const auto pixels = static_cast<std::size_t>(std::max(width, 0)) * static_cast<std::size_t>(std::max(height, 0));
    if (pixels == 0) return tl::unexpected(refusal("{file}: the picture has no pixels", path));
    if (pixels <= most_pixels) return {};
    return tl::unexpected(
        sentence("{file}: the picture has {width} × {height} pixels; at most {most} pixels are allowed",
                 {{"file", path.filename().string()}, {"width", width}, {"height", height}, {"most", most_pixels}}));
}

// PNG and JPEG by their first bytes: the decoder is asked for nothing else.
bool is_png_or_jpeg(std::FILE* file) {
    std::array<unsigned char, 4> first{};
    const std::size_t count = std::fread(first.data(), 1, first.size(), file);
    std::rewind(file);
    const bool is_png = first[0] == 0x89 && first[1] == 'P' && first[2] == 'N' && first[3] == 'G';
    return count == first.size() && (is_png || (first[0] == 0xFF && first[1] == 0xD8 && first[2] == 0xFF));
}

}  // namespace

tl::expected<render::Image, std::string> read_image(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) return tl::unexpected(refusal("{file}: there is no such file", path));
    if (!fs::is_regular_file(path, error)) return tl::unexpected(refusal("{file}: this is not an ordinary file", path));
    const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) return tl::unexpected(refusal("{file}: the file cannot be opened", path));
    if (!is_png_or_jpeg(file.get()))
        return tl::unexpected(refusal("{file}: this is not a picture that can be read; PNG and JPEG are", path));
    int width = 0;
    int height = 0;
    int found_channels = 0;
    if (stbi_info_from_file(file.get(), &width, &height, &found_channels) == 0)
        return tl::unexpected(refusal("{file}: the picture is damaged or of a rare kind and cannot be read", path));
    if (auto size = check_size(path, width, height); !size) return tl::unexpected(size.error());
    const std::unique_ptr<stbi_uc, Close> pixels(
        stbi_load_from_file(file.get(), &width, &height, &found_channels, channels));
    if (pixels == nullptr)
        return tl::unexpected(refusal("{file}: the picture is damaged or cut off and cannot be read", path));
    render::Image image{width, height, {}};
    const std::size_t bytes = channels * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.rgba.assign(pixels.get(), pixels.get() + bytes);
    return image;
}

bool is_named_as_image(const fs::path& path) {
    const std::string ending = core::in_small_letters(path.extension().string());
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

}  // namespace batten::picture
