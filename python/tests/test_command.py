"""Is the command that the package brings the program, with all its commands?"""

import os
import signal
import subprocess
import sys
import sysconfig
import time
from importlib.metadata import files, requires, version
from pathlib import Path

import pytest

COMMAND = Path(sysconfig.get_path("scripts")) / ("crankstar.exe" if os.name == "nt" else "crankstar")
PROGRAM = os.environ.get("CRANKSTAR_PROGRAM", "")
ASKED = [
    ["--help"],
    ["list"],
    ["classify", "I4", "--json"],
    ["sweep", "V6-60-shared", "--bank-angle", "0..180:30", "--format", "csv"],
    ["optimise", "--help"],
    ["completions", "bash"],
]


def asked(*arguments: str, by: tuple[str, ...] = (str(COMMAND),), folder: Path | None = None):
    return subprocess.run([*by, *arguments], capture_output=True, text=True, encoding="utf-8", cwd=folder)


def test_the_command_is_installed_and_tells_its_version():
    told = asked("--version")
    assert (told.returncode, told.stdout) == (0, f"crankstar {version('crankstar')}\n")


@pytest.mark.skipif(not PROGRAM, reason="CRANKSTAR_PROGRAM names no program")
@pytest.mark.parametrize("arguments", ASKED, ids=" ".join)
def test_it_answers_as_the_program_does(arguments: list[str]):
    by_program = asked(*arguments, by=(PROGRAM,))
    by_command = asked(*arguments)
    by_module = asked(*arguments, by=(sys.executable, "-m", "crankstar"))
    assert by_program.returncode == 0 and by_program.stdout
    for told in (by_command, by_module):
        assert (told.returncode, told.stdout, told.stderr) == (0, by_program.stdout, by_program.stderr)


def test_exit_statuses_are_those_of_the_program(tmp_path: Path):
    assert asked("classify", "no-such-engine.toml", folder=tmp_path).returncode == 1
    assert asked("no-such-command").returncode == 2
    (tmp_path / "claims.toml").write_text(
        'title = "A wrong claim"\n[[statement]]\nsource = "a book"\nengine = "I4"\nclaims = ["the force of order 2 vanishes"]\n',
        encoding="utf-8",
    )
    told = asked("check", "claims.toml", folder=tmp_path)
    assert told.returncode == 1, told


def test_a_report_is_written(tmp_path: Path):
    assert asked("report", "I4", "--output", "I4-report", folder=tmp_path).returncode == 0
    assert (tmp_path / "I4-report" / "report.md").is_file()


def test_the_code_is_in_the_package_once():
    carried = [file for file in files("crankstar") or [] if file.suffix in {".so", ".pyd", ".dylib", ".dll"} or file.name == "crankstar.exe"]
    modules = [file for file in carried if file.name.startswith("_crankstar")]
    assert len(modules) == 1
    assert COMMAND.stat().st_size < 200_000


def test_the_command_asks_for_no_other_package():
    assert all("extra ==" in requirement for requirement in requires("crankstar") or [])


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_an_interrupt_ends_it_at_once():
    arguments = [str(COMMAND), "search", "--cylinders", "18", "--cycle", "two-stroke", "--threads", "1"]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        time.sleep(1)
        assert child.poll() is None
        sent = time.time()
        child.send_signal(signal.SIGINT)
        assert child.wait(timeout=30) == -signal.SIGINT
        assert time.time() - sent < 0.5


@pytest.mark.skipif(os.name != "posix", reason="descriptors")
def test_closed_output_is_told():
    told = subprocess.run(["sh", "-c", 'exec "$0" list >&-', str(COMMAND)], stderr=subprocess.PIPE, text=True)
    assert told.returncode == 1
    assert told.stderr == "error: cannot write to standard output: it is closed\n"
