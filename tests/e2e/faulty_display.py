"""Has the display do what a real one seldom does, by a library between the editor and GLFW (faulty_display.cpp)."""

import os
import subprocess


def stands_between():
    """Whether GLFW is no part of the program, so that a library can stand between the two."""
    linked = subprocess.run(["ldd", os.environ["BATTEN_BINARY"]], capture_output=True, text=True).stdout
    return "BATTEN_FAULTY_DISPLAY" in os.environ and "libglfw" in linked


class FaultyDisplay:
    def __init__(self, folder):
        self.folder = folder
        self.folder.mkdir()
        self.folder.chmod(0o777)

    def words(self):
        """Before the command of the editor; none where nothing can stand between."""
        library = os.environ.get("BATTEN_FAULTY_DISPLAY")
        return ["env", f"LD_PRELOAD={library}", f"BATTEN_FAULTS={self.folder}"] if stands_between() else []

    def ask(self, name, text=""):
        new = self.folder / f"{name}.new"
        new.write_text(text)
        new.rename(self.folder / name)

    def is_done(self, name):
        return not (self.folder / name).exists()

    def clear(self):
        for path in self.folder.iterdir():
            path.unlink()
