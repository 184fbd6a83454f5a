/// How entities of a DXF file are drawn, of which curves have a color alone, whether they show, and whether they
/// change.
#pragma once

#include "core/document/document.h"
#include "exchange/dxf/dxf_entity.h"
#include "exchange/notes.h"

namespace batten::exchange {

/// Of a layer, or of an entity on it.
struct DxfLook {
    std::optional<core::DocumentColor> color{};
    bool visible = true;
    bool locked = false;
    bool has_line_type = false;    ///< other than a whole line
    bool has_line_weight = false;  ///< a width in millimeters
    bool has_width = false;        ///< a width in the drawing, as polylines have
    bool has_thickness = false;    ///< a height of its own above the plane

    /// Notes what a curve loses.
    void tell_losses(Notes& looks) const;
};

DxfLook look_of_layer(const DxfEntity& layer);

/// As `layer`, unless the entity says otherwise.
DxfLook look_of_entity(const DxfEntity& entity, const DxfLook& layer);

}  // namespace batten::exchange
