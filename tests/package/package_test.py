"""Installs a build into a folder of its own and uses the core from there, as another project does: package_test.py BUILD."""

import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "e2e"))
from driver import Display, Editor  # noqa: E402

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
WORK = BUILD / "tests" / "package" / "work"
PREFIX = WORK / "prefix"
CACHE = dict(re.findall(r"^([A-Za-z0-9_]+):\w+=(.*)$", (BUILD / "CMakeCache.txt").read_text(), re.M))
IS_ON = {name: value.upper() in ("ON", "TRUE", "1", "YES") for name, value in CACHE.items()}

# What the project is built with and the core does not need once it is built.
NOT_NEEDED = ("Eigen3", "nlohmann_json", "CLI11", "glfw3", "OpenGL", "imgui", "GTest", "rapidcheck", "PkgConfig")


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def expected_files():
    core = ["share/doc/batten/LICENSE", "include/batten/core/base/version.h", "include/batten/core/curve/curve.h"]
    program = ["bin/batten", *(f"share/batten/examples/{file.name}" for file in (HERE / "../../assets/examples").glob("*.*")), "share/batten/batten.schema.json"]
    manual = ["share/man/man1/batten.1"]
    window = ["share/applications/batten.desktop", "share/icons/hicolor/scalable/apps/batten.svg"]
    has_program = IS_ON["BATTEN_PROGRAM"]
    has_opencascade = has_program and (BUILD / "app/batten-occt").is_file()
    has_manual = has_program and not CACHE["HELP2MAN"].endswith("NOTFOUND")
    opencascade = ["libexec/batten/batten-occt"]
    return core + has_program * program + has_opencascade * opencascade + has_manual * manual + (has_program and IS_ON["BATTEN_WINDOW"]) * window


class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        os.environ.pop("DESTDIR", None)
        run(CACHE["CMAKE_COMMAND"], "--install", BUILD, "--prefix", WORK / "elsewhere")
        (WORK / "elsewhere").rename(PREFIX)  # the package must not remember where it was installed

    def test_installs_all_that_belongs_to_the_program_and_the_core(self):
        for file in expected_files():
            with self.subTest(file):
                self.assertTrue((PREFIX / file).is_file())

    def test_installs_no_header_of_what_the_core_hides(self):
        headers = list((PREFIX / "include").rglob("*.h"))
        self.assertGreater(len(headers), 50)
        for header in headers:
            for name in re.findall(r"#include <(\w+)/", header.read_text()):
                self.assertIn(name, ("glm", "tl"), header)

    def test_installs_a_program_that_knows_its_version(self):
        if not IS_ON["BATTEN_PROGRAM"]:
            self.skipTest("the program is not built")
        self.assertEqual(run(PREFIX / "bin/batten", "--version"), f"batten {CACHE['CMAKE_PROJECT_VERSION']}\n")

    def test_installs_a_program_that_finds_its_examples(self):
        if not (IS_ON["BATTEN_PROGRAM"] and IS_ON["BATTEN_WINDOW"]):
            self.skipTest("the window is not built")
        examples = PREFIX / "share/batten/examples"
        shutil.copy(next(examples.glob("*.json")), examples / "only-here.json")
        with Display() as display, Editor(PREFIX / "bin/batten", display, WORK, ["--example", "only-here"]) as editor:
            self.assertGreater(len(editor.state()["points"]), 0)

    def test_serves_another_project(self):
        sanitizers = "-fsanitize=address,undefined" if IS_ON["BATTEN_SANITIZE"] else ""
        given = ["CMAKE_CXX_COMPILER", "CMAKE_MAKE_PROGRAM", "CMAKE_TOOLCHAIN_FILE"]
        settings = {name: CACHE[name] for name in given if name in CACHE}
        settings["CMAKE_PREFIX_PATH"] = ";".join([str(PREFIX), CACHE.get("CMAKE_PREFIX_PATH", "")])
        settings["CMAKE_CXX_FLAGS"] = f"{CACHE['CMAKE_CXX_FLAGS']} {sanitizers}"
        settings["CMAKE_EXE_LINKER_FLAGS"] = CACHE["CMAKE_EXE_LINKER_FLAGS"]
        settings["BATTEN_VERSION"] = CACHE["CMAKE_PROJECT_VERSION"]
        settings |= {f"CMAKE_DISABLE_FIND_PACKAGE_{name}": "ON" for name in NOT_NEEDED}
        definitions = [f"-D{name}={value}" for name, value in settings.items()]
        run(CACHE["CMAKE_COMMAND"], "-S", HERE, "-B", WORK / "build", "-G", CACHE["CMAKE_GENERATOR"], *definitions)
        run(CACHE["CMAKE_COMMAND"], "--build", WORK / "build", "--parallel", "2")

        printed = run(WORK / "build/quarter_circle")
        match = re.fullmatch(r"4 control points\nC\(0\.5\) = \(([\d.]+), ([\d.]+)\)\nlength ([\d.]+)\n", printed)
        self.assertTrue(match, printed)
        for found, exact in zip(match.groups(), (math.sqrt(0.5), math.sqrt(0.5), math.pi / 2)):
            self.assertAlmostEqual(float(found), exact, delta=1e-14)


if __name__ == "__main__":
    unittest.main(verbosity=2)
