#include "core/document/detail/native_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/document/detail/fit_member.h"
#include "core/document/detail/joint_member.h"
#include "core/document/detail/json_text.h"
#include "core/document/detail/native_format.h"
#include "core/document/detail/object_reader.h"
#include "core/document/unit_scale.h"

namespace batten::core {

namespace {

constexpr double half_turn = 180.0;

std::optional<FileError> take(const Json& value, const std::string& pointer, DocumentColor& target) {
    const auto color = value.is_string() ? color_of_text(value.get<std::string>()) : std::nullopt;
    if (!color) return wrong_value(pointer, value, "a color of the form \"#4c7fe0\"");
    target = *color;
    return std::nullopt;
}

// Where in the object of a curve, which stands at `pointer`, the error sits.
std::string place_of(const std::string& pointer, const CurveError& error) {
    switch (error.code) {
        case CurveErrorCode::degree_out_of_range:
            return place_in(pointer, "degree");
        case CurveErrorCode::too_few_points:
            return place_in(pointer, "points");
        case CurveErrorCode::point_not_finite:
            return place_in(place_in(pointer, "points"), error.index);
        case CurveErrorCode::weight_count_mismatch:
            return place_in(pointer, "weights");
        case CurveErrorCode::weight_not_finite:
        case CurveErrorCode::weight_not_positive:
            return place_in(place_in(pointer, "weights"), error.index);
        case CurveErrorCode::knot_count_mismatch:
        case CurveErrorCode::knots_too_far_apart:
        case CurveErrorCode::domain_empty:
            return place_in(pointer, "knots");
        case CurveErrorCode::knot_not_finite:
        case CurveErrorCode::knot_decreasing:
        case CurveErrorCode::multiplicity_too_high:
            return place_in(place_in(pointer, "knots"), error.index);
        default:
            return pointer;
    }
}

void read_degree(ObjectReader& reader, int& degree) {
    double value = degree;
    reader.required("degree", value);
    if (reader.error()) return;
    if (std::trunc(value) != value || value < min_degree || value > max_degree)
        reader.note(FileError{reader.place("degree"),
                              std::trunc(value) == value
                                  ? describe({.code = CurveErrorCode::degree_out_of_range, .value = value})
                                  : "the degree is not a whole number"});
    else
        degree = static_cast<int>(value);
}

// A full vector draws an open curve, whatever "periodic" says: the data count, not the flag.
void trust_data_over_flag(CurveDefinition& definition) {
    if (definition.knots.size() == definition.points.size() + static_cast<std::size_t>(definition.degree) + 1)
        definition.periodic = false;
}

void read_definition(ObjectReader& reader, CurveDefinition& definition, std::optional<KnotKind>& kind) {
    bool may_tear = false;
    read_degree(reader, definition.degree);
    reader.required("knots", definition.knots);
    reader.required("points", definition.points);
    reader.optional("weights", definition.weights);
    reader.optional("periodic", definition.periodic);
    if (const Json* value = reader.find("kind")) reader.note(take(*value, reader.place("kind"), kind.emplace()));
    reader.optional("tears", may_tear);
    definition.tears = may_tear ? Tears::allow : Tears::refuse;
    trust_data_over_flag(definition);
}

// Without a stored kind it is what the values say, which needs the vector first.
Result<Curve> make_curve(CurveDefinition definition, std::optional<KnotKind> kind) {
    definition.kind = kind.value_or(KnotKind::custom);
    auto curve = Curve::make(std::move(definition));
    if (kind || !curve) return curve;
    const KnotKind found = classify(curve->knots());
    if (found == KnotKind::custom) return curve;
    definition = curve->definition();
    definition.kind = found;
    curve = refuse({});  // a large one is not held twice
    return Curve::make(std::move(definition));
}

// Needs the curve, of whose control points they are indices.
void read_pinned(ObjectReader& reader, DocumentCurve& entry) {
    std::vector<double> indices;
    reader.optional("pinned", indices);
    if (reader.error()) return;
    const std::size_t last = entry.curve->control_points().size() - 1;
    for (std::size_t k = 0; k < indices.size(); ++k)
        if (!(indices[k] >= 0.0 && indices[k] <= static_cast<double>(last) && std::trunc(indices[k]) == indices[k]))
            return reader.note(
                FileError{place_in(reader.place("pinned"), k),
                          sentence("found {found}, but it must be the index of a control point, 0 to {last}",
                                   {{"found", shortest_text(indices[k])}, {"last", last}})});
    for (const double index : indices) entry.pinned.push_back(static_cast<std::size_t>(index));
    std::ranges::sort(entry.pinned);
    entry.pinned.erase(std::unique(entry.pinned.begin(), entry.pinned.end()), entry.pinned.end());
}

// Stores a whole number from `least` to `most`.
void read_count(ObjectReader& reader, const char* name, std::size_t least, std::size_t most, std::size_t& target) {
    auto value = static_cast<double>(least);
    reader.required(name, value);
    if (reader.error()) return;
    if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most) && std::trunc(value) == value))
        return reader.note(FileError{reader.place(name),
                                     sentence("found {found}, but it must be a whole number from {least} to {most}",
                                              {{"found", shortest_text(value)}, {"least", least}, {"most", most}})});
    target = static_cast<std::size_t>(value);
}

