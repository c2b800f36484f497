#!/usr/bin/env python3
"""Runs the examples of the documentation and compares what they print with what the page says, byte for byte
but for the 13th and later digits of a number.

usage: examples.py [--update] --bin DIR --files DIR DOCUMENT…
       examples.py --self-test

An example is a block in which a line starts with "$ ": in Markdown a fence marked `console`, in a manual page the text
between .EX and .EE. "$ " starts a command, "> " continues it, all other lines are its output, standard error included.
A line "…" stands for any lines, or none. Blocks marked otherwise (`sh`, `json`, …) are shown, not run.

Every block starts in an empty folder that holds copies of the files in --files, with --bin first in the PATH and the
program also as tools/predict. Its commands share one shell, so `$?` and files reach from one to the next.
--update writes what the commands print into the documents instead, except where an expected output contains "…".
"""
import argparse
import contextlib
import difflib
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

ANY = "…"
SECONDS_A_BLOCK = 120


class Markdown:
    start = re.compile(r"^```console\s*$")
    end = re.compile(r"^```\s*$")
    decode = staticmethod(lambda line: line)
    encode = staticmethod(lambda line: line)


class Manual:
    start = re.compile(r"^\.EX\s*$")
    end = re.compile(r"^\.EE\s*$")
    # roff escape ↔ character; the backslash itself comes first when encoding and last when decoding
    ESCAPES = [("\\e", "\\"), ("\\-", "-"), ("\\(aq", "'"), ("\\(ga", "`"), ("\\(ha", "^"), ("\\(ti", "~"), ("\\(dq", '"')]

    @staticmethod
    def decode(line):
        escapes = dict(Manual.ESCAPES) | {"\\&": "", "\\(bu": "•"}
        return re.sub(r"\\(?:\(..|.)", lambda m: escapes.get(m[0], m[0]), line)

    @staticmethod
    def encode(line):
        characters = {character: escape for escape, character in Manual.ESCAPES if character != '"'}
        text = "".join(characters.get(c, c) for c in line)
        return "\\&" + text if line[:1] in (".", "'") else text


@dataclass
class Command:
    text: str
    source: list  # the lines of the document it was written as
    expected: list = field(default_factory=list)
    line: int = 0  # of the document


def blocks_of(document):
    """(first line, last line, commands, syntax) of every example in a document; lines count from 0, the fences excluded."""
    lines = document.read_text(encoding="utf-8").split("\n")
    syntax = Markdown if document.suffix == ".md" else Manual
    at = 0
    while at < len(lines):
        if not syntax.start.match(lines[at]):
            at += 1
            continue
        begin = at + 1
        end = next((i for i in range(begin, len(lines)) if syntax.end.match(lines[i])), None)
        if end is None:
            sys.exit(f"{document}:{begin}: this block has no end")
        commands = commands_of(lines, begin, end, syntax, document)
        if commands:
            yield begin, end, commands, syntax
        at = end + 1


def commands_of(lines, begin, end, syntax, document):
    commands = []
    for number in range(begin, end):
        text = syntax.decode(lines[number])
        if text.startswith("$ "):
            commands.append(Command(text[2:], [lines[number]], line=number + 1))
        elif commands and not commands[-1].expected and text.startswith("> "):
            commands[-1].text += "\n" + text[2:]
            commands[-1].source.append(lines[number])
        elif commands:
            commands[-1].expected.append(text)
        elif syntax is Markdown:
            sys.exit(f"{document}:{number + 1}: output without a command")
        else:
            return []  # a manual page shows other things in this form too
    return commands


def run(commands, bin_dir, files):
    """What each command prints, as lists of lines."""
    with tempfile.TemporaryDirectory() as folder:
        for file in files.iterdir():
            if file.is_file():
                shutil.copy(file, folder)
        (Path(folder) / "tools").mkdir()
        (Path(folder) / "tools" / "predict").symlink_to(bin_dir / "bioprint-predict")
        mark = "\x1eend of an example\x1e"
        script = "exec 2>&1\n" + "".join(
            f"{command.text}\n__status=$?; printf '%s\\n' '{mark}'; (exit $__status)\n" for command in commands
        )
        environment = {"PATH": f"{bin_dir}:/usr/bin:/bin", "HOME": folder, "LC_ALL": "C.UTF-8", "COLUMNS": "80"}
        for name in ("ASAN_OPTIONS", "UBSAN_OPTIONS"):
            if name in os.environ:
                environment[name] = os.environ[name]
        done = subprocess.run(
            ["bash", "-c", script], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            timeout=SECONDS_A_BLOCK, check=False,
        )
    printed = done.stdout.decode("utf-8", "backslashreplace").split(mark + "\n")
    if len(printed) != len(commands) + 1:
        sys.exit(f"the shell broke off in: {commands[0].text}\n{printed[-1]}")
    return [lines_of(text) for text in printed[:-1]]


