#!/usr/bin/env python3
"""LibreOffice Calc, headless, in an English and a German locale: the macro of the examples, workbooks, and CSV there and back."""
import csv
import functools
import html
import re
import subprocess
import zipfile
import xml.etree.ElementTree as ElementTree

from program import EXAMPLES, PROGRAM, Case, main, need

need("soffice")

LOCALES = {"en-US": ",", "de-DE": ";"}
SHEET = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
TEST_MODULE = '''
Sub Main
    Dim document As Object
    Dim sheet As Object
    document = StarDesktop.loadComponentFromURL("private:factory/scalc", "_blank", 0, Array())
    sheet = document.getSheets().getByIndex(0)
    sheet.getCellByPosition(0, 0).setString("radius [um]")
    sheet.getCellByPosition(1, 0).setString("alpha")
    sheet.getCellByPosition(2, 0).setString("Notiz, ""µ""")
    sheet.getCellByPosition(0, 1).setValue(50.5)
    sheet.getCellByPosition(1, 1).setValue(0.75)
    sheet.getCellByPosition(2, 1).setString("a, ""b""")
    sheet.getCellByPosition(0, 2).setValue(100)
    sheet.getCellByPosition(1, 2).setValue(1.2)
    sheet.getCellByPosition(0, 3).setFormula("=50+50")
    sheet.getCellByPosition(1, 3).setValue(0.3)
    PredictRange(sheet.getCellRangeByPosition(0, 0, 2, 3))
    sheet.getCellByPosition(0, 5).setValue(BioprintPredict("--radius 50um --flowrate 141uL/h", "nozzle.stress_max"))
    sheet.getCellByPosition(1, 5).setString(BioprintPredict("--radius 5s", "nozzle.stress_max"))
    sheet.getCellByPosition(0, 9).setString("radius [um]")
    sheet.getCellByPosition(0, 10).setValue(50)
    sheet.getCellByPosition(0, 12).setValue(100)
    sheet.getCellByPosition(0, 13).setString(" ")
    sheet.getCellByPosition(0, 14).setValue(200)
    PredictRange(sheet.getCellRangeByPosition(0, 8, 0, 15))
    Dim result(0) As New com.sun.star.beans.PropertyValue
    result(0).Name = "FilterName"
    result(0).Value = "Calc MS Excel 2007 XML"
    document.storeToURL(ConvertToURL("%s"), result())
    document.close(True)
    StarDesktop.terminate()
End Sub
'''


