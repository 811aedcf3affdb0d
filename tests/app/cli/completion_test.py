# SPDX-License-Identifier: MIT
"""Types Tab and Enter in a real interactive shell with the completion of barycage-cli, on names made to do harm.

usage: completion_test.py bash|zsh|fish BARYCAGE_CLI COMPLETIONS [SEED]

What a name asks for never happens, what is completed is passed to the program as exactly that name, and the program
finds the entry by it.
"""
import fcntl
import json
import os
import pty
import random
import select
import shutil
import signal
import struct
import sys
import tempfile
import termios
import time
from pathlib import Path
from xml.sax.saxutils import quoteattr

THOROUGH = "BARYCAGE_ALL" in os.environ  # every name behind every quote, and not behind one
PATIENCE = 120 # seconds, for a machine that has much else to do
PROMPT = b"@prompt@"
DONE = "@done@"
KILL_LINE = "\x15"
TABS = {"bash": "\t\t", "zsh": "\t", "fish": "\t"}  # before names are listed
MARK = "ran"  # the file that a name would like to make

NAMES = [
    "plain", "`touch$IFS./ran`", "$(touch ran)", '"$(touch ran)"', "'$(touch ran)'", "';touch ran;'", '";touch ran;"',
    ";touch ran;", "&touch ran&", "|touch ran", "x\\`touch ran\\`", "\\$(touch ran)", "(touch ran)",
    "${IFS:=$(touch ran)}", "<(touch ran)", ">ran", "{a,>ran}", "a[$(touch ran)]", "$((a[$(touch ran)]))",
    "x=$(touch ran)", "%(touch ran)", "$ran", "$HOME", "~", "~root", "a~b", "*", "?", "[a-z]*", "**/*", "{a,b}",
    "{1..3}", "#comment", "a#b", "!!", "a!b", "!touch", "^a^b", "=ls", "a=b", "a:b", "a:~", "a:b=c d", "a@b", "ends:",
    "ends=", "ends/", "a/b", "./a", "../a", ",", "%1", "%s%n", "--json", "-x", "--", "-", "--entry=x", "my name",
    "two  blanks", " led by one", "ends in one ", "it's", 'say "so"', "\"'`", "'", '"', "\\", "ends in \\", "a\\ b",
    "\\n", "\\x1b[41m", "\\e]0;pwned\\a", "tab\there", "line\nend", "\x1bcreset\x07", "\x1b[41mred", "\x9b41mred",
    "\x07\x08\x7f", "é", "Фрактал", "分形 図", "分形\u3000図", "🌿 fern", "e\u0301", "\u200frtl\u202eabc",
    "\u00a0hard blank", "\u2028", "0" * 60, "x;y" * 500, "naïve $(touch ran)", "info", "render", "''", '""', "$''",
    "a''b", "a$", "a\\", "é:$(touch ran)'",
]
PIECES = list(" '\"\\`$(){}[]<>|&;*?~!#^=:@%,/.-+_é分") + [
    "a", "b", "touch ran", "$(touch ran)", "`touch ran`", "$IFS", "'\\''", "\\'", '\\"', "\\n", "\u200f", "\x1b[41m", "&&", "${a}"]


def shown(name):
    """The name as the program prints it: what controls the terminal or turns the text is replaced."""
    turning = "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
    return "".join("\ufffd" if ord(c) < 32 or 127 <= ord(c) < 160 or c in turning else c for c in name)


def collection(folder, names):
    """A file with entries of these names: Fractint's where it can hold them, else flames that are refused, by name."""
    fractint = all(map(fits_fractint, names))
    path = folder / ("names.ifs" if fractint else "names.flame")
    if fractint:
        text = "".join(n + " {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 .5 .5\n}\n" for n in names)
    else:
        flame = '<flame name=%s><xform weight="1" spherical="1" coefs="1 0 0 1 0 0"/></flame>\n'
        escapes = {"\n": "&#10;", "\t": "&#9;"}
        text = "<flames>\n" + "".join(flame % quoteattr(n, escapes) for n in names) + "</flames>\n"
    path.write_text(text, encoding="utf-8", newline="")
    return path.name


def can_be_held(name):
    return not any(ord(c) < 32 and c not in "\t\n" for c in name) or fits_fractint(name)


def fits_fractint(name):
    return not set(name) & set("(){};\n\r") and name == name.strip()


