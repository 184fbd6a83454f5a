// Corners of the strips that polylines are made of.
layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 place_px;   // along and across the line
layout(location = 2) in vec2 ends_px;    // along the line, where its round ends begin
layout(location = 3) in vec3 style_px;   // half the width, half a dash, dash and gap
layout(location = 4) in vec4 color;

uniform vec2 viewport_px;

out vec2 v_place_px;
flat out vec2 v_ends_px;
flat out vec3 v_style_px;
flat out vec4 v_color;

void main() {
    v_place_px = place_px;
    v_ends_px = ends_px;
    v_style_px = style_px;
    v_color = color;
    gl_Position = vec4(vec2(2.0, -2.0) * position_px / viewport_px + vec2(-1.0, 1.0), 0.0, 1.0);
}
