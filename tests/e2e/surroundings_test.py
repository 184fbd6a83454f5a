"""Starts in surroundings that lack something: no place to write to, no fonts, an old OpenGL, hardly any window."""

import os
import shutil
import subprocess
import unittest

from case import WindowTest

NOBODY = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups")
FONTS = "/usr/share/fonts"


def may_mount():
    return shutil.which("unshare") and subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "none", FONTS], capture_output=True).returncode == 0


class SurroundingsTest(WindowTest):
    def edit(self, editor):
        editor.key("ctrl+d")
        return editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "an edit")

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("setpriv"), "only root can become a user who may write nowhere")
    def test_without_write_access_to_anything(self):
        self.folder.chmod(0o755)
        self.path.chmod(0o644)
        before = self.path.stat().st_mtime_ns
        nowhere = {"HOME": "/nonexistent", "XDG_CONFIG_HOME": "/nonexistent/config", "XDG_STATE_HOME": "/nonexistent/state"}
        editor = self.start(self.display(), before=NOBODY, environment=nowhere)
        editor.folder.chmod(0o777)  # for the state report alone
        with editor:
            self.edit(editor)
            state = editor.wait(lambda state: "no recovery journal" in state["message"], "the sentence")
            self.assertEqual(state["message"], "Unsaved changes would be lost in a crash, because no recovery journal can be written: Permission denied")
            self.assertFalse(state["message_is_error"])
            editor.key("ctrl+s")
            state = editor.wait(lambda state: state["message_is_error"] and state["is_settled"], "the refusal")
            self.assertEqual(state["message"], "wave.json: the file cannot be written: Permission denied")
            self.assertTrue(state["is_modified"])
            editor.screenshot("read-only")
            editor.key("ctrl+z")
            editor.wait(lambda state: state["undo_count"] == 0 and not state["is_modified"], "the step back")
            editor.key("ctrl+shift+z")
            state = editor.wait(lambda state: state["undo_count"] == 1, "the step again")
            self.assertNotIn("recovery journal", state["message"], "told once")
        self.assertEqual(self.path.stat().st_mtime_ns, before)

    def test_without_a_home(self):
        editor = self.start(self.display(), environment={"HOME": "", "XDG_CONFIG_HOME": "", "XDG_STATE_HOME": ""})
        with editor:
            state = self.edit(editor)
            self.assertIn("no recovery journal can be written: neither HOME nor XDG_STATE_HOME names a folder", state["message"])

    @unittest.skipUnless(may_mount(), "mounting is not permitted here")
    def test_without_fonts(self):
        for fonts in ("", f"&& mkdir -p {FONTS}/truetype/dejavu && echo broken > {FONTS}/truetype/dejavu/DejaVuSans.ttf"):
            hidden = ("unshare", "-m", "sh", "-c", f'mount -t tmpfs none {FONTS} {fonts} && exec "$@"', "sh")
            with self.start(self.display(), before=hidden) as editor:
                self.edit(editor)
                editor.screenshot("fonts" if fonts else "no-fonts")

    def test_with_an_old_opengl(self):
        display = self.display()
        environment = dict(os.environ, DISPLAY=display.name, LIBGL_ALWAYS_SOFTWARE="1",
                           XDG_CONFIG_HOME=str(self.folder / "config"), XDG_STATE_HOME=str(self.folder / "state"))
        environment.pop("WAYLAND_DISPLAY", None)
        for version in ("2.1", "3.2"):
            environment["MESA_GL_VERSION_OVERRIDE"] = version
            ended = subprocess.run([os.environ["BATTEN_BINARY"]], env=environment, capture_output=True, text=True)
            self.assertEqual(ended.returncode, 1, ended.stderr)
            self.assertTrue(ended.stderr.startswith("batten: no window with OpenGL 3.3 can be opened: "), ended.stderr)
            self.assertEqual(ended.stderr.count("\n"), 1)

    def test_in_hardly_any_window(self):
        with self.start(self.display()) as editor:
            window = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Batten"], env=editor.environment, capture_output=True,
                                    text=True, check=True).stdout.split()[0]
            for size in ((1, 1), (2, 900), (1440, 1), (300, 200), (1440, 900)):
                before = editor.state()["frame_count"]
                editor.xdotool("windowsize", window, *size)
                editor.wait(lambda state: state["frame_count"] > before and state["is_settled"], f"a window of {size}")
            editor.xdotool("windowunmap", window)
            editor.xdotool("windowmap", window)
            editor.settle()
            editor.click(700, 300)
            self.edit(editor)
            editor.screenshot("back")


if __name__ == "__main__":
    unittest.main()
