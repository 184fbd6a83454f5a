#include "exchange/occt/imported_edges.h"

#include <BRep_Tool.hxx>
#include <Interface_Check.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/base/ascii.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "exchange/collector.h"
#include "exchange/refusal.h"

namespace batten::exchange::occt {

namespace {

constexpr core::PluralPattern in_other_planes{"one curve is left out: it does not lie in a plane with one z",
                                              "{count} curves are left out: they do not lie in planes with one z each"};
constexpr core::PluralPattern of_other_kinds{
    "one curve is left out: it is neither a line nor a conic nor a spline",
    "{count} curves are left out: they are neither lines nor conics nor splines"};
constexpr core::PluralPattern without_ends{"one curve is left out: it has no ends",
                                           "{count} curves are left out: they have no ends"};
constexpr core::PluralPattern not_computable{"one curve is left out: {reason}",
                                             "{count} curves are left out: {reason}"};
constexpr core::PluralPattern not_whole{
    "parts of the curve at {place} were left out, since OpenCASCADE makes no curves of them",
    "parts of {count} curves were left out, the first at {place}, since OpenCASCADE makes no curves of them"};
constexpr core::PluralPattern raised_edges{"one curve has a z that is not 0, which is left out",
                                           "{count} curves have a z that is not 0, which is left out"};
constexpr core::PluralPattern of_two_meanings{
    "the numbers of the curve at {place} contradict one another; by how much is in the error",
    "the numbers of {count} curves contradict one another, the first at {place}; by how much is in the error"};
constexpr core::PluralPattern beyond_knots{
    "the curve at {place} was to begin or end beyond its knots; the part within them was read",
    "{count} curves were to begin or end beyond their knots, the first at {place}; the parts within them were read"};
constexpr core::PluralPattern not_in_knots{
    "the curve at {place} was read whole, since the part that was meant is beyond its knots or does not end after its "
    "beginning",
    "{count} curves were read whole, the first at {place}, since the parts that were meant are beyond their knots or "
    "do "
    "not end after their beginnings"};
constexpr core::PluralPattern faults_found{
    "OpenCASCADE found a fault in the file; curves may be missing or other than they were",
    "OpenCASCADE found {count} faults in the file; curves may be missing or other than they were"};

// Of the size of a curve; what is less may be rounded in the file.
constexpr double contradicting = 1e-6;

// Of an edge, or of the entity from which one should have come.
struct Origin {
    Entity entity{};  // null: not known
    std::string name{};
    std::size_t edges_of_named = 0;  // of the part of the file that has the name
    bool is_hidden = false;
};

// By the curves of the edges, which stay when edges are copied into wires.
using Origins = std::unordered_map<const Geom_Curve*, Origin>;

const Geom_Curve* curve_of(const TopoDS_Shape& edge) {
    TopLoc_Location location;
    double first = 0.0;
    double last = 0.0;
    return BRep_Tool::Curve(TopoDS::Edge(edge), location, first, last).get();
}

void add_origin(Origins& origins, const Entity& entity, const TopoDS_Shape& shape, const EntityReader& reader) {
    const std::string name(core::trimmed(reader.name(entity)));
    const bool is_hidden = reader.is_hidden(entity);
    const std::vector<Entity> curves = reader.is_curve(entity) ? std::vector{entity} : reader.members(entity);
    if (shape.IsNull() || (name.empty() && !is_hidden && curves.empty())) return;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    const auto count = static_cast<std::size_t>(edges.Extent());
    for (int i = 1; i <= edges.Extent(); ++i) {
        Origin& origin = origins[curve_of(edges(i))];
        if (count == curves.size()) origin.entity = curves[static_cast<std::size_t>(i) - 1];
        origin.is_hidden = origin.is_hidden || is_hidden;
        if (name.empty() || (!origin.name.empty() && origin.edges_of_named <= count)) continue;
        origin.name = name;
        origin.edges_of_named = count;
    }
}

Origins origins_of(const Handle(Transfer_TransientProcess) & process, const EntityReader& reader) {
    Origins origins;
    for (int i = 1; i <= process->NbMapped(); ++i) {
        const Entity entity = process->Mapped(i);
        add_origin(origins, entity, TransferBRep::ShapeResult(process, entity), reader);
    }
    origins.erase(nullptr);
    return origins;
}

class Edges {
  public:
    explicit Edges(const EntityReader& reader) : reader_(reader) {}

    void add(const TopoDS_Edge& edge, const Origin& origin) {
        TopLoc_Location location;
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom_Curve) geometry = BRep_Tool::Curve(edge, location, first, last);
        if (geometry.IsNull() || origin.entity.IsNull()) return add(flat_curve(edge), origin);
        const Correction correction = reader_.correction(origin.entity, *geometry);
        const auto stated = reader_.curve(origin.entity);
        FlatCurve curve = stated ? flat_curve(*stated, gp_GTrsf(location.Transformation()))
                                 : flat_curve(edge, correction.parameter_factor);
        curve.error += correction.contradiction;
        curve.contradiction += correction.contradiction;
        add(std::move(curve), origin);
    }

    void add_lost(const Entity& entity) {
        const auto stated = reader_.curve(entity);
        add(stated ? flat_curve(*stated, {}) : FlatCurve{.why = LeftOut::not_computable},
            {.entity = entity, .name = reader_.name(entity), .is_hidden = reader_.is_hidden(entity)});
    }

    void note_incomplete(const Entity& entity) {
        collector_.notes().add(not_whole, [&] { return reader_.place(entity); });
    }

    core::FileResult<Imported> take() {
        return std::move(collector_).finish("the file has no curves that can be read");
    }

