// Paints a disc or a square with its outline over it.
in vec2 v_local_px;
flat in vec3 v_shape_px;
flat in vec4 v_fill;
flat in vec4 v_outline;

out vec4 premultiplied;

// The part of the pixel inside the shape of this radius.
float coverage(float radius) {
    vec2 sides = clamp(radius + 0.5 - abs(v_local_px), 0.0, 1.0);
    float disc = clamp(radius + 0.5 - length(v_local_px), 0.0, 1.0);
    return mix(sides.x * sides.y, disc, v_shape_px.x);
}

void main() {
    float radius = v_shape_px.y;
    float half_outline = v_shape_px.z;
    float fill_alpha = v_fill.a * coverage(radius);
    float outline_alpha = v_outline.a * (coverage(radius + half_outline) - coverage(radius - half_outline));
    float below = fill_alpha * (1.0 - outline_alpha);
    premultiplied = vec4(v_outline.rgb * outline_alpha + v_fill.rgb * below, outline_alpha + below);
}
