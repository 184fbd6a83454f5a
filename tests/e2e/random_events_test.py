"""Random events in the real window: pointer, keys in several layouts, every command by its name, files dropped on it, other sizes of the
window, other scales of the monitor, and the loss of the OpenGL context. It neither ends with an error nor grows. BATTEN_EVENT_MINUTES
sets for how long, a quarter of one where it is not set, and BATTEN_EVENT_SEED which events."""

import os
import pathlib
import random
import re
import shutil
import subprocess
import time
import unittest

from case import WindowTest
from faulty_display import FaultyDisplay

SIZE = (1280, 800)
# AddressSanitizer keeps what was freed for a while, and with it the pages around it, and for each new place in the program that takes
# memory the calls that led there; here it keeps little of both.
KEEPS_LITTLE = {"ASAN_OPTIONS": ":".join([os.environ.get("ASAN_OPTIONS", "detect_leaks=1"), "quarantine_size_mb=8", "malloc_context_size=8"])}
SOURCES = pathlib.Path(__file__).parents[2]
KEYS = ["Escape", "Return", "Tab", "Delete", "BackSpace", "space", "Left", "Right", "Up", "Down", "Home", "End", "Prior", "Next", "plus",
        "minus", "comma", "period", "slash", "at", "F1", "F11", *"0123456789", *"abcdefghijklmnopqrstuvwxyz"]
CONTROL_KEYS = ["a", "c", "x", "v", "d", "z", "y", "z", "y", "p", "n", "g", "s", "o", "shift+z", "shift+s", "shift+g", "alt+v"]
MODIFIERS = ["ctrl", "shift", "alt"]
LAYOUTS = ["us", "de", "fr", "gr", "ru"]
# Of a window; the pointer waits at PLACES for it, which are in all of them, but for TINY.
SIZES = [SIZE, SIZE, (640, 400), (1280, 401), (700, 1200), (1920, 1200)]
TINY = [(1, 1), (2, 800), (1280, 1)]
PLACES = [(320, 200), (321, 200)]
SCALES = ["1", "1", "2", "1.25", "0.8"]
# The commands that open dialogs, with those, come first, and again until they have been open. The dialogs that are not awaited need a file that
# another program changed, one that is large, or a session that was killed.
OPENING = {"about": "about", "welcome": "welcome", "key-sheet": "key-sheet", "open": "open-file", "save-as": "save-file", "open-table": "open-table",
           "choose-picture": "open-picture"}
SOON = 20  # commands later
DIALOGS = {"none", "unsaved-changes", "command-palette", "command-form", *OPENING.values()}


def command_names():
    """All commands as they are typed, but for the one that ends the session."""
    sources = (SOURCES / "app" / "editor" / "commands").glob("*.cpp")
    names = {name for source in sources for name in re.findall(r'\.name = "([^"]+)"', source.read_text())}
    return sorted(names - {"quit"})


def files_to_drop():
    data = SOURCES / "tests" / "data"
    return [path for folder in (SOURCES / "assets" / "examples", data / "exchange", data / "pictures", data / "versions")
            for path in sorted(folder.rglob("*")) if path.is_file()]


