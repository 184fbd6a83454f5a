#include "core/document/native_file.h"

#include "core/document/detail/native_reader.h"

namespace batten::core {

namespace fs = std::filesystem;

namespace {

FileResult<Document> read_file(InputFile& file, const Progress& progress, const PointsRead& points_read) {
    TextStream text(file, progress);
    return read_document(text, points_read);
}

}  // namespace

FileResult<Curve> load_curve(const fs::path& path) {
    const FileResult<Document> document = load_document(path);
    if (!document) return tl::unexpected(document.error());
    const DocumentCurve* active = document->active_curve();
    if (active == nullptr) return tl::unexpected(FileError{path.string(), "the file has no curve; one is needed"});
    return *active->curve;
}

FileResult<void> save_curve(const Curve& curve, const fs::path& path, const std::string& name) {
    Document document;
    DocumentCurve& entry = document.curves.emplace_back();
    entry.name = name;
    entry.curve = std::make_shared<const Curve>(curve);
    return save_document(document, path);
}

FileResult<Document> parse_document(std::string_view text) {
    TextStream stream(text);
    return read_document(stream);
}

FileResult<Document> load_document(const fs::path& path, const Progress& progress, const PointsRead& points_read) {
    return InputFile::open(path).and_then([&](InputFile file) { return read_file(file, progress, points_read); });
}

FileResult<Document> load_document(int descriptor, const std::string& name) {
    InputFile file(descriptor, name);
    return read_file(file, {}, {});
}

FileResult<void> save_document(const Document& document, const fs::path& path, const Progress& progress) {
    return replace_text(path, format_document(document, progress));
}

}  // namespace batten::core
