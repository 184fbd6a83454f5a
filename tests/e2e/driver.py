"""Drives the real editor on a virtual display: real pointer and key events in, the state report and screenshots out.

Nothing here waits for a time: every step waits until the editor reports the state that it must lead to.
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PATIENCE_SECONDS = 30.0
POLL_SECONDS = 0.01


# Whoever ends the tests by a signal has them leave no windows, displays and folders behind.
signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))


class Display:
    """A virtual X display of its own, gone at the end of the with block."""

    def __init__(self, width=1440, height=900):
        self.size = (width, height)

    def __enter__(self):
        reader, writer = os.pipe()
        screen = f"{self.size[0]}x{self.size[1]}x24"
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", screen, "-nolisten", "tcp", "-noreset"],
            pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.name = f":{number}"
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


class Editor:
    """The editor on a display, started in the with block and closed at its end: by the command `before` where there is one, with the variables
    of `environment` beside its own."""

    def __init__(self, binary, display, artifacts, arguments=(), settings=None, config=None, before=(), environment=()):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="batten-"))
        self.report = self.folder / "state.json"
        self.artifacts = pathlib.Path(artifacts)
        self.artifacts.mkdir(parents=True, exist_ok=True)
        config = pathlib.Path(config or self.folder / "config")
        self.environment = dict(os.environ, DISPLAY=display.name, XDG_CONFIG_HOME=str(config),
                                XDG_STATE_HOME=str(config / "state"), LIBGL_ALWAYS_SOFTWARE="1")
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.environment.update(environment)
        if settings is not None:
            path = config / "batten" / "settings.json"
            path.parent.mkdir(parents=True)
            path.write_text(json.dumps(settings))
        self.quit_key = "ctrl+q"
        self.is_killed = False
        self.command = [*before, str(binary), "--state-report", str(self.report), *map(str, arguments)]

    def __enter__(self):
        self.errors = open(self.folder / "stderr.txt", "w+")
        self.process = subprocess.Popen(self.command, env=self.environment, stderr=self.errors)
        try:
            self.wait(lambda state: state["is_settled"], "the first frames")
        except BaseException:
            self.__exit__(*sys.exc_info())
            raise
        return self

    def __exit__(self, kind, *_):
        try:
            if kind is None:
                self.close()
        finally:
            if self.process.poll() is None:
                self.process.kill()
                self.process.wait()
            self.errors.close()
            shutil.rmtree(self.folder)

    def close(self):
        """Quits without saving and asserts that the editor ended well."""
        if self.is_killed:
            return
        if self.process.poll() is None:
            if self.state()["dialog"] not in ("none", "welcome"):
                self.key("Escape")
            self.key(self.quit_key)
            self.wait_until(lambda: self.process.poll() is not None or self.state()["dialog"] == "unsaved-changes", "quitting")
            if self.process.poll() is None:
                self.move(*self.widget_center("dialog discard"))
                self.xdotool("click", 1)
        self.process.wait(PATIENCE_SECONDS)
        assert self.process.returncode == 0, f"the editor ended with {self.process.returncode}:\n{self.error_text()}"

    def kill(self):
        """Ends the editor as a crash does."""
        self.process.kill()
        self.process.wait()
        self.is_killed = True

    def error_text(self):
        self.errors.seek(0)
        return self.errors.read()

    # What the editor shows.

    def state(self):
        return json.loads(self.report.read_text())

    def wait_until(self, condition, what):
        # So many looks and not so much time, which also passes while the machine stands still.
        for _ in range(round(PATIENCE_SECONDS / POLL_SECONDS)):
            if condition():
                return
            time.sleep(POLL_SECONDS)
        self.screenshot("failure")
        raise AssertionError(f"waited in vain for {what}")

    def wait(self, predicate, what):
        """The first reported state for which the predicate holds."""
        found = {}

        def holds():
            if self.process.poll() is not None:
                raise AssertionError(f"the editor ended with {self.process.returncode} before {what}:\n{self.error_text()}")
            if not self.report.exists():
                return False
            found.update(self.state())
            return predicate(found)

        try:
            self.wait_until(holds, what)
        except AssertionError as error:
            told = ("dialog", "pointer", "buttons_down", "is_settled", "is_playing", "frame_count", "message")
            raise AssertionError(f"{error}; the last state: { {name: found.get(name) for name in told} }") from error
        return found

    def settle(self):
        return self.wait(lambda state: state["is_settled"], "rest")

    def labels(self):
        return [label["text"] for label in self.state()["labels"]]

    def screenshot(self, name):
        path = self.artifacts / f"{name}.png"
        subprocess.run(["import", "-window", "root", str(path)], env=self.environment, check=True)
        return path

    # Pointer and keys.

    def xdotool(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)

    def move(self, x, y):
        x, y = round(x), round(y)
        self.xdotool("mousemove", x, y)
        self.wait(lambda state: state["pointer"] == {"x": x, "y": y} and (state["is_settled"] or state["is_playing"]),
                  f"the pointer at {x}, {y}")

    def press(self, button=1):
        self.xdotool("mousedown", button)
        self.wait(lambda state: state["buttons_down"] > 0, "the press")

    def release(self, button=1):
        self.xdotool("mouseup", button)
        self.wait(lambda state: state["buttons_down"] == 0 and (state["is_settled"] or state["is_playing"]), "the release")

    def click(self, x, y, button=1):
        self.move(x, y)
        self.press(button)
        self.release(button)

    def double_click(self, x, y):
        self.move(x, y)
        before = self.state()["press_count"]
        self.xdotool("click", "--repeat", 2, "--delay", 20, 1)
        self.wait(lambda state: state["press_count"] == before + 2 and state["buttons_down"] == 0 and state["is_settled"],
                  "the double click")

    def drag(self, start, end, steps=8, release=True):
        """Presses at start and moves to end in steps; both are (x, y) in window pixels."""
        self.move(*start)
        self.press()
        for i in range(1, steps + 1):
            self.move(start[0] + (end[0] - start[0]) * i / steps, start[1] + (end[1] - start[1]) * i / steps)
        if release:
            self.release()

    def wheel(self, notches):
        self.xdotool("click", "--repeat", abs(notches), 4 if notches > 0 else 5)

    def key(self, *names):
        before = self.state()["key_count"]
        self.xdotool("key", *names)

        def is_handled():
            if self.process.poll() is not None:
                return True
            state = self.state()
            return state["key_count"] >= before + len(names) and (state["is_settled"] or state["is_playing"])

        self.wait_until(is_handled, f"the keys {names}")

    def type(self, text):
        self.xdotool("type", "--delay", 5, "--", text)

    def widget(self, name):
        return self.wait(lambda state: name in state["widgets"], f"the widget '{name}'")["widgets"][name]

    def widget_center(self, name):
        place = self.widget(name)
        return place["x"] + place["width"] / 2, place["y"] + place["height"] / 2

    def click_widget(self, name):
        self.click(*self.widget_center(name))

    def point(self, index):
        place = self.state()["points"][index]
        return place["x"], place["y"]

    def strip_knot(self, index):
        place = next(knot for knot in self.state()["strip_knots"] if knot["index"] == index)
        return place["x"], place["y"]
