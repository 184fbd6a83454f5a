"""Checks core's READMEs against its headers: the program, the table of all operations, the headers of each folder."""

import pathlib
import re
import sys

MOST_LINES = 60  # of a folder's README


def public_headers(folder):
    return [header for header in sorted(folder.rglob("*.h*")) if header.suffix != ".cpp" and "detail" not in header.parts]


def declarations(source):
    """What stands in the header's namespace, with everything in braces left out."""
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', re.sub(r"//[^\n]*", "", source))
    text = re.search(r"namespace batten::core \{(.*)\}", text, re.S).group(1)
    nested = 1
    while nested:
        text, nested = re.subn(r"\{[^{}]*\}", ";", text)
    return [" ".join(declaration.split()) for declaration in text.split(";")]


def functions(header):
    """The names of the functions declared in the header, except operators; members of classes are not among them."""
    found = (re.match(r"(?:\[\[nodiscard\]\] )?(?:template <[^>]*> ?)?(?!class|struct|enum|using|concept)[^=(]*?(\w+)\(", declaration)
             for declaration in declarations(header.read_text()) if "->" not in declaration)
    return {match.group(1) for match in found if match and not match.group().endswith("operator(")}


def rows(readme):
    """The table: header to the names in its row."""
    found = re.findall(r"^\| `(\w+/\w+\.h)` \| (.*) \|$", readme, re.M)
    return {header: set(re.findall(r"`([\w:]+)`", row)) for header, row in found}


def unequal_rows(core):
    table = rows((core / "README.md").read_text())
    headers = {header.relative_to(core).as_posix(): header for header in public_headers(core) if header.suffix == ".h"}
    for name in sorted(table.keys() - headers.keys()):
        yield f"core/README.md: there is no header {name}"
    for name, header in headers.items():
        source, named, declared = header.read_text(), table.get(name, set()), functions(header)
        yield from (f"core/README.md: the row of {name} lacks {function}" for function in sorted(declared - named))
        for other in sorted(named - declared):
            class_name, *member = other.split("::")
            if not re.search(rf"\bclass {class_name}\b", source) or not all(re.search(rf"\b{m}\(", source) for m in member):
                yield f"core/README.md: {name} has no {other}"


def wrong_program(core, program):
    block = re.search(r"```cpp\n(.*?)```", (core / "README.md").read_text(), re.S)
    if not block or block.group(1) != program.read_text():
        yield f"core/README.md: the first program is not {program.name}, which is what the tests compile"


def incomplete_folders(core):
    for folder in sorted(path for path in core.iterdir() if path.is_dir()):
        readme = (folder / "README.md").read_text()
        if len(readme.splitlines()) > MOST_LINES:
            yield f"core/{folder.name}/README.md has more than {MOST_LINES} lines"
        for header in public_headers(folder):
            if not re.search(rf"`{header.name.split('.')[0]}(\.h)?`", readme):
                yield f"core/{folder.name}/README.md does not name {header.name}"


def main():
    root = pathlib.Path(sys.argv[1])
    core = root / "core"
    found = [*wrong_program(core, root / "tests/package/quarter_circle.cpp"), *unequal_rows(core), *incomplete_folders(core)]
    count = sum(len(functions(header)) for header in public_headers(core))
    print("\n".join(found) or f"the READMEs of core name all {count} operations")
    sys.exit(1 if found or not count else 0)


if __name__ == "__main__":
    main()
