/// The basic shapes of SVG: rect, circle, ellipse, line, polyline, polygon.
#pragma once

#include <pugixml.hpp>
#include <string_view>

#include "exchange/svg/path_data.h"
#include "exchange/svg/viewport.h"

namespace batten::exchange {

/// Whether `name` is that of a basic shape.
bool is_basic_shape(std::string_view name);

/// Whether the file does not say where a basic shape is or how large (Viewport::length).
bool has_unknown_length(const pugi::xml_node& element, std::string_view name, const Viewport& viewport);

/// Hands the outline of the shape, whose lengths are known, mapped to `sink`: circles, ellipses and rounded corners as
/// exact quarters. What has no size hands nothing. Returns where its list of points goes wrong, counted from 0, if it
/// does; what stands before is read.
std::optional<std::size_t> read_basic_shape(const pugi::xml_node& element, std::string_view name,
                                            const Viewport& viewport, const core::PlaneMap& map,
                                            const OutlineSink& sink);

}  // namespace batten::exchange
