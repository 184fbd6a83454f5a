"""Files in the real window: broken ones, unsaved changes, what is remembered."""

import json
import os
import unittest
import unittest.mock

from case import CUBIC, WindowTest


class FilesTest(WindowTest):
    def open_file(self, editor, path):
        editor.key("ctrl+o")
        editor.wait(lambda state: state["dialog"] == "open-file" and state["is_settled"], "the file dialog")
        editor.key("ctrl+a")
        editor.type(path)
        editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == str(path), "the typed path")
        editor.key("Return")

    def open_folder(self, *names):
        """The editor on a file in a folder of its own that has copies of it under these names."""
        self.curves = self.folder / "curves"
        for path in (self.curves / name for name in ("wave.json", *names)):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(self.path.read_text())
        return self.open_editor(self.curves / "wave.json")

    def rows(self, state):
        """The names in the list of the file dialog, from top to bottom, and which one is chosen."""
        rows = {name.split(" ", 1)[1]: place for name, place in state["widgets"].items()
                if name.startswith(("file ", "folder ")) and name != "file name"}
        names = sorted(rows, key=lambda name: rows[name]["y"])
        return names, [name for name in names if rows[name]["value"] == "chosen"]

    def show_dialog(self, editor, keys, name):
        editor.key(keys)
        editor.wait(lambda state: state["dialog"] == name and state["is_settled"], "the file dialog")

    def typed(self, editor, text):
        def holds(value):
            return lambda state: state["widgets"]["file-dialog name"]["value"] == value and state["is_settled"]

        editor.key(*["BackSpace"] * max(1, len(editor.state()["widgets"]["file-dialog name"]["value"])))
        editor.wait(holds(""), "the empty field")
        editor.type(text)
        return editor.wait(holds(text), f"'{text}' in the field")

    def test_the_file_dialog_filters_while_typing_and_opens_what_fits(self):
        editor = self.open_folder("wave 10.json", "Wave 2.json", "arch.json", "notes.txt")
        self.show_dialog(editor, "ctrl+o", "open-file")
        self.assertEqual(self.rows(editor.state()), (["arch.json", "wave.json", "Wave 2.json", "wave 10.json"], []))
        self.assertEqual(self.rows(self.typed(editor, "ve 1")), (["wave 10.json"], ["wave 10.json"]))
        self.assertEqual(self.rows(self.typed(editor, "WAVE")), (["wave.json", "Wave 2.json", "wave 10.json"], ["wave.json"]))
        editor.screenshot("filtered")
        self.typed(editor, "2")
        editor.key("Return")
        editor.wait(lambda state: state["path"] == str(self.curves / "Wave 2.json") and state["dialog"] == "none", "the file")

    def test_a_file_of_another_program_is_opened_and_a_copy_written(self):
        editor = self.open_folder()
        drawing = self.curves / "drawing.svg"
        # 100 of its units are 100 mm; y goes down.
        drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">'
                           '<path id="leaf" d="M 10 90 C 20 50 60 50 90 90"/></svg>')
        self.open_file(editor, drawing)
        state = editor.wait(lambda state: state["dialog"] == "none" and state["message"].startswith("Opened drawing.svg"), "the drawing")
        self.assertEqual((state["path"], state["is_modified"]), ("", False))
        self.assertIn("its curves are exact", state["message"])
        editor.key("ctrl+s")
        editor.wait(lambda state: state["dialog"] == "save-file" and state["is_settled"], "the question for a name")
        self.assertEqual(editor.state()["widgets"]["file-dialog name"]["value"], "drawing.json")
        copy = self.curves / "copy.dxf"
        editor.key("ctrl+a")
        editor.type(copy)
        editor.wait(lambda state: "file-dialog note" in state["widgets"], "what DXF does to curves")
        editor.screenshot("format-by-ending")
        editor.key("Return")
        state = editor.wait(lambda state: state["dialog"] == "none", "the copy")
        self.assertTrue(copy.exists())
        self.assertEqual(state["path"], "")
        self.assertTrue(state["message"].startswith("Exported copy.dxf"))

    def test_the_format_is_chosen_where_the_ending_does_not_say_it(self):
        editor = self.open_folder()
        editor.key("ctrl+shift+s")
        editor.wait(lambda state: state["dialog"] == "save-file" and state["is_settled"], "the dialog")
        editor.click_widget("file-dialog format")
        editor.wait(lambda state: "format dxf" in state["widgets"], "the formats")
        editor.screenshot("formats")
        editor.click_widget("format dxf")
        editor.wait(lambda state: state["widgets"]["file-dialog format"]["value"] != "" and "format dxf" not in state["widgets"], "DXF")
        path = self.curves / "drawing"
        self.typed(editor, str(path))
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none", "the copy")
        self.assertTrue((self.curves / "drawing.dxf").exists())

    def test_a_figure_is_among_the_formats(self):
        editor = self.open_folder()
        editor.key("ctrl+shift+s")
        editor.wait(lambda state: state["dialog"] == "save-file" and state["is_settled"], "the dialog")
        path = self.curves / "drawing.json"
        self.typed(editor, str(path))
        editor.click_widget("file-dialog format")
        editor.wait(lambda state: "format pdf" in state["widgets"], "the formats")
        editor.screenshot("figures-among-formats")
        editor.click_widget("format pdf")
        editor.wait(lambda state: "figure" in state["widgets"].get("file-dialog note", {"value": ""})["value"] and "format pdf" not in state["widgets"], "what a figure is")
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none", "the figure")
        self.assertTrue((self.curves / "drawing.pdf").read_bytes().startswith(b"%PDF-"))
        self.assertFalse(path.exists())

    def test_keys_move_in_the_file_dialog(self):
        editor = self.open_folder(*(f"curve {i}.json" for i in range(30)))
        self.show_dialog(editor, "ctrl+o", "open-file")
        for key, name in (("Down", "curve 0.json"), ("Down", "curve 1.json"), ("End", "wave.json"), ("Up", "curve 29.json"),
                          ("Home", "curve 0.json"), ("Up", "curve 0.json")):
            editor.key(key)
            state = editor.wait(lambda state: self.rows(state)[1] == [name] and state["is_settled"], f"{name} after {key}")
            self.assertEqual(state["widgets"]["file-dialog name"]["value"], name)
        editor.key("Next")
        state = editor.wait(lambda state: self.rows(state)[1] != ["curve 0.json"], "the next page")
        ((name,), page) = self.rows(state)[1], len(self.rows(state)[0])
        self.assertIn(int(name.split(" ")[1].split(".")[0]), range(page - 4, page + 1))
        editor.key("Prior", "Down", "Return")
        editor.wait(lambda state: state["path"] == str(self.curves / "curve 1.json"), "the chosen file")

    def test_typed_folders_are_listed_and_the_home_folder_is_known(self):
        with unittest.mock.patch.dict(os.environ, HOME=str(self.folder / "curves")):
            editor = self.open_folder("week/notes.json", "week/wind.json")
        self.show_dialog(editor, "ctrl+o", "open-file")
        self.assertEqual(self.rows(self.typed(editor, "/"))[1], [])
        state = self.typed(editor, "~/week/n")
        self.assertEqual(self.rows(state)[0], ["notes.json", "wind.json"])
        self.assertEqual(state["widgets"]["file-dialog folder"]["value"], str(self.curves / "week"))
        self.typed(editor, "~")
        self.assertEqual(self.rows(editor.state())[0], ["week", "wave.json"])
        self.typed(editor, "~/week")
        editor.key("Return")
        editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == "" and self.rows(state)[0] == ["notes.json", "wind.json"],
                    "the folder")
        self.typed(editor, "~/week/wind.json")
        editor.key("Return")
        editor.wait(lambda state: state["path"] == str(self.curves / "week" / "wind.json"), "the file")

    def test_a_second_enter_overwrites_nothing(self):
        editor = self.open_folder("arch.json")
        arch = self.curves / "arch.json"
        arch.write_text("precious")
        self.show_dialog(editor, "ctrl+shift+s", "save-file")
        self.typed(editor, "arch")
        editor.key("Return", "Return")
        editor.wait(lambda state: "dialog question" not in state["widgets"] and state["is_settled"], "the dialog")
        editor.key("Return", "Return", "Return")
        editor.wait(lambda state: "dialog question" in state["widgets"] and state["is_settled"], "the question")
        editor.screenshot("question")
        self.assertEqual(arch.read_text(), "precious")
        editor.key("Escape")
        editor.wait(lambda state: "dialog question" not in state["widgets"], "no question")
        self.assertEqual(editor.state()["dialog"], "save-file")
        editor.key("Return")
        editor.wait(lambda state: "dialog question" in state["widgets"], "the question")
        editor.key("Tab", "space")
        editor.wait(lambda state: state["path"] == str(arch) and state["dialog"] == "none", "the file replaced")
        self.assertEqual(json.loads(arch.read_text())["curves"][0]["knots"], CUBIC["curves"][0]["knots"])

    def test_the_answer_can_be_clicked(self):
        editor = self.open_folder("arch.json")
        self.show_dialog(editor, "ctrl+shift+s", "save-file")
        self.typed(editor, "arch.json")
        for button, dialog in (("dialog keep", "save-file"), ("dialog replace", "none")):
            editor.key("Return")
            editor.click_widget(button)
            editor.wait(lambda state: "dialog question" not in state["widgets"] and state["dialog"] == dialog, button)
        self.assertEqual(editor.state()["path"], str(self.curves / "arch.json"))

    def test_a_foreign_ending_is_not_given_curves(self):
        editor = self.open_editor()
        self.show_dialog(editor, "ctrl+shift+s", "save-file")
        self.typed(editor, "wave.ai")
        editor.key("Return")
        state = editor.wait(lambda state: "dialog error" in state["widgets"], "the sentence")
        self.assertIn("name it 'wave.json'", state["widgets"]["dialog error"]["value"])
        self.assertEqual(state["widgets"]["file-dialog format"]["value"], "by its ending: unknown")
        self.assertFalse((self.folder / "wave.ai").exists())
        self.choose_format(editor, "batten")
        state = editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == "wave.json", "the name")
        self.assertEqual(state["widgets"]["file-dialog format"]["value"], "by its ending: Batten")

    def choose_format(self, editor, name):
        editor.click_widget("file-dialog format")
        editor.wait(lambda state: f"format {name}" in state["widgets"] and state["is_settled"], "the formats")
        editor.click_widget(f"format {name}")
        editor.wait(lambda state: f"format {name}" not in state["widgets"] and state["is_settled"], "the choice")

    def test_batten_is_chosen_in_place_of_any_other_kind(self):
        editor = self.open_editor()
        self.show_dialog(editor, "ctrl+shift+s", "save-file")
        for name in ("wave.pdf", "wave.svg", "wave.tinyspline.json", "wave", "wave.json"):
            editor.click_widget("file-dialog name")
            self.typed(editor, name)
            self.choose_format(editor, "batten")
            editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == "wave.json", name)

    def test_an_svg_is_a_figure_where_that_is_chosen(self):
        editor = self.open_folder()
        drawing = self.curves / "drawing.svg"
        drawing.write_text("of yesterday")
        self.show_dialog(editor, "ctrl+shift+s", "save-file")
        self.typed(editor, str(self.curves / "drawing"))
        self.choose_format(editor, "figure-svg")
        state = editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == str(drawing), "the name")
        self.assertEqual(state["widgets"]["file-dialog format"]["value"], "as figure")
        self.assertEqual(state["widgets"]["file-dialog note"]["value"], "What the canvas shows is drawn as a figure.")
        editor.screenshot("figure-by-save-as")
        editor.click_widget("dialog save")
        editor.wait(lambda state: "dialog question" in state["widgets"], "whether to replace it")
        editor.click_widget("dialog replace")
        editor.wait(lambda state: state["dialog"] == "none" and state["message"].startswith("Exported drawing.svg"), "the figure")
        self.assertIn("<text", drawing.read_text())
        self.assertNotIn('"format"', drawing.read_text(), "no document is within")
        self.assertEqual(editor.state()["path"], str(self.curves / "wave.json"))

    def test_what_was_left_out_of_a_drawing_is_not_lost_without_a_word(self):
        editor = self.open_folder()
        line = '<path d="M0 0L3 5" fill="none" stroke="red"/>'
        for name, more, question in (("filled.svg", '<rect width="1" height="2"/>', "What was left out when it was opened is lost then."),
                                     ("lines.svg", "", "It exists already.")):
            drawing = self.curves / name
            drawing.write_text(f"<svg>{line}{more}</svg>")
            self.show_dialog(editor, "ctrl+o", "open-file")
            self.typed(editor, str(drawing))
            editor.key("Return")
            editor.wait(lambda state, name=name: state["message"].startswith(f"Opened {name}"), name)
            self.show_dialog(editor, "ctrl+shift+s", "save-file")
            self.typed(editor, str(drawing))
            editor.key("Return")
            state = editor.wait(lambda state: "dialog question" in state["widgets"] and state["is_settled"], "the question")
            self.assertEqual(state["widgets"]["dialog question"]["value"], f"Replace {name}? {question}")
            editor.screenshot(f"question-{name}")
            editor.key("Escape", "Escape")
            editor.wait(lambda state: state["dialog"] == "none", "the window")

    def test_a_missing_folder_is_told(self):
        editor = self.open_editor()
        for key, dialog in (("ctrl+shift+s", "save-file"), ("ctrl+o", "open-file")):
            self.show_dialog(editor, key, dialog)
            state = self.typed(editor, "/no/such folder/wave.json")
            self.assertEqual(state["widgets"]["dialog error"]["value"], "there is no folder /no/such folder/")
            editor.key("Escape")
            editor.wait(lambda state: state["dialog"] == "none", "the window")

    def test_a_low_window_shows_files_formats_and_what_was_left_out(self):
        settings = {"window": {"x": 0, "y": 0, "width": 1024, "height": 700}, "user_scale": 2.0}
        self.curves = self.folder / "curves"
        self.curves.mkdir()
        for i in range(30):
            (self.curves / f"curve {i}.json").write_text(self.path.read_text())
        editor = self.enterContext(self.start(self.display(1024, 700), self.curves / "curve 0.json", settings=settings))
        self.show_dialog(editor, "ctrl+shift+s", "save-file")
        name = editor.state()["widgets"]["file-dialog name"]
        rows = [widget for key, widget in editor.state()["widgets"].items() if key.startswith("file ") and widget["y"] + widget["height"] <= name["y"]]
        self.assertGreaterEqual(len(rows), 5)
        title = editor.state()["widgets"]["dialog close"]
        editor.click_widget("file-dialog format")
        state = editor.wait(lambda state: "format by-ending" in state["widgets"] and state["is_settled"], "the formats")
        self.assertGreaterEqual(state["widgets"]["format by-ending"]["y"], title["y"] + title["height"])
        editor.screenshot("formats-in-a-low-window")
        editor.key("Escape")
        editor.wait(lambda state: "format by-ending" not in state["widgets"] and state["dialog"] == "save-file", "the dialog alone")
        name = "a copy of the curves in this file for a table.csv"
        self.typed(editor, str(self.curves / name))
        editor.key("Return")
        state = editor.wait(lambda state: state["dialog"] == "none" and state["message"].startswith(f"Exported {name}") and state["is_settled"], "the copy")
        editor.screenshot("report-in-a-low-window")
        message = state["widgets"]["status message"]
        self.assertLessEqual(message["x"] + message["width"], 1024)
        self.assertGreater(message["width"], 800, "hint and readouts make room")

    def test_ten_thousand_files_are_listed(self):
        editor = self.open_folder(*(f"curve {i}.json" for i in range(10000)))
        self.show_dialog(editor, "ctrl+o", "open-file")
        names, _ = self.rows(editor.state())
        self.assertEqual(names[:3], ["curve 0.json", "curve 1.json", "curve 2.json"])
        self.assertLess(len(names), 60, "rows that are out of sight are not drawn")
        editor.key("Up")
        state = editor.wait(lambda state: self.rows(state)[1] == ["wave.json"], "the last one in sight")
        self.assertEqual(self.rows(self.typed(editor, "e 777"))[0][0], "curve 777.json")
        self.assertEqual(len(self.rows(editor.state())[0]), 11)

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

    def slow_file(self):
        """A file that takes many seconds: a member is found by comparing with all before it in its object."""
        members = ",".join(f'"m{i}":0' for i in range(4000))
        path = self.folder / "slow.json"
        path.write_text(json.dumps(CUBIC)[:-1] + ',"others":[' + ",".join(["{" + members + "}"] * 400) + "]}")
        return path

    def test_reading_a_long_file_shows_how_far_it_is_and_can_be_canceled(self):
        editor = self.open_editor()
        self.open_file(editor, self.slow_file())
        state = editor.wait(lambda state: "% done" in state["widgets"].get("work", {"value": ""})["value"], "the first per cent")
        self.assertEqual((state["dialog"], state["at_work"]), ("at-work", "Opening slow.json"))
        self.assertEqual(state["path"], str(self.path))
        points = CUBIC["curves"][0]["points"]
        editor.wait(lambda state: state["sketched_points"] == len(points), "the points read so far")
        editor.screenshot("at work")
        editor.key("Escape")
        state = editor.wait(lambda state: state["at_work"] is None and state["is_settled"], "the end of the work")
        self.assertEqual((state["message"], state["message_is_error"]), ("Opening slow.json: canceled; nothing has changed", False))
        self.assertEqual((state["path"], state["curve_count"], state["dialog"]), (str(self.path), 1, "open-file"))
        self.assertEqual(state["sketched_points"], 0)

    def test_a_long_file_can_be_canceled_at_the_start(self):
        editor = self.open_editor(self.slow_file())
        editor.wait(lambda state: state["dialog"] == "at-work", "the work")
        editor.click_widget("dialog cancel")
        state = editor.wait(lambda state: state["at_work"] is None and state["is_settled"], "the end of the work")
        self.assertEqual((state["path"], state["curve_count"], state["dialog"]), ("", 0, "none"))

    def test_a_large_file_is_shown_once_it_is_read(self):
        path = self.folder / "large.json"
        path.write_text(json.dumps({**CUBIC, "ballast": "x" * 8000000}))
        editor = self.open_editor()
        self.open_file(editor, path)
        state = editor.wait(lambda state: state["path"] == str(path) and state["is_settled"], "the large file")
        self.assertEqual((state["dialog"], state["message"], state["curve_count"]), ("none", "Opened large.json", 1))

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
