"""open_reports.py GSBENCH: prints how long Chromium takes to open the report of a thousand outlets, beside
that of eight outlets."""

import glob
import os
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "browser"))
from webdriver import Browser  # noqa: E402

OPENED = 5
PROFILE = """title = "{outlets} outlets"
source = "made for this measurement"
[grid]
system = "ieee24"
[[grid.loss]]
at_s = 30.0
power_mw = 500.0
[signal]
duration_s = 60.0
noise_pct = 1.0
[[outlet]]
count = {outlets}
accumulated_mw = 100.0
[[expect]]
measure = "relay.end"
equals = "open"
"""


def report_of(gsbench, outlets, folder):
    profile = os.path.join(folder, f"{outlets}.toml")
    with open(profile, "w", encoding="utf-8") as file:
        file.write(PROFILE.format(outlets=outlets))
    runs = os.path.join(folder, str(outlets))
    subprocess.run([gsbench, "run", profile, "--out", runs], check=True, stdout=subprocess.DEVNULL)
    return glob.glob(os.path.join(runs, "*", "report.html"))[0]


def opening_s(browser, report):
    """From the address to the drawn curves; the median, the first one left out."""
    times = []
    for _ in range(OPENED + 1):
        begin = time.monotonic()
        browser.open(report)
        if browser.run("return gsbenchGraphs.length") != 2:
            sys.exit(f"{report}: the curves are not drawn")
        times.append(time.monotonic() - begin)
    return statistics.median(times[1:])


def main():
    with tempfile.TemporaryDirectory() as folder, Browser() as browser:
        for outlets in (8, 1000):
            report = report_of(sys.argv[1], outlets, folder)
            size_mb = os.path.getsize(report) / 1e6
            print(f"report of {outlets:4} outlets: {size_mb:.2f} MB, opened in {opening_s(browser, report):.2f} s")


if __name__ == "__main__":
    main()
