#include "exchange/dxf/dxf_reader.h"

#include <charconv>
#include <unordered_map>

#include "exchange/dxf/dxf_curves.h"
#include "exchange/dxf/dxf_look.h"
#include "exchange/dxf/dxf_tables.h"
#include "exchange/places.h"
#include "exchange/refusal.h"
#include "exchange/utf8_text.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

using core::PluralPattern;

constexpr PluralPattern not_read{
    "an entity {what} at {place} was left out; SPLINE, LWPOLYLINE, POLYLINE, LINE, ARC, CIRCLE and ELLIPSE are read",
    "{count} entities {what} were left out, the first at {place}; SPLINE, LWPOLYLINE, POLYLINE, LINE, ARC, CIRCLE and "
    "ELLIPSE are read"};
constexpr PluralPattern in_paper_space{
    "{what} at {place} was left out, since it is on a sheet of paper, not in the model",
    "{count} entities {what} were left out, the first at {place}, since they are on sheets of paper, not in the model"};
constexpr PluralPattern interpolated{
    "{what} at {place} has only points that it passes; a curve through them was made, which may be another between "
    "them",
    "{count} entities {what} have only points that they pass, the first at {place}; curves through them were made, "
    "which may be others between them"};
constexpr PluralPattern interpolated_with_tangents{
    "{what} at {place} has only points that it passes and tangents at one end or both; a curve with these was made, "
    "which may be another between them",
    "{count} entities {what} have only points that they pass and tangents at one end or both, the first at {place}; "
    "curves with these were made, which may be others between them"};
constexpr PluralPattern unit_not_known{"the unit of length at {place} is not known here and was let go",
                                       "{count} units of length are not known here and were let go"};

// "\U+00e4" stands for a character.
std::string decoded(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        constexpr std::size_t length = 7;
        unsigned long character = 0;
        const bool is_escape =
            text.size() >= length && text.starts_with("\\U+") &&
            std::from_chars(text.data() + 3, text.data() + length, character, 16).ptr == text.data() + length;
        if (is_escape)
            append_utf8(result, character);
        else
            result.push_back(text.front());
        text.remove_prefix(is_escape ? length : 1);
    }
    return result;
}

std::string name_of(const DxfEntity& entity) {
    if (!entity.layer().empty() && entity.layer() != "0") return decoded(utf8_text(entity.layer()));
    if (entity.name() == "SPLINE") return "spline";
    if (entity.name() == "LINE") return "line";
    if (entity.name() == "ARC") return "arc";
    if (entity.name() == "CIRCLE") return "circle";
    return entity.name() == "ELLIPSE" ? "ellipse" : "polyline";
}

class DxfReader {
  public:
    explicit DxfReader(std::string_view text) : groups_(text) {}

    core::FileResult<Imported> read();

  private:
    void begin(const DxfGroup& group);
    void take(const DxfGroup& group);
    void take_variable(const DxfGroup& group);
    void end_entity();
    void end_polyline();
    void add_curve(const DxfEntity& entity);

    DxfGroups groups_;
    Collector found_;
    std::string_view section_{};
    std::string_view variable_{};
    std::optional<DxfEntity> entity_{};
    std::optional<DxfEntity> polyline_{};  // whose vertices follow
    std::unordered_map<std::string, DxfLook> layers_;
};

core::FileResult<Imported> DxfReader::read() {
    while (const std::optional<DxfGroup> group = groups_.next()) {
        if (group->code != 0) {
            take(*group);
            continue;
        }
        begin(*group);
        if (group->value == "EOF") return std::move(found_).finish("there are no curves in this file");
    }
    if (groups_.error()) return tl::unexpected(*groups_.error());
    if (groups_.line() == 0) return refused_file("the file is empty");
    return refused_file("the file ends without its end mark, EOF; it is not whole", line_place(groups_.line()));
}

void DxfReader::begin(const DxfGroup& group) {
    end_entity();
    const bool is_vertex = group.value == "VERTEX";
    if (polyline_ && !is_vertex) end_polyline();
    if (group.value == "SECTION" || group.value == "ENDSEC") section_ = {};
    if (section_ == "ENTITIES" || (section_ == "TABLES" && group.value == "LAYER") || group.value == "SECTION")
        entity_.emplace(group);
}

void DxfReader::take(const DxfGroup& group) {
    constexpr int name_code = 2;
    if (entity_ && entity_->name() == "SECTION") {
        if (group.code == name_code) section_ = group.value;
        entity_.reset();
    } else if (section_ == "HEADER") {
        take_variable(group);
    } else if (entity_) {
        entity_->take(group);
    }
}

void DxfReader::take_variable(const DxfGroup& group) {
    constexpr int variable_code = 9;
    constexpr int number_code = 70;
    if (group.code == variable_code) variable_ = group.value;
    if (group.code != number_code || variable_ != "$INSUNITS") return;
    found_.document().units = units_of_code(group.value);
    if (!found_.document().units && group.value != "0")
        found_.notes().add(unit_not_known, [&] { return line_place(group.line); });
}

void DxfReader::end_entity() {
    if (!entity_) return;
    const std::string_view name = entity_->name();
    if (section_ == "TABLES") {
        layers_[layer_key(entity_->title())] = look_of_layer(*entity_);
    } else if (name == "POLYLINE" && !is_mesh(*entity_)) {
        polyline_ = std::move(entity_);
        polyline_->forget_vertices();
    } else if (name == "VERTEX" && polyline_) {
        if (is_on_polyline(*entity_)) polyline_->add_vertex(*entity_);
    } else if (name != "VERTEX" && name != "SEQEND") {
        add_curve(*entity_);
    }
    entity_.reset();
}

void DxfReader::end_polyline() {
    add_curve(*polyline_);
    polyline_.reset();
}

void DxfReader::add_curve(const DxfEntity& entity) {
    const DxfCurveMaker make =
        is_mesh(entity) && entity.name() == "POLYLINE" ? nullptr : dxf_curve_maker(entity.name());
    const auto place = [&] { return line_place(entity.line()); };
    if (make == nullptr) return found_.notes().add(not_read, place, entity.name());
    if (entity.number(67, 0.0) != 0.0) return found_.notes().add(in_paper_space, place, entity.name());
    if (found_.is_full()) return found_.leave_out_more(place);
    MadeCurve made = entity.defect().empty() ? make(entity) : tl::unexpected(entity.defect());
    core::DocumentCurve* curve = found_.add(std::move(made), name_of(entity), entity.name(), place);
    if (curve == nullptr) return;
    const auto layer = layers_.find(layer_key(entity.layer()));
    const DxfLook look = look_of_entity(entity, layer == layers_.end() ? DxfLook{} : layer->second);
    curve->color = look.color;
    curve->visible = look.visible;
    curve->locked = look.locked;
    look.tell_losses(found_.looks());
    if (entity.is_off_plane()) found_.note_heights(entity.name(), place);
    if (entity.name() != "SPLINE") return;
    if (!has_fit_points_alone(entity)) return found_.note_error(unrolling_error(*curve->curve));
    found_.notes().add(has_end_tangents(entity) ? interpolated_with_tangents : interpolated, place, entity.name());
}

}  // namespace

core::FileResult<Imported> read_dxf(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (text.starts_with("AutoCAD Binary DXF"))
        return refused_file("this is a binary DXF; save it as text (ASCII) to read it");
    if (text.starts_with("AC10")) return refused_file("this is a DWG, not a DXF; save it as DXF to read it");
    return DxfReader(text).read();
}

}  // namespace batten::exchange