void read_symmetry(ObjectReader& curve_reader, DocumentCurve& entry) {
    Json* object = curve_reader.find("symmetry");
    if (!object) return;
    ObjectReader reader(*object, curve_reader.place("symmetry"));
    Symmetry symmetry;
    constexpr std::size_t most_groups = 1'000'000'000;
    read_count(reader, "group", 0, most_groups, symmetry.group);
    if (reader.find("turns") != nullptr)
        read_count(reader, "turns", 2, Symmetry::most_turns, symmetry.turns.emplace());
    else
        reader.required("mirror", symmetry.angle);
    read_count(reader, "place", 0, symmetry.turns.value_or(2) - 1, symmetry.place);
    reader.required("center", symmetry.center);
    symmetry.unknown_members = reader.unknown_members();
    entry.symmetry = std::move(symmetry);
    curve_reader.note(reader.error());
}

// Needs the curve, which is what counts: where it was changed without its points, it is made of them no more.
void read_curve_fit(ObjectReader& reader, DocumentCurve& entry, std::size_t& lost_fits) {
    Json* value = reader.find("fit");
    if (value == nullptr) return;
    auto member = read_fit(*value, reader.place("fit"));
    if (!member) return reader.note(member.error());
    if (!is_curve_of(member->fit, *entry.curve)) {
        ++lost_fits;
        return;
    }
    entry.fit = std::make_shared<const FitPoints>(std::move(member->fit));
    entry.unknown_fit_members = std::move(member->unknown_members);
}

FileResult<DocumentCurve> read_curve(Json& object, const std::string& pointer, std::size_t& lost_fits) {
    ObjectReader reader(object, pointer);
    DocumentCurve entry;
    CurveDefinition definition;
    std::optional<KnotKind> kind;
    reader.optional("name", entry.name);
    read_definition(reader, definition, kind);
    if (const Json* value = reader.find("color"))
        reader.note(take(*value, reader.place("color"), entry.color.emplace()));
    reader.optional("visible", entry.visible);
    reader.optional("locked", entry.locked);
    reader.optional("group", entry.group);
    entry.tears = definition.tears;
    if (reader.error()) return tl::unexpected(*reader.error());
    auto curve = make_curve(std::move(definition), kind);
    if (!curve) return tl::unexpected(FileError{place_of(pointer, curve.error()), describe(curve.error())});
    entry.curve = std::make_shared<const Curve>(std::move(*curve));
    read_curve_fit(reader, entry, lost_fits);
    read_pinned(reader, entry);
    read_symmetry(reader, entry);
    if (Json* value = reader.find("joints")) {
        auto joints = read_joints(*value, reader.place("joints"), *entry.curve);
        if (!joints) return tl::unexpected(joints.error());
        entry.joints = *std::move(joints);
    }
    if (reader.error()) return tl::unexpected(*reader.error());
    entry.unknown_members = reader.unknown_members();
    return entry;
}

void read_format(ObjectReader& reader) {
    std::string format;
    double version = 0.0;
    reader.required("format", format);
    if (!reader.error() && format != format_name)
        reader.note(wrong_value(reader.place("format"), format, fmt::format("\"{}\"", format_name)));
    reader.required("version", version);
    if (!reader.error() && version != format_version)
        reader.note(FileError{reader.place("version"),
                              sentence("version {found} of the format is not known; this program reads version {known}",
                                       {{"found", reader.find("version")->dump()}, {"known", format_version}})});
}

void read_curves(ObjectReader& reader, Document& document) {
    Json* list = reader.find("curves");
    if (!list) return;
    if (!list->is_array()) return reader.note(wrong_value(reader.place("curves"), *list, "a list of curves"));
    for (std::size_t i = 0; i < list->size(); ++i) {
        auto curve = read_curve((*list)[i], place_in(reader.place("curves"), i), document.lost_fits);
        if (!curve) return reader.note(curve.error());
        document.curves.push_back(std::move(*curve));
    }
    reader.note(check_marked_ends(document.curves, *list, reader.place("curves")));
}

// A number of a picture that must be above 0, or lie from 0 to 1.
void check_number(ObjectReader& reader, const char* name, double value, bool is_good, const char* allowed) {
    if (!reader.error() && !is_good) reader.note(wrong_value(reader.place(name), value, allowed));
}

