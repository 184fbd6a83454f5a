// Corners of the squares that carry markers.
layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 local_px;
layout(location = 2) in vec3 shape_px;  // roundness, radius, half the width of the outline
layout(location = 3) in vec4 fill;
layout(location = 4) in vec4 outline;

uniform vec2 viewport_px;

out vec2 v_local_px;
flat out vec3 v_shape_px;
flat out vec4 v_fill;
flat out vec4 v_outline;

void main() {
    v_local_px = local_px;
    v_shape_px = shape_px;
    v_fill = fill;
    v_outline = outline;
    gl_Position = vec4(vec2(2.0, -2.0) * position_px / viewport_px + vec2(-1.0, 1.0), 0.0, 1.0);
}
