#!/usr/bin/env python3
"""Opens an HTML report in headless Chromium and compares it with the JSON of the same record.

    check_report.py REPORT.html RESULT.json [--pictures STEM]

Exit code 0 without findings; otherwise prints every finding and exits with 1.
--pictures writes STEM-1280.png, STEM-400.png and STEM.pdf for visual inspection.
"""

import argparse
import json
import math
import os
import re
import signal
import subprocess
import sys
import tempfile

from webdriver import Browser, BrowserError

WIDTHS = (1280, 400)
A4_PT = (595.28, 841.89)  # 210 mm × 297 mm; pdfinfo rounds to whole device pixels
A4_TOLERANCE_PT = 1.0

CELLS = """
return Array.from(document.querySelectorAll('details')).map(d => ({
  name: d.querySelector('summary').lastChild.textContent.trim(),
  verdict: d.querySelector('summary .badge').textContent,
  measurements: Array.from(d.querySelectorAll('tr[data-measurement]')).map(r => ({
    name: r.dataset.measurement,
    value: r.querySelector('[data-label=Value]').textContent.trim(),
    badge: r.querySelector('.badge') ? r.querySelector('.badge').textContent : null }))}));
"""

INKED_PIXELS = """
const counted = canvas => {
  if (!canvas || !canvas.width || !canvas.height) return 0;
  const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  let inked = 0;
  for (let i = 3; i < pixels.length; i += 4) if (pixels[i]) ++inked;
  return inked;
};
return ['frequency-plot', 'rocof-plot'].map(
  id => counted(document.querySelector('#' + id + ' canvas')));
"""

WINDOWS = "return gsbenchGraphs.map(g => g.xAxisRange());"


class Findings:
    def __init__(self):
        self.list = []

    def expect(self, condition, text):
        if not condition:
            self.list.append(text)


def shown_number(text):
    """(value, half a unit of the last digit shown), or None if the text is not a number."""
    match = re.match(r"([−-]?\d+(?:\.(\d+))?(?:e([+-]?\d+))?)", text)
    if not match:
        return None
    exponent = int(match.group(3) or 0) - len(match.group(2) or "")
    value = float(match.group(1).replace("−", "-"))
    return value, 0.5 * 10.0 ** exponent


def check_measurement(found, where, shown, expected):
    value, text = expected["value"], shown["value"]
    if value is None:
        found.expect(text == "–", f"{where}: shows {text!r} although there is no value")
    elif isinstance(value, str):
        found.expect(text == value, f"{where}: shows {text!r}, the record has {value!r}")
    else:
        number = shown_number(text)
        # Slightly more than half a unit, since a value may lie exactly between two digits.
        right = number is not None and math.isclose(
            number[0], value, rel_tol=5e-5, abs_tol=number[1] * (1 + 1e-9))
        found.expect(right, f"{where}: shows {text!r}, the record has {value!r}")
        found.expect(text.endswith(expected["unit"]),
                     f"{where}: {text!r} has no unit {expected['unit']}")
    if shown["badge"] is not None:
        found.expect(shown["badge"] == expected["verdict"],
                     f"{where}: shows {shown['badge']}, the record has {expected['verdict']}")


VERDICTS = ["PASS", "INCONCLUSIVE", "FAIL", "ERROR"]
MOST_DRAWN = 20


def outlets_drawn(browser, result, found):
    """Those of the record that the page shows in full, in its order."""
    outlets = result["outlets"]
    if len(outlets) <= MOST_DRAWN:
        return outlets
    shown = [outlet["name"] for outlet in browser.run(CELLS)]
    drawn = [outlet for name in shown for outlet in outlets if outlet["id"] == name]
    found.expect(len(drawn) == MOST_DRAWN, f"{len(drawn)} outlets are shown in full")
    worst = sorted((VERDICTS.index(o["verdict"]) for o in outlets), reverse=True)[:MOST_DRAWN]
    found.expect([VERDICTS.index(o["verdict"]) for o in drawn] == worst,
                 "the outlets shown in full are not the worst")
    note = browser.run("return document.getElementById('not-drawn').textContent")
    found.expect(f"for {MOST_DRAWN} of the {len(outlets)} outlets" in note, f"the note is {note!r}")
    return drawn


def check_figures(browser, result, drawn, found):
    verdict = browser.run("return document.getElementById('verdict').textContent")
    found.expect(result["verdict"] in verdict, f"the verdict shown is {verdict!r}")
    found.expect(result["profile"] in browser.run("return document.title"),
                 "the page title does not contain the profile")
    facts = browser.run("return document.querySelector('.facts').textContent")
    for key in ("run_id", "profile", "seed", "profile_sha256", "firmware_sha256"):
        found.expect(str(result[key]) in facts, f"the facts do not contain {key} {result[key]}")
    outlets = browser.run(CELLS)
    found.expect([o["name"] for o in outlets] == [o["id"] for o in drawn],
                 f"outlets shown: {[o['name'] for o in outlets]}")
    rows = browser.run("return document.querySelectorAll('#overview tbody tr').length")
    found.expect(rows == len(result["outlets"]),
                 f"the overview has {rows} rows for {len(result['outlets'])} outlets")
    for shown, expected in zip(outlets, drawn):
        found.expect(shown["verdict"] == expected["verdict"], f"{shown['name']}: {shown['verdict']}")
        names = [m["name"] for m in expected["measurements"]]
        found.expect([m["name"] for m in shown["measurements"]] == names,
                     f"{shown['name']}: the measurements shown differ from those of the record")
        for row, measurement in zip(shown["measurements"], expected["measurements"]):
            check_measurement(found, f"{shown['name']} {row['name']}", row, measurement)


