// Fades the fill over the pixel that its edge crosses.
in float v_inside_px;
flat in vec4 v_color;

out vec4 premultiplied;

void main() {
    float alpha = v_color.a * clamp(v_inside_px + 0.5, 0.0, 1.0);
    premultiplied = vec4(v_color.rgb * alpha, alpha);
}