class Shell:
    def __init__(self, kind, program, completions):
        self.kind = kind
        self.home = Path(tempfile.mkdtemp(prefix="completion-"))
        self.folder = self.home / "work"
        self.folder.mkdir()
        # Without this folder fish reads every manual page of the machine in the background.
        (self.home / ".local/share/fish/generated_completions").mkdir(parents=True)
        self.record = self.home / "record"
        self.install_recorder(program)
        self.output = b""
        binary = shutil.which(kind) or sys.exit(f"there is no {kind} here: ./dev setup installs what the tests need")
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            self.become(binary)
        fcntl.ioctl(self.terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 200, 200, 0, 0))
        self.type(self.setup(Path(completions).resolve()) + "\r")
        self.await_prompt()
        self.output = b""

    def install_recorder(self, program):
        """A barycage-cli that notes how it was called, but when a completion asks it."""
        recorder = self.home / "bin" / "barycage-cli"
        recorder.parent.mkdir()
        recorder.write_text(f"""#!/bin/sh
[ "$1 $2" = "info --names" ] && exec '{program}' "$@"
for argument; do printf '%s\\0' "$argument"; done > '{self.record}.part'
'{program}' "$@" > '{self.home}/answer' 2> '{self.home}/errors'
mv '{self.record}.part' '{self.record}'
echo {DONE}
""")
        recorder.chmod(0o755)

    def become(self, binary):
        arguments = {"bash": ["--noprofile", "--norc", "-i"], "zsh": ["-f", "-i"], "fish": ["--private", "-i"]}
        os.chdir(self.folder)
        environment = {"PATH": f"{self.home}/bin:/usr/bin:/bin", "HOME": str(self.home), "TERM": "xterm", "LC_ALL": "C.UTF-8",
                       "PS1": "> "}
        os.execve(binary, [self.kind, *arguments[self.kind]], environment)

    def setup(self, completions):
        prompt = "@prom''pt@"  # so that what is echoed is not taken for it
        if self.kind == "bash":
            return f"source '{completions}/barycage-cli.bash'; PS1={prompt}"
        if self.kind == "zsh":
            return (f"fpath=('{completions}' $fpath); autoload -Uz compinit; compinit -u -D; unset zle_bracketed_paste; "
                    f"unsetopt PROMPT_SP; PS1={prompt}")
        return f"function fish_prompt; echo -n {prompt}; end; function fish_greeting; end; source '{completions}/barycage-cli.fish'"

    def type(self, text):
        data = text.encode()
        while data:  # what comes back has to be read for the shell to go on
            self.read(0)
            data = data[os.write(self.terminal, data[:256]):]

    def read(self, seconds):
        while select.select([self.terminal], [], [], seconds)[0]:
            try:
                self.output += os.read(self.terminal, 65536)
            except OSError:
                self.fail("the shell has ended")
            seconds = 0

    def wait(self, what, happened):
        end = time.monotonic() + PATIENCE
        while not happened():
            if time.monotonic() > end:
                self.fail(f"waited in vain for {what}")
            self.read(0.02)

    def await_prompt(self, behind=b""):
        self.wait("the prompt", lambda: PROMPT in self.output.partition(behind)[2] if behind else PROMPT in self.output)

    def enter(self, line):
        """Types the line and Enter; returns the arguments that the program got."""
        self.record.unlink(missing_ok=True)
        self.line, self.output = line, b""
        self.type(line + "\r")
        self.await_prompt(behind=DONE.encode())
        return self.record.read_bytes().decode().split("\0")[:-1]

    def expect(self, actual, expected):
        if actual != expected:
            self.fail(f"got {actual!r} instead of {expected!r}")

    def expect_nothing_ran(self):
        files = [path for path in (*self.folder.rglob("*"), *self.home.iterdir()) if path.name.startswith(MARK)]
        if files:
            self.fail(f"a name was executed: there is {files[0].name}")
        for command in (b"\x1bcreset", b"\x1b[41m", b"\xc2\x9b"):
            if command in self.output:
                self.fail("a name commands the terminal")

    def fail(self, sentence):
        os.kill(self.process, signal.SIGKILL)
        sys.exit(f"{self.kind}: {sentence}\ntyped: {getattr(self, 'line', '')!r}\nscreen: "
                 f"{self.output[-1500:]!r}")

    def close(self):
        os.kill(self.process, signal.SIGHUP)
        os.close(self.terminal)
        os.waitpid(self.process, 0)
        shutil.rmtree(self.home)

    def typed(self, prefix, quote):
        """The beginning of a name as one types it, behind an open quote or none; None where that cannot be."""
        if quote == "'":
            inside = {"'": "\\'", "\\": "\\\\"} if self.kind == "fish" else {"'": "'\\''"}
        elif quote == '"':
            if "!" in prefix:
                return None
            inside = {c: "\\" + c for c in ('"$\\' if self.kind == "fish" else '"$`\\')}
        else:
            inside = {c: "\\" + c for c in " \\'\"`$(){}[]<>|&;*?~!#^"}
            if self.kind == "zsh" and prefix.startswith("="):
                inside["="] = "\\="
            if self.kind == "fish":
                inside = {c: inside[c] for c in " \\'\"$(){}[]<>|&;*?~#"}
        return quote + "".join(inside.get(c, c) for c in prefix)


