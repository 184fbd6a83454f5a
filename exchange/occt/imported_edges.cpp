#include "exchange/occt/imported_edges.h"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Interface_Check.hxx>
#include <NCollection_DataMap.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TransferBRep.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/ascii.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/curve/knot_analysis.h"
#include "core/refine/clamping.h"
#include "core/refine/periodic.h"
#include "core/refine/split.h"
#include "exchange/collector.h"
#include "exchange/refusal.h"

namespace batten::exchange::occt {

namespace {

// Parts of the size of a curve, or of its domain.
constexpr double flatness = 1e-9;
constexpr double same_parameter = 1e-12;
constexpr double closing_tolerance = 1e-12;

enum class LeftOut { none, in_another_plane, of_another_kind, unbounded, not_computable };

struct FlatCurve {
    std::optional<core::Curve> curve{};
    double error = 0.0;
    double height = 0.0;
    LeftOut why = LeftOut::none;
};

core::CurveDefinition definition_of(const Geom_BSplineCurve& spline) {
    core::CurveDefinition definition{.degree = spline.Degree(), .tears = core::Tears::allow};
    for (int k = 1; k <= spline.NbKnots(); ++k)
        definition.knots.insert(definition.knots.end(), static_cast<std::size_t>(spline.Multiplicity(k)),
                                spline.Knot(k));
    for (int i = 1; i <= spline.NbPoles(); ++i) {
        const gp_Pnt pole = spline.Pole(i);
        definition.points.emplace_back(pole.X(), pole.Y());
        if (spline.IsRational()) definition.weights.push_back(spline.Weight(i));
    }
    return definition;
}

// Where the poles are above the plane, and how far from one height.
bool set_height(const Geom_BSplineCurve& spline, FlatCurve& result) {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    double size = 0.0;
    for (int i = 1; i <= spline.NbPoles(); ++i) {
        lower = std::min(lower, spline.Pole(i).Z());
        upper = std::max(upper, spline.Pole(i).Z());
        size = std::max(size, spline.Pole(i).Distance(spline.Pole(1)));
    }
    result.height = lower + 0.5 * (upper - lower);
    result.error = upper - lower;
    return upper - lower <= flatness * size;
}

// The part that an edge has of its curve.
std::optional<core::Curve> part_between(const core::Curve& curve, double first, double last) {
    const core::Interval domain = curve.domain();
    const double small = same_parameter * std::max(domain.upper - domain.lower, std::abs(domain.upper));
    if (std::abs(first - domain.lower) <= small && std::abs(last - domain.upper) <= small) return curve;
    const auto part = core::sub_curve(curve, std::max(first, domain.lower), std::min(last, domain.upper));
    return part ? std::optional(*part) : std::nullopt;
}

core::Result<core::Curve> of_its_kind(core::CurveDefinition definition) {
    core::Result<core::Curve> curve = core::Curve::make(definition);
    if (!curve) return curve;
    definition.kind = core::kind_by_values(curve->knots());
    return core::Curve::make(std::move(definition));
}

core::Result<core::Curve> opened(const Geom_BSplineCurve& spline) {
    const auto copy = Handle(Geom_BSplineCurve)::DownCast(spline.Copy());
    copy->SetNotPeriodic();
    return of_its_kind(definition_of(*copy)).and_then(core::clamp_ends).and_then([](const core::Curve& curve) {
        return of_its_kind(curve.definition());
    });
}

// A periodic curve with a seam at which only its ends meet is better known as clamped, as files have it.
std::optional<core::Approximation> closed_smoothly(const core::Curve& curve) {
    const core::Box box = core::control_box(curve);
    const double size = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
    const auto closed = core::to_periodic(curve, closing_tolerance * size);
    return closed ? std::optional(*closed) : std::nullopt;
}

FlatCurve flat_spline(const Handle(Geom_BSplineCurve) & spline, double first, double last) {
    FlatCurve result;
    if (!set_height(*spline, result)) return {.why = LeftOut::in_another_plane};
    const bool is_smooth_at_seam = spline->IsPeriodic() && spline->Multiplicity(1) < spline->Degree();
    const auto curve = spline->IsPeriodic() ? opened(*spline) : of_its_kind(definition_of(*spline));
    if (curve) result.curve = part_between(*curve, first, last);
    if (!result.curve) return {.why = LeftOut::not_computable};
    if (!is_smooth_at_seam || result.curve != *curve) return result;
    if (const auto closed = closed_smoothly(*curve)) {
        result.curve = closed->curve;
        result.error += closed->error;
    }
    return result;
}

// What OpenCASCADE computes from lengths and angles.
double rounding_at(const gp_Pnt& point) {
    return 4.0 * std::numeric_limits<double>::epsilon() * point.XYZ().Modulus();
}

FlatCurve flat_line(const Geom_Line& line, double first, double last) {
    const gp_Pnt a = line.Value(first);
    const gp_Pnt b = line.Value(last);
    if (std::abs(a.Z() - b.Z()) > flatness * a.Distance(b)) return {.why = LeftOut::in_another_plane};
    FlatCurve result{.error = std::abs(a.Z() - b.Z()) + rounding_at(a) + rounding_at(b), .height = a.Z()};
    const auto curve = of_its_kind({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{a.X(), a.Y()}, {b.X(), b.Y()}}});
    if (!curve) return {.why = LeftOut::not_computable};
    result.curve = *curve;
    return result;
}

FlatCurve flat_curve(Handle(Geom_Curve) curve, double first, double last) {
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
    if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return {.why = LeftOut::unbounded};
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve)) return flat_spline(spline, first, last);
    if (const auto line = Handle(Geom_Line)::DownCast(curve)) return flat_line(*line, first, last);
    if (!curve->IsKind(STANDARD_TYPE(Geom_Conic)) && !curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)))
        return {.why = LeftOut::of_another_kind};
    const Handle(Geom_Curve) part = new Geom_TrimmedCurve(curve, first, last);
    const Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(part);
    FlatCurve result = flat_spline(spline, spline->FirstParameter(), spline->LastParameter());
    for (int i = 1; i <= spline->NbPoles(); ++i) result.error = std::max(result.error, rounding_at(spline->Pole(i)));
    return result;
}