def lines_of(text):
    if text and not text.endswith("\n"):
        text += "\n(no newline at the end)\n"
    return text.split("\n")[:-1]


NUMBER = re.compile(r"-?\d+\.\d{9,}(?:e[-+]?\d+)?|-?\d\.?\d*e[-+]\d+")
ROUNDING = 1e-12


def same_line(expected, printed):
    """Equal, but for the last of many digits: mathematical libraries round them by the processor they find."""
    if expected == printed:
        return True
    if NUMBER.sub("#", expected) != NUMBER.sub("#", printed):
        return False
    pairs = zip(NUMBER.findall(expected), NUMBER.findall(printed))
    return all(abs(float(a) - float(b)) <= ROUNDING * abs(float(a)) for a, b in pairs)


def same_lines(expected, printed):
    return len(expected) == len(printed) and all(map(same_line, expected, printed))


def matches(expected, printed):
    if ANY not in expected:
        return same_lines(expected, printed)
    at = expected.index(ANY)
    rest = expected[at + 1 :]
    return same_lines(expected[:at], printed[:at]) and any(matches(rest, printed[i:]) for i in range(at, len(printed) + 1))


def check(document, bin_dir, files):
    """(examples run, examples that print something else)"""
    count = wrong = 0
    for _, _, commands, _ in blocks_of(document):
        for command, printed in zip(commands, run(commands, bin_dir, files)):
            count += 1
            if not matches(command.expected, printed):
                wrong += 1
                print(f"{document.name}:{command.line}: $ {command.text}")
                print("\n".join(difflib.unified_diff(command.expected, printed, "the page", "the program", lineterm="")))
    return count, wrong


def update(document, bin_dir, files):
    lines = document.read_text(encoding="utf-8").split("\n")
    for begin, end, commands, syntax in reversed(list(blocks_of(document))):
        fresh = []
        for command, printed in zip(commands, run(commands, bin_dir, files)):
            output = command.expected if ANY in command.expected else printed
            fresh += command.source + [syntax.encode(line) for line in output]
        lines[begin:end] = fresh
    document.write_text("\n".join(lines), encoding="utf-8")


def self_test():
    """Right and wrong pages of both kinds, with `printf` in the program's place."""
    with tempfile.TemporaryDirectory() as folder:
        files = Path(folder) / "files"
        files.mkdir()
        (files / "rows.csv").write_text("a,b\n1,2\n")
        page = "# x\n```console\n$ printf 'a\\nb\\nc\\n'\na\n{}\nc\n$ false\n$ echo $?\n1\n```\n```sh\n$ never run\n```\n"
        manual = ".EX\n$ cat \\\n> rows.csv | tr , \\-\na\\-b\n{}\n.EE\n.EX\nshown alone\n.EE\n"
        cases = [
            ("a.md", page.format("b"), 3, 0), ("b.md", page.format("x"), 3, 1), ("c.md", page.format(ANY), 3, 0),
            ("d.md", page.format(f"{ANY}\nb"), 3, 0), ("e.md", page.format(f"{ANY}\nx"), 3, 1),
            ("f.1", manual.format("1\\-2").replace("\\\n", "\\e\n"), 1, 0),
            ("g.1", manual.format("1\\-3").replace("\\\n", "\\e\n"), 1, 1),
        ]  # fmt: skip
        for name, text, count, wrong in cases:
            document = Path(folder) / name
            document.write_text(text, encoding="utf-8")
            with contextlib.redirect_stdout(io.StringIO()):  # what is wrong with a wrong page is no news here
                result = check(document, files, files)
            if result != (count, wrong):
                sys.exit(f"{name}: {result[0]} examples, {result[1]} wrong; expected {count} and {wrong}")
            update(document, files, files)
            if wrong and ANY not in text and check(document, files, files) != (count, 0):
                sys.exit(f"{name}: --update did not make it right")
    print("examples: right pages pass, wrong ones do not")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("documents", nargs="*", type=Path)
    parser.add_argument("--bin", type=Path)
    parser.add_argument("--files", type=Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    bad = 0
    for document in arguments.documents:
        if arguments.update:
            update(document, arguments.bin.resolve(), arguments.files.resolve())
            continue
        count, wrong = check(document, arguments.bin.resolve(), arguments.files.resolve())
        print(f"{document.name}: {count - wrong} of {count} examples print what the page says")
        bad += wrong + (count == 0)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
