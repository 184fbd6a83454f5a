/// Collects the edges of shapes as curves of a document.
#pragma once

#include <Interface_CheckIterator.hxx>
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

/// Says how many faults OpenCASCADE found in the file.
void add_faults(Imported& imported, const Interface_CheckIterator& checks);

/// Says in what the document's lengths are: a millimeter or an inch where `unit` is as long, in millimeters; the
/// lengths of other units were converted to millimeters.
void set_units(Imported& imported, double unit);

/// The unit in which to read: `unit` where documents have it, else a millimeter.
double unit_to_read_in(double unit);

}  // namespace batten::exchange::occt
