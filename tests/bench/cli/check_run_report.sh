#!/usr/bin/env bash
# check_run_report.sh GSBENCH CHECK_REPORT FOLDER: runs the 500 MW experiment and compares its report, in
# a browser, with its JSON result.
set -euo pipefail
gsbench=$1 check_report=$2 folder=$3
rm -rf "$folder"
"$gsbench" run paper/loss-500mw --out "$folder"
python3 "$check_report" "$folder"/*/report.html "$folder"/*/result.json --pictures "$folder/report"
