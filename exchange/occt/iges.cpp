#include <IGESBasic_Group.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESGeom_CircularArc.hxx>
#include <IGESGeom_CompositeCurve.hxx>
#include <IGESGeom_OffsetCurve.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <IGESToBRep.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TransferBRep.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <sstream>
#include <unordered_set>

#include "exchange/notes.h"
#include "exchange/occt/drawing.h"
#include "exchange/occt/geom_curves.h"
#include "exchange/occt/iges_curves.h"
#include "exchange/occt/imported_edges.h"
#include "exchange/occt/lengths.h"
#include "exchange/refusal.h"

namespace batten::exchange::occt {

namespace {

Handle(IGESData_IGESEntity) iges_entity(const Entity& entity) {
    return Handle(IGESData_IGESEntity)::DownCast(entity);
}

bool is_iges_geometry(const Entity& item) {
    constexpr int first_other = 200;
    const auto entity = iges_entity(item);
    return !entity.IsNull() && entity->TypeNumber() < first_other;
}

bool is_iges_curve(const Handle(IGESData_IGESEntity) & entity) {
    return IGESToBRep::IsBasicCurve(entity) || entity->IsKind(STANDARD_TYPE(IGESGeom_OffsetCurve));
}

void add_members(std::vector<Entity>& members, const Handle(IGESGeom_CompositeCurve) & composite) {
    for (int i = 1; i <= composite->NbCurves(); ++i) {
        const Handle(IGESData_IGESEntity) member = composite->Curve(i);
        if (const auto inner = Handle(IGESGeom_CompositeCurve)::DownCast(member)) add_members(members, inner);
        if (!member.IsNull() && is_iges_curve(member)) members.push_back(member);
    }
}

std::vector<Entity> members_of(const Entity& entity) {
    std::vector<Entity> members;
    if (const auto composite = Handle(IGESGeom_CompositeCurve)::DownCast(entity)) add_members(members, composite);
    return members;
}

class IgesReader : public EntityReader {
  public:
    IgesReader(Handle(IGESData_IGESModel) model, double unit) : model_(std::move(model)), unit_(unit) {}

    std::string name(const Entity& item) const override {
        const auto entity = iges_entity(item);
        if (entity.IsNull() || !(is_curve(item) || entity->IsKind(STANDARD_TYPE(IGESGeom_CompositeCurve)))) return {};
        if (entity->HasName()) return entity->NameValue()->ToCString();
        return entity->HasShortLabel() ? entity->ShortLabel()->ToCString() : std::string();
    }
    std::string kind(const Entity& item) const override { return std::to_string(iges_entity(item)->TypeNumber()); }
    std::string place(const Entity& item) const override { return model_->StringLabel(item)->ToCString(); }
    bool is_curve(const Entity& item) const override {
        const auto entity = iges_entity(item);
        return !entity.IsNull() && is_iges_curve(entity);
    }
    bool is_hidden(const Entity& item) const override {
        const auto entity = iges_entity(item);
        constexpr int left_to_members = 1;
        if (entity.IsNull() || entity->BlankStatus() == 0) return false;
        return is_curve(item) || entity->HierarchyStatus() != left_to_members;
    }
    std::vector<Entity> members(const Entity& item) const override { return members_of(item); }
    std::optional<StatedCurve> curve(const Entity& item) const override { return iges_curve(iges_entity(item), unit_); }
    Correction correction(const Entity& item, const Geom_Curve& /*geometry*/) const override {
        const auto arc = Handle(IGESGeom_CircularArc)::DownCast(item);
        if (arc.IsNull()) return {};
        return {.contradiction = unit_ * std::abs(arc->EndPoint().Distance(arc->Center()) - arc->Radius())};
    }

  private:
    Handle(IGESData_IGESModel) model_;
    double unit_;
};

// Finds what is missing in the shapes of entities.
class Losses {
  public:
    explicit Losses(ReadShapes& shapes) : shapes_(shapes) {}