def check_layout(browser, width, found):
    browser.set_width(width)
    page, view = browser.run("return [document.scrollingElement.scrollWidth, innerWidth]")
    found.expect(view == width, f"the window is {view} pixels wide, not {width}")
    found.expect(page <= view,
                 f"at {width} pixels the page is {page} wide and scrolls horizontally")
    clipped = browser.run("""
        return Array.from(document.querySelectorAll('table, dl, .verdict, .controls, .legend'))
          .filter(e => e.getBoundingClientRect().right > innerWidth + 0.5)
          .map(e => e.tagName + '.' + e.className)""")
    found.expect(not clipped, f"at {width} pixels these elements extend beyond the page: {clipped}")


def check_plots(browser, drawn, found):
    inked = browser.run(INKED_PIXELS)
    # A single line across the plot has over 300 pixels; an empty canvas has none.
    found.expect(min(inked) > 300, f"a plot is empty; inked pixels: {inked}")
    whole = browser.run(WINDOWS)
    browser.run("document.getElementById('frequency-plot').scrollIntoView({block: 'center'})")
    left, top, width, height = browser.run("""
        const box = document.getElementById('frequency-plot').getBoundingClientRect();
        return [box.left, box.top, box.width, box.height];""")
    y = top + height / 2
    browser.drag(left + 0.4 * width, y, left + 0.6 * width, y)
    zoomed = browser.run(WINDOWS)
    span, part = whole[0][1] - whole[0][0], zoomed[0][1] - zoomed[0][0]
    found.expect(0.1 * span < part < 0.35 * span,
                 f"dragging over a fifth of the plot shows {part} s of {span} s")
    found.expect(zoomed[0] == zoomed[1], f"the plots show different times: {zoomed}")
    browser.double_click(left + width / 2, y)
    found.expect(browser.run(WINDOWS) == whole, "a double click does not restore the whole run")
    browser.run("document.getElementById('zoom-event').click()")
    near = browser.run(WINDOWS)
    found.expect(near[0] == near[1] and near[0][0] >= whole[0][0] and near[0][1] <= whole[0][1],
                 f"the button 'event' shows {near}")
    browser.run("document.getElementById('zoom-all').click()")
    found.expect(browser.run(WINDOWS) == whole, "the button 'all' does not restore the whole run")

    def curve():
        return browser.run("""
            const rows = gsbenchGraphs[0].file_;
            return rows.filter(r => Number.isFinite(r[1])).map(r => r[1]);""")
    curves = []
    for index in range(len(drawn)):
        browser.run("""
            const choice = document.getElementById('outlet-choice');
            choice.value = String(arguments[0]);
            choice.dispatchEvent(new Event('change'));""", index)
        curves.append(tuple(curve()))
        found.expect(min(browser.run(INKED_PIXELS)) > 300, f"outlet {index}: the plot is empty")
    found.expect(len(set(curves)) == len(curves), "choosing another outlet shows the same curve")


def check_print(browser, path, result, drawn, found):
    browser.print_a4(path)
    information = subprocess.run(["pdfinfo", path], capture_output=True, text=True, check=True).stdout
    size = re.search(r"Page size:\s+([\d.]+) x ([\d.]+)", information)
    found.expect(size and all(abs(float(size.group(i + 1)) - A4_PT[i]) < A4_TOLERANCE_PT
                              for i in range(2)), f"the paper is not A4: {information}")
    text = subprocess.run(["pdftotext", "-layout", path, "-"],
                          capture_output=True, text=True, check=True).stdout
    found.expect("End of the report on run" in text, "the printed report is not complete")
    found.expect(text.count(result["run_id"]) >= text.count("\f"),
                 "a printed page does not contain the run id")
    for outlet in drawn:
        for measurement in outlet["measurements"]:
            found.expect(measurement["name"] in text, f"{measurement['name']} is not printed")
    # The curves are printed as images that are larger than any icon.
    pictures = subprocess.run(["pdfimages", "-list", path],
                              capture_output=True, text=True, check=True).stdout
    widths = [int(line.split()[3]) for line in pictures.splitlines()[2:]]
    found.expect(sum(width > 600 for width in widths) >= 2,
                 f"the curves are not printed:\n{pictures}")


def check(browser, report, result, pictures=None):
    """The findings about the report, one text each; empty if there are none."""
    found = Findings()
    browser.set_width(WIDTHS[0])
    browser.open(report)
    drawn = outlets_drawn(browser, result, found)
    check_figures(browser, result, drawn, found)
    for width in WIDTHS:
        check_layout(browser, width, found)
        if pictures:
            browser.screenshot(f"{pictures}-{width}.png", whole_page=True)
    browser.set_width(WIDTHS[0])
    if result["outlets"]:
        check_plots(browser, drawn, found)
    with tempfile.TemporaryDirectory() as folder:
        paper = f"{pictures}.pdf" if pictures else os.path.join(folder, "report.pdf")
        check_print(browser, paper, result, drawn, found)
    found.expect(browser.run("return performance.getEntriesByType('resource').length") == 0,
                 "the page loads other files")
    console = browser.console()
    found.expect(not console, f"there are messages on the console: {console}")
    return found.list


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report")
    parser.add_argument("result")
    parser.add_argument("--pictures", metavar="STEM")
    arguments = parser.parse_args()
    # On SIGTERM, Browser.__exit__ must run and stop the browser.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    with open(arguments.result, encoding="utf-8") as file:
        result = json.load(file)
    try:
        with Browser() as browser:
            findings = check(browser, arguments.report, result, arguments.pictures)
    except (BrowserError, subprocess.CalledProcessError, OSError) as error:
        findings = [str(error)]
    for finding in findings:
        print(f"{arguments.report}: {finding}", file=sys.stderr)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
