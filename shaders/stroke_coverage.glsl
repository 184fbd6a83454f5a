// How much of the pixel a stroke covers, from the distance to its center line and to the ends of the dash.
in vec2 v_place_px;
flat in vec2 v_ends_px;
flat in vec3 v_style_px;
flat in vec4 v_color;

float stroke_coverage() {
    float along = clamp(v_place_px.x, v_ends_px.x, v_ends_px.y);
    float from_line = length(vec2(v_place_px.x - along, v_place_px.y));
    float half_dash = v_style_px.y;
    float period = v_style_px.z;
    float from_dash_middle = period * abs(fract((along - half_dash) / period + 0.5) - 0.5);
    return clamp(v_style_px.x + 0.5 - from_line, 0.0, 1.0) * clamp(half_dash + 0.5 - from_dash_middle, 0.0, 1.0);
}
