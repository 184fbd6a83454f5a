#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Parabola.hxx>
#include <Interface_Static.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepAP214.hxx>
#include <StepAP214_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_BSplineCurve.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepGeom_GeometricRepresentationItem.hxx>
#include <StepGeom_Parabola.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_Edge.hxx>
#include <StepShape_GeometricSet.hxx>
#include <StepShape_GeometricSetSelect.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <vector>

#include "exchange/occt/drawing.h"
#include "exchange/occt/geom_curves.h"
#include "exchange/occt/imported_edges.h"
#include "exchange/occt/lengths.h"
#include "exchange/refusal.h"

namespace batten::exchange::occt {

namespace {

bool is_step_geometry(const Entity& item) {
    return item->IsKind(STANDARD_TYPE(StepGeom_GeometricRepresentationItem));
}

// The parameters and the points between which a curve is trimmed, as far as the file has them.
struct Trimming {
    std::array<std::optional<double>, 2> parameters{};
    std::array<std::optional<gp_XYZ>, 2> points{};
};

gp_XYZ place_of(const Handle(StepGeom_CartesianPoint) & point) {
    gp_XYZ place(0.0, 0.0, 0.0);
    for (int i = 1; i <= std::min(point->NbCoordinates(), 3); ++i) place.SetCoord(i, point->CoordinatesValue(i));
    return place;
}

Trimming trimming_of(const StepGeom_TrimmedCurve& curve) {
    Trimming trimming;
    const auto take = [&](std::size_t end, const StepGeom_TrimmingSelect& trim) {
        if (trim.CaseMember() > 0) trimming.parameters[end] = trim.ParameterValue();
        if (trim.CaseNumber() > 0) trimming.points[end] = place_of(trim.CartesianPoint());
    };
    for (int i = 1; i <= curve.NbTrim1(); ++i) take(0, curve.Trim1Value(i));
    for (int i = 1; i <= curve.NbTrim2(); ++i) take(1, curve.Trim2Value(i));
    return trimming;
}

// By the standard u is at F (u^2 x + 2u y) from the vertex, for OpenCASCADE at u^2 / 4F x + u y, and so in the files
// that it writes; which of these is meant the points tell, if they are there.
Correction correction_of(const StepGeom_TrimmedCurve& curve, const StepGeom_Parabola& stated,
                         const Geom_Parabola& parabola) {
    const Trimming trimming = trimming_of(curve);
    const bool is_by_parameters =
        trimming.parameters[0] && trimming.parameters[1] && curve.MasterRepresentation() != StepGeom_tpCartesian;
    if (!is_by_parameters || stated.FocalDist() == 0.0) return {};
    const double unit = parabola.Focal() / stated.FocalDist();
    const double sign = curve.SenseAgreement() ? 1.0 : -1.0;
    const auto contradiction = [&](double factor) {
        double largest = 0.0;
        for (std::size_t end = 0; end < 2; ++end)
            if (trimming.points[end])
                largest = std::max(largest, parabola.Value(sign * factor * *trimming.parameters[end])
                                                .Distance(gp_Pnt(unit * *trimming.points[end])));
        return largest;
    };
    const double by_standard = 2.0 * parabola.Focal();
    const bool is_standard = contradiction(by_standard) <= contradiction(1.0);
    return {.parameter_factor = is_standard ? by_standard : 1.0,
            .contradiction = std::min(contradiction(by_standard), contradiction(1.0))};
}

class StepReader : public EntityReader {
  public:
    explicit StepReader(Handle(StepData_StepModel) model) : model_(std::move(model)) {}

    std::string name(const Entity& entity) const override {
        if (!entity->IsKind(STANDARD_TYPE(StepGeom_Curve)) && !entity->IsKind(STANDARD_TYPE(StepShape_Edge))) return {};
        auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
        for (; !item.IsNull(); item = Handle(StepGeom_TrimmedCurve)::DownCast(item)->BasisCurve()) {
            const Handle(TCollection_HAsciiString) name = item->Name();
            if (!name.IsNull() && name->Length() > 0) return name->ToCString();
            if (!item->IsKind(STANDARD_TYPE(StepGeom_TrimmedCurve))) break;
        }
        return {};
    }
    std::string kind(const Entity& /*entity*/) const override { return {}; }
    std::string place(const Entity& entity) const override { return model_->StringLabel(entity)->ToCString(); }
    bool is_curve(const Entity& entity) const override {
        return entity->IsKind(STANDARD_TYPE(StepGeom_Curve)) || entity->IsKind(STANDARD_TYPE(StepShape_Edge));
    }
    bool is_hidden(const Entity& /*entity*/) const override { return false; }
    std::vector<Entity> members(const Entity& /*entity*/) const override { return {}; }
    std::optional<StatedCurve> curve(const Entity& /*entity*/) const override { return std::nullopt; }

    Correction correction(const Entity& entity, const Geom_Curve& geometry) const override {
        const auto trimmed = Handle(StepGeom_TrimmedCurve)::DownCast(entity);
        if (trimmed.IsNull()) return {};
        const auto stated = Handle(StepGeom_Parabola)::DownCast(trimmed->BasisCurve());
        const auto* const parabola = dynamic_cast<const Geom_Parabola*>(&geometry);
        return stated.IsNull() || parabola == nullptr ? Correction{} : correction_of(*trimmed, *stated, *parabola);
    }

