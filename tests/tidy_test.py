"""Checks the sources in one folder by .clang-tidy: tidy_test.py ROOT BUILD CLANG_TIDY FOLDER.

Most of the time goes into the headers of the libraries. So sources with the same flags are checked many together, as one unit that
includes them, and a source that was found clean is checked again only when its text or what it depends on has changed.
"""

import collections
import hashlib
import json
import pathlib
import re
import shlex
import subprocess
import sys

MOST_TOGETHER = 32
KEPT_FLAGS = re.compile(r"-[DI]|-isystem$|-std=")
ERROR = re.compile(r"^(.+?):\d+:\d+: error: .*clang-diagnostic-error", re.M)
FINDING = re.compile(r"^(/.+?)(:\d+:\d+: (?:warning|error): .*)", re.M)
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def flags_of(entry):
    """What matters for the meaning of a source: defined names, folders of headers, the standard."""
    words = shlex.split(entry["command"])
    flags = []
    for word, following in zip(words, words[1:] + [""]):
        if KEPT_FLAGS.match(word):
            flags += [word, following] if word == "-isystem" else [word]
    return tuple(flags)


def sources_of(entry, build):
    """The source of an entry, or those that it compiles together."""
    file = pathlib.Path(entry["file"])
    if not file.is_relative_to(build):
        return [file]
    return [pathlib.Path(name) for name in INCLUDE.findall(file.read_text()) if name.endswith(".cpp")]


def sources_by_flags(root, build, folder):
    sources = collections.defaultdict(list)
    for entry in json.loads((build / "compile_commands.json").read_text()):
        for source in sources_of(entry, build):
            if source.is_relative_to(root / folder) and not source.is_relative_to(build):
                sources[flags_of(entry)].append(source)
    return sources


class Fingerprints:
    """Hashes of sources with all headers of the project that they include, the flags, the checks and the program."""

    def __init__(self, root, program):
        version = subprocess.run([program, "--version"], capture_output=True, check=True).stdout
        self.base = version + (root / ".clang-tidy").read_bytes() + pathlib.Path(__file__).read_bytes()

    def of(self, source, flags):
        folders = [pathlib.Path(flag[2:]) for flag in flags if flag.startswith("-I")]
        found, open_files = {}, [source]
        while open_files:
            file = open_files.pop()
            if file in found:
                continue
            found[file] = file.read_text()
            for name in INCLUDE.findall(found[file]):
                candidates = [folder / name for folder in [file.parent, *folders]]
                open_files += [path for path in candidates if path.is_file()][:1]
        text = "\0".join([*flags, *(found[file] for file in sorted(found))])
        return hashlib.sha256(self.base + str(source).encode() + text.encode()).hexdigest()


class Tidy:
    def __init__(self, root, work, program):
        self.unit = work / "unit.cpp"
        self.command = [program, "--quiet", f"--config-file={root / '.clang-tidy'}"]

    def run(self, sources, flags, *options):
        self.unit.write_text("".join(f'#include "{source}"\n' for source in sources))
        command = [*self.command, *options, str(self.unit), "--", "-ferror-limit=0", *flags]
        result = subprocess.run(command, capture_output=True, text=True)
        return result.stdout + (result.stderr if result.returncode < 0 or result.returncode and not result.stdout else "")

    def compatible(self, sources, flags):
        """The sources in lists without two things of the same name. One check that costs nothing stands for none."""
        if len(sources) == 1:
            return [sources]
        in_error = {pathlib.Path(name) for name in ERROR.findall(self.run(sources, flags, "--checks=-*,misc-definitions-in-headers"))}
        if not in_error:
            return [sources]
        rest = [source for source in sources if source not in in_error]
        if len(rest) in (0, len(sources)):
            rest = sources[: len(sources) // 2]
        others = [source for source in sources if source not in rest]
        return self.compatible(rest, flags) + self.compatible(others, flags)


def findings_in(output, root):
    """The findings by their place; a header is reached through links of the build's folder."""
    for path, text in FINDING.findall(output):
        place = pathlib.Path(path).resolve()
        yield f"{place.relative_to(root) if place.is_relative_to(root) else place}{text}"


def main():
    root, build = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    program, folder = sys.argv[3:]
    work = build / "tidy" / folder
    work.mkdir(parents=True, exist_ok=True)
    list_of_clean = work / "clean.txt"  # their fingerprints
    known = set(list_of_clean.read_text().split()) if list_of_clean.exists() else set()
    fingerprints, tidy = Fingerprints(root, program), Tidy(root, work, program)
    clean, found, count = set(), set(), 0
    for flags, sources in sources_by_flags(root, build, folder).items():
        prints = {source: fingerprints.of(source, flags) for source in sorted(sources)}
        clean |= known & set(prints.values())
        count += len(prints)
        changed = [source for source in prints if prints[source] not in known]
        for start in range(0, len(changed), MOST_TOGETHER):
            for together in tidy.compatible(changed[start : start + MOST_TOGETHER], flags):
                output = tidy.run(together, flags)
                found |= set(findings_in(output, root))
                if not output.strip():
                    clean |= {prints[source] for source in together}
                elif not found:
                    found.add(output)
                list_of_clean.write_text("\n".join(sorted(known | clean)))
    list_of_clean.write_text("\n".join(sorted(clean)))
    print("\n".join(sorted(found)) or f"{count} sources are clean")
    sys.exit(1 if found or count == 0 else 0)


if __name__ == "__main__":
    main()
