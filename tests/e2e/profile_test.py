"""The costs of frames, measured in the real window: what is told about them, never how long they took."""

import json
import os
import subprocess

from case import CUBIC, WindowTest

PARTS = ["input", "commands", "panels", "scene", "upload", "draw"]


class ProfileTest(WindowTest):
    def profile(self, *arguments):
        environment = dict(os.environ, DISPLAY=self.display().name, XDG_CONFIG_HOME=str(self.folder / "config"), LIBGL_ALWAYS_SOFTWARE="1")
        environment.pop("WAYLAND_DISPLAY", None)
        return subprocess.run([os.environ["BATTEN_BINARY"], "profile", *map(str, arguments)], env=environment, capture_output=True, text=True)

    def measured(self, *arguments):
        ended = self.profile(*arguments, "--json")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        return json.loads(ended.stdout)

    def assert_is_spread(self, spread):
        self.assertEqual(list(spread), ["median", "p99"])
        self.assertGreaterEqual(spread["p99"], spread["median"])
        self.assertGreaterEqual(spread["median"], 0)

    def test_a_file_that_takes_long_to_read_is_waited_for(self):
        count = 300_000
        knots = [0, 0, 0, *range(count - 2), *[count - 3] * 3]
        curve = {"name": "long", "degree": 3, "knots": knots, "points": [[i, i % 7] for i in range(count)]}
        path = self.folder / "long.json"
        path.write_text(json.dumps({"format": "batten", "version": 1, "curves": [curve]}))
        found = self.measured(path, "--drag", "--frames", 2)
        self.assertGreater(found["vertices"]["median"], found["empty"]["vertices"]["median"])

    def test_every_gesture_is_measured(self):
        for gesture in ("drag", "drag-knot", "insert-knot", "hover", "pan", "zoom", "play"):
            with self.subTest(gesture):
                found = self.measured(self.path, f"--{gesture}", "--frames", 3)
                self.assertEqual((found["file"], found["gesture"], found["frames"]), (str(self.path), gesture, 3))
                for canvas in (found, found["empty"]):
                    self.assertGreater(canvas["frame_ms"]["median"], 0)
                    self.assertGreater(canvas["vertices"]["median"], 0)
                    self.assertEqual(list(canvas["parts_ms"]), PARTS)
                    for spread in (canvas["frame_ms"], canvas["vertices"], *canvas["parts_ms"].values()):
                        self.assert_is_spread(spread)
                self.assertGreater(found["start_ms"], 0)
                self.assertGreater(found["vertices"]["median"], found["empty"]["vertices"]["median"])
                self.assertAlmostEqual(found["ratio"], found["frame_ms"]["median"] / found["empty"]["frame_ms"]["median"])

    def test_what_is_to_be_done_before_the_gesture_is_done(self):
        self.assertEqual(self.profile(self.path, "--pan", "--frames", 2, "--do", "select-all", "--do", "set-tool transform").returncode, 0)
        refused = self.profile(self.path, "--pan", "--frames", 2, "--do", "select-none", "--do", "delete-points")
        self.assertEqual(refused.returncode, 1)
        self.assertTrue(refused.stderr.startswith("batten: --do 'delete-points': "), refused.stderr)

    def test_it_leaves_the_file_and_the_settings_alone(self):
        before = self.path.read_text()
        self.measured(self.path, "--drag", "--frames", 2)
        self.assertEqual(self.path.read_text(), before)
        self.assertFalse((self.folder / "config").exists())

    def test_as_text_it_names_the_same(self):
        text = self.profile(self.path, "--zoom", "--frames", 2).stdout
        for word in ("Zoom in and out: 2 frames", "empty canvas", *PARTS, "vertices", "times that of an empty canvas"):
            self.assertIn(word, text)

    def refused(self, *arguments):
        ended = self.profile(*arguments)
        self.assertEqual(ended.stdout, "")
        return ended.returncode, ended.stderr

    def test_a_gesture_that_does_nothing_is_no_measurement(self):
        self.path.write_text(json.dumps(dict(CUBIC, curves=[dict(CUBIC["curves"][0], locked=True)])))
        self.assertEqual(self.refused(self.path, "--drag", "--frames", 2),
                         (1, "batten: the gesture 'drag' does nothing to the active curve\n"))

    def test_one_gesture_is_needed(self):
        for gestures in ([], ["--drag", "--pan"]):
            self.assertEqual(self.refused(self.path, *gestures),
                             (2, "batten profile: one gesture is needed: --drag, --drag-knot, --insert-knot, --hover, --pan, --zoom or --play\n"))
        for wrong in (["--drag", "--frames", 0], ["--drag", "--frames", "x"], ["--spin"]):
            self.assertEqual(self.refused(self.path, *wrong)[0], 2)

    def test_a_file_that_is_none(self):
        self.path.write_text("{}")
        status, text = self.refused(self.path, "--drag")
        self.assertEqual(status, 1)
        self.assertTrue(text.startswith("batten: wave.json: "), text)
