#include "core/document/native_file.h"

#include "core/base/sentence.h"
#include "core/document/detail/native_reader.h"

namespace batten::core {

namespace fs = std::filesystem;

namespace {

FileResult<Document> read_file(InputFile& file, const Progress& progress, const PointsRead& points_read) {
    TextStream text(file, progress);
    return read_document(text, points_read);
}

// The paths of pictures are told from the folder of the document.
fs::path folder_of(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    return (error ? path : whole).parent_path();
}

Document with_absolute_pictures(Document document, const fs::path& path) {
    for (Picture& picture : document.pictures) picture.path = (folder_of(path) / picture.path).lexically_normal();
    return document;
}

// A file elsewhere in the same file system has such a path; another one keeps its own.
Document with_relative_pictures(Document document, const fs::path& path) {
    for (Picture& picture : document.pictures) {
        const fs::path relative = picture.path.lexically_relative(folder_of(path));
        if (picture.path.is_absolute() && !relative.empty()) picture.path = relative;
    }
    return document;
}

FileResult<FileStamp> replace_document(const fs::path& path, std::string_view text) {
    if (text.size() <= most_document_bytes) return replace_and_stamp(path, text);
    return tl::unexpected(
        FileError{path.string(), sentence("the document has more than {most} MiB, the most that can be read again",
                                          {{"most", most_document_bytes >> 20U}})});
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
    return save_document(document, path).map([](const FileStamp&) {});
}

FileResult<Document> parse_document(std::string_view text) {
    TextStream stream(text);
    return read_document(stream);
}

FileResult<Document> load_document(const fs::path& path, const Progress& progress, const PointsRead& points_read) {
    return InputFile::open(path, most_document_bytes)
        .and_then([&](InputFile file) { return read_file(file, progress, points_read); })
        .map([&](Document document) { return with_absolute_pictures(std::move(document), path); });
}

FileResult<Document> load_document(int descriptor, const std::string& name) {
    InputFile file(descriptor, name, most_document_bytes);
    return read_file(file, {}, {});
}

FileResult<FileStamp> save_document(const Document& document, const fs::path& path, const Progress& progress) {
    if (document.pictures.empty()) return replace_document(path, format_document(document, progress));
    return replace_document(path, format_document(with_relative_pictures(document, path), progress));
}

}  // namespace batten::core