def check_name(shell, name, prefix, quote, option="--entry "):
    if shell.kind == "fish" and name[0] == ".":
        prefix = prefix or "."  # the shell offers these behind a point only, as it does with files
    if shell.kind == "fish" and (name[0] == "-" or set(prefix) & set("*?")):
        prefix = ""  # behind a dash the shell offers options only, and it takes stars for patterns
    typed = shell.typed(prefix, quote)
    if typed is None:
        return
    file = collection(shell.folder, [name])
    line = f"barycage-cli info --json {file} {option}{typed}\t"
    if shell.kind == "fish" and quote and name[-1] in "/=@:.,-":
        line += quote  # the shell lets words go on behind these, and closes no quote
    arguments = shell.enter(line)
    shell.expect_nothing_ran()
    if shell.kind == "fish" and not quote and (name[0] == "~" or set(name) & set("\u00a0\u2028\u3000")):
        shell.expect(arguments[3:], [option.strip()] + ([prefix] if prefix else []))  # offered behind a quote only
        return
    given = option.strip() + shown(name) if option.endswith("=") else shown(name)
    shell.expect(arguments[3:], [given] if option.endswith("=") else [option.strip(), given])
    shell.expect([entry["name"] for entry in json.loads((shell.home / "answer").read_bytes())["entries"]], [name])


def check_names(shell):
    quotes = ("", "'", '"')
    for number, name in enumerate(NAMES):
        for quote in quotes if THOROUGH else [quotes[number % 3]]:
            check_name(shell, name, "", quote)
    for name in ("my name", "it's", "a:b=c d", "a!b", "é:$(touch ran)'", 'say "so"'):
        for size in range(1, len(name) + (shell.kind != "zsh")):
            for quote in quotes if THOROUGH else [quotes[size % 3]]:
                check_name(shell, name, name[:size], quote)
    if shell.kind != "zsh":
        for name in ("plain", "my name", "a:b=c d", "$(touch ran)"):
            check_name(shell, name, name[:1], "", "--entry=")


def check_random_names(shell, seed):
    chance = random.Random(seed)
    for _ in range(60 if THOROUGH else 20):
        name = ""
        while not name.strip() or not can_be_held(name) or shown(name).lower().startswith("comment"):
            name = "".join(chance.choice(PIECES) for _ in range(chance.randint(1, 12)))
        prefix = shown(name)[:chance.randint(0, len(name) - 1)]
        check_name(shell, name, prefix, chance.choice(["", "'", '"']))


def check_list(shell, names):
    file = collection(shell.folder, names)
    shell.line, shell.output = f"barycage-cli info {file} --entry {TABS[shell.kind]}", b""
    shell.type(shell.line)
    shell.wait("the list", lambda: b"plain" in shell.output and b"zzz" in shell.output)
    shell.expect_nothing_ran()
    shell.expect(shell.enter(f"{KILL_LINE}barycage-cli info {file}"), ["info", file])


def check_many(shell):
    names = [f"`touch ran` {i:04}" for i in range(5000)]
    file = collection(shell.folder, names)
    for start in ("'`touch ran` 234", "\\`touch\\ ran\\`\\ 234"):
        arguments = shell.enter(f"barycage-cli info {file} --names --entry {start}5\t")
        shell.expect(arguments[-1], names[2345])
    shell.expect_nothing_ran()


def check_files(shell):
    odd = "a b$(touch ran)'\"\\c.ifs"
    folder = shell.folder / "folder of $HOME"
    folder.mkdir()
    for path in (shell.folder / odd, folder / "in it.ifs"):
        path.write_text("my name {\n .5 0 0 .5 0 0 1\n}\n")
    (shell.folder / "shot of it.png").write_bytes(b"")
    arguments = shell.enter("barycage-cli info a\t --json --entry \t")
    shell.expect(arguments, ["info", odd, "--json", "--entry", "my name"])
    arguments = shell.enter("barycage-cli info fold\tin\t --entry \t")
    shell.expect(arguments, ["info", "folder of $HOME/in it.ifs", "--entry", "my name"])
    arguments = shell.enter("barycage-cli render -o sh\t --size 9x9 --points 9 --colour den\t 'fold\tin\t --entry m\t")
    shell.expect(arguments, ["render", "-o", "shot of it.png", "--size", "9x9", "--points", "9", "--colour", "density",
                             "folder of $HOME/in it.ifs", "--entry", "my name"])
    arguments = shell.enter("barycage-cli inf\t fold\tin\t --jso\t")
    shell.expect(arguments, ["info", "folder of $HOME/in it.ifs", "--json"])
    shell.expect_nothing_ran()


def main():
    kind, program, completions = sys.argv[1:4]
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 22
    shell = Shell(kind, program, completions)
    check_names(shell)
    check_files(shell)
    check_random_names(shell, seed)
    short = [name for name in NAMES if len(name) < 50]
    check_list(shell, [*filter(fits_fractint, short), "zzz"])
    check_list(shell, [*(name for name in short if not set(name) & set("\x1b\x07\x08")), "zzz"])
    check_many(shell)
    shell.close()


main()