class Spreadsheet(Case):
    def profile(self, locale, modules=None):
        """A user's folder with the locale set and the macros installed."""
        # The first start fills a new folder and would put its own empty modules over ours.
        self.office(locale, "--terminate_after_init")
        basic = self.folder / locale / "user" / "basic" / "Standard"
        basic.mkdir(parents=True, exist_ok=True)
        settings = self.folder / locale / "user" / "registrymodifications.xcu"
        ours = ('<item oor:path="/org.openoffice.Setup/L10N"><prop oor:name="ooSetupSystemLocale" oor:op="fuse">'
                f"<value>{locale}</value></prop></item></oor:items>")  # fmt: skip
        settings.write_text(settings.read_text(encoding="utf-8").replace("</oor:items>", ours), encoding="utf-8")
        macro = (EXAMPLES / "libreoffice-macro.bas").read_text(encoding="utf-8")
        macro = macro.replace('"bioprint-predict"', f'"{PROGRAM}"')
        macro = macro.replace('nozzle.pressure_gradient"', 'nozzle.pressure_gradient passages.0.peak.place"')
        modules = modules or {"Bioprint": macro, "Check": TEST_MODULE % (self.folder / f"{locale}.xlsx")}
        kind = "http://openoffice.org/2000/"
        for name, text in modules.items():
            (basic / f"{name}.xba").write_text(
                '<?xml version="1.0" encoding="UTF-8"?>\n<script:module xmlns:script="' + kind + 'script" script:name="'
                + name + '" script:language="StarBasic">' + html.escape(text, quote=False) + "</script:module>",
                encoding="utf-8")  # fmt: skip
        (basic / "script.xlb").write_text(
            '<?xml version="1.0" encoding="UTF-8"?>\n<library:library xmlns:library="' + kind + 'library" '
            'library:name="Standard" library:readonly="false" library:passwordprotected="false">'
            + "".join(f'<library:element library:name="{name}"/>' for name in modules) + "</library:library>")  # fmt: skip
        (basic.parent / "script.xlc").write_text(
            '<?xml version="1.0" encoding="UTF-8"?>\n<library:libraries xmlns:library="' + kind + 'library" '
            'xmlns:xlink="http://www.w3.org/1999/xlink"><library:library library:name="Standard" '
            'xlink:href="$(USER)/basic/Standard/script.xlb/" xlink:type="simple" library:link="false"/>'
            "</library:libraries>")  # fmt: skip

    def office(self, locale, *arguments):
        done = subprocess.run(
            ["soffice", f"-env:UserInstallation=file://{self.folder / locale}", "--headless", "--norestore", *arguments],
            cwd=self.folder, capture_output=True, timeout=90, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr.decode())

    def rows(self, name):
        with zipfile.ZipFile(self.folder / name) as book:
            shared = []
            if "xl/sharedStrings.xml" in book.namelist():
                strings = ElementTree.fromstring(book.read("xl/sharedStrings.xml"))
                shared = ["".join(t.text or "" for t in item.iter(SHEET + "t")) for item in strings]
            sheet = ElementTree.fromstring(book.read("xl/worksheets/sheet1.xml"))
        rows = []
        for row in sheet.iter(SHEET + "row"):
            cells = []
            rows += [[] for _ in range(int(row.get("r")) - 1 - len(rows))]
            for cell in row:
                # An empty cell may be left out, so the place is what the cell says of itself.
                letters = re.match("[A-Z]+", cell.get("r")).group()
                place = functools.reduce(lambda n, letter: 26 * n + ord(letter) - 64, letters, 0) - 1
                cells += [None] * (place + 1 - len(cells))
                value = cell.find(SHEET + "v")
                if value is not None:
                    cells[place] = (shared[int(value.text)] if cell.get("t") == "s" else
                                    value.text if cell.get("t") == "str" else float(value.text))  # fmt: skip
            rows.append(cells)
        return rows

    def value(self, path, *arguments):
        return float(self.call("-q", *arguments, "--get", path))

    def test_the_macro_answers_a_table_and_a_cell_in_both_locales(self):
        for locale in LOCALES:
            self.profile(locale)
            self.office(locale, "macro:///Standard.Check.Main")
            rows = self.rows(f"{locale}.xlsx")
            self.assertEqual(rows[0][3], "nozzle.stress_max")
            for row, radius, alpha in ((rows[1], "50.5um", "0.75"), (rows[3], "100um", "0.3")):
                wall = self.value("nozzle.stress_max", "--radius", radius, "--alpha", alpha)
                self.assertAlmostEqual(row[3] / wall, 1.0, delta=1e-14)
            self.assertEqual(rows[2][3], "no answer")
            self.assertEqual(rows[1][6], self.call("-q", "--get", "passages.0.peak.place").strip())
            cell = rows[5]
            wall = self.value("nozzle.stress_max", "--radius", "50um", "--flowrate", "141uL/h")
            self.assertAlmostEqual(cell[0] / wall, 1.0, delta=1e-14)
            self.assertIn("no answer", cell[1])
            # Nothing stands beside an empty row, and no answer beside another row's question.
            self.assertEqual(rows[9][1], "nozzle.stress_max")
            for row, radius in ((10, "50um"), (12, "100um"), (14, "200um")):
                wall = self.value("nozzle.stress_max", "--radius", radius)
                self.assertAlmostEqual(rows[row][1] / wall, 1.0, delta=1e-14)
            for row in (8, 11, 13, *range(15, len(rows))):
                self.assertFalse(any(rows[row][1:]), rows[row])

    def test_the_excel_module_has_no_error_of_syntax(self):
        """LibreOffice compiles VBA too; a module with an error in it never gets to its last procedure."""
        text = (EXAMPLES / "excel-macro.bas").read_text(encoding="utf-8").split("\n", 1)[1]
        here = f'Open "{self.folder}/compiled" For Output As #1'
        check = f'\nSub Check\n    {here}\n    Print #1, "yes"\n    Close #1\n    StarDesktop.terminate()\nEnd Sub\n'
        self.profile("en-US", {"Excel": "Option VBASupport 1\n" + text + check})
        self.office("en-US", "macro:///Standard.Excel.Check")
        self.assertEqual(self.read("compiled"), b"yes\n")

    def test_a_csv_goes_there_and_back_in_both_locales(self):
        for locale, separator in LOCALES.items():
            self.profile(locale)
            self.write("start.csv", "name;radius [um];alpha\nä, b;50,5;0,75\nc;100;0,3\n")
            code = str(ord(separator))
            # Read as German, whatever the locale; written in the locale's own way.
            self.office(locale, "--convert-to", "ods", "--infilter=CSV:59,34,76,1,,1031", "start.csv")
            self.office(locale, "--convert-to", f"csv:Text - txt - csv (StarCalc):{code},34,76,1,,0,false,true,false", "start.ods")
            saved = self.read("start.csv").decode()
            self.assertIn(separator.join(["50,5", "0,75"]) if separator == ";" else "50.5,0.75", saved)
            self.call("-q", "--batch", "start.csv", "--output", "answers.csv")
            self.office(locale, "--convert-to", "xlsx", f"--infilter=CSV:{code},34,76,1", "answers.csv")
            rows = self.rows("answers.xlsx")
            place = rows[0].index("nozzle.stress_max [Pa]")
            self.assertEqual(rows[1][0], "ä, b")
            for row, radius, alpha in ((rows[1], "50.5um", "0.75"), (rows[2], "100um", "0.3")):
                wall = self.value("nozzle.stress_max", "--radius", radius, "--alpha", alpha)
                self.assertIsInstance(row[place], float)
                self.assertAlmostEqual(row[place] / wall, 1.0, delta=1e-14)

    def test_a_workbook_opens_with_its_numbers_in_both_locales(self):
        for locale in LOCALES:
            self.profile(locale)
            self.call("-q", "--alpha", "0:0.75:0.25", "--output", "sweep.xlsx")
            self.office(locale, "--convert-to", "csv:Text - txt - csv (StarCalc):9,34,76,1,,0,false,false,false", "sweep.xlsx")
            rows = list(csv.reader(self.read("sweep.csv").decode().splitlines(), delimiter="\t"))
            place = rows[0].index("nozzle.stress_max [Pa]")
            mark = "," if locale == "de-DE" else "."
            for row, alpha in zip(rows[1:], ("0", "0.25", "0.5", "0.75")):
                wall = self.value("nozzle.stress_max", "--alpha", alpha)
                self.assertAlmostEqual(float(row[place].replace(mark, ".")) / wall, 1.0, delta=1e-9)


main()
