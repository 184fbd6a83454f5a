"""What is left of a session that was killed, and how the next one offers it. BATTEN_WINDOW_KILLS sets how many are killed at random
moments, and BATTEN_WINDOW_SIGNALS how many are ended by signals while they save; 3 where it is not set."""

import json
import os
import random
import signal
import subprocess
import time
import unittest

from case import CUBIC, WindowTest

STEPS = 60


def edits_in(journal):
    """How many edits the last whole record of a journal tells of (app/editor/recovery/journal_format.h)."""
    content = journal.read_bytes()
    place, edits = 16, 0
    while place + 16 < len(content):
        body = content[place + 16:place + 16 + int.from_bytes(content[place:place + 8], "little")]
        length = at = 0
        while at == 0 or body[at - 1] >= 128:
            length |= (body[at] & 127) << 7 * at
            at += 1
        at += length  # the name of the file
        at += 1 + 40 * body[at] + 8  # its stamp, where it has one, and the time
        edits = int.from_bytes(body[at:at + 8], "little")
        place += 16 + len(body)
    return edits


class RecoveryTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.screen = self.display()
        self.config = self.folder / "config"

    def journals(self):
        return sorted((self.config / "state" / "batten" / "recovery").glob("*"))

    def begin(self, *arguments, **options):
        return self.start(self.screen, *arguments, config=self.config, **options)

    def duplicate(self, editor):
        before = editor.state()["undo_count"]
        editor.key("ctrl+d")
        editor.wait(lambda state: state["undo_count"] == before + 1 and state["is_settled"], "the step")

    def await_journal(self, editor, edits):
        """Waits until a journal tells of so many edits."""
        editor.wait_until(lambda: any(edits_in(journal) == edits for journal in self.journals() if journal.suffix == ".journal"), "the journal")

    def leave_unsaved(self, path=None, steps=2):
        """A session that ends with unsaved changes, all of which are in its journal."""
        with self.begin(path or self.path) as editor:
            for _ in range(steps):
                self.duplicate(editor)
            self.await_journal(editor, steps)
            editor.kill()

    def curves(self):
        return json.loads(self.path.read_text())["curves"]

    def test_the_next_start_offers_the_document(self):
        self.leave_unsaved()
        self.assertEqual(len(self.journals()), 1)
        with self.begin(self.path) as editor:
            state = editor.wait(lambda state: state["dialog"] == "recovery" and state["is_settled"], "the offer")
            self.assertTrue(state["widgets"]["recovery 0"]["value"].startswith("2 edits, the last today at "))
            editor.screenshot("offer")
            editor.key("Return")
            state = editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the document")
            self.assertEqual((state["path"], state["is_modified"], state["undo_count"]), (str(self.path), True, 0))
            self.assertEqual(state["message"], "Recovered wave.json; it is not saved yet")
            self.assertEqual(len(self.curves()), 1)
            editor.key("ctrl+s")
            editor.wait(lambda state: not state["is_modified"], "the saved document")
            self.assertEqual(len(self.curves()), 3)
            editor.wait_until(lambda: not self.journals(), "no journal")
        with self.begin() as editor:
            self.assertEqual(editor.state()["dialog"], "none")

    def test_several_documents_are_chosen_by_keys(self):
        other = self.folder / "other.json"
        other.write_text(json.dumps(CUBIC))
        self.leave_unsaved()
        with self.begin(other) as editor:
            editor.wait(lambda state: state["dialog"] == "recovery", "the offer")
            editor.key("Escape")
            editor.wait(lambda state: state["dialog"] == "none" and state["path"] == str(other), "the other document")
            self.duplicate(editor)
            self.await_journal(editor, 1)
            editor.kill()
        with self.begin("--example", "wave") as editor:
            editor.wait(lambda state: state["dialog"] == "recovery" and state["widgets"].get("recovery 0", {}).get("value") == "chosen", "the list")
            editor.key("Down")
            editor.wait(lambda state: state["widgets"]["recovery 1"]["value"] == "chosen", "the second document")
            editor.screenshot("list")
            editor.key("Tab", "Tab")
            editor.key("space")
            editor.wait(lambda state: state["dialog"] == "none", "the document kept for later")
            self.choose_recovery(editor)
            editor.key("Tab")
            editor.key("Return")
            editor.wait(lambda state: "recovery 1" not in state["widgets"] and state["is_settled"], "one document less")
            self.assertEqual(len(self.journals()), 1)
            editor.key("Escape")
            editor.wait(lambda state: state["dialog"] == "none", "no dialog")

    def choose_recovery(self, editor):
        editor.click_widget("menu file")
        editor.click_widget("menu-item show-recovery")
        editor.wait(lambda state: state["dialog"] == "recovery" and state["is_settled"], "the offer")

    def test_a_session_that_ends_well_leaves_nothing(self):
        with self.begin(self.path) as editor:
            self.duplicate(editor)
            editor.wait_until(lambda: len(self.journals()) == 1, "the journal")
        self.assertEqual(self.journals(), [])

    def test_two_sessions_leave_each_other_alone(self):
        with self.begin(self.path) as first:
            self.duplicate(first)
            first.wait_until(lambda: len(self.journals()) == 1, "the journal")
            with self.begin("--example", "wave") as second:
                self.assertEqual(second.state()["dialog"], "none")
                self.assertEqual(len(self.journals()), 1)

    def test_a_file_that_another_program_changed_is_not_overwritten(self):
        with self.begin(self.path) as editor:
            self.duplicate(editor)
            self.path.write_text("precious")
            editor.key("ctrl+s")
            editor.wait(lambda state: state["dialog"] == "changed-file" and state["is_settled"], "the question")
            editor.screenshot("changed")
            editor.key("Escape")
            editor.wait(lambda state: state["dialog"] == "none" and state["is_modified"], "the document")
            self.assertEqual(self.path.read_text(), "precious")
            editor.key("ctrl+s")
            editor.wait(lambda state: state["dialog"] == "changed-file" and state["is_settled"], "the question")
            editor.key("Return")
            editor.wait(lambda state: state["dialog"] == "save-file", "the dialog for another file")
            editor.key("Escape")
            editor.wait(lambda state: state["dialog"] == "none", "no dialog")
            editor.key("ctrl+s")
            editor.click_widget("dialog overwrite")
            editor.wait(lambda state: not state["is_modified"], "the saved document")
            self.assertEqual(len(self.curves()), 2)

    def temporary_files(self):
        return [path for path in self.folder.iterdir() if path.name.startswith(".batten-")]

    def end_while_saving(self, number, moments):
        """Ends a session by the signal at a random moment after it began to write its file. Returns whether the file is the new one."""
        self.path.write_text(self.long_document)
        with self.begin(self.path) as editor:
            self.duplicate(editor)
            subprocess.run(["xdotool", "key", "ctrl+s"], env=editor.environment, check=True)
            editor.wait_until(lambda: self.temporary_files() or len(self.path.read_text()) > 1.5 * len(self.long_document), "saving")
            time.sleep(moments.uniform(0.0, 0.05))
            editor.process.send_signal(number)
            editor.process.wait()
            self.assertEqual(editor.process.returncode, -number, editor.error_text())
            self.assertEqual(editor.error_text(), "")
            editor.is_killed = True
        self.assertEqual(self.temporary_files(), [])
        count = len(self.curves())
        with self.begin("--example", "wave") as editor:
            state = editor.settle()
            self.assertEqual(state["dialog"], "none" if count == 2 else "recovery")
        for journal in self.journals():
            journal.unlink()
        return count == 2

    def test_signals_leave_the_old_file_or_the_new_one_and_nothing_else(self):
        count = 40_000
        points = [[0.01 * i, 0.5 * (i % 7)] for i in range(count)]
        curve = {"name": "long", "degree": 1, "knots": [0, *range(count), count - 1], "points": points}
        self.long_document = json.dumps({"format": "batten", "version": 1, "curves": [curve]})
        moments = random.Random(int(os.environ.get("BATTEN_KILL_SEED", 1)))
        ends = int(os.environ.get("BATTEN_WINDOW_SIGNALS", 3))
        saved = sum(self.end_while_saving([signal.SIGTERM, signal.SIGHUP, signal.SIGINT][i % 3], moments) for i in range(ends))
        print(f"{ends} windows were ended while they saved; {saved} had saved")

    def test_a_signal_leaves_what_is_unsaved_to_the_next_start(self):
        with self.begin(self.path) as editor:
            for _ in range(3):
                self.duplicate(editor)
            editor.process.terminate()  # at once: the journal is written on the way out
            editor.process.wait()
            self.assertEqual(editor.process.returncode, -signal.SIGTERM)
            editor.is_killed = True
        self.assertEqual([edits_in(journal) for journal in self.journals()], [3])

    def sync(self):
        """Has the disk write a byte, as the journal does with its records."""
        with open(self.folder / "clock", "wb") as file:
            file.write(b"x")
            file.flush()
            os.fsync(file.fileno())

    def kill_at_random(self, moments, all_curves):
        """Kills a session that duplicates its curve again and again. Returns how many steps came back. What is a second old when it is
        killed must be among them, by a clock that stands still while others have the processor or the disk: of each look at the
        session, which takes a few milliseconds, 20 count at most."""
        self.path.write_text(json.dumps(CUBIC))
        told = []
        with self.begin(self.path) as editor:
            keys = subprocess.Popen(["xdotool", "key", "--delay", "40", *["ctrl+d"] * STEPS], env=editor.environment)
            now = time.monotonic()
            end = now + moments.uniform(0.2, 4.0)
            age = 0.0  # of the session, by that clock
            while now < end:
                told.append((age, editor.state()["undo_count"]))
                self.sync()
                time.sleep(0.005)
                before, now = now, time.monotonic()
                age += min(now - before, 0.02)
            editor.kill()
            keys.kill()
            keys.wait()
            subprocess.run(["xdotool", "keyup", "d", "keyup", "ctrl"], env=editor.environment, check=True)  # that may still be held
        due = max([count for when, count in told if when <= age - 1], default=0)
        with self.begin("--example", "wave") as editor:
            state = editor.settle()
            if state["dialog"] != "recovery":
                self.assertEqual(due, 0)
                return 0
            editor.key("Return")
            editor.wait(lambda state: state["dialog"] == "none" and state["is_modified"] and state["is_settled"], "the document")
            editor.key("ctrl+s")
            editor.wait(lambda state: not state["is_modified"], "the saved document")
        found = self.curves()
        self.assertGreaterEqual(len(found) - 1, due)
        self.assertEqual(found, all_curves[:len(found)])
        self.assertEqual(self.journals(), [])
        return len(found) - 1

    def test_no_kill_loses_what_is_older_than_a_second(self):
        with self.begin(self.path) as editor:
            editor.key(*["ctrl+d"] * STEPS)
            editor.wait(lambda state: state["undo_count"] == STEPS, "all steps")
            editor.key("ctrl+s")
            editor.wait(lambda state: not state["is_modified"], "the saved document")
        all_curves = self.curves()
        moments = random.Random(int(os.environ.get("BATTEN_KILL_SEED", 1)))
        kills = int(os.environ.get("BATTEN_WINDOW_KILLS", 3))
        came_back = [self.kill_at_random(moments, all_curves) for _ in range(kills)]
        print(f"{kills} windows were killed; {min(came_back)} to {max(came_back)} of {STEPS} steps had been made and came back")


if __name__ == "__main__":
    unittest.main()
