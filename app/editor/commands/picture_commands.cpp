#include "app/editor/commands/picture_commands.h"

#include <algorithm>

#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/picture_list.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/show_dialog.h"
#include "app/picture/image_file.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::Picture;
using core::sentence;

constexpr double share_of_view = 0.8;
constexpr double usual_opacity = 0.5;

Outcome<void> choose_picture(EditorState& state, const ChoosePicture&) {
    show_dialog(state, Dialog::open_picture);
    return {};
}

Outcome<Edit> add_picture(const EditorState& state, const AddPicture& command) {
    Picture picture;
    picture.path = absolute_path(command.path);
    const LoadedPicture& loaded = state.pictures.of(picture.path);
    if (loaded.image == nullptr) return tl::unexpected(loaded.problem);
    picture.width = loaded.image->width;
    picture.height = loaded.image->height;
    picture.scale = command.width / picture.width;
    picture.position = command.center - 0.5 * picture.scale * core::Vector(picture.width, picture.height);
    picture.opacity = command.opacity;
    Edit edit{state.history.present()};
    edit.document.pictures.push_back(std::move(picture));
    return edit;
}

// The document after `change` of the picture.
template <class Change>
Outcome<Edit> with_picture(const EditorState& state, std::size_t index, const Change& change) {
    if (std::optional<Refusal> refusal = no_such_picture(state, index)) return tl::unexpected(*refusal);
    Edit edit{state.history.present()};
    change(edit.document.pictures[index]);
    return edit;
}

// The same where it changes the place, which a lock forbids.
template <class Change>
Outcome<Edit> with_placed(const EditorState& state, std::size_t index, const Change& change) {
    if (!no_such_picture(state, index) && state.history.present().pictures[index].locked)
        return tl::unexpected(Refusal("the picture is locked; unlock it first"));
    return with_picture(state, index, change);
}

Outcome<Edit> remove_picture(const EditorState& state, const RemovePicture& command) {
    if (std::optional<Refusal> refusal = no_such_picture(state, command.picture)) return tl::unexpected(*refusal);
    Edit edit{state.history.present()};
    std::vector<Picture>& pictures = edit.document.pictures;
    pictures.erase(pictures.begin() + static_cast<std::ptrdiff_t>(command.picture));
    return edit;
}

Outcome<Edit> move_picture(const EditorState& state, const MovePicture& command) {
    return with_placed(state, command.picture, [&](Picture& picture) { picture.position = command.position; });
}

Outcome<Edit> place_picture(const EditorState& state, const PlacePicture& command) {
    return with_placed(state, command.picture, [&](Picture& picture) {
        picture.position = command.position;
        picture.scale = command.width / picture.width;
        picture.rotation = command.rotation;
    });
}

Outcome<void> measure_picture(EditorState& state, const MeasurePicture& command) {
    if (std::optional<Refusal> refusal = no_such_picture(state, command.picture)) return tl::unexpected(*refusal);
    if (state.history.present().pictures[command.picture].locked)
        return tl::unexpected(Refusal("the picture is locked; unlock it first"));
    state.gauge = PictureGauge{command.picture, {}};
    state.message = {"Click two points of the picture whose distance you know · Escape gives up", false};
    return {};
}

// The first point stays where it is.
Outcome<Edit> scale_picture(const EditorState& state, const ScalePicture& command) {
    const double distance = core::robust_length(command.to - command.from);
    if (distance == 0.0)
        return tl::unexpected(Refusal("both points are the same; two different ones are needed to scale a picture"));
    return with_placed(state, command.picture, [&](Picture& picture) {
        const double factor = command.length / distance;
        picture.position = command.from + factor * (picture.position - command.from);
        picture.scale *= factor;
    });
}

Outcome<Edit> dim_picture(const EditorState& state, const DimPicture& command) {
    return with_picture(state, command.picture, [&](Picture& picture) { picture.opacity = command.opacity; });
}

Outcome<Edit> lock_picture(const EditorState& state, const LockPicture& command) {
    return with_picture(state, command.picture, [&](Picture& picture) { picture.locked = command.locked; });
}

Outcome<Edit> show_picture(const EditorState& state, const ShowPicture& command) {
    return with_picture(state, command.picture, [&](Picture& picture) { picture.visible = command.visible; });
}

StepTexts texts_of_lock(const EditorState&, const LockPicture& command) {
    if (command.locked) return {"Lock picture", "Locked the picture"};
    return {"Unlock picture", "Unlocked the picture"};
}

StepTexts texts_of_show(const EditorState&, const ShowPicture& command) {
    if (command.visible) return {"Show picture", "Showed the picture"};
    return {"Hide picture", "Hid the picture"};
}

