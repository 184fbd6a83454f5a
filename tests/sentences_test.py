"""Checks that texts for people are written whole: templates with named places, nothing glued, one spelling, lengths in the unit of the document."""

import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\\n]|\\.)*"'
GLUED = re.compile(r'"(\d+)"\s*\+(?!=)\s*[\w(*]|[\w)\]]\s*\+=?\s*"(\d+)"|\.append\("(\d+)"')
PLACE = re.compile(r"(?<!\{)\{(\w+)\}")
GIVEN = re.compile(r'\{"(\w+)",')

# British spellings and words that a native writer would not use, with what is written instead.
WORDS = {
    "colour": "color", "centre": "center", "neighbour": "neighbor", "behaviour": "behavior", "grey": "gray", "artefact": "artifact",
    "towards": "toward", "afterwards": "afterward", "cancelled": "canceled", "labelled": "labeled", "optimis": "optimiz",
    "normalis": "normaliz", "maximis": "maximiz", "minimis": "minimiz", "recognis": "recogniz", "parametris": "parametriz",
    "reckon": "compute", "is no operation": "is not an operation", "is called like that": "is called that",
}
NAME_OF_0_1 = {"maximis"}  # a member of the settings' file of version 0.1
DESCRIBES = "app/editor/words/refusal.cpp"
ALLOWED = {"app/editor/state/settings.cpp": NAME_OF_0_1, "tests/editor/state/settings_test.cpp": NAME_OF_0_1,
           "exchange/svg/color_names.h": {"grey"}}


def without_comments(source):
    return re.sub(r"//[^\n]*", "", source)


def joined(source):
    """The source with literals on successive lines made one."""
    return re.sub(r'"\s*\n\s*"', "", source)


def call_after(source, start):
    """The text of the call whose opening parenthesis is just before `start`."""
    depth, i = 1, start
    while depth > 0 and i < len(source):
        if source[i] == '"':
            i = re.compile(LITERAL).match(source, i).end()
            continue
        depth += {"(": 1, ")": -1}.get(source[i], 0)
        i += 1
    return source[start : i - 1]


def unequal_places(call):
    """Names that a template has and that are not given, or the other way; only where both are written out."""
    patterns = [literal[1:-1] for literal in re.findall(LITERAL, re.sub(r'\{"\w+",[^{}]*\}', "", call)) if " " in literal or "{" in literal]
    used = {name for pattern in patterns for name in PLACE.findall(pattern)} - {"count"}
    given = set(GIVEN.findall(call)) - {"count"}
    if not patterns or not given:
        return set()
    return given - used


def numbered_literals(source):
    """The source with each literal's text replaced by its number, and the literals."""
    literals = []

    def number(match):
        literals.append(match.group())
        return f'"{len(literals) - 1}"'

    return re.sub(LITERAL, number, source), literals


def glued_texts(path, source):
    text, literals = numbered_literals(joined(without_comments(source)))
    for match in GLUED.finditer(text):
        literal = literals[int(next(group for group in match.groups() if group))]
        if not literal.startswith('".'):  # the ending of a file's name
            yield f"{path}: {literal} is glued to something; write the sentence whole"


def wrong_places(path, source):
    text = joined(without_comments(source))
    for match in re.finditer(r"\bsentence\(", text):
        for name in unequal_places(call_after(text, match.end())):
            yield f"{path}: a sentence has no place {{{name}}}"


def refusals_without_units(path, source):
    if path.startswith(("app/editor/", "app/ui/")) and path != DESCRIBES and "core::describe(" in without_comments(source):
        yield f"{path}: core::describe leaves lengths in the world; refusal_words ({DESCRIBES}) has them in the document's unit"


def foreign_words(path, source):
    for number, line in enumerate(source.splitlines(), 1):
        for word, better in WORDS.items():
            if word in line.lower() and word not in ALLOWED.get(path, ()):
                yield f"{path}:{number}: '{word}' is written '{better}' here"


def main():
    root = pathlib.Path(sys.argv[1])
    found = []
    sources = [p for layer in ("core", "exchange", "render", "app", "tests") for p in (root / layer).rglob("*") if p.suffix in (".h", ".cpp", ".md")]
    for source in sorted(sources + list(root.glob("*.md"))):
        path, text = source.relative_to(root).as_posix(), source.read_text()
        if path != "CHANGELOG.md":
            found += foreign_words(path, text)
        if source.suffix == ".cpp" and not path.startswith("tests/"):
            found += glued_texts(path, text)
            found += wrong_places(path, text)
            found += refusals_without_units(path, text)
    print("\n".join(found) or f"{len(sources)} files have whole sentences")
    sys.exit(1 if found or not sources else 0)


if __name__ == "__main__":
    main()
