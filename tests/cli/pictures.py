#!/usr/bin/env python3
"""`--plot`: the pictures are drawn, whole or not at all, the same every time, and can be told apart in grey."""
import itertools
import json
import os
import re
import shutil
import xml.etree.ElementTree as ElementTree

from program import EXAMPLES, Case, ink_named, main, need

need("gnuplot")

KINDS = ("overview", "profile", "exit", "cell", "nomogram")
SVG = "{http://www.w3.org/2000/svg}"


def channels(colour):
    """Red, green and blue as amounts of light."""
    shares = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in shares]


def lightness(light):
    y = 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


# Machado, Oliveira, Fernandes (2009), severity 1: what is left of a colour.
BLINDNESS = {
    "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}


def lab(light):
    """CIE L*a*b*, D65."""
    r, g, b = (min(max(c, 0.0), 1.0) for c in light)
    xyz = (
        (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047,
        0.2126 * r + 0.7152 * g + 0.0722 * b,
        (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883,
    )
    f = [v ** (1 / 3) if v > 0.008856 else 7.787 * v + 16 / 116 for v in xyz]
    return 116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])


def distance(a, b):
    return sum((p - q) ** 2 for p, q in zip(lab(a), lab(b))) ** 0.5


class Pictures(Case):
    def svg(self, name="p.svg"):
        return ElementTree.fromstring(self.read(name))

    def texts(self, name="p.svg"):
        return ["".join(t.itertext()) for t in self.svg(name).iter(SVG + "text")]

    def test_every_kind_is_an_svg_with_curves_and_without_nan(self):
        for kind in KINDS:
            self.call("-q", "--plot", "p.svg", "--plot-kind", kind)
            paths = [p for p in self.svg().iter(SVG + "path") if p.get("d")]
            self.assertGreater(len(paths), 10, kind)
            self.assertNotRegex(self.read("p.svg").decode().lower(), r"\bnan\b|\binf\b", kind)

    def test_the_same_question_gives_the_same_bytes(self):
        self.call("-q", "--plot", "a.svg")
        self.call("-q", "--plot", "b.svg", "-j", "1", env={"LC_ALL": "de_DE.UTF-8", "GNUTERM": "dumb", "HOME": "/"})
        self.assertEqual(self.read("a.svg"), self.read("b.svg"))

    def test_png_and_pdf_are_what_they_say(self):
        self.call("-q", "--plot", "p.png", "--plot-kind", "exit")
        self.assertEqual(self.read("p.png")[:8], b"\x89PNG\r\n\x1a\n")
        self.call("-q", "--plot", "P.PDF", "--plot-kind", "exit")
        self.assertEqual(self.read("P.PDF")[:5], b"%PDF-")
        self.assertIn(b"%%EOF", self.read("P.PDF")[-32:])

    def test_the_terminal_shows_a_picture_of_its_width(self):
        text = self.call("-q", "--plot", "-")
        self.assertIn("Stress through the exit", text)
        picture = text[text.index("Stress through the exit") :]
        self.assertLessEqual(max(len(line) for line in picture.splitlines()), 80)
        self.assertIn("*", picture)

    def test_the_answer_is_printed_as_without_a_picture(self):
        self.assertEqual(self.call("--json"), self.call("--json", "--plot", "p.svg"))

    def test_units_are_those_of_the_lab(self):
        self.call("-q", "--plot", "p.svg", "--plot-kind", "profile")
        self.assertIn("velocity [mm/s]", self.texts())
        self.assertIn("distance from the axis [µm]", self.texts())

    def test_cells_are_to_scale(self):
        """The circle of a cell of 8 µm is 8/50 as wide as the axis to the wall."""
        self.call("-q", "--plot", "p.svg", "--plot-kind", "cell", "--offset", "0")
        numbers = re.compile(r"-?\d+(?:\.\d+)?")
        for x_of in (0, 1):  # outlines are closed paths; the cell at rest is the roundest
            spans = []
            for path in self.svg().iter(SVG + "path"):
                values = list(map(float, numbers.findall(path.get("d") or "")))
                if len(values) > 150:
                    spans.append(max(values[x_of::2]) - min(values[x_of::2]))
            self.assertGreater(len(spans), 4)

    def test_a_sweep_draws_the_values_of_get_over_its_longest_list(self):
        self.call("-q", "--alpha", "0:0.9:0.3", "--velocity", "1mm/s,5mm/s", "--plot", "p.svg")
        self.assertIn("α, how strongly the ink thins", self.texts())
        self.assertIn("velocity 5 mm/s", self.texts())
        self.call("-q", "--alpha", "0:0.9:0.3", "--velocity", "1:9:2mm/s", "--plot", "p.svg")
        self.assertIn("velocity [mm/s]", self.texts())
        self.assertIn("α 0.3", self.texts())
        self.call("-q", "--radius", "50:100:10um", "--get", "nozzle.pressure_gradient", "--plot", "p.svg")
        self.assertIn("nozzle.pressure_gradient [MPa/m]", self.texts())
        self.assertIn("radius [µm]", self.texts())

    def test_an_angle_has_its_unit_at_the_axis(self):
        self.call("-q", "--velocity", "1:3:1mm/s", "--get", "cells.4.angle", "--plot", "p.svg")
        self.assertIn("cells.4.angle [rad]", self.read("p.svg").decode())

    def test_names_are_points_and_rows_without_an_answer_gaps(self):
        self.call("-q", "--ink", "alginate-2.5,alginate-2-25C", "--plot", "p.svg")
        self.assertIn("alginate-2-25C", self.texts())
        self.call("-q", "--alpha", "0.5,0.9,1.3", "--plot", "p.svg", status=6)

    def test_a_simulation_is_drawn_against_its_prediction(self):
        self.call("-q", "--simulate=exit-flow", "--fidelity", "draft", "--plot", "p.svg")
        self.assertIn("predicted", self.texts())
        self.assertIn("simulated", self.texts())

    def test_scenes_of_a_cell_have_a_picture(self):
        for scene in ("channel", "exit"):
            self.call("-q", f"--simulate={scene}", "--offset", "0", "--fidelity", "draft", "--plot", "p.svg")
            self.assertTrue(any(text.startswith("predicted") for text in self.texts()), scene)
            self.assertTrue(any(text.startswith("simulated") for text in self.texts()), scene)

    def test_a_fit_is_drawn_with_its_data_laws_and_residuals(self):
        shutil.copy(EXAMPLES / "flow-curve.csv", self.folder)
        self.call("fit", "-q", "flow-curve.csv", "--plot", "p.svg", "-o", "fit.txt")
        texts = self.texts()
        for words in ("measured", "left out as outliers", "cross", "viscosity [Pa s]", "shear rate [1/s]", "residual [%]"):
            self.assertIn(words, texts)
        self.assertTrue(any(text.startswith("carreau-yasuda (AICc") for text in texts), texts)
        self.assertNotRegex(self.read("p.svg").decode().lower(), r"\bnan\b|\binf\b")
        text = self.call("fit", "-q", "flow-curve.csv", "--plot", "-")
        self.assertIn("residual [%]", text)
        for arguments, status, words in (
            (["--plot", "p.gif"], 2, ".svg, .png or .pdf"),
            (["--plot", "-", "--json"], 2, "--output"),
            (["--plot", "none/p.svg"], 4, "create the directory"),
        ):  # fmt: skip
            self.call("fit", "-q", "flow-curve.csv", *arguments, status=status)
            self.assertIn(words, self.err)
            self.assertEqual(self.names(), ["fit.txt", "flow-curve.csv", "p.svg"])

    def test_a_fit_shows_the_best_law_by_its_name_over_residuals_of_the_same_axis(self):
        rows = "".join(f"{r:g},{0.3 + 50 / (1 + (3 * r) ** 0.9):g}\n" for r in (0.01 * 10 ** (i / 6) for i in range(31)))
        (self.folder / "floor.csv").write_text("rate [1/s],viscosity [Pa.s]\n" + rows)
        self.call("fit", "-q", "floor.csv", "--plot", "p.svg", "-o", "fit.txt")
        texts = self.texts()
        self.assertIn("floor: cross", texts)
        self.assertTrue(any(text.startswith("cross, eta_inf fitted (AICc -") for text in texts), texts)
        places = re.findall(r'translate\(([\d.]+),[\d.]+\)"[^>]*>\s*<text>1000<', self.read("p.svg").decode())
        self.assertEqual(len(places), 2, "an axis each")
        self.assertEqual(places[0], places[1])
        self.call("fit", "-q", "floor.csv", "--law", "carreau-yasuda", "--eta-inf", "fit", "--plot", "p.svg", "-o", "fit.txt")
        texts = self.texts()
        self.assertIn("floor: carreau-yasuda, eta_inf fitted", texts)
        self.assertTrue(any(text.startswith("--law carreau-yasuda --eta0 ") for text in texts), texts)

    def test_a_spread_is_drawn_where_one_was_asked_for(self):
        for kind, words in (("exit", "largest, 5 to 95 %"), ("profile", "cell (von Mises), 5 to 95 %"),
                            ("nomogram", "this print, 5 to 95 %")):  # fmt: skip
            self.call("-q", "--alpha", "0.75±0.05", "--samples", "32", "--plot", "p.svg", "--plot-kind", kind)
            self.assertIn(words, self.texts(), kind)
            self.call("-q", "--plot", "p.svg", "--plot-kind", kind)
            self.assertNotIn(words, self.texts(), kind)
        plain = self.call("-q", "--velocity", "1:5:1mm/s", "--format", "csv", "--plot", "p.svg")
        without = len(self.read("p.svg"))
        self.call("-q", "--velocity", "1:5:1mm/s", "--uncertainty", "--samples", "32", "--format", "csv", "--plot", "p.svg")
        self.assertGreater(len(self.read("p.svg")), without + 1000)
        self.assertTrue(any(text.endswith("bars: 5 to 95 %") for text in self.texts()), self.texts()[:3])
        self.assertIn("nozzle.stress_max [Pa]", plain)

    def test_the_population_is_drawn_with_what_its_cells_bear(self):
        self.call("-q", "--population", "--plot", "p.svg", "--plot-kind", "profile")
        for words in ("cells, largest in the nozzle", "cells, largest at the exit", "95 % of all cells"):
            self.assertIn(words, self.texts())
        self.call("-q", "--population", "--velocity", "1:3:1mm/s", "--plot", "p.svg")
        self.assertIn("95 % of all cells", self.texts())

    def test_a_viscosity_without_a_bound_leaves_its_curve_readable(self):
        """In a yielding ink it grows to 1e12 and more near the plug; the axis ends 4 decades above the wall's."""
        self.call("-q", "--ink", "ama-25C", "--velocity", "1mm/s", "--plot", "p.svg", "--plot-kind", "profile")
        self.assertFalse([text for text in self.texts() if re.fullmatch(r"\d*·?10[⁷⁸⁹]|.*[eE]\+?\d+.*", text)])

    def test_a_title_says_what_ink_and_cell_it_is_of(self):
        self.call("-q", "--alpha", "0.2", "--shear-modulus", "100Pa", "--plot", "p.svg")
        self.assertTrue(any("α 0.2; cell reference: R 8 µm, 100 Pa" in text for text in self.texts()), self.texts()[:3])
        self.call("-q", "--velocity", "1:5:1mm/s", "--plot", "p.svg")
        self.assertIn("Over velocity", self.texts())

    def test_lines_differ_in_grey_and_for_colour_blind_eyes(self):
        self.call("-q", "--radius", "50um", "--velocity", "1,2,3,4,5,6mm/s", "--alpha", "0:0.9:0.1",
                  "--get", "nozzle.stress_max", "--plot", "p.svg")  # fmt: skip
        seen = re.findall(r"stroke='rgb\( *(\d+), *(\d+), *(\d+)\)'|stroke=\"(#[0-9a-fA-F]{6})\"", self.read("p.svg").decode())
        colours = ["#%02x%02x%02x" % tuple(map(int, rgb[:3])) if rgb[0] else rgb[3] for rgb in seen]
        house = [c for c in dict.fromkeys(c.lower() for c in colours)
                 if c in ("#000000", "#004f8c", "#c44e00", "#00a878", "#e69f00", "#9ad3f5")]  # fmt: skip
        self.assertEqual(len(house), 6)
        tones = [lightness(channels(c)) for c in house]
        for dark, light in itertools.pairwise(tones):
            self.assertGreater(light - dark, 7.0, tones)
        for name, rows in BLINDNESS.items():
            seen = [[sum(m * c for m, c in zip(row, channels(colour))) for row in rows] for colour in house]
            for a, b in itertools.combinations(seen, 2):
                self.assertGreater(distance(a, b), 9.0, name)  # 2.3 is just noticeable side by side

    def test_text_of_the_users_is_text_and_nothing_else(self):
        name = "x'`touch owned`\\n$(touch owned)\"; system \"touch owned\" <b>&"
        self.write("ink.json", json.dumps(ink_named(name)))
        file = "a b'; touch owned; `touch owned`.svg"
        self.call("-q", "--ink", "./ink.json", "--plot", file)
        self.assertEqual(self.names(), sorted([file, "ink.json"]))
        self.assertTrue(any(name in text for text in self.texts(file)), self.texts(file)[:3])

    def test_what_cannot_be_drawn_is_named_and_leaves_no_file(self):
        for arguments, status, words in (
            (["--plot", "p.gif"], 2, ".svg, .png or .pdf"),
            (["--plot", ""], 2, "--plot"),
            (["--plot", "p.svg", "--plot-kind", "pie"], 2, "nomogram"),
            (["--plot-kind", "exit"], 2, "add --plot"),
            (["--plot", "p.svg", "--batch", "x.csv"], 2, "--batch"),
            (["--plot", "-", "--json"], 2, "--output"),
            (["--plot", "p.svg", "--velocity", "0"], 2, "nothing flows"),
            (["--plot", "p.svg", "--alpha", "1.2"], 3, "no steady flow"),
            (["--plot", "p.svg", "--alpha", "0:0.9:0.1", "--velocity", "1:9:1mm/s"], 2, "shorten a list"),
            (["--plot", "none/p.svg"], 4, "create the directory"),
            (["--plot", "p.svg", "--alpha", "0,1", "--get", "input.ink.name"], 2, "is no number"),
        ):  # fmt: skip
            self.call("-q", *arguments, status=status)
            self.assertIn(words, self.err)
            self.assertEqual(len(self.err.splitlines()), 1, self.err)
            self.assertEqual(self.names(), [])

    def test_a_kind_that_is_none_is_told_those_of_the_manual(self):
        self.call("-q", "--plot", "p.svg", "--plot-kind", "foo", status=2)
        self.assertIn("it takes overview, profile, exit, cell or nomogram\n", self.err)

    def test_in_the_terminal_this_nozzle_differs_from_the_other_needles(self):
        text = self.call("-q", "--plot", "-", "--plot-kind", "nomogram")
        sign = re.search(r"^ +(\S)\s*this nozzle$", text, re.M).group(1)
        curve = text[text.index("this nozzle") :].splitlines()[4:]
        self.assertGreater(sum(line.count(sign) for line in curve), 20)
        # The others are drawn by signs, not by letters.
        self.assertEqual(sign, "O")

    def test_without_gnuplot_the_package_is_named(self):
        os.mkdir(self.folder / "empty")
        self.call("-q", "--plot", "p.svg", status=4, env={"PATH": str(self.folder / "empty")})
        self.assertIn("apt-get install gnuplot-nox", self.err)
        self.assertEqual(self.names(), ["empty"])

    def test_an_interrupt_while_gnuplot_draws_is_told_and_leaves_no_file(self):
        """Ctrl-C reaches gnuplot as well, which then ends without a picture. One Ctrl-C, however many draw."""
        folder = self.folder / "bin"
        folder.mkdir()
        pressed = folder / "pressed"
        (folder / "gnuplot").write_text(f"#!/bin/sh\nmkdir '{pressed}' 2>/dev/null && kill -INT $PPID\nexit 130\n")
        (folder / "gnuplot").chmod(0o755)
        for arguments in (["--plot", "p.svg"], ["--report", "r.html"], ["--velocity", "1:5:1mm/s", "--plot", "p.svg"]):
            shutil.rmtree(pressed, ignore_errors=True)
            self.call("-q", *arguments, "-o", "answer.txt", status=130, env={"PATH": f"{folder}:/usr/bin:/bin"})
            self.assertIn("interrupted; no file was written", self.err)
            self.assertEqual(self.names(), ["bin"])

    def test_a_second_interrupt_ends_at_once_and_is_told(self):
        folder = self.folder / "bin"
        folder.mkdir()
        (folder / "gnuplot").write_text("#!/bin/sh\nkill -INT $PPID\nsleep 0.3\nkill -INT $PPID\nexit 130\n")
        (folder / "gnuplot").chmod(0o755)
        self.call("-q", "--plot", "p.svg", "-o", "answer.txt", status=130, env={"PATH": f"{folder}:/usr/bin:/bin"})
        self.assertEqual(self.err, "bioprint-predict: interrupted twice: ended at once\n")
        self.assertEqual(self.names(), ["bin"])

    def test_a_gnuplot_that_fails_is_heard(self):
        folder = self.folder / "bin"
        folder.mkdir()
        (folder / "gnuplot").write_text("#!/bin/sh\necho 'line 3: unknown terminal' >&2\nexit 1\n")
        (folder / "gnuplot").chmod(0o755)
        self.call("-q", "--plot", "p.svg", status=4, env={"PATH": f"{folder}:/usr/bin:/bin"})
        self.assertIn("unknown terminal", self.err)
        self.assertEqual(self.names(), ["bin"])


main()
