# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that the program wrote, as text."""

import pathlib
import sqlite3


def readable(path: pathlib.Path) -> str:
    if path.read_bytes()[:15] == b"SQLite format 3":
        return tables(path)
    return path.read_text(encoding="utf-8", errors="replace")


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
    return value