FlatCurve flat_edge(const TopoDS_Edge& edge) {
    try {
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        return curve.IsNull() ? FlatCurve{.why = LeftOut::of_another_kind} : flat_curve(curve, first, last);
    } catch (const Standard_Failure&) {
        return {.why = LeftOut::not_computable};
    }
}

constexpr core::PluralPattern in_other_planes{"one curve is left out: it does not lie in a plane with one z",
                                              "{count} curves are left out: they do not lie in planes with one z each"};
constexpr core::PluralPattern of_other_kinds{
    "one curve is left out: it is neither a line nor a conic nor a spline",
    "{count} curves are left out: they are neither lines nor conics nor splines"};
constexpr core::PluralPattern without_ends{"one curve is left out: it has no ends",
                                           "{count} curves are left out: they have no ends"};
constexpr core::PluralPattern beyond_doubles{"one curve is left out: its numbers make no curve",
                                             "{count} curves are left out: their numbers make no curves"};
constexpr core::PluralPattern raised_edges{"one curve has a z that is not 0, which is left out",
                                           "{count} curves have a z that is not 0, which is left out"};

const core::PluralPattern& pattern_of(LeftOut why) {
    switch (why) {
        case LeftOut::in_another_plane:
            return in_other_planes;
        case LeftOut::of_another_kind:
            return of_other_kinds;
        case LeftOut::unbounded:
            return without_ends;
        case LeftOut::none:
        case LeftOut::not_computable:
            break;
    }
    return beyond_doubles;
}

