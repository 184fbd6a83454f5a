/// Collects the edges of shapes as curves of a document.
#pragma once

#include <Geom_Curve.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TopoDS_Shape.hxx>
#include <Transfer_TransientProcess.hxx>
#include <string>
#include <vector>

#include "exchange/occt/flat_curves.h"
#include "exchange/report.h"

namespace batten::exchange::occt {

using Entity = Handle(Standard_Transient);

/// What of an edge is otherwise than OpenCASCADE has it.
struct Correction {
    double parameter_factor = 1.0;  ///< by which its first and last parameter are multiplied
    double contradiction = 0.0;     ///< how far apart its ends are by the numbers that the file has of them
};

/// What the entities of a file say beside the shapes that OpenCASCADE makes of them.
class EntityReader {
  public:
    EntityReader() = default;
    EntityReader(const EntityReader&) = delete;
    EntityReader& operator=(const EntityReader&) = delete;
    virtual ~EntityReader() = default;

    virtual std::string name(const Entity& entity) const = 0;   ///< empty where it has none
    virtual std::string kind(const Entity& entity) const = 0;   ///< what readers of such files call it; or empty
    virtual std::string place(const Entity& entity) const = 0;  ///< where it stands in the file
    virtual bool is_curve(const Entity& entity) const = 0;      ///< of one edge
    virtual bool is_hidden(const Entity& entity) const = 0;

    /// The entities of the single edges, in their order, of an entity that joins curves; else none.
    virtual std::vector<Entity> members(const Entity& entity) const = 0;

    /// The curve by the numbers of its entity; none where that of the edge is as true.
    virtual std::optional<StatedCurve> curve(const Entity& entity) const = 0;

    /// Of the edge of `entity` along `geometry`, which is not placed yet.
    virtual Correction correction(const Entity& entity, const Geom_Curve& geometry) const = 0;
};

/// What a file was read to.
struct ReadShapes {
    TopoDS_Shape shape{};
    Handle(Transfer_TransientProcess) process{};
    std::vector<Entity> lost{};        ///< of which OpenCASCADE made no edges, and which stand in no other
    std::vector<Entity> incomplete{};  ///< of which it made fewer edges than they have members
};

/// The edges that lie in a plane z = constant, as far as they are lines, conics, Bézier and B-spline curves; and those
/// of lost entities whose curves `reader` knows. What has no name has that of the smallest part of the file around it
/// that has one. The others are counted in the report, with reasons where they are known. Error: there is none.
core::FileResult<Imported> imported_edges(const ReadShapes& shapes, const EntityReader& reader);

/// Whether an entity of a file is a point, a direction or a curve, or where they are.
using IsGeometry = bool (*)(const Entity& entity);

/// The first fault that OpenCASCADE found in the geometry of `model`, of which it takes what is wrong for zeros.
std::optional<core::FileError> geometry_fault(const Handle(Interface_InterfaceModel) & model,
                                              const Interface_CheckIterator& checks, IsGeometry is_geometry);

/// Says how many faults OpenCASCADE found in the file; how far the curves are off is not known then.
void tell_faults(Imported& imported, const Interface_CheckIterator& checks);

/// Says in what the document's lengths are: a millimeter or an inch where `unit` is as long, in millimeters; the
/// lengths of other units were converted to millimeters.
void set_units(Imported& imported, double unit);

/// Adds what the lengths are rounded where all are multiplied by a factor that is rounded itself.
void add_rounding_of_lengths(Imported& imported);

/// The unit in which to read: `unit` where documents have it, else a millimeter.
double unit_to_read_in(double unit);

}  // namespace batten::exchange::occt
