"""Has the display do what a real one seldom does, by a library between the editor and GLFW (faulty_display.cpp)."""

import os
import subprocess


def linked_libraries():
    """The paths of the libraries of the program, by their names."""
    told = subprocess.run(["ldd", os.environ["BATTEN_BINARY"]], capture_output=True, text=True).stdout
    return {words[0]: words[2] for words in map(str.split, told.splitlines()) if len(words) > 2}


def preloaded():
    """What to load before the program: AddressSanitizer must be the first. None where GLFW is a part of the program."""
    libraries = linked_libraries()
    if "BATTEN_FAULTY_DISPLAY" not in os.environ or not any(name.startswith("libglfw") for name in libraries):
        return []
    return [*(path for name, path in libraries.items() if name.startswith("libasan")), os.environ["BATTEN_FAULTY_DISPLAY"]]


class FaultyDisplay:
    def __init__(self, folder):
        self.folder = folder
        self.folder.mkdir()
        self.folder.chmod(0o777)

    def words(self):
        """Before the command of the editor; none where nothing can stand between."""
        libraries = preloaded()
        return ["env", f"LD_PRELOAD={':'.join(libraries)}", f"BATTEN_FAULTS={self.folder}"] if libraries else []

    def ask(self, name, text=""):
        new = self.folder / f"{name}.new"
        new.write_text(text)
        new.rename(self.folder / name)

    def is_done(self, name):
        return not (self.folder / name).exists()

    def clear(self):
        for path in self.folder.iterdir():
            path.unlink()
