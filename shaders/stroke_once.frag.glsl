// Paints a translucent stroke that covers pixels several times, each pixel once and with its largest coverage; follows
// stroke_coverage.glsl. The first pass writes only the depth, nearer for more coverage. The second pass comes one level nearer:
// it passes where it has the largest coverage, and only the first time, because then the depth holds its own level.
uniform float first_level;  // the levels before belong to strokes painted earlier
uniform float pass_shift;   // 0 in the first pass, 1 in the second

out vec4 premultiplied;

void main() {
    float level = floor(stroke_coverage() * 255.0 + 0.5);
    float alpha = v_color.a * level / 255.0;
    premultiplied = vec4(v_color.rgb * alpha, alpha);
    gl_FragDepth = 1.0 - (first_level + level + pass_shift) / 4194304.0;
}