core::Point camera_center(const EditorState& state) {
    return core::Point(state.view.camera.center);
}

double width_in_view(const EditorState& state) {
    const glm::dvec2 size = state.view.camera.size_px;
    return share_of_view * std::min(size.x, size.y) / state.view.camera.scale;
}

// The last picture, which is the only one most of the time.
std::optional<Picture> last_picture(const EditorState& state) {
    const std::vector<Picture>& pictures = state.history.present().pictures;
    return pictures.empty() ? std::nullopt : std::optional(pictures.back());
}

std::optional<core::Point> present_position(const EditorState& state) {
    const std::optional<Picture> picture = last_picture(state);
    return picture ? std::optional(picture->position) : std::nullopt;
}

std::optional<double> present_width(const EditorState& state) {
    const std::optional<Picture> picture = last_picture(state);
    return picture ? std::optional(picture->scale * picture->width) : std::nullopt;
}

std::optional<double> present_rotation(const EditorState& state) {
    const std::optional<Picture> picture = last_picture(state);
    return picture ? std::optional(picture->rotation) : std::nullopt;
}

std::optional<core::Point> gauge_point(const EditorState& state, std::size_t index) {
    if (!state.gauge || state.gauge->points.size() <= index) return std::nullopt;
    return state.gauge->points[index];
}

std::optional<core::Point> gauge_from(const EditorState& state) {
    return gauge_point(state, 0);
}

std::optional<core::Point> gauge_to(const EditorState& state) {
    return gauge_point(state, 1);
}

std::optional<double> gauge_length(const EditorState& state) {
    const auto from = gauge_from(state);
    const auto to = gauge_to(state);
    return from && to ? std::optional(core::distance(*from, *to)) : std::nullopt;
}

template <class Command>
Field opacity_field() {
    return field::number<&Command::opacity>("opacity", "from 0, not seen, to 1")
        .at_least(0.0)
        .at_most(1.0)
        .usually(usual_opacity);
}

}  // namespace

AddPicture picture_in_view(const EditorState& state, const std::filesystem::path& path) {
    return {path, camera_center(state), width_in_view(state), usual_opacity};
}

const CommandSpec& ChoosePicture::spec() {
    static const CommandSpec spec{
        .name = "choose-picture",
        .title = "Add picture…",
        .explanation = "Asks for a PNG or JPEG file that is shown below the curves, to draw by or to be traced.",
        .synonyms = "image reference background photo scan",
        .group = CommandGroup::file,
        .offered = in_the_window,
        .run = body_of<choose_picture>,
        .is_logged = false};
    return spec;
}

const CommandSpec& AddPicture::spec() {
    static const CommandSpec spec{
        .name = "add-picture",
        .title = "Add picture",
        .explanation = "Adds a PNG or JPEG file as a picture below the curves, to draw by or to be traced.",
        .synonyms = "image reference background photo scan",
        .group = CommandGroup::file,
        .offered = {.menu = false},
        .fields = {field::file<&AddPicture::path>("path", "the file"),
                   field::position<&AddPicture::center>({"x", "x of its middle"}, {"y", "y of its middle"})
                       .suggesting<camera_center>(),
                   field::length<&AddPicture::width>("width", "how wide it is in the plane, above 0")
                       .above(0.0)
                       .suggesting<width_in_view>(),
                   opacity_field<AddPicture>()},
        .run = body_of<add_picture>,
        .at_work = "Adding {path}",
        .step = "Add picture {path}",
        .done = "Added picture {path}"};
    return spec;
}

const CommandSpec& RemovePicture::spec() {
    static const CommandSpec spec{.name = "remove-picture",
                                  .title = "Remove picture",
                                  .explanation = "Takes a picture from below the curves.",
                                  .synonyms = "image delete",
                                  .group = CommandGroup::edit,
                                  .submenu = "Picture",
                                  .fields = {picture_field<RemovePicture>()},
                                  .refusal = no_picture,
                                  .run = body_of<remove_picture>,
                                  .done = "Removed the picture"};
    return spec;
}

const CommandSpec& MovePicture::spec() {
    static const CommandSpec spec{.name = "move-picture",
                                  .title = "Move picture",
                                  .explanation = "Moves a picture so that its lower left corner is at a place.",
                                  .synonyms = "image",
                                  .group = CommandGroup::edit,
                                  .submenu = "Picture",
                                  .offered = {.menu = false},
                                  .fields = {picture_field<MovePicture>(), field::position<&MovePicture::position>(
                                                                               {"x", "x of its lower left corner"},
                                                                               {"y", "y of its lower left corner"})
                                                                               .beginning_with<present_position>()},
                                  .refusal = no_picture,
                                  .run = body_of<move_picture>,
                                  .done = "Moved the picture"};
    return spec;
}

