#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the template of Open Job Description as a render manager does, tasks last to first, and compares every
byte with what one process draws.

Usage: openjd_test.py BARYCAGE-CLI TEMPLATE COLLECTION [VIDEO]    VIDEO: the step that encodes is run as well
"""
import filecmp
import os
import re
import subprocess
import sys
import tempfile


def scalar(text):
    text = text.strip()
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] == '"' else text


def parse(lines, indent):
    """The block of that indentation: the few forms of YAML that the template is written in."""
    result = None
    while lines and lines[0][0] >= indent:
        depth, text = lines[0]
        assert depth == indent, f"unexpected indentation: {text}"
        if text.startswith("- "):
            result = [] if result is None else result
            rest = text[2:]
            if re.match(r"[A-Za-z]+:(\s|$)", rest):
                lines[0] = (indent + 2, rest)
                result.append(parse(lines, indent + 2))
            else:
                lines.pop(0)
                result.append(scalar(rest))
        else:
            result = {} if result is None else result
            key, value = re.fullmatch(r"([A-Za-z]+):\s*(.*)", text).groups()
            assert key not in result, f"twice: {key}"
            lines.pop(0)
            result[key] = scalar(value) if value else parse(lines, lines[0][0])
    return result


def template(path):
    with open(path, encoding="utf-8") as file:
        lines = [line.rstrip() for line in file if line.strip() and not line.lstrip().startswith("#")]
    return parse([(len(line) - len(line.lstrip()), line.lstrip()) for line in lines], 0)


def filled(text, values):
    """Every reference must be to something that is defined."""
    return re.sub(r"\{\{\s*([A-Za-z.]+)\s*\}\}", lambda match: values[match.group(1)], text)


def command(program, step, values):
    action = step["script"]["actions"]["onRun"]
    assert action["command"] == "barycage-cli", action["command"]
    return [program] + [filled(argument, values) for argument in action["args"]]


def main():
    program, path, collection = sys.argv[1:4]
    has_video = len(sys.argv) > 4
    job = template(path)
    assert job["specificationVersion"] == "jobtemplate-2023-09"
    with tempfile.TemporaryDirectory() as parent:
        folder = f"{parent}/{{{{Param.Entry}}}} # %n $(touch canary)\n"
        os.mkdir(folder)
        given = {"File": collection, "Entry": "maple_wind", "Frames": f"{folder}/frames",
                 "Output": f"{folder}/job.mkv", "Tasks": "3", "LastTask": "2", "Size": "64x48",
                 "Points": "20000"}
        values = {}
        for parameter in job["parameterDefinitions"]:
            name = parameter["name"]
            assert name in given or "default" in parameter, f"{name} is not given"
            values[f"Param.{name}"] = given.pop(name, None) or parameter["default"]
        assert not given, f"not in the template: {given}"
        assert filled(job["name"], values) == "Barycage maple_wind"
        draw, encode = job["steps"]
        assert encode["dependencies"] == [{"dependsOn": draw["name"]}]
        task, = draw["parameterSpace"]["taskParameterDefinitions"]
        first, last = filled(task["range"], values).split("-")
        os.mkdir(values["Param.Frames"])
        os.mkdir(f"{folder}/alone")
        for number in range(int(last), int(first) - 1, -1):
            subprocess.run(command(program, draw, values | {f"Task.Param.{task['name']}": str(number)}), check=True)
        alone = command(program, draw, values | {"Param.Frames": f"{folder}/alone", "Param.Tasks": "1",
                                                 f"Task.Param.{task['name']}": "0"})
        subprocess.run(alone, check=True)
        frames = sorted(os.listdir(f"{folder}/alone"))
        assert len(frames) > 10 and frames == sorted(os.listdir(values["Param.Frames"])), frames
        for frame in frames:
            same = filecmp.cmp(f"{folder}/alone/{frame}", f"{values['Param.Frames']}/{frame}", shallow=False)
            assert same, f"{frame} differs"
        if has_video:
            subprocess.run(command(program, encode, values), check=True)
            subprocess.run([program, "encode", f"{folder}/alone/######.png", "-o", f"{folder}/alone.mkv"], check=True)
            assert filecmp.cmp(f"{folder}/alone.mkv", values["Param.Output"], shallow=False), "the videos differ"
    print(f"{len(frames)} frames in {int(last) + 1} tasks")


if __name__ == "__main__":
    main()
