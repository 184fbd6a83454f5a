#include "app/editor/derived/loaded_pictures.h"

#include "app/picture/image_file.h"

namespace batten::editor {

const LoadedPicture& LoadedPictures::of(const std::filesystem::path& path) const {
    std::error_code error;
    const auto written = std::filesystem::last_write_time(path, error);
    Entry& entry = entries_[path];
    if (entry.is_read && entry.written == written) return entry.loaded;
    auto image = picture::read_image(path);
    entry = {written, true, {}};
    if (image)
        entry.loaded.image = std::make_shared<const render::Image>(*std::move(image));
    else
        entry.loaded.problem = image.error();
    return entry.loaded;
}

}  // namespace batten::editor