    void look_for(const Handle(IGESData_IGESEntity) & entity) {
        if (entity.IsNull() || !seen_.insert(entity.get()).second) return;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(shapes_.process, entity);
        if (shape.IsNull()) return shapes_.lost.push_back(entity);
        if (const auto group = Handle(IGESBasic_Group)::DownCast(entity))
            for (int i = 1; i <= group->NbEntities(); ++i) look_for(group->Entity(i));
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(shape, TopAbs_EDGE, edges);
        if (static_cast<std::size_t>(edges.Extent()) < members_of(entity).size()) shapes_.incomplete.push_back(entity);
    }

  private:
    ReadShapes& shapes_;
    std::unordered_set<const IGESData_IGESEntity*> seen_{};
};

// Numbers are left as they are where that is the unit of the file, or where it has none.
void count_lengths_in(const Handle(IGESData_IGESModel) & model, std::optional<double> unit) {
    constexpr int millimeters = 2;
    IGESData_GlobalSection section = model->GlobalSection();
    if (!unit) {
        section.SetUnitFlag(millimeters);
        section.SetUnitName(new TCollection_HAsciiString("MM"));
    }
    section.SetCascadeUnit(unit.value_or(unit_millimeter));
    model->SetGlobalSection(section);
}

constexpr core::PluralPattern labeled{
    "the name '{place}' was changed, since IGES has labels of eight ASCII characters",
    "{count} names were changed, since IGES has labels of eight ASCII characters; the first one is '{place}'"};

// Labels have eight characters of ASCII.
Handle(TCollection_HAsciiString) iges_label(const std::string& name) {
    constexpr std::size_t most_characters = 8;
    std::string label;
    for (const char c : name)
        if (label.size() < most_characters && ' ' <= c && c <= '~') label += c;
    return new TCollection_HAsciiString(label.c_str());
}

}  // namespace

core::FileResult<Imported> read_iges(const std::string& path) {
    IGESControl_Controller::Init();
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0);
    IGESControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        return refused_file("this is no IGES file that OpenCASCADE can read");
    const Handle(IGESData_IGESModel) model = reader.IGESModel();
    const Handle(XSControl_WorkSession) session = reader.WS();
    if (auto fault = geometry_fault(model, session->ModelCheckList(), is_iges_geometry))
        return tl::unexpected(*std::move(fault));
    constexpr int unknown_name = 3;  // OpenCASCADE puts the number of the unit in its place where it knows the name
    const double unit = model->GlobalSection().UnitValue();
    const bool has_unit = unit > 0.0 && model->GlobalSection().UnitFlag() != unknown_name;
    count_lengths_in(model, has_unit ? std::optional(unit_to_read_in(unit)) : std::nullopt);
    reader.TransferRoots();
    ReadShapes shapes{.shape = reader.OneShape(), .process = session->TransferReader()->TransientProcess()};
    Losses losses(shapes);
    for (int i = 1; i <= reader.NbRootsForTransfer(); ++i) losses.look_for(iges_entity(reader.RootForTransfer(i)));
    const IgesReader entities(model, model->GlobalSection().UnitValue());
    auto imported = imported_edges(shapes, entities);
    if (!imported) return imported;
    if (has_unit)
        set_units(*imported, unit);
    else
        imported->report.left_out.emplace_back(
            "the unit of the file is none that IGES has, so it is left out; the numbers stay as they are");
    tell_faults(*imported, session->ModelCheckList());
    return imported;
}

core::FileResult<Exported> write_iges(const core::Document& document) {
    const bool has_inches = is_in_inches(document);
    IGESControl_Controller::Init();
    IGESControl_Writer writer(has_inches ? "INCH" : "MM", 0);
    count_lengths_in(writer.Model(), has_inches ? unit_inch : unit_millimeter);
    Notes notes;
    for (const NamedSpline& curve : geom_curves(document)) {
        writer.AddGeom(curve.spline);
        const Handle(IGESData_IGESModel) model = writer.Model();
        const Handle(TCollection_HAsciiString) label = iges_label(curve.name);
        model->Entity(model->NbEntities())->SetLabel(label);
        if (curve.name != label->ToCString()) notes.add(labeled, [&] { return curve.name; });
    }
    writer.ComputeModel();
    IGESData_IGESWriter text(writer.Model());
    text.FloatWriter().SetFormat(all_digits);
    text.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
    std::ostringstream stream;
    text.Print(stream);
    return Exported{stream.str(), {.left_out = notes.sentences()}};
}

}  // namespace batten::exchange::occt
