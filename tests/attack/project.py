# SPDX-License-Identifier: GPL-3.0-or-later
"""One project: several processes replace encoders in it at once, and are killed at random moments."""

import json
import re
import shutil
import threading
import time

PLACES = ("1.0", "2.0")


def serial_numbers(project):
    """By place; nothing if the file is no project."""
    try:
        devices = [device for bus in json.loads(project.read_bytes())["buses"] for device in bus["devices"]]
        return {one["place"]: one.get("label", {}).get("serialNumber") for one in devices}
    except (OSError, ValueError, KeyError, TypeError):
        return None


def replace(bench, project, place, serial):
    return ("replace", place, "--project", project, "--serial", serial, "--yes", "--json",
            "--beyond-eeprom-limit", place, "--ledger", bench.path(f"ledger-{place}.sqlite"))


def copy_of_example(bench, folder):
    (bench.folder / folder).mkdir()
    project = bench.folder / folder / "plant.codewheel"
    shutil.copy(bench.example("training.codewheel"), project)
    return project


def is_new_file_of_killed(one, project):
    """What a program leaves if it is killed while replacing the file (docs/project-files.md, Saving)."""
    return re.fullmatch(re.escape(project.name) + r"\.[A-Za-z]{6}", one.name) is not None


def look_for_leftovers(project, findings, was_killed=False):
    """Nothing stays beside the project but the previous file, and a lock that is not held."""
    for one in project.parent.iterdir():
        isOurs = one.name in (project.name, project.name + "~")
        if was_killed and is_new_file_of_killed(one, project):
            findings.tries("new files left by a kill")
        elif not isOurs and one.stat().st_size > 0:
            findings.loses(f"left over: {one.name}, {one.stat().st_size} bytes")
        elif not isOurs and one.name.endswith("~"):
            findings.loses(f"left over: {one.name}")


def parallel(bench, random, until, findings):
    """What a call has put into the project stays there, whatever others replace."""
    project = copy_of_example(bench, "parallel")
    guard = threading.Lock()

    def replace_one_after_the_other(place, first):
        serial = first
        while time.monotonic() < until:
            serial += 1
            run = bench.run(*replace(bench, project, place, serial))
            there = serial_numbers(project)
            with guard:
                findings.tries("encoders replaced" if run.code == 0 else "refusals")
                if not run.ended_by_itself() or (run.code != 0 and not run.err):
                    findings.loses(run)
                if there is None:
                    findings.loses(f"the project cannot be read after {run}")
                elif run.code == 0 and there.get(place) != str(serial):
                    findings.loses(f"{place} was replaced by {serial}, the project has {there.get(place)}")

    def store_again_and_again():
        while time.monotonic() < until:
            run = bench.run("store", project, PLACES[0])
            with guard:
                findings.tries("times stored" if run.code == 0 else "refusals")
                if not run.ended_by_itself() or (run.code != 0 and not run.err):
                    findings.loses(run)

    threads = [threading.Thread(target=store_again_and_again)]
    threads += [threading.Thread(target=replace_one_after_the_other, args=(place, 1000 * (index + 1)))
                for index, place in enumerate(PLACES)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    look_for_leftovers(project, findings)


def killed(bench, random, until, findings):
    """The old file or the new one is there, complete."""
    project = copy_of_example(bench, "killed")
    place = PLACES[0]
    usual = bench.run(*replace(bench, project, place, 1))
    may_be = {"1"}
    serial = 1
    while time.monotonic() < until:
        serial += 1
        call = bench.start(*replace(bench, project, place, serial))
        time.sleep(random.uniform(0, 1.2 * usual.seconds))
        call.kill()
        run = call.wait()
        findings.tries("kills")
        there = serial_numbers(project)
        may_be = {str(serial)} if run.code == 0 else may_be | {str(serial)}
        if there is None or there.get(place) not in may_be:
            findings.loses(f"{project.name} has {there and there.get(place)}, it may have {sorted(may_be)}")
            return
        may_be = {there[place]}
    end = bench.run(*replace(bench, project, place, serial + 1))
    if end.code != 0:
        findings.loses(f"after the kills: {end}")
    look_for_leftovers(project, findings, was_killed=True)
