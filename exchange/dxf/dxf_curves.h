/// The curves of the entities of a DXF file.
#pragma once

#include "exchange/collector.h"
#include "exchange/dxf/dxf_entity.h"

namespace batten::exchange {

/// Makes a curve of an entity, or says in words why there is none.
using DxfCurveMaker = MadeCurve (*)(const DxfEntity& entity);

/// How entities of this name are read; null for those that are not.
DxfCurveMaker dxf_curve_maker(std::string_view name);

/// Whether `entity`, a SPLINE, has no control points, but points that it passes.
bool has_fit_points_alone(const DxfEntity& entity);

/// Whether such a SPLINE has a tangent at one end or both, which the curve through its points gets.
bool has_end_tangents(const DxfEntity& entity);

/// Whether `entity`, a POLYLINE, is a mesh and no curve.
bool is_mesh(const DxfEntity& entity);

/// Whether `entity`, a VERTEX, is a place of the polyline, and no control point from which it was made.
bool is_on_polyline(const DxfEntity& entity);

}  // namespace batten::exchange
