"""Checks every #include of the project against the table of layers."""

import pathlib
import re
import sys

# Folder: the folders of the project and the outside headers it may include (beside the standard library).
LAYERS = {
    "core": ({"core"}, {"glm", "tl", "Eigen", "fmt", "hwy", "nlohmann", "posix"}),
    "exchange": ({"core", "exchange"}, {"glm", "tl", "fmt", "nlohmann", "pugixml", "ft2build", "freetype", "posix", "opencascade"}),
    "render": ({"render"}, {"glm", "tl", "fmt", "glad", "cairo", "cairo-pdf"}),
    "app/picture": ({"core", "app/picture"}, {"tl", "stb"}),
    "app/editor": ({"core", "exchange", "app/editor", "app/picture"}, {"glm", "tl", "fmt", "nlohmann", "posix"}),
    "app/ui": ({"core", "exchange", "app/editor", "app/ui"}, {"glm", "tl", "fmt", "imgui", "misc"}),
    "app/platform": ({"core", "render", "app/editor", "app/ui", "app/platform"}, {"glm", "tl", "fmt", "imgui", "backends", "nlohmann", "GLFW", "posix"}),
    "app/cli": ({"core", "exchange", "render", "app/editor", "app/cli"}, {"glm", "tl", "fmt", "CLI", "nlohmann", "posix"}),
    "app": ({"app/platform", "app/cli"}, set()),
}

# The part of render that is plain data, open to all above it.
PICTURE = {"render/draw_list.h", "render/camera.h", "render/clip.h", "render/color.h", "render/coverage_map.h", "render/figure.h",
           "render/first_sign.h", "render/formula_label.h", "render/image.h", "render/label_runs.h", "render/orbit_camera.h",
           "render/pixel_box.h", "render/prose.h", "render/region_cover.h", "render/tex_signs.h"}

# The folders of core in the order of reading, with those before each that it may include. What measures, refines, edits and makes knows
# each other only where an operation stands on another.
CORE_FOLDERS = {
    "base": set(),
    "curve": {"base"},
    "evaluate": {"base", "curve"},
    "measure": {"base", "curve", "evaluate"},
    "refine": {"base", "curve", "evaluate", "measure"},
    "edit": {"base", "curve", "evaluate", "measure", "refine"},
    "make": {"base", "curve", "evaluate"},
    "shape": {"base", "curve", "evaluate", "measure", "refine", "edit", "make"},
    "document": {"base", "curve", "measure", "edit", "make"},
}

# Outside headers that only these places may include.
ONLY_IN = {
    ("core", "Eigen"): {"core/base/detail/dense_least_squares.cpp"},
    ("core", "hwy"): {"core/evaluate/detail/span_block.cpp", "core/evaluate/detail/taylor_samples.cpp"},
    ("core", "nlohmann"): {"core/document/"},
    ("core", "posix"): {"core/document/"},
    ("exchange", "pugixml"): {"exchange/svg/"},
    ("exchange", "ft2build"): {"exchange/font_reader.cpp"},
    ("exchange", "freetype"): {"exchange/font_reader.cpp"},
    ("render", "cairo"): {"render/cairo_painter.cpp"},
    ("render", "cairo-pdf"): {"render/cairo_painter.cpp"},
    ("exchange", "posix"): {"exchange/occt/main.cpp", "exchange/cad/occt_process.cpp"},
    ("exchange", "opencascade"): {"exchange/occt/"},
    ("app/editor", "posix"): {"app/editor/recovery/"},
    ("app/platform", "posix"): {"app/platform/end_signals.cpp"},
    ("app/cli", "posix"): {"app/cli/movie.cpp", "app/cli/standard_streams.cpp"},
}

# Headers of the operating system, without a folder of their own.
POSIX = {"fcntl.h", "linux/limits.h", "poll.h", "spawn.h", "unistd.h", "sys/eventfd.h", "sys/file.h", "sys/mman.h", "sys/resource.h",
         "sys/signalfd.h", "sys/stat.h", "sys/wait.h", "sys/xattr.h"}

# Headers that the build makes.
GENERATED = {"shaders/sources.h": "render", "core/base/version.h": "core"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)


def layer_of(path):
    """The longest folder of LAYERS that holds the path."""
    return max((layer for layer in LAYERS if path.startswith(layer + "/")), key=len, default=None)


def outside_name(header):
    """The first word of an outside header: glm/vec2.hpp is glm; a standard header has no dot."""
    if header in POSIX:
        return "posix"
    if header.endswith(".hxx"):
        return "opencascade"
    return header.split("/")[0].split(".")[0].split("_")[0] if "." in header or "/" in header else None


def is_inside_of_core(header):
    return header.startswith("core/") and "/detail/" in header


def is_before_in_core(path, header):
    own, other = path.split("/")[1], header.split("/")[1]
    return other == own or other in CORE_FOLDERS[own]


def is_allowed(path, layer, quote, header):
    inside, outside = LAYERS[layer]
    if quote == '"':
        if layer == "core" and header.startswith("core/") and not is_before_in_core(path, header):
            return False
        if layer != "core" and is_inside_of_core(header):
            return False
        target = GENERATED.get(header) or layer_of(header)
        return target in inside or (header in PICTURE and layer.startswith("app/"))
    name = outside_name(header)
    if name is None:
        return True
    if name not in outside:
        return False
    places = ONLY_IN.get((layer, name))
    return places is None or any(path.startswith(place) for place in places)


def main():
    root = pathlib.Path(sys.argv[1])
    sources = [p for layer in ("core", "exchange", "render", "app") for p in (root / layer).rglob("*") if p.suffix in (".h", ".cpp")]
    wrong = []
    for source in sorted(sources):
        path = source.relative_to(root).as_posix()
        layer = layer_of(path)
        for quote, header in INCLUDE.findall(source.read_text()):
            if not is_allowed(path, layer, quote, header):
                wrong.append(f"{path}: {layer} may not include {header}")
    print("\n".join(wrong) or f"{len(sources)} files keep to their layers")
    sys.exit(1 if wrong or not sources else 0)


if __name__ == "__main__":
    main()
