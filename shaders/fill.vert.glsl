// Corners of filled polygons.
layout(location = 0) in vec2 position_px;
layout(location = 1) in float inside_px;
layout(location = 2) in vec4 color;

uniform vec2 viewport_px;

out float v_inside_px;
flat out vec4 v_color;

void main() {
    v_inside_px = inside_px;
    v_color = color;
    gl_Position = vec4(vec2(2.0, -2.0) * position_px / viewport_px + vec2(-1.0, 1.0), 0.0, 1.0);
}
