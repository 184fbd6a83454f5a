// Paints strokes one over another; follows stroke_coverage.glsl.
out vec4 premultiplied;

void main() {
    float alpha = v_color.a * stroke_coverage();
    premultiplied = vec4(v_color.rgb * alpha, alpha);
}
