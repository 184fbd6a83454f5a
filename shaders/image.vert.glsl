// Corners of the part of an image that is seen.
layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 place;
layout(location = 2) in float opacity;

uniform vec2 viewport_px;

out vec2 v_place;
flat out float v_opacity;

void main() {
    v_place = place;
    v_opacity = opacity;
    gl_Position = vec4(vec2(2.0, -2.0) * position_px / viewport_px + vec2(-1.0, 1.0), 0.0, 1.0);
}
