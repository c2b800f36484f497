#!/usr/bin/env python3
"""`--output x.xlsx`: numbers are numbers, units stand in the header, a chart shows the stress."""
import csv
import io
import subprocess
import sys
import zipfile
import xml.etree.ElementTree as ElementTree

from program import PROGRAM, SKIPPED, Case, main

SHEET = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
PROBE = subprocess.run([PROGRAM, "-q", "--output", "/dev/null/x.xlsx"], capture_output=True, check=False)
if b"libxlsxwriter" in PROBE.stderr:
    print("skipped: built or installed without libxlsxwriter")
    sys.exit(SKIPPED)


class Workbook(Case):
    def cells(self, name="x.xlsx"):
        """The rows of the first sheet, as texts and floats by column."""
        with zipfile.ZipFile(self.folder / name) as book:
            self.assertIsNone(book.testzip())
            self.parts = book.namelist()
            for part in self.parts:
                if part.endswith((".xml", ".rels")):
                    ElementTree.fromstring(book.read(part))
            shared = []
            if "xl/sharedStrings.xml" in self.parts:
                strings = ElementTree.fromstring(book.read("xl/sharedStrings.xml"))
                shared = ["".join(t.text or "" for t in item.iter(SHEET + "t")) for item in strings]
            sheet = ElementTree.fromstring(book.read("xl/worksheets/sheet1.xml"))
            self.chart = next((book.read(p).decode() for p in self.parts if p.startswith("xl/charts/chart")), "")
        rows = []
        for row in sheet.iter(SHEET + "row"):
            cells = {}
            for cell in row:
                column = "".join(c for c in cell.get("r") if c.isalpha())
                self.assertIsNone(cell.find(SHEET + "f"), "a formula")
                if cell.get("t") == "inlineStr":
                    cells[column] = "".join(t.text or "" for t in cell.iter(SHEET + "t"))
                elif cell.get("t") == "s":
                    cells[column] = shared[int(cell.find(SHEET + "v").text)]
                elif cell.find(SHEET + "v") is not None:
                    cells[column] = float(cell.find(SHEET + "v").text)
            rows.append(cells)
        return rows

    @staticmethod
    def column(number):
        letters = ""
        while number >= 0:
            letters, number = chr(ord("A") + number % 26) + letters, number // 26 - 1
        return letters

    def test_every_value_of_the_csv_with_numbers_as_numbers(self):
        sweep = ["--alpha", "0:0.75:0.25"]
        rows = list(csv.reader(io.StringIO(self.call("-q", *sweep, "--format", "csv"))))
        self.call("-q", *sweep, "--output", "x.xlsx")
        cells = self.cells()
        self.assertEqual(len(cells), len(rows))
        numbers = 0
        for row, expected in zip(cells, rows):
            for i, text in enumerate(expected):
                value = row.get(self.column(i), "")
                if isinstance(value, float):
                    numbers += 1
                    # Sixteen digits: the library writes that many.
                    self.assertAlmostEqual(value, float(text), delta=1e-15 * abs(float(text)))
                else:
                    self.assertEqual(value, text)
        self.assertGreater(numbers, 4 * 60)
        self.assertIn("nozzle.stress_max [Pa]", cells[0].values())

    def test_a_sweep_has_a_chart_over_what_changes(self):
        self.call("-q", "--alpha", "0:0.75:0.25", "--output", "x.xlsx")
        self.cells()
        self.assertIn("input.ink.alpha", self.chart)
        self.assertIn("stress [Pa]", self.chart)
        self.assertIn("$2:", self.chart)
        self.assertIn("$5<", self.chart)
        self.assertEqual(self.chart.count("<c:ser>"), 2)

    def test_a_batch_keeps_the_users_columns(self):
        self.write("runs.csv", "id;radius [um];note\n007;50,5;=1+1\n+49;60;\"a;b\"\n12345678901234567;70;ü\n")
        self.call("-q", "--batch", "runs.csv", "--output", "x.xlsx")
        cells = self.cells()
        self.assertEqual([row.get("A") for row in cells], ["id", "007", "+49", "12345678901234567"])
        self.assertEqual([row.get("B") for row in cells[1:]], [50.5, 60.0, 70.0])
        self.assertEqual([row.get("C") for row in cells[1:]], ["=1+1", "a;b", "ü"])
        place = next(k for k, v in cells[0].items() if v == "nozzle.stress_max [Pa]")
        self.assertTrue(all(isinstance(row[place], float) for row in cells[1:]))

    def test_a_failed_row_says_why_and_bytes_that_are_no_text_are_replaced(self):
        self.write("runs.csv", b"radius,note\n5s,\xff\x01\n50um,x\n")
        self.call("-q", "--batch", "runs.csv", "--output", "x.xlsx", status=6)
        cells = self.cells()
        self.assertTrue(any("takes a length" in str(v) for v in cells[1].values()))

    def test_one_question_is_one_row(self):
        self.call("-q", "--output", "X.XLSX")
        self.assertEqual(len(self.cells("X.XLSX")), 2)
        self.assertEqual(self.names(), ["X.XLSX"])

    def test_openpyxl_reads_it(self):
        try:
            import openpyxl
        except ImportError:
            self.skipTest("python3-openpyxl is not installed")
        self.call("-q", "--velocity", "1:5:1mm/s", "--output", "x.xlsx")
        book = openpyxl.load_workbook(self.folder / "x.xlsx")
        sheet = book["Answers"]
        head = [cell.value for cell in sheet[1]]
        stress = [sheet.cell(r, head.index("nozzle.stress_max [Pa]") + 1).value for r in range(2, 7)]
        self.assertEqual(stress, sorted(stress))
        self.assertIn("Chart", book.sheetnames)

    def test_what_has_no_workbook_is_refused_and_leaves_no_file(self):
        for arguments, words in (
            (["--json"], "--format"),
            (["--get", "nozzle.stress_max"], "--get"),
            (["--simulate"], "--simulate"),
            (["--list", "inks"], "--list"),
        ):
            self.call("-q", *arguments, "--output", "x.xlsx", status=2)
            self.assertIn(words, self.err)
            self.assertEqual(self.names(), [])


main()
