"""The manual and the completions against the help: test_pages.py PROGRAM FOLDER, where FOLDER has gusset.1 and the rest."""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest


class Pages(unittest.TestCase):
    program = folder = None

    def run_program(self, *arguments):
        return subprocess.run([self.program, *arguments], capture_output=True, text=True, check=True).stdout

    def commands(self):
        """For each command its options, as its help has them."""
        listed = self.run_program("--help").split("Commands:\n")[1].split("\n\n")[0]
        names = [line.split()[0] for line in listed.splitlines() if re.match(r"  \w", line)]
        return {name: set(re.findall(r"(?m)^ {2,6}(?:-\w, )?(--[a-z][-a-z]*)", self.run_program(name, "--help"))) for name in names}

    def setUp(self):
        self.known = self.commands()
        self.assertEqual(list(self.known), ["join", "stitch", "fill", "repair", "unite", "weld", "sew", "orient", "align", "trim", "section", "loft", "flatten",
                                            "check", "convert", "info", "certify", "filters", "run"])
        self.assertLessEqual({"--meridians", "--rows", "--output", "--json", "--threads"}, self.known["stitch"])
        self.assertIn("--param", self.known["run"])

    def test_manual_names_all(self):
        page = (self.folder / "gusset.1").read_text().replace("\\-", "-")
        general = page.split(".SH COMMANDS")[0]
        for name, options in self.known.items():
            section = page.split(f".SS gusset {name}\n")[1].split(".S")[0]
            self.assertIn(f"Example: gusset {name} ", section)
            for option in options - {"--plugin"}:
                self.assertRegex(section, rf"(?m)^\\fB.*{option}\\fR", (name, option))
        self.assertIn("--plugin", general)
        for number in range(8):
            self.assertRegex(page, rf"(?m)^ +{number}  \w")
        self.assertNotIn("/work", page)

    def test_manual_is_sound(self):
        if shutil.which("groff") is None:
            self.skipTest("groff is missing")
        done = subprocess.run(["groff", "-man", "-ww", "-z", "-Tutf8", str(self.folder / "gusset.1")], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        shown = subprocess.run(["groff", "-man", "-Tascii", str(self.folder / "gusset.1")], capture_output=True, text=True).stdout
        self.assertIn("Joins, fills, mends and checks meshes in files", shown)

    def complete_in_bash(self, *words):
        """The completions that bash offers for the last word."""
        line = " ".join(f"'{word}'" for word in words)
        script = (f"PATH={pathlib.Path(self.program).parent}:$PATH; source {self.folder}/gusset.bash; COMP_WORDS=({line}); "
                  f"COMP_CWORD={len(words) - 1}; _gusset gusset '{words[-1]}' '{words[-2]}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
        done = subprocess.run(["bash", "-c", script], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return set(done.stdout.split())

    def test_bash(self):
        self.assertLessEqual(set(self.known) | {"--help", "--version", "--plugin"}, self.complete_in_bash("gusset", ""))
        for name, options in self.known.items():
            self.assertEqual(self.complete_in_bash("gusset", name, "--"),
                             {option for option in options if option.startswith("--")} | {"--plugin"}, name)
        self.assertEqual(self.complete_in_bash("gusset", "stitch", "a.ply", "--rows", ""), {"none", "by-mean-edge", "given-number"})
        self.assertEqual(self.complete_in_bash("gusset", "run", "wel"), {"weld"})
        self.assertIn("smooth_surface", self.complete_in_bash("gusset", "filters", ""))

    def test_zsh(self):
        if shutil.which("zsh") is None:
            self.skipTest("zsh is missing")
        done = subprocess.run(["zsh", "-n", str(self.folder / "_gusset")], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = (self.folder / "_gusset").read_text()
        for name, options in self.known.items():
            part = text.split(f"({name})\n")[1].split(";;")[0]
            for option in options:
                self.assertIn(option, part, name)

    def test_fish(self):
        if shutil.which("fish") is None:
            self.skipTest("fish is missing")
        script = f"set PATH {pathlib.Path(self.program).parent} $PATH; source {self.folder}/gusset.fish; complete -C "
        offered = lambda line: {row.split("\t")[0] for row in subprocess.run(
            ["fish", "--no-config", "-c", script + f"'{line}'"], capture_output=True, text=True, check=True).stdout.splitlines()}
        self.assertLessEqual(set(self.known), offered("gusset "))
        for name, options in self.known.items():
            self.assertLessEqual({option for option in options if option.startswith("--")}, offered(f"gusset {name} --"), name)
        self.assertEqual(offered("gusset stitch --rows "), {"none", "by-mean-edge", "given-number"})


if __name__ == "__main__":
    Pages.program, Pages.folder = sys.argv[1], pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
