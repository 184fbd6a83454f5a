"""Files that are wrong, damaged, endless or meant to do harm: each is refused in one sentence that names the place, within a second and in bounded
memory, and nothing but the named file is read. What the JSON Schema can tell it refuses, too.

With BATTEN_SECONDS=1 in the environment every refusal must come within so many seconds; else it may take thirty, since tests are built without optimization."""

import json
import os
import pathlib
import resource
import subprocess
import tempfile
import time
import unittest

import jsonschema

from program import BINARY, environment

ROOT = pathlib.Path(__file__).parents[2]
SCHEMA = json.loads((ROOT / "assets/batten.schema.json").read_text())
EVERYTHING = (ROOT / "tests/data/versions/2026-11-everything.json").read_text()
IS_SANITIZED = os.environ["BATTEN_SANITIZED"] == "1"
MOST_SECONDS = float(os.environ.get("BATTEN_SECONDS", 30))
MOST_MEMORY = 1 << 30

CURVE = {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[0, 0], [1, 2], [2, 0]]}


def document(**members):
    return json.dumps({"format": "batten", "version": 1, **members}).encode()


def curve(**members):
    return document(curves=[{**CURVE, **members}])


def fit(**members):
    return curve(fit={"kind": "c2", "points": [[0, 0], [1, 1]], "parameters": [0, 1], **members})


def spliced(member, text):
    """A document whose member has a value that json would not write."""
    return document(**{member: "HERE"}).replace(b'"HERE"', text)


def in_curve(member, text):
    return curve(**{member: "HERE"}).replace(b'"HERE"', text)


