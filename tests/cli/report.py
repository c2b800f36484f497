#!/usr/bin/env python3
"""`--report`: one well-formed page that holds everything it shows and lets no name of the user's be markup."""
import html.parser
import json
import re
import time

from program import Case, ink_named, main, need

need("gnuplot")

VOID = {"meta", "link", "br", "img", "hr", "input"}


class Page(html.parser.HTMLParser):
    """Reads a page strictly: every element is closed, in order; what would fetch or run is kept."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.faults, self.fetches, self.tags, self.ids = [], [], [], [], []
        self.texts = {}
        self.feed(text)
        self.close()
        if self.open:
            self.faults.append(f"not closed: {self.open}")

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        names = [name for name, _ in attrs]
        if len(names) != len(set(names)):
            self.faults.append(f"{tag}: an attribute twice")
        for name, value in attrs:
            if name == "id":
                self.ids.append(value)
            outside = name in ("src", "href", "xlink:href", "action", "data") and not (value or "").startswith(("#", "data:"))
            if outside or name.startswith("on") or tag in ("script", "iframe", "object"):
                self.fetches.append((tag, name, value))
            if name in ("fill", "style", "clip-path", "mask") and "url(" in (value or "") and "url(#" not in value:
                self.fetches.append((tag, name, value))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.faults.append(f"</{tag}> closes {self.open[-1:]}")
        elif self.open:
            self.open.pop()

    def handle_data(self, data):
        for tag in set(self.open):
            self.texts[tag] = self.texts.get(tag, "") + data


class Report(Case):
    def page(self, *arguments, status=0, name="r.html", env=None):
        self.call("-q", *arguments, "--report", name, status=status, env=env)
        self.text = self.read(name).decode()
        page = Page(self.text)
        self.assertEqual(page.faults, [])
        self.assertEqual(page.fetches, [])
        self.assertEqual(len(page.ids), len(set(page.ids)), "an id twice")
        return page

    def test_a_question_with_its_sources_answer_pictures_notes_call_and_json(self):
        page = self.page("--needle", "27G", "--tip", "steel", "--flowrate", "20uL/min", "--population")
        self.assertEqual(page.tags.count("svg"), 4)
        for words in ("--needle 27G --tip steel --flowrate 20uL/min", "27G steel", "Source: ", "In the nozzle",
                      "At the exit", "peak stress", "Notes", "percentile 95"):  # fmt: skip
            self.assertIn(words, self.text)
        answer = json.loads(page.texts["pre"])
        self.assertEqual(answer, json.loads(self.call("-q", "--needle", "27G", "--tip", "steel", "--flowrate", "20uL/min",
                                                      "--population", "--json")))  # fmt: skip
        self.assertIn("@media print", self.text)
        self.assertNotRegex(self.text, r">(nan|inf|null)<")

    def test_a_sweep_has_a_row_each_and_one_picture(self):
        page = self.page("--alpha", "0:0.75:0.25", "--velocity", "1mm/s,5mm/s")
        self.assertEqual(page.tags.count("svg"), 1)
        self.assertEqual(len(json.loads(page.texts["pre"])), 8)

    def test_a_row_without_an_answer_says_why(self):
        page = self.page("--alpha", "0.5,1.3", status=6)
        self.assertIn("no steady flow", page.texts["td"])

    def test_checks_spread_and_sensitivity_stand_where_they_were_asked_for(self):
        page = self.page("--uncertainty", "--samples", "64", "--check", "nozzle.stress_max<2kPa", "--check",
                         "cells.exit.stress.von_mises<100Pa", status=7)  # fmt: skip
        for words in ("<h2>Checks</h2>", "does not hold", "78 %", "<h2>Uncertainty</h2>", "64 samples", "share of the variance",
                      "eLife 11:e78823", "Most of the spread of", "5 to 95 %"):  # fmt: skip
            self.assertIn(words, self.text)
        answer = json.loads(page.texts["pre"])
        self.assertEqual([check["holds"] for check in answer["checks"]], [True, False])
        self.assertIn("first_order", answer["uncertainty"]["nozzle"]["stress_max"])
        self.page()
        for words in ("<h2>Checks</h2>", "<h2>Uncertainty</h2>", "5 to 95 %"):
            self.assertNotIn(words, self.text)

    def test_a_sweep_keeps_checks_and_spread_of_each_row(self):
        page = self.page("--alpha", "0.5,0.75", "--uncertainty", "--samples", "16", "--format", "csv", "--check",
                         "nozzle.stress_max<600Pa", status=7)  # fmt: skip
        rows = json.loads(page.texts["pre"])
        self.assertEqual([row["checks"][0]["holds"] for row in rows], [False, True])
        self.assertIn("uncertainty", rows[0])

    def test_the_value_carried_in_time_stands_before_the_steady_one(self):
        self.page("--offset", "0,12um")
        first = [self.text.index(f">{words}<") for words in ("ellipsoid, in time", "steady (roscoe-elongation)")]
        self.assertLess(*first)
        self.assertIn("Way of each cell", self.text)

    def test_a_simulation_stands_beside_its_prediction(self):
        page = self.page("--simulate=exit-flow", "--fidelity", "draft")
        self.assertIn("numerical error", self.text)
        self.assertIn("simulation", json.loads(page.texts["pre"]))

    def test_names_of_the_users_are_text(self):
        name = '</pre><script>alert(1)</script><img src=x onerror="alert(2)">&amp;\'" \u202e\x01 ]]>'
        self.write("ink<i>.json", json.dumps({**ink_named(name), "source": "<b>me</b>"}))
        page = self.page("--ink", "./ink<i>.json", name="r & <b>.html")
        self.assertNotIn("script", page.tags)
        self.assertNotIn("img", page.tags)
        self.assertIn("<b>me</b>", page.texts["p"])
        self.assertEqual(json.loads(page.texts["pre"].replace("\ufffd", " "))["input"]["ink"]["source"], "<b>me</b>")
        self.assertIn("'./ink<i>.json'", page.texts["code"])

    def test_the_same_question_gives_the_same_page(self):
        self.page()
        first = self.text
        self.page()
        self.assertEqual(first, self.text)

    def test_without_gnuplot_the_page_says_what_is_missing(self):
        (self.folder / "empty").mkdir()
        page = self.page(env={"PATH": str(self.folder / "empty")})
        self.assertNotIn("svg", page.tags)
        self.assertIn("gnuplot was not installed", self.text)

    def test_nothing_flowing_has_a_page_without_pictures(self):
        self.assertNotIn("svg", self.page("--velocity", "0").tags)

    def test_what_has_no_report_is_refused_and_leaves_no_file(self):
        for arguments, status in (
            (["--batch", "x.csv"], 2),
            (["--radius", "5s"], 2),
            (["--alpha", "0:1:0.0005"], 2),
            (["--alpha", "1.2"], 3),
        ):
            self.call("-q", *arguments, "--report", "r.html", status=status)
            self.assertEqual(self.names(), [])

    def test_it_takes_about_a_second(self):
        times = []
        for _ in range(3):
            begin = time.monotonic()
            self.page()
            times.append(time.monotonic() - begin)
        print(f"report: {min(times):.2f} s")
        self.assertLess(min(times), 20.0)  # a busy machine under a sanitizer; the figure above is the measurement


main()
