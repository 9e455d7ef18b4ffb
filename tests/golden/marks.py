# SPDX-License-Identifier: GPL-3.0-or-later
"""What is another one with each run, by a mark."""

import re
import socket

PATTERNS = (
    (r"\b\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?(Z|[+-]\d\d:?\d\d)?", "<moment>"),
    (r"\b\d{4}-\d\d-\d\d\b", "<date>"),
    (r"\b\d{1,2} (Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)[a-z]* \d{4}\b", "<date>"),
    (r"\b\d{1,2}\. ?(Jan|Feb|Mär|Apr|Mai|Jun|Jul|Aug|Sep|Okt|Nov|Dez)[a-zä.]* \d{4}\b", "<date>"),
    (r"\b\d{1,2}\.\d{1,2}\.\d{2,4}\b", "<date>"),
    (r"\b\d{1,2}/\d{1,2}/\d{2,4}\b", "<date>"),
    (r"\b\d{1,2}:\d\d:\d\d([.,]\d+)?\b", "<time>"),
    (r"\b[0-2]?\d:[0-5]\d\b", "<time>"),
    (r"/tmp/codewheel-screenshots-\w+", "<folder>"),
    (r"\b[0-9a-f]{32}\b", "<id>"),
    (r"\b[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\b", "<id>"),
)


class Marks:
    def __init__(self, home):
        self._folders = str(home)
        self._computer = socket.gethostname()
        self._patterns = [(re.compile(pattern), mark) for pattern, mark in PATTERNS]

    def replace(self, what):
        text = what if isinstance(what, str) else what.decode("utf-8", errors="replace")
        text = text.replace(self._folders, "<home>").replace(self._computer, "<computer>")
        for pattern, mark in self._patterns:
            text = pattern.sub(mark, text)
        return text if not text or text.endswith("\n") else text + "\n"
