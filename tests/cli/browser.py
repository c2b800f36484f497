#!/usr/bin/env python3
"""A report in headless Chromium: no console message, no request but for the page itself, and a page that is not empty."""
import json
import os
import subprocess

from program import Case, main, need

need("chromium", "gnuplot")


class Browser(Case):
    def chromium(self, *arguments):
        done = subprocess.run(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
             "--disable-component-update", "--no-first-run", f"--user-data-dir={self.folder / 'profile'}",
             "--virtual-time-budget=3000", *arguments],
            cwd=self.folder, capture_output=True, timeout=200, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr.decode("utf-8", "replace")[-2000:])
        return done.stdout.decode(), done.stderr.decode("utf-8", "replace")

    def requests(self, log):
        """Addresses asked for over a network, or of a file, by the page."""
        events = json.loads((self.folder / log).read_text(encoding="utf-8"))["events"]
        urls = {event.get("params", {}).get("url") for event in events}
        return {url for url in urls if url and url.split(":")[0] in ("http", "https", "ws", "wss", "ftp")}

    def test_reports_ask_for_nothing_and_complain_of_nothing(self):
        for name, arguments in {
            "question": ["--needle", "27G", "--tip", "steel", "--flowrate", "20uL/min", "--population"],
            "everything": ["--uncertainty", "--samples", "64", "--check", "nozzle.stress_max<2kPa", "--length", "12.7mm",
                           "--simulate=exit-flow", "--fidelity", "draft"],
            "sweep": ["--alpha", "0:0.75:0.15", "--velocity", "1mm/s,5mm/s"],
        }.items():
            self.call("-q", *arguments, "--report", f"{name}.html")
            dom, err = self.chromium("--dump-dom", "--enable-logging=stderr", "--v=0", f"--log-net-log={self.folder}/net.json",
                                     f"file://{self.folder}/{name}.html")  # fmt: skip
            self.assertNotIn("CONSOLE", err)
            page = [url for url in self.requests("net.json") if "google" not in url and "gvt1" not in url]
            self.assertEqual(page, [])
            self.assertIn("</svg>", dom)
            self.chromium("--screenshot=page.png", "--window-size=1000,3000", f"file://{self.folder}/{name}.html")
            self.chromium("--print-to-pdf=page.pdf", f"file://{self.folder}/{name}.html")
            self.assertGreater(len(self.read("page.png")), 100000)
            self.assertEqual(self.read("page.pdf")[:5], b"%PDF-")
            if folder := os.environ.get("BIOPRINT_KEEP"):
                for kind in ("png", "pdf"):
                    (self.folder / f"page.{kind}").rename(f"{folder}/report-{name}.{kind}")

    def test_a_page_that_fetches_and_complains_is_noticed(self):
        self.write("bad.html", "<script>console.log('hello')</script><img src='http://localhost:9/x.png'>")
        _, err = self.chromium("--dump-dom", "--enable-logging=stderr", "--v=0", f"--log-net-log={self.folder}/net.json",
                               f"file://{self.folder}/bad.html")  # fmt: skip
        self.assertIn("CONSOLE", err)
        self.assertIn("http://localhost:9/x.png", self.requests("net.json"))


main()
