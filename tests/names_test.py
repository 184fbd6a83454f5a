"""Checks that names in unnamed namespaces differ within a library, whose sources may be compiled together.

names_test.py SOURCE_FOLDER. Functions may share a name where their parameters differ. Nor may a header of the library declare the same
function in the same namespace, or one of that name that is not found by a type of the namespace among its parameters: the
unnamed one would hide it from the sources that are compiled after it.
"""

import collections
import pathlib
import re
import sys

LIBRARIES = ("core", "exchange", "render", "app/editor", "app/ui", "app/cli", "app/platform")
# These are compiled alone.
APART = {"evaluate/detail/span_block.cpp", "evaluate/detail/taylor_samples.cpp"}
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.M)
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.S | re.M)
TYPE = re.compile(r"(?:class|struct|enum class|enum) (\w+)(?=[ ;])")
CONSTANT = re.compile(r"(?:constexpr|const|using|namespace) (?:[^(=;{]*[\s&*])?(\w+)(?: =|\{|\[|;)")
FUNCTION = re.compile(r"(?:[\w:<>,&*\s\[\]]*[\s&*])(\w+)\(((?:[^()]|\([^()]*\))*)\)[^;]*?(?:\{|;)")


def statements(body):
    """What stands at the outermost level of a namespace, without comments and templates' heads."""
    body = re.sub(r"//[^\n]*", "", body)
    for block in re.split(r"\n(?=\S)", body):
        text = re.sub(r"^template <.*?> ?", "", " ".join(block.split()))
        if text and text[0] not in "})":
            yield text


def parameter_types(parameters):
    """The types of parameters, without their names."""
    parts = re.split(r",(?![^<]*>)", parameters) if parameters.strip() else []
    return tuple(re.sub(r"\s*=.*", "", re.sub(r"(?<=[\s&*>])\w+\s*$", "", part.split("=")[0].strip())).strip() for part in parts)


def names_in(text):
    """What the statement names: a name alone, or with the types of parameters."""
    if found := TYPE.match(text):
        return found[1], None
    if found := CONSTANT.match(text):
        return found[1], None
    if found := FUNCTION.match(text):
        return found[1], parameter_types(found[2])
    return None


def declared(folder):
    """The functions that headers declare, by name and namespace, with their parameters and headers."""
    places = collections.defaultdict(set)
    for header in sorted(folder.rglob("*.h")):
        text = header.read_text()
        for statement in statements(text):
            name = FUNCTION.match(statement) and names_in(statement)
            if name and (namespace := NAMESPACE.search(text)):
                places[name[0], namespace[1]].add((name[1], header))
    return places


def hides(parameters, declared_parameters):
    """Whether the unnamed function is in the way of the declared one."""
    has_own_type = any(re.search(r"(?<!::)\b[A-Z]\w+", parameter) for parameter in declared_parameters)
    return parameters == declared_parameters or not has_own_type


def repeated(folder):
    """Each name that occurs in several sources, with these."""
    places, in_headers = collections.defaultdict(set), declared(folder)
    for source in sorted(set(folder.rglob("*.cpp")) - {folder / path for path in APART}):
        source_text = source.read_text()
        namespace = NAMESPACE.search(source_text)
        for body in UNNAMED.findall(source_text):
            for text in statements(body):
                # The same alias may stand in several sources.
                if not text.startswith(("using ", "namespace ")) and (name := names_in(text)):
                    places[name].add(source)
                    if namespace:
                        places[name] |= {header for parameters, header in in_headers[name[0], namespace[1]]
                                         if hides(name[1], parameters)}
    plain = {name for name, parameters in places if parameters is None}
    for (name, parameters), sources in sorted(places.items(), key=str):
        others = set().union(*(where for (other, _), where in places.items() if other == name)) if name in plain else sources
        if len(others) > 1:
            yield name, sorted(others)


def main():
    root = pathlib.Path(sys.argv[1])
    found = [f"{library}: {name} in {', '.join(str(source.relative_to(root / library)) for source in sources)}"
             for library in LIBRARIES for name, sources in repeated(root / library)]
    for line in dict.fromkeys(found):
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
