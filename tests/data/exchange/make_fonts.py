"""Makes quadratic.ttf and cubic.otf by FontForge (python3-fontforge): a few letters whose outlines the tests know."""

import fontforge

QUADRATIC_O = [(300, 0, True), (100, 0, False), (100, 200, True), (100, 400, False), (300, 400, True), (500, 400, False), (500, 200, True), (500, 0, False)]
# Points between two off the outline are in their middle and left out of the file: here at halves of units.
QUADRATIC_C = [(50.5, 0, True), (0, 0, False), (0, 50.5, True), (0, 101, False), (50.5, 101, True), (101, 101, False), (101, 50.5, True), (101, 0, False)]
CUBIC_O = [(500, 200, True), (500, 90, False), (410, 0, False), (300, 0, True), (190, 0, False), (100, 90, False), (100, 200, True), (100, 310, False),
           (190, 400, False), (300, 400, True), (410, 400, False), (500, 310, False)]
INNER_O = [(200, 100, True), (400, 100, True), (400, 300, True), (200, 300, True)]
L = [(50, 0, True), (50, 700, True), (150, 700, True), (150, 100, True), (450, 100, True), (450, 0, True)]
TRIANGLE = [(0, 0, True), (0, 200, True), (200, 0, True)]


def add(font, character, width, contours):
    layer = fontforge.layer()
    layer.is_quadratic = font.layers["Fore"].is_quadratic
    for points in contours:
        contour = fontforge.contour()
        contour.is_quadratic = layer.is_quadratic
        for point in points:
            contour += fontforge.point(*point)
        contour.closed = True
        layer += contour
    glyph = font.createChar(ord(character))
    glyph.foreground = layer
    glyph.width = width
    return glyph


def make(name, is_quadratic):
    font = fontforge.font()
    font.em, font.ascent, font.descent = 1000, 800, 200
    font.fontname = font.familyname = font.fullname = "BattenTest"
    font.encoding = "UnicodeFull"
    font.layers["Fore"].is_quadratic = is_quadratic
    add(font, "o", 600, [QUADRATIC_O if is_quadratic else CUBIC_O, INNER_O])
    if is_quadratic:
        add(font, "c", 200, [QUADRATIC_C])
    add(font, "ä", 400, [TRIANGLE])
    add(font, " ", 300, [])
    font.addLookup("kern", "gpos_pair", (), (("kern", (("latn", ("dflt")), ("DFLT", ("dflt")))),))
    font.addLookupSubtable("kern", "pairs")
    add(font, "L", 500, [L]).addPosSub("pairs", "o", -120)
    font.generate(name, flags=("old-kern", "short-post", "no-hints"))


make("quadratic.ttf", True)
make("cubic.otf", False)
