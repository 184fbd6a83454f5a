"""Standard input and output, and files that cannot be read or written to their end."""

import json
import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from program import BINARY, environment, run, write_document

LINE = {"name": "line", "degree": 1, "knots": [0, 0, 2, 2], "points": [[0, 0], [3, 4]]}


def only_so_many_bytes(count):
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (count, count))
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)

    return limit


class Streams(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = write_document(self.folder / "line.json", LINE)
        self.text = self.file.read_text()

    def files(self):
        return sorted(os.listdir(self.folder))

    def test_a_minus_sign_is_standard_input(self):
        for arguments in (("info", "-"), ("eval", "-", "--at", 1), ("apply", "-", "arc-length"), ("check", "-")):
            named = run(*(self.file if word == "-" else word for word in arguments))
            piped = run(*arguments, input=self.text)
            self.assertEqual((piped.returncode, piped.stderr), (0, ""))
            self.assertEqual(piped.stdout, named.stdout.replace(str(self.file), "standard input"))
        error = run("info", "-", input=self.text[:-2])
        self.assertEqual((error.returncode, error.stdout), (1, ""))
        self.assertIn("standard input: line 1, column", error.stderr)

    def test_standard_input_goes_on_where_it_is(self):
        with open(self.folder / "behind.json", "w+b") as file:
            file.write(b"not JSON\n" + self.text.encode())
            file.flush()
            os.lseek(file.fileno(), 9, os.SEEK_SET)
            self.assertEqual(run("check", "-", stdin=file).returncode, 0)

    def test_standard_input_can_be_read_once(self):
        process = run("check", "-", self.file, "-", input=self.text)
        self.assertEqual((process.returncode, process.stdout), (2, ""))
        self.assertIn("only once", process.stderr)

    def test_a_minus_sign_is_standard_output(self):
        process = run("apply", "-", "reverse", "-o", "-", input=self.text)
        self.assertEqual(process.returncode, 0)
        (curve,) = json.loads(process.stdout)["curves"]
        self.assertEqual(curve["points"], [[3, 4], [0, 0]])
        self.assertIn("Reversed", process.stderr)
        process = run("new", "line", 0, 0, 3, 4, "arc-length", "--json", "-o", "-")
        self.assertEqual(len(json.loads(process.stdout)["curves"]), 1)
        self.assertEqual(json.loads(process.stderr)[1]["findings"][0]["length"], 5)
        refused = run("new", "line", 0, 0, 3, 4, "insert-knot", 7, "-o", "-")
        self.assertEqual((refused.returncode, refused.stdout), (1, ""))
        self.assertFalse((pathlib.Path.cwd() / "-").exists())

    def test_output_that_is_full_or_closed_ends_with_1(self):
        calls = (("info", self.file), ("eval", self.file, "--at", 1), ("apply", self.file, "reverse"), ("check", self.file), ("--help",),
                 ("--version",), ("apply", "--list"), ("new", "line", "-o", "-"), ("info", self.file, "--json"))
        for arguments in calls:
            with self.subTest(arguments), open("/dev/full", "w") as full:
                process = run(*arguments, stdout=full)
                self.assertEqual(process.returncode, 1)
                self.assertIn("standard output: the results cannot be written: No space left on device", process.stderr)
                process = run(*arguments, stdout=None, preexec_fn=lambda: os.close(1))
                self.assertEqual(process.returncode, 1)
                self.assertIn("standard output: the results cannot be written: Bad file descriptor", process.stderr)

    def test_output_that_nobody_reads_ends_with_1_and_silence(self):
        reader, writer = os.pipe()
        os.close(reader)
        process = run("apply", "--list", stdout=writer)
        os.close(writer)
        self.assertEqual((process.returncode, process.stderr), (1, ""))

    def test_long_output_is_told_once_when_it_cannot_be_written(self):
        count = 60000
        file = self.folder / "long.json"
        file.write_text(json.dumps({"format": "batten", "version": 1, "curves": [
            {"name": "long", "degree": 1, "knots": [0, *range(count), count - 1], "points": [[i, i % 2] for i in range(count)]}]}))
        whole = run("info", file).stdout
        self.assertGreater(len(whole), 1 << 20)
        self.assertIn(f"\n    {count // 2}\tmultiplicity 1\tC^0\n", whole)
        self.assertTrue(whole.endswith(f"\n    {count - 1}\tmultiplicity 2\n"))
        with open("/dev/full", "w") as full:
            process = run("info", file, stdout=full)
        self.assertEqual((process.returncode, process.stderr.count("the results cannot be written")), (1, 1))
        reader, writer = os.pipe()
        os.close(reader)
        process = run("info", file, stdout=writer)
        os.close(writer)
        self.assertEqual((process.returncode, process.stderr), (1, ""))

    def test_a_closed_stream_is_no_place_for_a_file(self):
        output = self.folder / "out.json"
        process = run("apply", self.file, "reverse", "-o", output, stdout=None, preexec_fn=lambda: os.close(1))
        self.assertEqual(process.returncode, 1)
        self.assertEqual(len(json.loads(output.read_text())["curves"]), 1)
        process = run("check", "-", stdin=None, preexec_fn=lambda: os.close(0))
        self.assertEqual(process.returncode, 1)
        self.assertIn("standard input: the file cannot be read: Bad file descriptor", process.stderr)

    def test_output_beyond_the_limit_of_file_sizes_ends_with_1(self):
        with open(self.folder / "list.txt", "w") as file:
            process = run("apply", "--list", stdout=file, preexec_fn=only_so_many_bytes(512))
        self.assertEqual(process.returncode, 1)
        self.assertIn("File too large", process.stderr)

    def test_saving_beyond_the_limit_leaves_the_old_file_and_no_other(self):
        before = self.files()
        process = run("apply", self.file, "reverse", "-o", self.file, preexec_fn=only_so_many_bytes(64))
        self.assertEqual(process.returncode, 1)
        self.assertIn("the file cannot be written: File too large", process.stderr)
        self.assertEqual((self.files(), self.file.read_text()), (before, self.text))

    def test_a_signal_while_saving_leaves_no_temporary_file(self):
        large = {**LINE, "knots": [0, *range(200000), 199999], "points": [[i, 0.1 * i] for i in range(200000)]}
        write_document(self.file, large)
        output = self.folder / "out.json"
        before = set(self.files())
        words = [BINARY, "apply", str(self.file), "normalize", "-o", str(output)]
        process = subprocess.Popen(words, env=environment(), stdout=subprocess.DEVNULL)
        while process.poll() is None and set(self.files()) == before:
            time.sleep(1e-4)
        process.send_signal(signal.SIGTERM)
        process.wait()
        self.assertLessEqual(set(self.files()) - before, {"out.json"})

    def test_what_cannot_be_read_to_its_end_is_a_sentence(self):
        for path, part in (("/proc/self/mem", "the file cannot be read: Input/output error"), ("/dev/zero", "zero byte"),
                           (self.folder, "this is a folder"), (self.folder / "none.json", "No such file")):
            for arguments in (("info", path), ("eval", path, "--at", 0), ("apply", path, "reverse"), ("check", path)):
                process = run(*arguments)
                self.assertEqual((process.returncode, process.stdout), (1, ""))
                self.assertTrue(process.stderr.startswith(f"{path}: "), process.stderr)
                self.assertIn(part, process.stderr)
                self.assertEqual(process.stderr.count("\n"), 1)

    def test_input_without_end_has_a_limit(self):
        for line, arguments, refusal in (("0 0", ("new", "polyline", "@-"), "standard input: there are more than 128 MiB"),
                                         ("[", ("info", "-"), "standard input: line 101, column 1: lists and objects are nested more than 100 deep"),
                                         ("x", ("info", "-"), "standard input: line 1, column 1: this is not JSON")):
            with subprocess.Popen(["yes", line], stdout=subprocess.PIPE) as endless:
                process = run(*arguments, stdin=endless.stdout)
                endless.stdout.close()
            self.assertEqual(process.returncode, 1)
            self.assertIn(refusal, process.stderr)

    def test_a_pipe_with_a_name_is_read(self):
        os.mkfifo(self.folder / "pipe")
        with subprocess.Popen(["cp", str(self.file), str(self.folder / "pipe")]):
            self.assertEqual(run("check", self.folder / "pipe").returncode, 0)

    def test_a_zero_byte_behind_the_document_is_refused(self):
        self.file.write_bytes(self.text.encode() + b"\n\0more")
        self.assertEqual(run("check", self.file).stderr,
                         f"{self.file}: line 2, column 1: this is not JSON: there is a zero byte, which no text has\n")

    def test_a_dangling_link_gets_its_target(self):
        link = self.folder / "link.json"
        link.symlink_to("target.json")
        self.assertEqual(run("apply", self.file, "reverse", "-o", link).returncode, 0)
        self.assertTrue(link.is_symlink())
        self.assertFalse((self.folder / "target.json").is_symlink())
        self.assertEqual(run("check", self.folder / "target.json").returncode, 0)


if __name__ == "__main__":
    unittest.main()
