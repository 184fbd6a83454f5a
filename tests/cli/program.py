"""Runs the program without a window."""

import json
import os
import pathlib
import subprocess

BINARY = os.environ["BATTEN_BINARY"]


def environment():
    """Without a display that the program could use."""
    return {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}


def run(*arguments, **options):
    """The finished process; the options are those of subprocess.run."""
    words = [BINARY, *(str(argument) for argument in arguments)]
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **options}
    return subprocess.run(words, env=environment(), timeout=120, check=False, **streams)


def answer(*arguments):
    """What the program prints as JSON; it must end with 0."""
    process = run(*arguments, "--json")
    if process.returncode != 0:
        raise AssertionError(f"{arguments} ended with {process.returncode}: {process.stderr}")
    return json.loads(process.stdout)


def write_document(path, *curves):
    """A native file with these curves, given by their members."""
    path = pathlib.Path(path)
    path.write_text(json.dumps({"format": "batten", "version": 1, "curves": list(curves)}))
    return path
