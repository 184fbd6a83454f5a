// Paints each pixel as far as the map says that it is covered.
in vec2 v_place;
flat in vec4 v_color;

uniform sampler2D coverage;

out vec4 premultiplied;

void main() {
    float alpha = v_color.a * texture(coverage, v_place).r;
    premultiplied = vec4(v_color.rgb * alpha, alpha);
}
