// Corners of the rectangles that a map of coverage is painted in.
layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 color;

uniform vec2 viewport_px;

out vec2 v_place;
flat out vec4 v_color;

void main() {
    v_place = place;
    v_color = color;
    gl_Position = vec4(vec2(2.0, -2.0) * position_px / viewport_px + vec2(-1.0, 1.0), 0.0, 1.0);
}
