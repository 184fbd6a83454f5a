// Paints an image, as far as it is opaque.
in vec2 v_place;
flat in float v_opacity;

uniform sampler2D image;

out vec4 premultiplied;

void main() {
    premultiplied = texture(image, v_place) * v_opacity;
}
