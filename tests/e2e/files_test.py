"""Files in the real window: broken ones, unsaved changes, what is remembered."""

import unittest

from case import CUBIC, WindowTest


class FilesTest(WindowTest):
    def open_file(self, editor, path):
        editor.key("ctrl+o")
        editor.wait(lambda state: state["dialog"] == "open-file" and state["is_settled"], "the file dialog")
        editor.key("ctrl+a")
        editor.type(path)
        editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == str(path), "the typed path")
        editor.key("Return")

    def test_broken_file_is_refused_with_a_sentence_and_the_document_stays(self):
        broken = self.folder / "broken.json"
        broken.write_text(self.path.read_text().replace("[-1.5, 3.5]", "[-1.5, 3.5"))
        decreasing = self.folder / "decreasing.json"
        decreasing.write_text(self.path.read_text().replace("0.5, 0.75", "0.75, 0.5"))
        editor = self.open_editor()
        points = editor.state()["points"]
        for path, words in ((broken, ("broken.json", "line 1")), (decreasing, ("decreasing.json", "knot 6", "0.5", "0.75"))):
            self.open_file(editor, path)
            state = editor.wait(lambda state: "dialog error" in state["widgets"] and path.name in state["message"], "the sentence")
            for word in words:
                self.assertIn(word, state["widgets"]["dialog error"]["value"])
            editor.screenshot(path.stem)
            self.assertEqual(state["points"], points)
            self.assertEqual(state["path"], str(self.path))
            editor.key("Escape")
            editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the dialog closed")
        self.assertEqual(self.save(editor)["knots"], CUBIC["curves"][0]["knots"])

    def test_broken_file_given_at_the_start_is_refused_with_a_notice(self):
        self.path.write_text(self.path.read_text().replace('"degree": 3', '"degree": 30'))
        editor = self.open_editor()
        state = editor.wait(lambda state: "notice text" in state["widgets"], "the notice")
        for word in ("wave.json", "30", "25"):
            self.assertIn(word, state["widgets"]["notice text"]["value"])
        editor.screenshot("notice")
        editor.key("Escape")
        editor.wait(lambda state: not state["message_is_error"], "the notice gone")

    def test_unsaved_changes_are_asked_about(self):
        editor = self.open_editor()
        x, y = editor.point(1)
        editor.drag((x, y), (x + 30, y - 25))
        editor.key("ctrl+n")
        editor.wait(lambda state: state["dialog"] == "unsaved-changes" and state["is_settled"], "the question")
        editor.screenshot("question")
        editor.click_widget("dialog cancel")
        editor.wait(lambda state: state["dialog"] == "none" and state["curve_count"] == 1, "the document kept")
        editor.key("ctrl+n")
        editor.click_widget("dialog save")
        editor.wait(lambda state: state["curve_count"] == 0 and not state["is_modified"], "the new document")
        self.assertNotEqual(self.saved()["points"][1], [-4.5, 2.5])

    def test_theme_and_overlays_are_remembered(self):
        display = self.display()
        config = self.folder / "config"
        with self.start(display, config=config) as editor:
            self.assertEqual(editor.state()["theme"], "dark")
            editor.key("t")
            editor.wait(lambda state: state["theme"] == "light", "the light theme")
        with self.start(display, config=config) as editor:
            self.assertEqual(editor.state()["theme"], "light")


if __name__ == "__main__":
    unittest.main()
