#!/usr/bin/env python3
"""clang_tidy.py BUILD_FOLDER < list of source files: clang-tidy over those in the compile database.

A file that passed is not looked at again until it, one of our headers it includes, its compile
command or a .clang-tidy changes: a stamp named by the digest of all these stands in
BUILD_FOLDER/clang-tidy.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys


def our_includes(build, root):
    """Object file -> files under root it was made from, by ninja's record of the last build."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True)
    made_from, current = {}, None
    for line in listing.stdout.splitlines():
        if line.startswith("    "):
            path = (build / line.strip()).resolve()
            if root in path.parents:
                current.append(path)
        elif ": #deps" in line:
            current = made_from.setdefault(line.split(": #deps")[0], [])
    return made_from


def object_file(entry):
    words = shlex.split(entry["command"])
    return words[words.index("-o") + 1]


def settings(source, root):
    folders = [folder for folder in source.parents if folder == root or root in folder.parents]
    return [folder / ".clang-tidy" for folder in folders if (folder / ".clang-tidy").exists()]


def digest(entry, files):
    text = hashlib.sha256(entry["command"].encode())
    for path in sorted(set(files)):
        text.update(str(path).encode())
        text.update(path.read_bytes())
    return text.hexdigest()


def without_precompiled(entry):
    """clang cannot read g++'s precompiled headers, and a file is to include what it needs itself."""
    words = shlex.split(entry["command"])
    for place in [i for i, word in enumerate(words) if word == "-include"][::-1]:
        if words[place + 1].endswith("cmake_pch.hxx"):
            del words[place : place + 2]
    return {**entry, "command": shlex.join(words)}


def tidy(database, source):
    return subprocess.run(["clang-tidy", "--quiet", "-p", database, source], capture_output=True, text=True)


def main():
    root = pathlib.Path.cwd()
    build = pathlib.Path(sys.argv[1])
    stamps = build / "clang-tidy"
    stamps.mkdir(exist_ok=True)
    listed = {str(root / line.strip()) for line in sys.stdin}
    made_from = our_includes(build, root)

    entries = json.loads((build / "compile_commands.json").read_text())
    (stamps / "compile_commands.json").write_text(json.dumps([without_precompiled(entry) for entry in entries]))

    todo = {}  # one entry a source: a file built twice is still one file
    for entry in entries:
        source = pathlib.Path(entry["file"])
        if str(source) not in listed:
            continue
        files = made_from.get(object_file(entry), []) + settings(source, root) + [source]
        stamp = stamps / digest(entry, files)
        if not stamp.exists():
            todo[source] = stamp

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = {pool.submit(tidy, stamps, source): source for source in todo}
        for done, future in enumerate(concurrent.futures.as_completed(running), 1):
            source, result = running[future], future.result()
            name = os.path.relpath(source, root)
            print(f"[{done}/{len(todo)}] clang-tidy {name}", file=sys.stderr, flush=True)
            if result.returncode == 0:
                todo[source].touch()
            else:
                failed += 1
                print(result.stdout or result.stderr, file=sys.stderr, flush=True)
    return 1 if failed else 0


sys.exit(main())
