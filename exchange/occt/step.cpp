#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Precision.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepAP214.hxx>
#include <StepAP214_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_BSplineCurve.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_GeometricRepresentationItem.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_GeometricSet.hxx>
#include <StepShape_GeometricSetSelect.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/sentence.h"
#include "exchange/occt/drawing.h"
#include "exchange/occt/geom_curves.h"
#include "exchange/occt/imported_edges.h"
#include "exchange/occt/lengths.h"
#include "exchange/refusal.h"

namespace batten::exchange::occt {

namespace {

std::string step_name(const Handle(Standard_Transient) & entity) {
    auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
    for (; !item.IsNull(); item = Handle(StepGeom_TrimmedCurve)::DownCast(item)->BasisCurve()) {
        const Handle(TCollection_HAsciiString) name = item->Name();
        if (!name.IsNull() && name->Length() > 0) return name->ToCString();
        if (!item->IsKind(STANDARD_TYPE(StepGeom_TrimmedCurve))) break;
    }
    return {};
}

bool is_step_geometry(const Handle(Standard_Transient) & item) {
    return item->IsKind(STANDARD_TYPE(StepGeom_GeometricRepresentationItem));
}

// In millimeters, as the file calls it; what is unknown is converted.
double length_of(const TColStd_SequenceOfAsciiString& names) {
    if (names.IsEmpty()) return unit_millimeter;
    TCollection_AsciiString name = names.First();
    name.LowerCase();
    if (name.Search("inch") > 0) return unit_inch;
    return name.Search("milli") > 0 ? unit_millimeter : 0.0;
}

// The curves of sets of which there is no shape.
std::size_t lost_curves(const Handle(StepData_StepModel) & model, const Handle(Transfer_TransientProcess) & process) {
    std::size_t lost = 0;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto set = Handle(StepShape_GeometricSet)::DownCast(model->Value(i));
        for (int k = 1; !set.IsNull() && k <= set->NbElements(); ++k) {
            const Handle(StepGeom_Curve) curve = set->ElementsValue(k).Curve();
            if (!curve.IsNull() && !process->IsBound(curve)) ++lost;
        }
    }
    return lost;
}

gp_XYZ place_of(const Handle(StepGeom_CartesianPoint) & point) {
    gp_XYZ place(0.0, 0.0, 0.0);
    for (int i = 1; i <= std::min(point->NbCoordinates(), 3); ++i) place.SetCoord(i, point->CoordinatesValue(i));
    return place;
}

constexpr core::PluralPattern near_ends{
    "a spline has ends that are nearer than 1e-7 to each other, which OpenCASCADE takes for one",
    "{count} splines have ends that are nearer than 1e-7 to each other, which OpenCASCADE takes for one"};

// What OpenCASCADE takes for one is as far off as it was apart.
void note_near_ends(Imported& imported, const Handle(StepData_StepModel) & model) {
    std::size_t count = 0;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto spline = Handle(StepGeom_BSplineCurve)::DownCast(model->Value(i));
        if (spline.IsNull() || spline->NbControlPointsList() < 1) continue;
        const gp_XYZ first = place_of(spline->ControlPointsListValue(1));
        const gp_XYZ last = place_of(spline->ControlPointsListValue(spline->NbControlPointsList()));
        const double distance = std::hypot(last.X() - first.X(), last.Y() - first.Y(), last.Z() - first.Z());
        if (distance == 0.0 || distance > Precision::Confusion()) continue;
        imported.report.largest_error = std::max(imported.report.largest_error, distance);
        ++count;
    }
    if (count > 0) imported.report.left_out.push_back(core::sentence(near_ends, count));
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
    TColStd_SequenceOfAsciiString lengths;
    TColStd_SequenceOfAsciiString angles;
    TColStd_SequenceOfAsciiString solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    const double unit = length_of(lengths);
    reader.SetSystemLengthUnit(unit_to_read_in(unit));
    reader.TransferRoots();
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    auto imported = imported_edges(reader.OneShape(), process, step_name, lost_curves(reader.StepModel(), process));
    if (!imported) return imported;
    set_units(*imported, unit);
    note_near_ends(*imported, reader.StepModel());
    return with_faults_told(*std::move(imported), reader.StepModel(), reader.WS()->ModelCheckList(), is_step_geometry);
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
