/// Collects the edges of shapes as curves of a document.
#pragma once

#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TopoDS_Shape.hxx>
#include <Transfer_TransientProcess.hxx>
#include <string>

#include "exchange/report.h"

namespace batten::exchange::occt {

/// What an entity of a file is called; empty where it has no name.
using NameOf = std::string (*)(const Handle(Standard_Transient) & entity);

/// The edges of `shape` that lie in a plane z = constant, as far as they are lines, conics, Bézier and B-spline curves,
/// with the names of the entities of which `process` made them; the others are counted in the report, with `lost` more
/// of which OpenCASCADE made no edges. Error: there is none.
core::FileResult<Imported> imported_edges(const TopoDS_Shape& shape, const Handle(Transfer_TransientProcess) & process,
                                          NameOf name_of, std::size_t lost);

/// Whether an entity of a file is a point, a direction or a curve, or where they are.
using IsGeometry = bool (*)(const Handle(Standard_Transient) & entity);

/// Says how many faults OpenCASCADE found in the file; how far the curves are off is not known then. Error: one of them
/// is in the geometry of `model`, of which OpenCASCADE takes what is wrong for zeros.
core::FileResult<Imported> with_faults_told(Imported imported, const Handle(Interface_InterfaceModel) & model,
                                            Interface_CheckIterator checks, IsGeometry is_geometry);

/// Says in what the document's lengths are: a millimeter or an inch where `unit` is as long, in millimeters; the
/// lengths of other units were converted to millimeters.
void set_units(Imported& imported, double unit);

/// The unit in which to read: `unit` where documents have it, else a millimeter.
double unit_to_read_in(double unit);

}  // namespace batten::exchange::occt