  private:
    Handle(StepData_StepModel) model_;
};

// Else OpenCASCADE makes closed curves periodic, which rounds their points, and takes ends that are near for one.
void forget_that_curves_are_closed(const Handle(StepData_StepModel) & model) {
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto spline = Handle(StepGeom_BSplineCurve)::DownCast(model->Value(i)))
            spline->SetClosedCurve(StepData_LFalse);
}

Handle(StepRepr_GlobalUnitAssignedContext) units_of(const Entity& context) {
    using WithTolerance = StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx;
    using Plain = StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext;
    if (const auto units = Handle(WithTolerance)::DownCast(context)) return units->GlobalUnitAssignedContext();
    if (const auto units = Handle(Plain)::DownCast(context)) return units->GlobalUnitAssignedContext();
    return {};
}

// By what OpenCASCADE multiplies lengths, for each context of the file, where they are read in `unit`, in millimeters.
std::vector<double> length_factors(STEPControl_Reader& reader, double unit) {
    reader.SetSystemLengthUnit(unit);
    const Handle(StepData_StepModel) model = reader.StepModel();
    std::vector<double> factors;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const Handle(StepRepr_GlobalUnitAssignedContext) units = units_of(model->Value(i));
        STEPConstruct_UnitContext found;
        if (units.IsNull()) continue;
        found.ComputeFactors(units);
        if (found.LengthDone()) factors.push_back(found.LengthFactor());
    }
    return factors;
}

// The curves of sets of which there is no shape.
std::vector<Entity> lost_curves(const Handle(StepData_StepModel) & model,
                                const Handle(Transfer_TransientProcess) & process) {
    std::vector<Entity> lost;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto set = Handle(StepShape_GeometricSet)::DownCast(model->Value(i));
        for (int k = 1; !set.IsNull() && k <= set->NbElements(); ++k) {
            const Handle(StepGeom_Curve) curve = set->ElementsValue(k).Curve();
            if (!curve.IsNull() && !process->IsBound(curve)) lost.push_back(curve);
        }
    }
    return lost;
}

// The edges of the curves, of which those that OpenCASCADE makes no edge of are removed.
TopoDS_Compound edges_of(std::vector<NamedSpline>& curves) {
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    std::erase_if(curves, [&](const NamedSpline& curve) {
        BRepBuilderAPI_MakeEdge edge(curve.spline);
        if (edge.IsDone()) builder.Add(compound, edge.Edge());
        return !edge.IsDone();
    });
    return compound;
}

// The model has them in the order in which they were given.
void set_names(const Handle(StepData_StepModel) & model, const std::vector<NamedSpline>& curves) {
    std::size_t count = 0;
    for (int i = 1; i <= model->NbEntities() && count < curves.size(); ++i)
        if (const auto item = Handle(StepGeom_TrimmedCurve)::DownCast(model->Value(i)))
            item->SetName(new TCollection_HAsciiString(curves[count++].name.c_str()));
}

}  // namespace

core::FileResult<Imported> read_step(const std::string& text) {
    STEPControl_Reader reader;
    std::istringstream stream(text);
    if (reader.ReadStream("input", stream) != IFSelect_RetDone)
        return refused_file("this is no STEP file that OpenCASCADE can read");
    const std::vector<double> units = length_factors(reader, unit_millimeter);
    const double unit = units.empty() ? unit_millimeter : units.front();
    const std::vector<double> factors = length_factors(reader, unit_to_read_in(unit));
    const Handle(StepData_StepModel) model = reader.StepModel();
    if (auto fault = geometry_fault(model, reader.WS()->ModelCheckList(), is_step_geometry))
        return tl::unexpected(*std::move(fault));
    forget_that_curves_are_closed(model);
    reader.TransferRoots();
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    auto imported = imported_edges(
        {.shape = reader.OneShape(), .process = process, .lost = lost_curves(model, process)}, StepReader(model));
    if (!imported) return imported;
    set_units(*imported, unit);
    if (std::ranges::any_of(factors, [](double factor) { return factor != 1.0; })) add_rounding_of_lengths(*imported);
    tell_faults(*imported, reader.WS()->ModelCheckList());
    return imported;
}

core::FileResult<Exported> write_step(const core::Document& document) {
    std::vector<NamedSpline> curves = geom_curves(document);
    const TopoDS_Compound edges = edges_of(curves);
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", is_in_inches(document) ? "INCH" : "MM");
    Interface_Static::SetIVal("write.step.assembly", 0);
    writer.Transfer(edges, STEPControl_GeometricCurveSet);
    set_names(writer.Model(), curves);
    StepData_StepWriter text(writer.Model());
    text.FloatWriter().SetFormat(all_digits);
    text.SendModel(StepAP214::Protocol());
    std::ostringstream stream;
    text.Print(stream);
    return Exported{stream.str()};
}

}  // namespace batten::exchange::occt
