#!/usr/bin/env python3
"""clang_tidy.py BUILD_FOLDER < list of source files: clang-tidy over those in the compile database.

Files that are compiled together (a unity build) are checked together. A unit that passed is checked
again only if one of its files, a header of this tree that they include, the compile command or a
.clang-tidy has changed: a stamp named by the digest of all these is in BUILD_FOLDER/clang-tidy.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys


def our_includes(build, root):
    """Object file -> files under root that it was built from, by ninja's record of the last build."""
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


def sources_of(unit):
    """The files that a translation unit compiles: those that a unity file includes, otherwise itself."""
    if "/Unity/unity_" not in str(unit):
        return [unit]
    return [pathlib.Path(path) for path in re.findall(r'^#include "(.*)"$', unit.read_text(), re.MULTILINE)]


def settings(sources, root):
    folders = {folder for source in sources for folder in source.parents if folder == root or root in folder.parents}
    return [folder / ".clang-tidy" for folder in folders if (folder / ".clang-tidy").exists()]


def digest(entry, files):
    text = hashlib.sha256(entry["command"].encode())
    for path in sorted(set(files)):
        text.update(str(path).encode())
        text.update(path.read_bytes())
    return text.hexdigest()


def without_precompiled(entry):
    """clang cannot read g++'s precompiled headers."""
    words = shlex.split(entry["command"])
    for place in [i for i, word in enumerate(words) if word == "-include"][::-1]:
        if words[place + 1].endswith("cmake_pch.hxx"):
            del words[place : place + 2]
    return {**entry, "command": shlex.join(words)}


def tidy(database, unit):
    return subprocess.run(["clang-tidy", "--quiet", "-p", database, unit], capture_output=True, text=True)


def main():
    root = pathlib.Path.cwd()
    build = pathlib.Path(sys.argv[1])
    stamps = build / "clang-tidy"
    stamps.mkdir(exist_ok=True)
    listed = {str(root / line.strip()) for line in sys.stdin}
    made_from = our_includes(build, root)

    entries = json.loads((build / "compile_commands.json").read_text())
    (stamps / "compile_commands.json").write_text(json.dumps([without_precompiled(entry) for entry in entries]))

    todo = {}  # one entry for each unit, also if it is built twice
    for entry in entries:
        unit = pathlib.Path(entry["file"])
        sources = sources_of(unit)
        if not listed.intersection(map(str, sources)):
            continue
        checks = settings(sources, root)
        for own in checks:  # clang-tidy looks for them above the unit
            (build / own.relative_to(root)).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(own, build / own.relative_to(root))
        files = made_from.get(object_file(entry), []) + checks + sources
        stamp = stamps / digest(entry, files)
        if not stamp.exists():
            todo[unit] = stamp

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = {pool.submit(tidy, stamps, unit): unit for unit in todo}
        for done, future in enumerate(concurrent.futures.as_completed(running), 1):
            unit, result = running[future], future.result()
            names = " ".join(os.path.relpath(source, root) for source in sources_of(unit))
            print(f"[{done}/{len(todo)}] clang-tidy {names}", file=sys.stderr, flush=True)
            if result.returncode == 0:
                todo[unit].touch()
            else:
                failed += 1
                print(result.stdout or result.stderr, file=sys.stderr, flush=True)
    return 1 if failed else 0


sys.exit(main())