const CommandSpec& PlacePicture::spec() {
    static const CommandSpec spec{
        .name = "place-picture",
        .title = "Place picture",
        .explanation = "Puts a picture at a place, in a size and at an angle.",
        .synonyms = "image rotate scale",
        .group = CommandGroup::edit,
        .submenu = "Picture",
        .fields = {picture_field<PlacePicture>(),
                   field::position<&PlacePicture::position>({"x", "x of its lower left corner"},
                                                            {"y", "y of its lower left corner"})
                       .suggesting<present_position>(),
                   field::length<&PlacePicture::width>("width", "how wide it is in the plane, above 0")
                       .above(0.0)
                       .suggesting<present_width>(),
                   field::angle<&PlacePicture::rotation>("rotation", "about that corner, counterclockwise")
                       .suggesting<present_rotation>()},
        .refusal = no_picture,
        .run = body_of<place_picture>,
        .done = "Placed the picture"};
    return spec;
}

const CommandSpec& MeasurePicture::spec() {
    static const CommandSpec spec{
        .name = "measure-picture",
        .title = "Scale picture by two points…",
        .explanation = "Two clicks choose points of a picture; their true distance is typed then, and scales it.",
        .synonyms = "image calibrate size",
        .group = CommandGroup::edit,
        .submenu = "Picture",
        .offered = in_the_window,
        .fields = {picture_field<MeasurePicture>().unasked()},
        .refusal = no_picture,
        .run = body_of<measure_picture>,
        .is_logged = false};
    return spec;
}

const CommandSpec& ScalePicture::spec() {
    static const CommandSpec spec{
        .name = "scale-picture",
        .title = "Scale picture",
        .explanation = "Scales a picture so that two of its points have a given distance; the first one stays.",
        .synonyms = "image calibrate size",
        .group = CommandGroup::edit,
        .submenu = "Picture",
        .offered = {.menu = false},
        .fields = {picture_field<ScalePicture>(),
                   field::position<&ScalePicture::from>({"x1", "x of the first point, as it is now"},
                                                        {"y1", "y of the first point"})
                       .beginning_with<gauge_from>(),
                   field::position<&ScalePicture::to>({"x2", "x of the second point, as it is now"},
                                                      {"y2", "y of the second point"})
                       .beginning_with<gauge_to>(),
                   field::length<&ScalePicture::length>("length", "their true distance, above 0")
                       .above(0.0)
                       .beginning_with<gauge_length>()},
        .refusal = no_picture,
        .run = body_of<scale_picture>,
        .done = "Scaled the picture"};
    return spec;
}

const CommandSpec& DimPicture::spec() {
    static const CommandSpec spec{.name = "dim-picture",
                                  .title = "Dim picture",
                                  .explanation = "Makes a picture fainter or stronger.",
                                  .synonyms = "image opacity transparency fade",
                                  .group = CommandGroup::edit,
                                  .submenu = "Picture",
                                  .fields = {picture_field<DimPicture>(), opacity_field<DimPicture>()},
                                  .refusal = no_picture,
                                  .run = body_of<dim_picture>,
                                  .done = "Set the picture's opacity to {opacity}"};
    return spec;
}

const CommandSpec& LockPicture::spec() {
    static const CommandSpec spec{
        .name = "lock-picture",
        .title = "Lock picture",
        .explanation = "Locks a picture in its place, or unlocks it, so that it can be dragged.",
        .synonyms = "image unlock fix",
        .group = CommandGroup::edit,
        .submenu = "Picture",
        .fields = {picture_field<LockPicture>(),
                   field::flag<&LockPicture::locked>("locked", "yes to lock it, no to unlock it").usually(true)},
        .refusal = no_picture,
        .run = body_of<lock_picture>,
        .texts = texts_of<texts_of_lock>};
    return spec;
}

const CommandSpec& ShowPicture::spec() {
    static const CommandSpec spec{
        .name = "show-picture",
        .title = "Show picture",
        .explanation = "Shows a picture, or hides it.",
        .synonyms = "image hide visible",
        .group = CommandGroup::edit,
        .submenu = "Picture",
        .fields = {picture_field<ShowPicture>(),
                   field::flag<&ShowPicture::visible>("visible", "yes to show it, no to hide it").usually(true)},
        .refusal = no_picture,
        .run = body_of<show_picture>,
        .texts = texts_of<texts_of_show>};
    return spec;
}

void add_picture_commands(CommandTable& table) {
    add_all<ChoosePicture, AddPicture, MeasurePicture, PlacePicture, ScalePicture, MovePicture>(table);
    add_all<DimPicture, LockPicture, ShowPicture, RemovePicture>(table);
}

}  // namespace batten::editor
