# SPDX-License-Identifier: MIT
"""Checks what barycage-cli info --json prints against docs/info.schema.json.

usage: schema_test.py BARYCAGE_CLI SCHEMA FILE...
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}
KNOWN = {"$schema", "$ref", "$defs", "title", "description", "type", "properties", "required", "additionalProperties",
         "items", "minItems", "maxItems", "minimum", "maximum", "enum", "anyOf", "pattern"}
ODD = """one { ; a single map
 .5 0 0 .5 0 0 1
}
spin {
 0 -1 1 0 0 0 1
}
bad {
 .5 0 0 x 0 0 1
}
off {
 .5 0 0 .5 0 0 0
}
bent {
 ; barycage: rest 0 0
 ; barycage: rest 1 0
 ; barycage: rest 1 1
 ; barycage: rest 0 1
 ; barycage: current 0 0
 ; barycage: current 1 0
 ; barycage: current 2 2
 ; barycage: current 0 1
 .5 0 0 .5 0 0 .5
 .5 0 0 .5 .5 0 .5
}
moving {
 ; barycage: animation 8 24/1 cycle
 ; barycage: track map 1
 ; barycage: key 0 linear
 ; barycage: value .5 0 0 .5 0 0 .5
 .5 0 0 .5 0 0 .5
 .5 0 0 .5 .5 0 .5
}
twin { ; a tile, symmetric
 ; barycage: symmetry c2
 .5 .5 -.5 .5 0 0 .5
 .5 .5 -.5 .5 1 0 .5
}
twindragon {
 .5 .5 -.5 .5 0 0 .5
 .5 .5 -.5 .5 1 0 .5
}
koch { ; its numbers are rounded
 .3333333333333333 0 0 .3333333333333333 0 0 .25
 .16666666666666666 -.28867513459481287 .28867513459481287 .16666666666666666 .3333333333333333 0 .25
 .16666666666666666 .28867513459481287 -.28867513459481287 .16666666666666666 .5 .28867513459481287 .25
 .3333333333333333 0 0 .3333333333333333 .6666666666666666 0 .25
}
linked {
 ; barycage: links 1 0 1
 .5 0 0 .5 0 0 .5
 .5 0 0 .5 .5 0 .5
}
fern3 (3D) {
 .5 0 0 0 .5 0 0 0 .5 0 0 0 1
 .5 0 0 0 .5 0 0 0 .5 1 0 0 1
 .5 0 0 0 .5 0 0 0 .5 0 1 1 1
}
"""


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def fits(value, kind):
    if kind == "number":
        return is_number(value)
    if kind == "integer":
        return is_number(value) and value == int(value)
    return isinstance(value, TYPES[kind])


def errors(value, schema, whole, path="$"):
    """What is wrong with the value: the part of JSON Schema that the file uses."""
    unknown = set(schema) - KNOWN
    if unknown:
        return [f"{path}: the schema has {unknown}, which this test does not know"]
    found = []
    if "$ref" in schema:
        part = whole
        for key in schema["$ref"].removeprefix("#/").split("/"):
            part = part[key]
        found += errors(value, part, whole, path)
    if "anyOf" in schema:
        all_errors = [errors(value, option, whole, path) for option in schema["anyOf"]]
        if all(all_errors):
            found += all_errors[0]
    if "enum" in schema and value not in schema["enum"]:
        found.append(f"{path}: {value!r} is none of {schema['enum']}")
    if "type" in schema and not fits(value, schema["type"]):
        return found + [f"{path}: {value!r} is no {schema['type']}"]
    if is_number(value) and not schema.get("minimum", value) <= value <= schema.get("maximum", value):
        found.append(f"{path}: {value!r} is out of range")
    if isinstance(value, str) and not re.search(schema.get("pattern", ""), value):
        found.append(f"{path}: {value!r} does not match")
    if isinstance(value, list):
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
            found.append(f"{path}: {len(value)} items")
        for i, item in enumerate(value):
            found += errors(item, schema.get("items", {}), whole, f"{path}[{i}]")
    if isinstance(value, dict):
        properties = schema.get("properties", {})
        found += [f"{path}: no {key!r}" for key in schema.get("required", []) if key not in value]
        for key, item in value.items():
            if key in properties:
                found += errors(item, properties[key], whole, f"{path}.{key}")
            elif schema.get("additionalProperties", True) is False:
                found.append(f"{path}: {key!r} is not described")
    return found


def main():
    program, schema_file, *files = sys.argv[1:]
    text = Path(schema_file).read_text(encoding="utf-8")
    written = subprocess.run([program, "--describe", "schema"], stdout=subprocess.PIPE, check=True).stdout
    if written.decode("utf-8") != text:
        sys.exit(f"./dev describe renews {schema_file}")
    schema = json.loads(text)
    with tempfile.TemporaryDirectory() as folder:
        odd = Path(folder) / "odd.ifs"
        odd.write_text(ODD, encoding="utf-8")
        table = Path(folder) / "table.csv"
        table.write_text("a,b,c,d,e,f,p\n.5,0,0,.5,0,0,.5\n.5,0,0,.5,.5,0,.5\n", encoding="utf-8")
        alien = Path(folder) / "alien.txt"
        alien.write_text("Once upon a time\n", encoding="utf-8")
        flame = Path(folder) / "odd.flame"
        subprocess.run([program, "convert", odd, flame, "--entry", "one"], check=True)
        hopeless = Path(folder) / "late.ifs"
        rows = "".join(f" .3 {i / 100} -.2 .4 {i} {i * i % 7} 1\n" for i in range(59))
        twice = "twice {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 1 0 .4\n}\n"
        thirds = "thirds {\n" + "".join(f" {1 / 3} 0 0 {1 / 3} {k / 3} 0 1\n" for k in range(3)) + "}\n"
        hopeless.write_text("late {\n" + rows + "}\n" + twice + thirds, encoding="utf-8")
        entries, described, late = 0, set(), set()
        calls = [(file, []) for file in [odd, table, alien, flame, hopeless, *files]]
        for file in (odd, hopeless, files[0]):
            calls += [(file, ["--budget", "1e-9"]), (file, ["--budget", "0.01"]), (file, ["--list"])]
        for file, options in calls:
            run = subprocess.run([program, "info", "--json", *options, file], stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, check=False)
            report = json.loads(run.stdout)
            found = errors(report, schema, schema)
            if found:
                sys.exit(f"{file}: " + "\n".join(found[:20]))
            entries += len(report["entries"])
            for entry in report["entries"]:
                described |= {key for key, value in entry.items() if value not in (None, [])}
                late |= {key for key in entry.get("out_of_time") or [] if entry.get(key) is None}
        known = schema["$defs"]["entry"]["properties"]
        missing = (set(known) | set(schema["$defs"]["listed"]["properties"])) - described
        if missing - {"moved_branches"} or entries < 20:
            sys.exit(f"never seen: {missing}")
        never_late = set(known["out_of_time"]["anyOf"][0]["items"]["enum"]) - late
        if never_late - {"addresses"}:
            sys.exit(f"never out of time: {never_late}")
        # A checker that lets everything pass would be of no use.
        for wrong in ({"file": 1}, {**report, "entries": [{}]}, {**report, "more": 1}, {**report, "format": "docx"}):
            if not errors(wrong, schema, schema):
                sys.exit(f"{wrong} passed")


main()
