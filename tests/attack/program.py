# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the real codewheel-cli: undisturbed, many at once, killed, with little room, and without output."""

import json
import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import threading
import time

PATIENCE = 60  # s, for any single call: one that takes longer hangs


class Run:
    """The outcome of one call."""

    def __init__(self, arguments, code, out, err, seconds, peak_kilobytes):
        self.arguments = arguments
        self.code = code  # as in a shell; negative: the signal that ended it; None: it hung
        self.out = out
        self.err = err
        self.seconds = seconds
        self.peak_kilobytes = peak_kilobytes

    def ended_by_itself(self):
        return self.code is not None and self.code >= 0

    def answer(self):
        """The output of --json; {} if there was none, or something else."""
        try:
            told = json.loads(self.out)
        except ValueError:
            return {}
        return told if isinstance(told, dict) else {}

    def __str__(self):
        call = "codewheel-cli " + " ".join(self.arguments)
        if self.code is None:
            return f"{call}: did not end within {PATIENCE} s"
        how = f"signal {signal.Signals(-self.code).name}" if self.code < 0 else f"exit code {self.code}"
        return f"{call}: {how}; {self.err.decode(errors='replace').strip()[:300]!r}"


class Call:
    """A running call. Its output goes to files, so that it never waits for a reader."""

    def __init__(self, bench, arguments, *, stdout=None, stderr=None, prepare=None, prefix=()):
        self.arguments = [str(argument) for argument in arguments]
        self._out = tempfile.TemporaryFile()
        self._err = tempfile.TemporaryFile()
        self._begin = time.monotonic()
        self._process = subprocess.Popen(
            [*prefix, str(bench.cli), *self.arguments], stdin=subprocess.DEVNULL,
            stdout=self._out if stdout is None else stdout, stderr=self._err if stderr is None else stderr,
            preexec_fn=prepare, env=bench.environment, cwd=bench.folder)

    def kill(self):
        os.kill(self._process.pid, signal.SIGKILL)  # nothing else waits for this process

    def wait(self):
        hung = threading.Timer(PATIENCE, self.kill)
        hung.start()
        _, status, usage = os.wait4(self._process.pid, 0)
        seconds = time.monotonic() - self._begin
        hung.cancel()
        code = os.waitstatus_to_exitcode(status)
        self._process.returncode = code  # so that subprocess does not wait again
        if code == -signal.SIGKILL and seconds >= PATIENCE:
            code = None
        return Run(self.arguments, code, self._read(self._out), self._read(self._err), seconds, usage.ru_maxrss)

    @staticmethod
    def _read(file):
        with file:
            file.seek(0)
            return file.read()


class Bench:
    """A folder and a user for one attack."""

    def __init__(self, cli, writer, root, folder):
        self.cli = pathlib.Path(cli)
        self.writer = pathlib.Path(writer)  # tests/journal/journal_writer.cpp
        self.root = pathlib.Path(root)  # of the sources
        self.folder = pathlib.Path(folder)
        self.environment = {
            "PATH": os.environ.get("PATH", "/usr/bin:/bin"), "LC_ALL": "C.UTF-8", "HOME": str(folder),
            "XDG_DATA_HOME": str(self.folder / "data"), "XDG_CONFIG_HOME": str(self.folder / "config"),
            "XDG_RUNTIME_DIR": str(self.folder), "QT_QPA_PLATFORM": "offscreen"}

    def start(self, *arguments, **how):
        return Call(self, arguments, **how)

    def run(self, *arguments, **how):
        return self.start(*arguments, **how).wait()

    def example(self, name):
        return self.root / "docs" / "examples" / name

    def seed_of_fuzzer(self, name):
        """A file of a fuzz target; one of the journal without the letter that selects the kind."""
        data = (self.root / "tests" / "fuzz" / "corpus" / name).read_bytes()
        return data[1:] if name.startswith("journal/") else data

    def path(self, name):
        return self.folder / name


def at_most(file_bytes):
    """For `prepare`: no file grows beyond this; further writes fail, as on a full disk."""

    def prepare():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))

    return prepare


def with_memory(most_bytes):
    """For `prepare`: limits the memory to this."""

    def prepare():
        resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes))

    return prepare


def closed(*descriptors):
    """For `prepare`: starts without these."""

    def prepare():
        for descriptor in descriptors:
            os.close(descriptor)

    return prepare