void collect(Collector& collector, FlatCurve curve, const std::string& name) {
    const auto place = [&] { return name; };
    if (!curve.curve) return collector.notes().add(pattern_of(curve.why), place);
    const std::size_t number = collector.document().curves.size() + 1;
    std::string wish(core::trimmed(name));
    if (wish.empty()) wish = core::sentence("curve {number}", {{"number", number}});
    if (collector.add(*std::move(curve.curve), wish, "curve", place) == nullptr) return;
    collector.note_error(curve.error);
    if (curve.height != 0.0) collector.notes().add(raised_edges, place);
}

// Wherever the shapes are in their assemblies.
using ShapeNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

ShapeNames names_of_shapes(const Handle(Transfer_TransientProcess) & process, NameOf name_of) {
    ShapeNames names;
    for (int i = 1; i <= process->NbMapped(); ++i) {
        const Handle(Standard_Transient) entity = process->Mapped(i);
        const std::string name = name_of(entity);
        if (name.empty()) continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        if (!shape.IsNull()) names.Bind(shape.Located(TopLoc_Location()), name);
    }
    return names;
}

constexpr core::PluralPattern faults_found{
    "OpenCASCADE found a fault in the file; curves may be missing or other than they were",
    "OpenCASCADE found {count} faults in the file; curves may be missing or other than they were"};

constexpr double millimeter = 1.0;
constexpr double inch = 25.4;

bool is_about(double unit, double other) {
    return std::abs(unit - other) <= 1e-9 * other;
}

}  // namespace

core::FileResult<Imported> imported_edges(const TopoDS_Shape& shape, const Handle(Transfer_TransientProcess) & process,
                                          NameOf name_of, std::size_t lost) {
    Collector collector;
    const ShapeNames names = names_of_shapes(process, name_of);
    TopTools_IndexedMapOfShape edges;
    if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (BRep_Tool::Degenerated(edge)) continue;
        const std::string* name = names.Seek(edge.Located(TopLoc_Location()));
        collect(collector, flat_edge(edge), name != nullptr ? *name : std::string());
    }
    for (std::size_t i = 0; i < lost; ++i) collect(collector, {.why = LeftOut::not_computable}, {});
    return std::move(collector).finish("the file has no curves that can be read");
}

core::FileResult<Imported> with_faults_told(Imported imported, const Handle(Interface_InterfaceModel) & model,
                                            Interface_CheckIterator checks, IsGeometry is_geometry) {
    std::size_t faults = 0;
    for (checks.Start(); checks.More(); checks.Next()) {
        const Handle(Interface_Check) check = checks.Value();
        if (!check->HasFailed()) continue;
        faults += static_cast<std::size_t>(check->NbFails());
        const Handle(Standard_Transient) entity =
            check->HasEntity() ? check->Entity() : model->Value(std::max(checks.Number(), 1));
        if (!is_geometry(entity)) continue;
        const Handle(TCollection_HAsciiString) label = model->StringLabel(entity);
        return refused_file(
            core::sentence("OpenCASCADE finds a fault in the geometry, in '{entity}'; the file is damaged",
                           {{"entity", label->ToCString()}}));
    }
    if (faults == 0) return imported;
    imported.report.largest_error = std::numeric_limits<double>::infinity();
    imported.report.left_out.push_back(core::sentence(faults_found, faults));
    return imported;
}

double unit_to_read_in(double unit) {
    return is_about(unit, inch) ? inch : millimeter;
}

void set_units(Imported& imported, double unit) {
    const bool has_inches = is_about(unit, inch);
    imported.document.units = core::DocumentUnits{.unit = has_inches ? core::LengthUnit::inch : core::LengthUnit::mm};
    if (has_inches || is_about(unit, millimeter)) return;
    double size = 0.0;
    for (const core::DocumentCurve& entry : imported.document.curves)
        for (const core::Point& point : entry.curve->control_points())
            size = std::max({size, std::abs(point.x), std::abs(point.y)});
    imported.report.largest_error += std::numeric_limits<double>::epsilon() * size;
    imported.report.left_out.emplace_back(
        "The unit of the file is neither a millimeter nor an inch; its lengths are "
        "converted to millimeters");
}

}  // namespace batten::exchange::occt
