#!/usr/bin/env python3
"""Shows that check_report.py can fail: it must detect each damage to a valid report.

    check_report_test.py FOLDER    (the folder of write_sample_reports)
"""

import json
import os
import sys
import tempfile

from check_report import check
from webdriver import Browser

# Pages with several damages each: (description, text, replacement, part of the finding).
DAMAGED_PAGES = [
    [
        ("a figure", "3.107 ± 0.050 mHz", "3.207 ± 0.050 mHz", "tracker.error.rms: shows"),
        ("the verdict", "</span> FAIL</p>", "</span> PASS</p>", "the verdict shown"),
        ("a message on the console", '"use strict";', '"use strict"; console.warn("odd");', "odd"),
        ("a wide element", "<main>", '<main><div style="width:1500px">.</div>',
         "scrolls horizontally"),
        ("plots that do not zoom together", "if (other !== graph) other", "if (false) other",
         "different times"),
        ("an outlet that cannot be chosen", "data.outlets[choice.value]", "data.outlets[0]",
         "the same curve"),
        ("curves not printed", ".paper { position: static; }", ".paper { display: none; }",
         "the curves are not printed"),
        ("another paper size", "size: A4;", "size: letter;", "not A4"),
    ],
    [
        ("a unit", "3.107 ± 0.050 mHz", "3.107 ± 0.050 Hz", "has no unit mHz"),
        ("an external file", '<link rel="icon" href="data:,">',
         '<link rel="stylesheet" href="other.css">', "other.css"),
        ("a wide table at 400 pixels", "<main>", '<main><table style="min-width:500px"></table>',
         "at 400 pixels"),
        ("an empty plot", "window.gsbenchGraphs = graphs;",
         'window.gsbenchGraphs = graphs; document.querySelectorAll(".plot canvas").forEach('
         "(canvas) => { canvas.width += 0; });", "the plot is empty"),
        ("measurements not printed", "@media print {",
         "@media print { .measurements { display: none; }", "is not printed"),
    ],
]


def damaged(page, old, new):
    assert old in page, f"the page does not contain {old!r}"
    return page.replace(old, new)


def main():
    folder = sys.argv[1]
    with open(os.path.join(folder, "failing.html"), encoding="utf-8") as file:
        page = file.read()
    with open(os.path.join(folder, "failing.json"), encoding="utf-8") as file:
        result = json.load(file)
    missed = 0
    with Browser() as browser, tempfile.TemporaryDirectory() as scratch:
        assert check(browser, os.path.join(folder, "failing.html"), result) == []
        for damages in DAMAGED_PAGES:
            text = page
            for _, old, new, _ in damages:
                text = damaged(text, old, new)
            path = os.path.join(scratch, "damaged.html")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            findings = check(browser, path, result)
            for what, _, _, expected in damages:
                if not any(expected in finding for finding in findings):
                    missed += 1
                    print(f"not detected: {what}; findings: {findings}", file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
