// Paints an image, as far as it is opaque.
in vec2 v_place;
flat in float v_opacity;

uniform sampler2D image;

out vec4 premultiplied;

void main() {
    vec4 color = texture(image, v_place);
    float alpha = color.a * v_opacity;
    premultiplied = vec4(color.rgb * alpha, alpha);
}
