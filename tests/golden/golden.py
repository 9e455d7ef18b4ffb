#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the program says and writes today, for a comparison before and after the house is rearranged.

golden.py record FOLDER [--build BUILD]   records text, JSON and files of every command on the training bus,
                                          and every view as a screen reader tells it, in English and German
golden.py compare BEFORE AFTER            prints what differs; exit code 1 if anything does

Times, durations of real time, folders and random names are replaced by marks.
"""

import argparse
import concurrent.futures
import difflib
import os
import pathlib
import subprocess
import sys
import tempfile

from calls import calls
from files import readable
from marks import Marks

ROOT = pathlib.Path(__file__).resolve().parents[2]
LANGUAGES = ("en", "de")
FORMS = {"text": (), "json": ("--json",)}


def environment(home, language):
    kept = {name: os.environ[name] for name in ("PATH", "LD_LIBRARY_PATH") if name in os.environ}
    (home / "run").mkdir(mode=0o700, exist_ok=True)
    return {**kept, "HOME": str(home), "XDG_CONFIG_HOME": str(home / "config"), "XDG_DATA_HOME": str(home / "data"),
            "XDG_CACHE_HOME": str(home / "cache"), "XDG_RUNTIME_DIR": str(home / "run"), "TZ": "UTC",
            "LC_ALL": "C.UTF-8", "LANGUAGE": language, "QT_QPA_PLATFORM": "offscreen"}


def record_commands(build, out, language, form):
    """Every call, in order, in a folder of its own: what one of them leaves there, the next ones find."""
    with tempfile.TemporaryDirectory() as made:
        home = pathlib.Path(made).resolve()
        work = home / "work"
        work.mkdir()
        marks = Marks(home)
        told = {}
        for arguments in calls(ROOT, work, str(build / "bin/codewheel-cli")):
            run = subprocess.run([build / "bin/codewheel-cli", *arguments, *FORMS[form]], cwd=work,
                                 env=environment(home, language), stdin=subprocess.DEVNULL, capture_output=True,
                                 timeout=120, check=False)
            shown = " ".join(arguments)
            out_text = marks.replace(run.stdout)
            if arguments[:2] == ["ledger", "entries"]:  # by moments, which overlap between calls
                out_text = "".join(sorted(out_text.splitlines(keepends=True)))
            told.setdefault(arguments[0].lstrip("-"), []).append(
                f"$ {shown}\n{out_text}{marks.replace(run.stderr)}exit {run.returncode}\n\n")
        for name, parts in told.items():
            put(out / "commands" / language / form / f"{name}.txt", "".join(parts))
        for path in sorted(work.rglob("*")):
            if path.is_file() and form == "text":
                put(out / "files" / language / f"{path.relative_to(work)}.txt", marks.replace(readable(path)))


def record_views(build, out, language):
    with tempfile.TemporaryDirectory() as made:
        home = pathlib.Path(made).resolve()
        trees = home / "trees"
        subprocess.run([build / "bin/codewheel-screenshots", trees, language, "trees"], check=True,
                       env=environment(home, language), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        marks = Marks(home)
        for path in sorted(trees.iterdir()):
            put(out / "views" / language / path.name, marks.replace(path.read_bytes()))


def put(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def record(build, out):
    tasks = [(record_views, (build, out, language)) for language in LANGUAGES]
    tasks += [(record_commands, (build, out, language, form)) for language in LANGUAGES for form in FORMS]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done in [pool.submit(what, *arguments) for what, arguments in tasks]:
            done.result()
    return 0


def compare(before, after):
    names = sorted({path.relative_to(folder) for folder in (before, after) for path in folder.rglob("*.txt")})
    differing = 0
    for name in names:
        lines = [(folder / name).read_text(encoding="utf-8").splitlines(keepends=True)
                 if (folder / name).exists() else [] for folder in (before, after)]
        difference = list(difflib.unified_diff(*lines, f"before/{name}", f"after/{name}"))
        differing += bool(difference)
        sys.stdout.writelines(difference)
    print(f"{len(names)} files, {differing} differ")
    return 1 if differing else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    recording = commands.add_parser("record")
    recording.add_argument("folder", type=pathlib.Path)
    recording.add_argument("--build", type=pathlib.Path, default=ROOT / "build/dev")
    recording.set_defaults(run=lambda given: record(given.build.resolve(), given.folder))
    comparing = commands.add_parser("compare")
    comparing.add_argument("before", type=pathlib.Path)
    comparing.add_argument("after", type=pathlib.Path)
    comparing.set_defaults(run=lambda given: compare(given.before, given.after))
    given = parser.parse_args()
    return given.run(given)


if __name__ == "__main__":
    sys.exit(main())
