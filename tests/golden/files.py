# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that the program wrote, as text."""

import decimal
import pathlib
import re
import sqlite3


def readable(path: pathlib.Path) -> str:
    if path.read_bytes()[:15] == b"SQLite format 3":
        return tables(path)
    text = path.read_text(encoding="utf-8", errors="replace")
    return from_the_first(text) if path.suffix == ".csv" else text


def from_the_first(text):
    """Seconds since 1970 at the beginning of each row, as seconds since the first row."""
    time = re.compile(r"^\d{10}[.,]\d+", re.MULTILINE)
    first = time.search(text)
    if first is None:
        return text
    begun = decimal.Decimal(first.group().replace(",", "."))
    return time.sub(lambda row: f"+{decimal.Decimal(row.group().replace(',', '.')) - begun}", text)


def tables(path):
    """Statements and rows; times as marks, since they are numbers there."""
    with sqlite3.connect(f"file:{path}?mode=ro", uri=True) as database:
        lines = [row[0] or "" for row in database.execute("SELECT sql FROM sqlite_master ORDER BY name")]
        for (name,) in database.execute("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name").fetchall():
            rows = database.execute(f'SELECT * FROM "{name}"').fetchall()
            lines.append(f"{name}: {len(rows)} rows")
            lines += [repr(tuple(plain(value) for value in row)) for row in rows]
    return "\n".join(lines) + "\n"


def plain(value):
    if isinstance(value, int) and value > 1_000_000_000_000:
        return "<moment>"
    if isinstance(value, bytes):  # packed with its moment; what it holds is in the tables that are exported from it
        return f"<{len(value)} bytes>"
    return value
