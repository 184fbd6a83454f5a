#include "app/editor/commands/trace_commands.h"

#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/picture_list.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "app/picture/image_file.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/make/trace.h"

namespace batten::editor {

namespace {

using core::sentence;

// As it is seen on white paper.
core::GrayImage gray_of(const render::Image& image) {
    core::GrayImage gray{image.width, image.height, {}};
    gray.values.reserve(image.rgba.size() / 4);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        // Weights of ITU-R BT.601, in thousandths.
        const unsigned shade = 299U * image.rgba[i] + 587U * image.rgba[i + 1] + 114U * image.rgba[i + 2];
        const unsigned alpha = image.rgba[i + 3];
        gray.values.push_back(static_cast<std::uint8_t>((shade * alpha / 1000U + 255U * (255U - alpha) + 127U) / 255U));
    }
    return gray;
}

core::Result<core::Curve> placed(const core::Curve& curve, const core::Picture& picture) {
    core::CurveDefinition definition = curve.definition();
    for (core::Point& point : definition.points)
        point = core::plane_from_picture(picture, {point.x, picture.height - point.y});
    return core::Curve::make(std::move(definition));
}

std::string remark_of(const core::Trace& found, bool is_inverted) {
    constexpr core::PluralPattern dark{
        .one = "one outline of what is darker than {threshold}, within {error} pixels",
        .many = "{count} outlines of what is darker than {threshold}, within {error} pixels"};
    constexpr core::PluralPattern light{
        .one = "one outline of what is lighter than {threshold}, within {error} pixels",
        .many = "{count} outlines of what is lighter than {threshold}, within {error} pixels"};
    std::string told =
        sentence(is_inverted ? light : dark, found.curves.size(),
                 {{"threshold", core::shortest_text(found.threshold)}, {"error", bound_text(found.error)}});
    if (found.left_out == 0) return told;
    return sentence("{told}; {left} smaller ones were left out", {{"told", told}, {"left", found.left_out}});
}

// The document with the outlines of the image as the picture is placed; the first of them is active.
template <class Command>
Outcome<Edit> with_outlines(const EditorState& state, const Command& command, const render::Image& image,
                            const core::Picture& picture) {
    const core::Result<core::Trace> found = core::trace(gray_of(image),
                                                        {.threshold = command.threshold,
                                                         .tolerance = command.tolerance,
                                                         .speckle = command.speckle,
                                                         .is_inverted = command.inverted},
                                                        state.progress);
    if (!found) return refused(std::nullopt, found.error());
    if (found->curves.empty())
        return tl::unexpected(sentence("nothing is outlined with the threshold {threshold}; another one is needed",
                                       {{"threshold", core::shortest_text(found->threshold)}}));
    Edit edit{state.history.present(), Selection{}};
    edit.document.active = edit.document.curves.size();
    core::FreeNames names(edit.document);
    for (const core::Curve& outline : found->curves) {
        core::Result<core::Curve> curve = placed(outline, picture);
        if (!curve) return refused(state, curve.error());
        core::DocumentCurve added;
        added.name = names.take(picture.path.stem().string());
        added.curve = std::make_shared<const core::Curve>(*std::move(curve));
        edit.document.curves.push_back(std::move(added));
    }
    edit.remark = remark_of(*found, command.inverted);
    return edit;
}

Outcome<Edit> trace_picture(const EditorState& state, const TracePicture& command) {
    if (std::optional<Refusal> refusal = no_such_picture(state, command.picture)) return tl::unexpected(*refusal);
    core::Picture picture = state.history.present().pictures[command.picture];
    const LoadedPicture& loaded = state.pictures.of(picture.path);
    if (loaded.image == nullptr) return tl::unexpected(loaded.problem);
    // A file that was replaced may have other pixels; it is shown in the same place.
    if (loaded.image->height != picture.height || loaded.image->width != picture.width)
        return tl::unexpected(
            sentence("{file}: the picture has {width} × {height} pixels now; add it again to trace it",
                     {{"file", picture.path.filename().string()},
                      {"width", loaded.image->width},
                      {"height", loaded.image->height}}));
    return with_outlines(state, command, *loaded.image, picture);
}

Outcome<Edit> trace_file(const EditorState& state, const TraceFile& command) {
    core::Picture picture;
    picture.path = absolute_path(command.path);
    const auto image = picture::read_image(picture.path);
    if (!image) return tl::unexpected(image.error());
    picture.width = image->width;
    picture.height = image->height;
    return with_outlines(state, command, *image, picture);
}

constexpr double pixel_tolerance = 0.3;
constexpr double least_speckle = 8.0;

template <class Command>
std::vector<Field> trace_fields(Field source) {
    return {std::move(source),
            field::number<&Command::threshold>("threshold",
                                               "from 0, black, to 255; left out, midway between dark and light")
                .at_least(0.0)
                .at_most(255.0)
                .absent_as("usual"),
            field::number<&Command::tolerance>("tolerance", "how far a curve may be from its outline, in pixels")
                .above(0.0)
                .usually(pixel_tolerance),
            field::number<&Command::speckle>("speckle", "what has less area is left out, in pixels")
                .at_least(0.0)
                .usually(least_speckle),
            field::flag<&Command::inverted>("inverted", "yes to outline what is light on dark").usually(false)};
}

}  // namespace

const CommandSpec& TracePicture::spec() {
    static const CommandSpec spec{.name = "trace-picture",
                                  .title = "Trace picture",
                                  .explanation = "Adds closed curves along the outlines of what is dark in a picture.",
                                  .synonyms = "image vectorize logo outline scan",
                                  .group = CommandGroup::make,
                                  .fields = trace_fields<TracePicture>(picture_field<TracePicture>()),
                                  .refusal = no_picture,
                                  .run = body_of<trace_picture>,
                                  .at_work = "Tracing the picture",
                                  .done = "Traced the picture"};
    return spec;
}

const CommandSpec& TraceFile::spec() {
    static const CommandSpec spec{
        .name = "trace",
        .title = "Trace file",
        .explanation = "Adds closed curves along the outlines of what is dark in a PNG or JPEG file, in its pixels.",
        .synonyms = "image vectorize logo outline scan",
        .group = CommandGroup::make,
        .offered = {.menu = false, .palette = false},
        .fields = trace_fields<TraceFile>(field::file<&TraceFile::path>("path", "the file")),
        .run = body_of<trace_file>,
        .at_work = "Tracing {path}",
        .step = "Trace {path}",
        .done = "Traced {path}"};
    return spec;
}

void add_trace_commands(CommandTable& table) {
    add_all<TracePicture, TraceFile>(table);
}

}  // namespace batten::editor