class Hand:
    """What a hand does that does not look; the same seed does the same."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def shuffled(self, items):
        return self.random.sample(items, len(items))

    def place(self):
        # Most of it in the picture, where most can happen.
        if self.random.random() < 0.6:
            return f"{self.random.randrange(60, 900)} {self.random.randrange(80, 560)}"
        return f"{self.random.randrange(SIZE[0])} {self.random.randrange(SIZE[1])}"

    def drag(self, button):
        held = self.random.choice(MODIFIERS) if self.random.random() < 0.3 else None
        words = [f"mousemove {self.place()}", f"mousedown {button}"]
        words += [f"mousemove {self.place()}" for _ in range(self.random.randrange(1, 5))]
        if self.random.random() < 0.1:
            words.append("key Escape")
        words.append(f"mouseup {button}")
        return [f"keydown {held}", *words, f"keyup {held}"] if held else words

    def act(self):
        kind = self.random.random()
        if kind < 0.35:
            return self.drag(1)
        if kind < 0.5:
            return [f"mousemove {self.place()}", f"click {self.random.choice([1, 1, 1, 3])}"]
        if kind < 0.55:
            return [f"mousemove {self.place()}", "click 1", "click 1"]
        if kind < 0.6:
            return self.drag(self.random.choice([2, 3]))
        if kind < 0.7:
            return [f"mousemove {self.place()}", *[f"click {self.random.choice([4, 5])}"] * self.random.randrange(1, 6)]
        if kind < 0.9:
            return [f"key {self.random.choice(KEYS)}" for _ in range(self.random.randrange(1, 4))]
        return [f"key ctrl+{self.random.choice(CONTROL_KEYS)}"]

    def acts(self, count):
        return [word for _ in range(count) for word in self.act()]


def resident_kilobytes(process):
    with open(f"/proc/{process.pid}/status") as status:
        return int(next(line for line in status if line.startswith("VmRSS")).split()[1])


@unittest.skipUnless(os.geteuid() == 0 and shutil.which("setpriv"), "only root can become a user who cannot write over files")
class RandomEventsTest(WindowTest):
    def begin(self, display, faults):
        nobody = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "env", "-C", str(self.home), *faults.words())
        home = {"HOME": str(self.home), "XDG_CONFIG_HOME": str(self.home / "config"), "XDG_STATE_HOME": str(self.home / "state")}
        editor = self.start(display, "--example", "wave", before=nobody, environment={**home, **KEEPS_LITTLE})
        editor.folder.chmod(0o777)
        return editor

    def lose_context(self, editor, faults):
        """Once at the larger scale, after which the driver of the virtual display keeps some buffers for good."""
        faults.ask("scale", "2")
        editor.wait(lambda state: state["interface_scale"] == 2.0 and state["is_settled"], "the other scale")
        faults.ask("reset")
        self.is_followed(editor)
        editor.wait_until(lambda: faults.is_done("reset"), "the loss of the context")
        faults.ask("scale", "1")
        editor.wait(lambda state: state["interface_scale"] == 1.0 and state["is_settled"], "the scale of the beginning")

    def is_followed(self, editor):
        """Waits until the editor has done with all events. Returns whether it still runs."""
        try:
            self.places.reverse()  # for there is nothing to wait for where it is already
            editor.move(*self.places[0])
            self.dialogs.add(editor.state()["dialog"])
        except AssertionError:
            if editor.process.poll() is None:
                raise
        return editor.process.poll() is None

    def run_command(self, editor, name):
        for words in (["key", "Escape", "key", "ctrl+p", "type", name], ["key", "Return"], ["key", "Return"]):
            subprocess.run(["xdotool", *words], env=editor.environment, stderr=subprocess.DEVNULL)
            if not self.is_followed(editor):
                return

    def resize(self, editor, *sizes):
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Batten"], env=editor.environment, capture_output=True, text=True)
        for size in sizes if found.stdout else ():
            subprocess.run(["xdotool", "windowsize", found.stdout.split()[0], *map(str, size)], env=editor.environment, stderr=subprocess.DEVNULL)

    def choose_layout(self, editor, layout):
        subprocess.run(["setxkbmap", "-layout", layout], env=editor.environment, stderr=subprocess.DEVNULL)

    def surprise(self, editor, hand, faults):
        """What comes from somewhere else than the hand."""
        kind = hand.random.random()
        if kind < 0.5:
            name = self.commands.pop()
            self.run_command(editor, name)
            if OPENING.get(name, "none") not in self.dialogs:
                self.commands.insert(max(0, len(self.commands) - SOON), name)
            self.commands = self.commands or hand.shuffled(command_names())
        elif kind < 0.65:
            tiny = [hand.random.choice(TINY)] if hand.random.random() < 0.3 else []
            self.resize(editor, *tiny, hand.random.choice(SIZES))
        elif kind < 0.75:
            self.choose_layout(editor, hand.random.choice(LAYOUTS))
        elif kind < 0.9:
            faults.ask("drop", "\n".join(map(str, hand.random.sample(files_to_drop(), hand.random.randrange(1, 4)))))
        elif kind < 0.95:
            faults.ask("scale", hand.random.choice(SCALES))
        else:
            faults.ask("reset")

    def memory_at_rest(self, editor, faults):
        """Without a document, and with all else that takes memory as at the beginning, so that what is left can be compared."""
        for key in (*MODIFIERS, *"dz"):
            editor.xdotool("keyup", key)
        self.choose_layout(editor, "us")
        faults.ask("scale", "1")
        self.resize(editor, SIZE)
        editor.key("Escape", "Escape", "Escape")
        self.run_command(editor, "scale-reset")
        is_as_before = lambda state: state["dialog"] != "at-work" and state["interface_scale"] == 1.0
        editor.wait(lambda state: is_as_before(state) and (state["is_settled"] or state["is_playing"]), "the end of what is at work")
        editor.key("ctrl+n")
        state = editor.wait(lambda state: state["dialog"] == "unsaved-changes" or state["curve_count"] == 0, "the question, or no document")
        if state["dialog"] == "unsaved-changes":
            editor.click_widget("dialog discard")
        editor.wait(lambda state: state["curve_count"] == 0 and not state["is_modified"] and (state["is_settled"] or state["is_playing"]), "no document")
        # What is free is given back to the system, so that what is resident is what is held.
        faults.ask("give-back")
        editor.wait_until(lambda: faults.is_done("give-back"), "the memory that is free")
        return resident_kilobytes(editor.process)

    def hammer(self, editor, hand, faults, end):
        """Until the time is over, or a hand closes the window. Returns the memory after each minute."""
        next_look = time.monotonic() + 60
        memory = []
        while time.monotonic() < end and editor.process.poll() is None:
            # It fails where the window is closed meanwhile.
            subprocess.run(["xdotool", *" ".join(hand.acts(20)).split()], env=editor.environment, stderr=subprocess.DEVNULL)
            if not self.is_followed(editor):
                break
            self.surprise(editor, hand, faults)
            if not self.is_followed(editor):
                break
            if time.monotonic() > next_look:
                memory.append(self.memory_at_rest(editor, faults))
                next_look += 60
        return memory

    def test_nothing_ends_it_and_it_does_not_grow(self):
        seed = int(os.environ.get("BATTEN_EVENT_SEED", 1))
        minutes = float(os.environ.get("BATTEN_EVENT_MINUTES", 0.25))
        self.home = self.folder / "home"
        self.home.mkdir()
        self.folder.chmod(0o755)
        shutil.chown(self.home, 65534, 65534)
        faults = FaultyDisplay(self.folder / "faults")
        hand = Hand(seed)
        self.commands = [*hand.shuffled(command_names()), *OPENING]
        self.dialogs = set()
        self.places = [*PLACES]
        end = time.monotonic() + 60 * minutes
        while time.monotonic() < end:
            faults.clear()
            with self.begin(self.display(*SIZE), faults) as editor:
                self.lose_context(editor, faults)
                memory = self.hammer(editor, hand, faults, end)
                if editor.process.poll() is not None:
                    # Where it is made with AddressSanitizer, that has looked for leaks at the end, too.
                    self.assertEqual(editor.process.returncode, 0, editor.error_text())
                    shutil.rmtree(self.home / "state", ignore_errors=True)
                    continue
                memory.append(self.memory_at_rest(editor, faults))
                self.assertEqual(editor.error_text(), "")
                print(f"seed {seed}: kB after each minute: {memory}")
                self.assertLess(memory[-1], 1.1 * memory[0])
        print(f"dialogs: {', '.join(sorted(self.dialogs))}")
        if minutes >= 10:
            self.assertEqual(DIALOGS - self.dialogs, set(), "what no event led to")


if __name__ == "__main__":
    unittest.main()