void read_pixels(ObjectReader& reader, const char* name, int& target) {
    constexpr int most = 1'000'000;
    double value = 0.0;
    reader.required(name, value);
    const bool is_good = value >= 1.0 && value <= most && std::trunc(value) == value;
    check_number(reader, name, value, is_good, "a whole number from 1 to 1000000");
    if (is_good) target = static_cast<int>(value);
}

FileResult<Picture> read_picture(Json& object, const std::string& pointer) {
    ObjectReader reader(object, pointer);
    Picture picture;
    std::string path;
    reader.required("path", path);
    picture.path = path;
    read_pixels(reader, "width", picture.width);
    read_pixels(reader, "height", picture.height);
    reader.optional("position", picture.position);
    reader.optional("scale", picture.scale);
    check_number(reader, "scale", picture.scale, picture.scale > 0.0, "a number above 0");
    reader.optional("rotation", picture.rotation);
    reader.optional("opacity", picture.opacity);
    check_number(reader, "opacity", picture.opacity, Interval{0.0, 1.0}.contains(picture.opacity),
                 "a number from 0 to 1");
    reader.optional("visible", picture.visible);
    reader.optional("locked", picture.locked);
    picture.unknown_members = reader.unknown_members();
    if (reader.error()) return tl::unexpected(*reader.error());
    return picture;
}

void read_pictures(ObjectReader& reader, std::vector<Picture>& pictures) {
    Json* list = reader.find("pictures");
    if (!list) return;
    if (!list->is_array()) return reader.note(wrong_value(reader.place("pictures"), *list, "a list of pictures"));
    for (std::size_t i = 0; i < list->size(); ++i) {
        auto picture = read_picture((*list)[i], place_in(reader.place("pictures"), i));
        if (!picture) return reader.note(picture.error());
        pictures.push_back(std::move(*picture));
    }
}

Guide read_guide(ObjectReader& reader) {
    Guide guide;
    reader.required("point", guide.point);
    reader.required("angle", guide.angle);
    guide.unknown_members = reader.unknown_members();
    if (reader.error()) return guide;
    if (!(guide.angle >= 0.0 && guide.angle < half_turn))
        reader.note(wrong_value(reader.place("angle"), *reader.find("angle"), "from 0 up to but not 180"));
    return guide;
}

void read_guides(ObjectReader& document_reader, std::vector<Guide>& guides) {
    Json* list = document_reader.find("guides");
    if (!list) return;
    const std::string place = document_reader.place("guides");
    if (!list->is_array()) return document_reader.note(wrong_value(place, *list, "a list of guides"));
    for (std::size_t i = 0; i < list->size(); ++i) {
        ObjectReader reader((*list)[i], place_in(place, i));
        guides.push_back(read_guide(reader));
        if (reader.error()) return document_reader.note(reader.error());
    }
}

void read_units(ObjectReader& document_reader, std::optional<DocumentUnits>& units) {
    Json* object = document_reader.find("units");
    if (!object) return;
    ObjectReader reader(*object, document_reader.place("units"));
    DocumentUnits found;
    reader.required("unit", found.unit);
    reader.optional("scale", found.scale);
    check_number(reader, "scale", found.scale, allowed_unit_scales.contains(found.scale), "a number from 1e-9 to 1e9");
    found.unknown_members = reader.unknown_members();
    if (reader.error()) return document_reader.note(reader.error());
    units = std::move(found);
}

// A name, or a place where names are not distinct. The view is a mere convenience, so one that names no curve is not an
// error.
std::size_t find_active(const Json& active, const std::vector<DocumentCurve>& curves) {
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (active == curves[i].name || active == i) return i;
    return 0;
}

void read_view(ObjectReader& document_reader, Document& document) {
    Json* object = document_reader.find("view");
    if (!object) return;
    ObjectReader reader(*object, document_reader.place("view"));
    reader.optional("parameter", document.view.parameter);
    reader.optional("overlays", document.view.overlays);
    reader.optional("notation", document.view.notation);
    if (const Json* active = reader.find("active")) document.active = find_active(*active, document.curves);
    document.view.unknown_members = reader.unknown_members();
    document_reader.note(reader.error());
}

}  // namespace

FileResult<Document> read_document(TextStream& text, const PointsRead& points_read) {
    auto tree = parse_json(text, points_read);
    if (!tree) return tl::unexpected(tree.error());
    ObjectReader reader(*tree, "");
    Document document;
    read_format(reader);
    reader.optional("title", document.title);
    reader.optional("description", document.description);
    read_curves(reader, document);
    read_pictures(reader, document.pictures);
    read_guides(reader, document.guides);
    read_units(reader, document.units);
    read_view(reader, document);
    document.unknown_members = reader.unknown_members();
    if (reader.error()) return tl::unexpected(*reader.error());
    return document;
}

}  // namespace batten::core
