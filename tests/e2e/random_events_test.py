"""Random pointer and key events in the real window: it neither ends with an error nor grows. BATTEN_EVENT_MINUTES sets for how long, a
quarter of one where it is not set, and BATTEN_EVENT_SEED which events."""

import os
import random
import shutil
import subprocess
import time
import unittest

from case import WindowTest

SIZE = (1280, 800)
KEYS = ["Escape", "Return", "Tab", "Delete", "BackSpace", "space", "Left", "Right", "Up", "Down", "Home", "End", "Prior", "Next", "plus",
        "minus", "comma", "period", "slash", "at", "F1", "F11", *"0123456789", *"abcdefghijklmnopqrstuvwxyz"]
CONTROL_KEYS = ["a", "c", "x", "v", "d", "z", "y", "z", "y", "p", "n", "g", "s", "o", "shift+z", "shift+s", "shift+g", "alt+v"]
MODIFIERS = ["ctrl", "shift", "alt"]


class Hand:
    """What a hand does that does not look; the same seed does the same."""

    def __init__(self, seed):
        self.random = random.Random(seed)

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
    def begin(self, display):
        nobody = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "env", "-C", str(self.home))
        home = {"HOME": str(self.home), "XDG_CONFIG_HOME": str(self.home / "config"), "XDG_STATE_HOME": str(self.home / "state")}
        editor = self.start(display, "--example", "wave", before=nobody, environment=home)
        editor.folder.chmod(0o777)
        return editor

    def is_followed(self, editor):
        """Waits until the editor has done with all events. Returns whether it still runs."""
        try:
            editor.move(SIZE[0] / 2, SIZE[1] / 2)
        except AssertionError:
            if editor.process.poll() is None:
                raise
        return editor.process.poll() is None

    def hammer(self, editor, hand, end):
        """Until the time is over, or a hand closes the window. Returns the memory after a minute, where it came to that, and at last."""
        start = time.monotonic()
        early = now = None
        while time.monotonic() < end and editor.process.poll() is None:
            # It fails where the window is closed meanwhile.
            subprocess.run(["xdotool", *" ".join(hand.acts(20)).split()], env=editor.environment, stderr=subprocess.DEVNULL)
            if not self.is_followed(editor):
                break
            now = resident_kilobytes(editor.process)
            if early is None and time.monotonic() > start + 60:
                early = now
        for key in (*MODIFIERS, *"dz"):
            editor.xdotool("keyup", key)
        return early, now

    def test_nothing_ends_it_and_it_does_not_grow(self):
        seed = int(os.environ.get("BATTEN_EVENT_SEED", 1))
        self.home = self.folder / "home"
        self.home.mkdir()
        self.folder.chmod(0o755)
        shutil.chown(self.home, 65534, 65534)
        hand = Hand(seed)
        end = time.monotonic() + 60 * float(os.environ.get("BATTEN_EVENT_MINUTES", 0.25))
        while time.monotonic() < end:
            with self.begin(self.display(*SIZE)) as editor:
                early, last = self.hammer(editor, hand, end)
                if editor.process.poll() is not None:
                    self.assertEqual(editor.process.returncode, 0, editor.error_text())
                    shutil.rmtree(self.home / "state", ignore_errors=True)
                    continue
                editor.key("Escape", "Escape", "Escape")
                self.assertEqual(editor.error_text(), "")
                if early:
                    print(f"seed {seed}: {early} kB after a minute, {last} kB at last")
                    self.assertLess(last, 1.1 * early)


if __name__ == "__main__":
    unittest.main()
