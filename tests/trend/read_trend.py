#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads FILE with pandas and says as JSON what it got. "spreadsheet": as read_csv reads a German table."""
import json
import sys

import pandas

file, style = sys.argv[1:]
if style == "spreadsheet":
    table = pandas.read_csv(file, sep=";", decimal=",")
    time = pandas.to_datetime(table["time"].str.replace(",", "."))
else:
    table = pandas.read_csv(file)
    time = pandas.to_datetime(table["time [s]"], unit="s", utc=True)

print(json.dumps({
    "columns": list(table.columns),
    "types": [str(kind) for kind in table.dtypes],
    "rows": len(table),
    "isMonotonic": bool(time.is_monotonic_increasing),
    "first": str(time.iloc[0].round("us")),
    "last": str(time.iloc[-1].round("us")),
    "missing": [int(count) for count in table.isna().sum()],
    "greatest": [float(value) for value in table.iloc[:, 1:].max()],
    "sums": [float(value) for value in table.iloc[:, 1:].sum()],
}))
