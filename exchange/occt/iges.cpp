#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>

#include "exchange/notes.h"
#include "exchange/occt/drawing.h"
#include "exchange/occt/geom_curves.h"
#include "exchange/occt/imported_edges.h"
#include "exchange/occt/lengths.h"
#include "exchange/refusal.h"

namespace batten::exchange::occt {

namespace {

std::string iges_name(const Handle(Standard_Transient) & item) {
    const auto entity = Handle(IGESData_IGESEntity)::DownCast(item);
    if (entity.IsNull()) return {};
    if (entity->HasName()) return entity->NameValue()->ToCString();
    return entity->HasShortLabel() ? entity->ShortLabel()->ToCString() : std::string();
}

bool is_iges_geometry(const Handle(Standard_Transient) & item) {
    constexpr int first_other = 200;
    const auto entity = Handle(IGESData_IGESEntity)::DownCast(item);
    return !entity.IsNull() && entity->TypeNumber() < first_other;
}

// Numbers are left as they are where that is the unit of the file.
void count_lengths_in(const Handle(IGESData_IGESModel) & model, double unit) {
    IGESData_GlobalSection section = model->GlobalSection();
    section.SetCascadeUnit(unit);
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
    const double unit = reader.IGESModel()->GlobalSection().UnitValue();
    count_lengths_in(reader.IGESModel(), unit_to_read_in(unit));
    reader.TransferRoots();
    const Handle(XSControl_TransferReader) transferred = reader.WS()->TransferReader();
    std::size_t lost = 0;
    for (int i = 1; i <= reader.NbRootsForTransfer(); ++i)
        if (transferred->ShapeResult(reader.RootForTransfer(i)).IsNull()) ++lost;
    auto imported = imported_edges(reader.OneShape(), transferred->TransientProcess(), iges_name, lost);
    if (!imported) return imported;
    set_units(*imported, unit);
    return with_faults_told(*std::move(imported), reader.Model(), reader.WS()->ModelCheckList(), is_iges_geometry);
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
