"""Checks that no header and no source is longer than one reads in a sitting."""

import pathlib
import sys

MOST_LINES = {".h": 200, ".cpp": 400}  # of the program; a test may be a long list of cases


def main():
    root = pathlib.Path(sys.argv[1])
    sources = [p for layer in ("core", "exchange", "render", "app") for p in sorted((root / layer).rglob("*")) if p.suffix in MOST_LINES]
    wrong = []
    for source in sources:
        lines, most = len(source.read_text().splitlines()), MOST_LINES[source.suffix]
        if lines > most:
            wrong.append(f"{source.relative_to(root).as_posix()}: {lines} lines, at most {most} are allowed; split it by verb")
    print("\n".join(wrong) or f"{len(sources)} files are short enough")
    sys.exit(1 if wrong or not sources else 0)


if __name__ == "__main__":
    main()
