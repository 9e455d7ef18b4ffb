# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares each output of moc in a build folder with that of moc with the folders of all of Qt's headers.

compare_outputs.py MOC BUILD-FOLDER
Not with those of the standard library, which take most of the time and have no QObject. Included headers are not
compared: if one were missing, the output would not compile.
"""
import json
import os
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

moc, build = sys.argv[1], pathlib.Path(sys.argv[2])


def lines_that_count(output):
    return [line for line in output.splitlines() if not line.startswith("#include")]


def has_no_qt(folder):
    return "/c++/" in folder or "/gcc/" in folder or folder.endswith(("/include", "/x86_64-linux-gnu"))


def full_output(settings, header):
    arguments = [f"-I{folder}" for folder in settings["MOC_INCLUDES"] if not has_no_qt(folder)]
    arguments += [f"-D{definition}" for definition in settings["MOC_DEFINITIONS"]]
    predefined = settings["MOC_PREDEFS_FILE"]
    done = subprocess.run([moc, *arguments, "--include", predefined, header], capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else done.stderr


def difference(job):
    settings, header, made = job
    here, full = (lines_that_count(text) for text in (made.read_text(), full_output(settings, header)))
    return None if here == full else f"{header}: {len(set(full) ^ set(here))} lines differ"


jobs = []
for file in build.rglob("AutogenInfo.json"):
    settings = json.loads(file.read_text())
    for header, _, name, *_ in settings["HEADERS"]:
        made = pathlib.Path(settings["BUILD_DIR"], name)
        if made.exists():
            jobs.append((settings, header, made))

with ThreadPoolExecutor(os.cpu_count()) as pool:
    differing = [text for text in pool.map(difference, jobs) if text]
print(f"{len(jobs)} outputs compared")
print("\n".join(differing))
sys.exit(bool(differing) or not jobs)