  private:
    void add(FlatCurve curve, const Origin& origin);
    void tell_contradictions(const FlatCurve& curve, const core::Curve& added, const PlaceText& place);

    const EntityReader& reader_;
    Collector collector_;
};

// Why a curve is left out, where the place says no more.
const core::PluralPattern* pattern_of(LeftOut why) {
    switch (why) {
        case LeftOut::in_another_plane:
            return &in_other_planes;
        case LeftOut::of_another_kind:
            return &of_other_kinds;
        case LeftOut::unbounded:
            return &without_ends;
        case LeftOut::none:
        case LeftOut::not_computable:
            break;
    }
    return nullptr;
}

void Edges::add(FlatCurve curve, const Origin& origin) {
    const bool is_known = !origin.entity.IsNull();
    const auto place = [&] { return is_known ? reader_.place(origin.entity) : origin.name; };
    if (const core::PluralPattern* pattern = pattern_of(curve.why)) return collector_.notes().add(*pattern, place);
    if (curve.reason.empty()) curve.reason = "OpenCASCADE makes no curve of it";
    if (!curve.curve && !is_known) return collector_.notes().add(not_computable, place, {}, curve.reason);
    const std::size_t number = collector_.document().curves.size() + 1;
    std::string wish(core::trimmed(origin.name));
    if (wish.empty()) wish = core::sentence("curve {number}", {{"number", number}});
    const std::string kind = is_known ? reader_.kind(origin.entity) : std::string();
    MadeCurve made = curve.curve ? MadeCurve(*std::move(curve.curve)) : tl::unexpected(curve.reason);
    core::DocumentCurve* const entry = collector_.add(std::move(made), wish, kind, place);
    if (entry == nullptr) return;
    entry->visible = !origin.is_hidden;
    collector_.note_error(curve.error);
    tell_contradictions(curve, *entry->curve, place);
    if (curve.height != 0.0) collector_.notes().add(raised_edges, place);
}

void Edges::tell_contradictions(const FlatCurve& curve, const core::Curve& added, const PlaceText& place) {
    const core::Box box = core::control_box(added);
    if (curve.contradiction > contradicting * core::distance(box.lower, box.upper))
        collector_.notes().add(of_two_meanings, place);
    if (curve.part == PartInDomain::some) collector_.notes().add(beyond_knots, place);
    if (curve.part == PartInDomain::none) collector_.notes().add(not_in_knots, place);
}

constexpr double millimeter = 1.0;
constexpr double inch = 25.4;

bool is_about(double unit, double other) {
    return std::abs(unit - other) <= 1e-9 * other;
}

}  // namespace

core::FileResult<Imported> imported_edges(const ReadShapes& shapes, const EntityReader& reader) {
    Edges found(reader);
    const Origins origins = origins_of(shapes.process, reader);
    TopTools_IndexedMapOfShape edges;
    if (!shapes.shape.IsNull()) TopExp::MapShapes(shapes.shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (BRep_Tool::Degenerated(edge)) continue;
        const auto origin = origins.find(curve_of(edge));
        found.add(edge, origin == origins.end() ? Origin{} : origin->second);
    }
    for (const Entity& entity : shapes.lost) found.add_lost(entity);
    for (const Entity& entity : shapes.incomplete) found.note_incomplete(entity);
    return found.take();
}

std::optional<core::FileError> geometry_fault(const Handle(Interface_InterfaceModel) & model,
                                              const Interface_CheckIterator& checks, IsGeometry is_geometry) {
    for (checks.Start(); checks.More(); checks.Next()) {
        const Handle(Interface_Check)& check = checks.Value();
        const bool is_of_entity = check->HasEntity() || checks.Number() > 0;
        if (!check->HasFailed() || !is_of_entity) continue;
        const Entity entity = check->HasEntity() ? check->Entity() : model->Value(checks.Number());
        if (!is_geometry(entity)) continue;
        return core::FileError{
            {},
            core::sentence("OpenCASCADE finds a fault in the geometry, in '{entity}'; the file is damaged",
                           {{"entity", model->StringLabel(entity)->ToCString()}})};
    }
    return std::nullopt;
}

void tell_faults(Imported& imported, const Interface_CheckIterator& checks) {
    std::size_t faults = 0;
    for (checks.Start(); checks.More(); checks.Next()) faults += static_cast<std::size_t>(checks.Value()->NbFails());
    if (faults == 0) return;
    imported.report.largest_error = std::numeric_limits<double>::infinity();
    imported.report.left_out.push_back(core::sentence(faults_found, faults));
}

double unit_to_read_in(double unit) {
    return is_about(unit, inch) ? inch : millimeter;
}

void add_rounding_of_lengths(Imported& imported) {
    constexpr double operations = 4.0;
    double size = 0.0;
    for (const core::DocumentCurve& entry : imported.document.curves)
        for (const core::Point& point : entry.curve->control_points())
            size = std::max({size, std::abs(point.x), std::abs(point.y)});
    imported.report.largest_error += operations * std::numeric_limits<double>::epsilon() * size;
}

void set_units(Imported& imported, double unit) {
    const bool has_inches = is_about(unit, inch);
    imported.document.units = core::DocumentUnits{.unit = has_inches ? core::LengthUnit::inch : core::LengthUnit::mm};
    if (has_inches || is_about(unit, millimeter)) return;
    add_rounding_of_lengths(imported);
    imported.report.left_out.emplace_back(
        "the unit of the file is neither a millimeter nor an inch; its lengths were converted to millimeters");
}

}  // namespace batten::exchange::occt
