# SPDX-License-Identifier: MIT
"""Reads the tree that the running editor shows to screen readers, as one of them would: over AT-SPI.

usage: xvfb-run dbus-run-session python3 accessible_tree.py PROGRAM   (./dev test --programs)
"""
import os
import re
import subprocess
import sys
import tempfile
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib

CONTROLS = {
    "push button", "toggle button", "check box", "radio button", "combo box", "text", "spin button", "slider",
    "list", "list item", "table", "table cell", "tree", "page tab", "menu", "menu item", "canvas", "image",
}


def wait_for(what, find, seconds=90):
    for _ in range(seconds * 4):
        try:
            if found := find():
                return found
        except GLib.GError:  # the editor is busy with starting
            pass
        time.sleep(0.25)
    sys.exit(f"{what} did not appear")


def children(node):
    return [child for child in (node.get_child_at_index(i) for i in range(node.get_child_count())) if child]


def editor():
    programs = [node for node in children(Atspi.get_desktop(0)) if "Barycage" in (node.get_name() or "")]
    return programs[0] if programs and programs[0].get_child_count() else None


def below(node, path=()):
    yield node, path
    for child in children(node):
        yield from below(child, (*path, node.get_name() or node.get_role_name()))


def canvas(program):
    return next((node for node, _ in below(program) if node.get_role_name() == "canvas"), None)


def vertices(canvas):
    named = {node.get_name(): node for node in children(canvas)}
    return {name: node for name, node in named.items() if re.fullmatch(r"Vertex \d+", name or "")}


def main():
    home = tempfile.TemporaryDirectory()
    surroundings = {**os.environ, "HOME": home.name, "LC_ALL": "C.UTF-8", "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1"}
    surroundings.pop("QT_QPA_PLATFORM", None)
    process = subprocess.Popen([sys.argv[1]], env=surroundings)
    try:
        program = wait_for("the editor", editor)
        drawn = wait_for("the canvas", lambda: canvas(program))
        wait_for("the cage", lambda: len(vertices(drawn)) == 3)
        nameless, controls = [], 0
        for node, path in below(program):
            if node.get_role_name() in CONTROLS and node.get_state_set().contains(Atspi.StateType.SHOWING):
                controls += 1
                if not (node.get_name() or "").strip():
                    nameless.append(" › ".join((*path, node.get_role_name())))
        print(f"{controls} controls, {len(nameless)} without a name", *nameless, sep="\n")
        taken = vertices(drawn)["Vertex 2"]
        where = taken.get_description()
        print("Vertex 2 is at", where)
        numbers = re.fullmatch(r"x (-?[\d.]+), y (-?[\d.]+)", where)
        actions = [taken.get_action_name(i) for i in range(taken.get_n_actions())]
        taken.do_action(actions.index("moveRight"))
        moved = wait_for("the move", lambda: (now := vertices(drawn)["Vertex 2"].get_description()) != where and now, 10)
        print("and after one step to the right at", moved)
        further = float(re.match(r"x (-?[\d.]+)", moved)[1]) > float(numbers[1])
        sys.exit(0 if controls > 100 and not nameless and further else 1)
    finally:
        process.terminate()
        process.wait()


main()