# By name: the bytes, and parts of the sentence.
BY_SYNTAX = {
    "nothing": (b"", "line 1, column 1"),
    "blanks alone": (b" \n \n", "line 3, column 1"),
    "no JSON": (b"knots", "line 1, column"),
    "a PNG picture": ((ROOT / "tests/data/pictures/ring_gray.png").read_bytes(), "line 1, column 1"),
    "random bytes": (bytes((i * 7919 + i * i) % 255 + 1 for i in range(10000)), "line 1, column"),
    "a zero byte": (b'{"format": "batten"\0}', "line 1, column 20: this is not JSON: there is a zero byte"),
    "UTF-16 with its mark": (document().decode().encode("utf-16"), "line 1, column"),
    "UTF-16 without": (document().decode().encode("utf-16-le"), "line 1, column 2"),
    "UTF-32": (document().decode().encode("utf-32-le"), "line 1, column 2"),
    "half a byte order mark": (b"\xef\xbb" + document(), "line 1, column"),
    "not UTF-8": (spliced("title", b'"\xff"'), "line 1, column"),
    "an overlong slash": (spliced("title", b'"\xc0\xaf"'), "line 1, column"),
    "a lone high surrogate": (spliced("title", b'"\\ud834"'), "line 1, column"),
    "a lone low surrogate": (spliced("title", b'"\\udd1e"'), "line 1, column"),
    "surrogates as UTF-8": (spliced("title", b'"\xed\xa0\x80"'), "line 1, column"),
    "a control character in a text": (spliced("title", b'"a\tb"'), "line 1, column"),
    "NaN": (in_curve("knots", b"[0,0,0,1,1,NaN]"), "line 1, column"),
    "Infinity": (in_curve("weights", b"[1,1,Infinity]"), "line 1, column"),
    "a number beyond doubles": (in_curve("knots", b"[0,0,0,1,1,1e309]"), "the number is too large; numbers must be finite"),
    "an exponent beyond integers": (in_curve("knots", b"[0,0,0,1,1,1e99999999999999999999]"), "the number is too large"),
    "a number of a million digits": (in_curve("knots", b"[0,0,0,1,1," + b"9" * 10**6 + b"]"), "the number is too large"),
    "a leading zero": (in_curve("knots", b"[00,0,0,1,1,1]"), "line 1, column"),
    "a hexadecimal number": (in_curve("knots", b"[0,0,0,1,1,0x1]"), "line 1, column"),
    "a decimal comma": (in_curve("points", b"[[0,5,1]]"), "/curves/0/points/0"),
    "single quotes": (b"{'format': 'batten'}", "line 1, column 2"),
    "a comment": (b"// curves\n{}", "line 1, column 1"),
    "a comma at the end": (b'{"format": "batten", "version": 1,}', "line 1, column 35"),
    "two documents": (document() + document(), "line 1, column 35"),
    "a doubled member": (b'{"format": "batten", "format": "batten", "version": 1}', 'line 1, column 29: the member "format" occurs twice'),
    "doubled knots": (document(curves=[{}]).replace(b"{}", b'{"degree": 1, "knots": [0,0,1,1], "knots": [0,0,2,2]}'), 'the member "knots" occurs twice'),
    "nesting of lists": (b"[" * 100_000, "line 1, column 101: lists and objects are nested more than 100 deep"),
    "nesting in a member": (spliced("x", b"[" * 100_000 + b"]" * 100_000), "nested more than 100 deep"),
    "nesting of objects": (b'{"a":' * 100_000, "line 1, column 501: lists and objects are nested"),
    "nesting in knots": (in_curve("knots", b"[0,0," + b"[" * 100_000), "nested more than 100 deep"),
    "members without end": (b'{"format": "batten", ' + b",".join(b'"m%d": 1' % i for i in range(10**6)) + b"}", "more than 10000 members"),
    "values without end": (spliced("x", b"[" + b"0," * 5_000_000 + b"0]"), "more than 4000000 values"),
    "empty lists without end": (spliced("x", b"[" + b"[]," * 5_000_000 + b"[]]"), "more than 4000000 values"),
    "a text without end": (spliced("title", b'"' + b"x" * (17 << 20) + b'"'), "beside the numbers of curves there are more than 16 MiB"),
    "a name without end": (b'{"' + b"n" * (17 << 20) + b'": 1}', "more than 16 MiB"),
    "blanks without end": (b" " * (17 << 20) + b"{}", "more than 16 MiB"),
    "doubled long names": (b'{"' + b"n" * 10**6 + b'": 1, "' + b"n" * 10**6 + b'": 1}', "occurs twice"),
    "an open text": (b'{"format": "batten', "line 1, column"),
    "cut in half": (EVERYTHING[: len(EVERYTHING) // 2].encode(), "line "),
}

# These are JSON, of which the schema can tell that it is no document.
BY_SCHEMA = {
    "a list": (b"[]", "found a list of 0 items, but it must be an object"),
    "a number": (b"7", "found 7, but it must be an object"),
    "null": (b"null", "found null"),
    "a text of a megabyte": (json.dumps("x" * 10**6).encode(), "found a text of 1000000 bytes"),
    "another format": (json.dumps({"format": "svg", "version": 1}).encode(), "/format"),
    "no format": (b'{"version": 1}', 'the member "format" is missing'),
    "a later version": (json.dumps({"format": "batten", "version": 2}).encode(), "/version: version 2 of the format is not known"),
    "no version": (b'{"format": "batten"}', 'the member "version" is missing'),
    "a title that is none": (document(title=5), "/title"),
    "curves that are none": (document(curves={}), "/curves: found an object, but it must be a list of curves"),
    "a million empty curves": (document(curves=[{}] * 10**6), '/curves/0: the member "degree" is missing'),
    "a million numbers for curves": (document(curves=[1] * 10**6), "/curves/0: found 1, but it must be an object"),
    "no degree": (document(curves=[{name: CURVE[name] for name in ("knots", "points")}]), '/curves/0: the member "degree" is missing'),
    "no knots": (document(curves=[{name: CURVE[name] for name in ("degree", "points")}]), 'the member "knots" is missing'),
    "no points": (document(curves=[{name: CURVE[name] for name in ("knots", "degree")}]), 'the member "points" is missing'),
    "degree 0": (curve(degree=0), "/curves/0/degree"),
    "degree 26": (curve(degree=26), "/curves/0/degree"),
    "degree 2.5": (curve(degree=2.5), "/curves/0/degree: the degree is not a whole number"),
    "degree 1e308": (curve(degree=1e308), "/curves/0/degree"),
    "a degree in words": (curve(degree="two"), '/curves/0/degree: found "two"'),
    "knots that are one number": (curve(knots=0), "/curves/0/knots: found 0, but it must be a list"),
    "a knot that is none": (curve(knots=[0, 0, 0, 1, 1, "1"]), "/curves/0/knots/5"),
    "a null among the knots": (curve(knots=[0, 0, 0, None, 1, 1]), "/curves/0/knots/3"),
    "a point of three coordinates": (curve(points=[[0, 0], [1, 2, 3], [2, 0]]), "/curves/0/points/1"),
    "a point of one": (curve(points=[[0, 0], [1], [2, 0]]), "/curves/0/points/1"),
    "a point that is an object": (curve(points=[[0, 0], {"x": 1, "y": 2}, [2, 0]]), "/curves/0/points/1: found an object"),
    "a coordinate that is none": (curve(points=[[0, 0], [1, True], [2, 0]]), "/curves/0/points/1/1"),
    "no points at all": (curve(points=[]), "/curves/0/points"),
    "a weight of zero": (curve(weights=[1, 0, 1]), "/curves/0/weights/1"),
    "a negative weight": (curve(weights=[1, 1, -1]), "/curves/0/weights/2"),
    "an unknown kind": (curve(kind="bspline"), "/curves/0/kind"),
    "periodic in words": (curve(periodic="yes"), "/curves/0/periodic"),
    "tears in numbers": (curve(tears=1), "/curves/0/tears"),
    "a color by name": (curve(color="red"), "/curves/0/color"),
    "a color of three digits": (curve(color="#fff"), "/curves/0/color"),
    "a name that is none": (curve(name=None), "/curves/0/name"),
    "a group that is none": (curve(group=1), "/curves/0/group"),
    "a pinned point before the first": (curve(pinned=[-1]), "/curves/0/pinned/0"),
    "half a pinned point": (curve(pinned=[0.5]), "/curves/0/pinned/0"),
    "a fit without points": (curve(fit={"kind": "c2", "parameters": [0, 1]}), "/curves/0/fit"),
    "a fit of an unknown kind": (fit(kind="c3"), "/curves/0/fit/kind"),
    "a fit of one point": (fit(points=[[0, 0]], parameters=[0]), "/curves/0/fit/points"),
    "an unknown parametrization": (fit(parametrization="arc"), "/curves/0/fit/parametrization"),
    "an unknown joint of a fit": (fit(joints=["smooth", "round"]), "/curves/0/fit/joints/1"),
    "a handle of one number": (fit(handles=[[0, 0], [1]]), "/curves/0/fit/handles/1"),
    "joints that are none": (curve(joints={}), "/curves/0/joints"),
    "a joint without its mark": (curve(joints=[{"u": 0.5}]), '/curves/0/joints/0: the member "mark" is missing'),
    "a joint of an unknown mark": (curve(joints=[{"u": 0.5, "mark": "sharp"}]), "/curves/0/joints/0/mark"),
    "a joint nowhere": (curve(joints=[{"mark": "corner"}]), "/curves/0/joints/0"),
    "a joint of an end without a number": (curve(joints=[{"mark": "corner", "end": "start"}]), "/curves/0/joints/0"),
    "a joint of an unknown end": (curve(joints=[{"mark": "corner", "end": "middle", "joint": 1}]), "/curves/0/joints/0/end"),
    "a symmetry without its center": (curve(symmetry={"group": 0, "place": 0, "mirror": 90}), "/curves/0/symmetry"),
    "a symmetry of one turn": (curve(symmetry={"group": 0, "place": 0, "center": [0, 0], "turns": 1}), "/curves/0/symmetry/turns"),
    "a third mirror image": (curve(symmetry={"group": 0, "place": 2, "center": [0, 0], "mirror": 0}), "/curves/0/symmetry/place"),
    "a picture without its path": (document(pictures=[{"width": 1, "height": 1}]), "/pictures/0"),
    "a picture of no pixels": (document(pictures=[{"path": "a.png", "width": 0, "height": 1}]), "/pictures/0/width"),
    "a picture of a billion pixels": (document(pictures=[{"path": "a.png", "width": 10**9, "height": 1}]), "/pictures/0/width"),
    "a picture of no size": (document(pictures=[{"path": "a.png", "width": 1, "height": 1, "scale": 0}]), "/pictures/0/scale"),
    "a picture beyond opaque": (document(pictures=[{"path": "a.png", "width": 1, "height": 1, "opacity": 1.5}]), "/pictures/0/opacity"),
    "a guide without its point": (document(guides=[{"angle": 0}]), "/guides/0"),
    "a guide of 180 degrees": (document(guides=[{"point": [0, 0], "angle": 180}]), "/guides/0/angle"),
    "units without a unit": (document(units={"scale": 1}), '/units: the member "unit" is missing'),
    "unknown units": (document(units={"unit": "ell"}), "/units/unit"),
    "units without size": (document(units={"unit": "mm", "scale": 0}), "/units/scale"),
    "a view that is none": (document(view=[]), "/view"),
    "a parameter that is none": (document(view={"parameter": "half"}), "/view/parameter"),
    "overlays that are one": (document(view={"overlays": "polygon"}), "/view/overlays"),
    "notation that is none": (document(view={"notation": {"points": 1}}), "/view/notation/points"),
}

# These fit the schema; only the program knows better.
BY_NUMBERS = {
    "too few knots": (curve(knots=[0, 0, 0, 1, 1]), "/curves/0/knots: 5 knots were found; 6 are needed"),
    "too many knots": (curve(knots=[0, 0, 0, 1, 1, 1, 1]), "/curves/0/knots"),
    "descending knots": (curve(knots=[0, 0, 0, 1, 0.5, 1]), "/curves/0/knots/4: knot 4 is 0.5, less than knot 3, which is 1"),
    "a million descending knots": (curve(knots=list(range(10**6, 0, -1)), points=[[0, 0]] * (10**6 - 3)), "/curves/0/knots/1"),
    "a descent at the end": (curve(knots=[*range(10**6), 0], points=[[i, 0] for i in range(10**6 - 2)]), "/curves/0/knots/1000000"),
    "an empty domain": (curve(knots=[0] * 6), "/curves/0/knots: the domain begins and ends at 0"),
    "knots too far apart": (curve(knots=[-1e308, -1e308, -1e308, 1e308, 1e308, 1e308]), "/curves/0/knots"),
    "a knot too often": (curve(knots=[0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1], points=[[i, 0] for i in range(6)]), "/curves/0/knots/3"),
    "too few points": (curve(degree=3), "/curves/0/points"),
    "too few weights": (curve(weights=[1, 1]), "/curves/0/weights: 2 weights were found"),
    "a pinned point too many": (curve(pinned=[3]), "/curves/0/pinned/0: found 3, but it must be the index of a control point, 0 to 2"),
    "a joint at no knot": (curve(joints=[{"u": 0.5, "mark": "corner"}]), "/curves/0/joints/0/u"),
    "a joint that is not smooth": (curve(degree=1, knots=[0, 0, 1, 2, 2], joints=[{"u": 1, "mark": "smooth"}]), "/curves/0/joints/0/mark"),
    "a joint marked twice": (curve(degree=1, knots=[0, 0, 1, 2, 2], joints=[{"u": 1, "mark": "corner"}] * 2), "/curves/0/joints/1/u: the knot is marked twice"),
    "ends that do not meet": (document(curves=[{**CURVE, "joints": [{"end": end, "joint": 1, "mark": "corner"}]} for end in ("start", "end")]), "/curves/0/joints/0/mark"),
    "parameters that descend": (fit(parameters=[1, 0]), "/curves/0/fit/parameters"),
    "too few parameters": (fit(points=[[0, 0], [1, 1], [2, 0]]), "/curves/0/fit/parameters"),
    "a later knot list of a million": (document(curves=[CURVE] * 1000 + [{**CURVE, "knots": [0] * 10**6}]), "/curves/1000/knots"),
}

# By name: the table, and parts of the sentence.
TABLES = {
    "nothing": (b"", "no line with two numbers was found"),
    "words": (b"no numbers here\nnor here\n", "no line with two numbers was found"),
    "one column": (b"1\n2\n3\n", ""),
    "not a number": (b"x,y\n1,nan\n2,3\n4,5\n6,7\n", "line 2"),
    "infinity": (b"1,2\n3,inf\n5,6\n7,8\n", "line 2"),
    "beyond doubles": (b"1,2\n3,1e309\n5,6\n7,8\n", "line 2"),
    "an empty cell": (b"1,2\n,3\n5,6\n7,8\n", "line 2, column 1"),
    "a missing cell": (b"1,2\n3\n5,6\n7,8\n", "line 2"),
    "a zero byte": (b"1,2\n3,4\0\n5,6\n", ""),
    "UTF-16": ("1,2\n3,4\n".encode("utf-16"), ""),
    "a PNG picture": ((ROOT / "tests/data/pictures/ring_gray.png").read_bytes(), ""),
    "one line of a megabyte": (b"1," * 500_000 + b"x\n", ""),
    "a number of a million digits": (b"1,2\n3," + b"9" * 10**6 + b"\n5,6\n7,8\n", "line 2"),
    "a cell of a megabyte": (b"1,2\n3,4\n" + b"z" * 10**6 + b",4\n5,6\n7,8\n", "line 3"),
    "a million empty lines": (b"\n" * 10**6, "no line with two numbers was found"),
}


class BadInputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refused(self, *arguments, limit=None):
        """The sentence with which the program refuses, in time and in bounded memory."""
        def bound():
            if limit is not None:
                resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

        errors = self.folder / "errors"
        begin = time.monotonic()
        with open(errors, "wb") as stream:
            process = subprocess.Popen([BINARY, *map(str, arguments)], env=environment(), stdout=subprocess.DEVNULL, stderr=stream, preexec_fn=bound)
            _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        sentence = errors.read_bytes().decode()
        self.assertEqual(process.returncode, 1, sentence[:2000])
        self.assertEqual(sentence.count("\n"), 1, sentence[:2000])
        self.assertLess(len(sentence), 1000)
        self.assertLess(time.monotonic() - begin, MOST_SECONDS)
        if not IS_SANITIZED:
            self.assertLess(usage.ru_maxrss * 1024, MOST_MEMORY)
        return sentence

    def written(self, content):
        path = self.folder / "bad.json"
        path.write_bytes(content)
        return path

    def test_documents_are_refused_with_their_place(self):
        for name, (content, part) in {**BY_SYNTAX, **BY_SCHEMA, **BY_NUMBERS}.items():
            with self.subTest(input=name):
                self.assertIn(part, self.refused("check", self.written(content)))

    def test_the_schema_refuses_what_it_can_tell(self):
        validator = jsonschema.Draft202012Validator(SCHEMA)
        for name, (content, _) in BY_SCHEMA.items():
            if len(content) < 10**6:
                with self.subTest(input=name):
                    self.assertFalse(validator.is_valid(json.loads(content)))
        for name, (content, _) in BY_NUMBERS.items():
            if len(content) < 10**5:
                with self.subTest(input=name):
                    self.assertTrue(validator.is_valid(json.loads(content)))

    def test_tables_are_refused(self):
        for name, (content, part) in TABLES.items():
            with self.subTest(input=name):
                path = self.folder / "bad.csv"
                path.write_bytes(content)
                self.assertIn(part, self.refused("new", "polyline", f"@{path}"))

    @unittest.skipIf(IS_SANITIZED, "the sanitizers take all addresses for themselves")
    def test_a_file_larger_than_memory_is_a_sentence(self):
        count = 3_000_000
        path = self.folder / "large.json"
        with open(path, "w", encoding="utf-8") as file:
            file.write('{"format": "batten", "version": 1, "curves": [{"degree": 1, "knots": [0,')
            file.write(",".join(map(str, range(count))) + f',{count - 1}], "points": [' + ",".join(["[1,2]"] * count) + "]}]}")
        self.assertIn("memory", self.refused("check", path, limit=150 << 20))

    def test_nothing_but_the_named_file_is_read(self):
        # Whoever opens this waits until someone writes to it.
        os.mkfifo(self.folder / "picture.png")
        path = self.written(document(pictures=[{"path": "picture.png", "width": 1, "height": 1}, {"path": "/dev/zero", "width": 1, "height": 1}],
                                     curves=[{**CURVE, "$ref": "file:///etc/passwd"}], include="/etc/passwd", **{"$schema": "http://localhost:1/schema.json"}))
        for arguments in (("check", path), ("info", path), ("apply", path, "reverse", "-o", self.folder / "out.json")):
            self.assertEqual(subprocess.run([BINARY, *map(str, arguments)], env=environment(), timeout=60, check=False, capture_output=True).returncode, 0)

    def test_a_byte_order_mark_does_no_harm(self):
        path = self.written(b"\xef\xbb\xbf" + document())
        self.assertEqual(subprocess.run([BINARY, "check", str(path)], env=environment(), check=False, capture_output=True).returncode, 0)

    def test_the_list_is_as_long_as_told(self):
        told = (ROOT / "docs/reliability.md").read_text()
        self.assertIn(f"{len(BY_SYNTAX) + len(BY_SCHEMA) + len(BY_NUMBERS)} bad documents and {len(TABLES)} bad tables", told)


if __name__ == "__main__":
    unittest.main()
