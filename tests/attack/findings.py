# SPDX-License-Identifier: GPL-3.0-or-later
"""What an attack has tried, and what was lost."""

import collections


class Findings:
    MOST_SHOWN = 10

    def __init__(self):
        self.tried = collections.Counter()
        self.lost = []

    def tries(self, what, times=1):
        self.tried[what] += times

    def loses(self, sentence):
        self.lost.append(str(sentence))

    def print(self, name):
        what = ", ".join(f"{times} {what}" for what, times in self.tried.items())
        print(f"{name}: {what or 'nothing was tried'}. Lost: {len(self.lost)}.", flush=True)
        for sentence in self.lost[:self.MOST_SHOWN]:
            print(f"    {sentence}", flush=True)
        if len(self.lost) > self.MOST_SHOWN:
            print(f"    ... and {len(self.lost) - self.MOST_SHOWN} more", flush=True)
