#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds the documentation as a site that needs no server and no network: ./dev site

    build.py BARYCAGE_CLI FOLDER

A page for each document that docs/README.md leads to; its lists are the navigation. A picture named after an entry of
docs/figures.ifs is a figure that can be dragged, where scripts run. What cannot be right ends the build: a link or an
anchor that leads nowhere, a document that no other leads to, a picture without words, a figure that nothing shows."""
import html
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import urllib.parse

from markdown_it import MarkdownIt
from markdown_it.token import Token

SOURCE = pathlib.Path(__file__).resolve().parents[2]
DOCS = SOURCE / "docs"
HOME = DOCS / "README.md"
FIGURES = DOCS / "figures.ifs"
OUR_FILES = ("site.css", "site.js")
FIGURE_SIZE = "672x504"  # CSS pixels: as wide as the text

TEMPLATE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<link rel="icon" href="{root}barycage.svg">
<link rel="stylesheet" href="{root}site.css">
<script defer src="{root}site.js"></script>
</head>
<body>
<a class="skip" href="#_text">Skip to the text</a>
<header><a class="home" href="{root}index.html"><img src="{root}barycage.svg" alt="" width="28" height="28">Barycage</a>
<details><summary>Contents</summary>
<nav aria-label="Contents">{contents}{pages}</nav>
</details></header>
<nav class="pages" aria-label="Documents">{pages}</nav>
<main id="_text">
{text}
{turn}
</main>
{aside}
</body>
</html>
"""


class Fault(Exception):
    """What is wrong with the documents, in a sentence."""


def slug(text, taken):
    """The id of a heading, as GitHub makes it."""
    first = re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")
    name, n = first, 0
    while name in taken:
        n += 1
        name = f"{first}-{n}"
    taken.add(name)
    return name


def size_of(picture):
    """Width and height of a PNG or a GIF."""
    top = picture.read_bytes()[:24]
    if top.startswith(b"\x89PNG"):
        return struct.unpack(">II", top[16:24])
    if top.startswith(b"GIF8"):
        return struct.unpack("<HH", top[6:10])
    raise Fault(f"{picture}: neither PNG nor GIF")


def address(path, start):
    """From one file of the site to another."""
    return urllib.parse.quote(os.path.relpath(path, start.parent))


def plain(inline):
    return "".join(" " if t.type == "softbreak" else t.content for t in inline.children or [])


def element(text):
    return Token("html_block", "", 0, content=text)


class Document:
    """A document of the source, and its page."""

    def __init__(self, source):
        self.source = source
        inside = source.relative_to(DOCS if source.is_relative_to(DOCS) else SOURCE)
        self.page = pathlib.Path("index.html") if source == HOME else inside.with_suffix(".html")
        if source.is_dir():
            self.page = inside / "index.html"
        self.root = "../" * (len(self.page.parts) - 1)
        self.name = source.relative_to(SOURCE)
        self.tokens = Site.reader.parse(self.words())
        self.ids = set()
        self.headings = []  # level, id, text
        for i, token in enumerate(self.tokens):
            if token.type == "heading_open":
                text = plain(self.tokens[i + 1])
                token.attrSet("id", slug(text, self.ids))
                self.headings.append((int(token.tag[1]), token.attrs["id"], text))
        if [level for level, _, _ in self.headings[:1]] != [1]:
            raise Fault(f"{self.name}: does not begin with its title")
        self.title = self.headings[0][2]

    def words(self):
        """The text; of a folder, a list of what it holds."""
        if not self.source.is_dir():
            return self.source.read_text(encoding="utf-8")
        titles = [(f.name, re.search(r"^# (.*)", f.read_text(encoding="utf-8"), re.M)[1]) for f in sorted(self.source.glob("*.md"))]
        lines = "\n".join(f"- [{re.sub('^[0-9]+[.] ', '', title)}]({name})" for name, title in titles)
        return f"# {self.source.name.capitalize()}\n\n{lines}\n"


class Site:
    reader = MarkdownIt("commonmark").enable("table")

    def __init__(self, cli, folder):
        self.cli = cli
        self.folder = folder
        self.documents = {}  # by their source
        self.order = []
        self.files = {}  # that pages show or lead to: from the site to the source
        entries = re.findall(r"^(\w+) (?:\(3D\) )?\{", FIGURES.read_text(encoding="utf-8"), re.M)
        self.entries = {e: 0 for e in entries}  # how often each is shown
        self.find(HOME)
        for source in sorted(DOCS.rglob("*.md")):
            if source not in self.documents:
                raise Fault(f"{source.relative_to(SOURCE)}: no document leads to it")

    def find(self, source):
        """This document and all that it leads to."""
        document = self.documents[source] = Document(source)
        self.order.append(document)
        for token in document.tokens:
            for part in token.children or []:
                if part.type == "link_open":
                    target = self.target(document, part.attrs["href"])[0]
                    isText = target and (target.suffix == ".md" or target.is_dir())
                    if isText and target not in self.documents:
                        self.find(target)

    def target(self, document, link):
        """The file to which a link leads, None where it leaves the project, and the anchor in it."""
        parts = urllib.parse.urlsplit(link)
        if parts.scheme:
            return None, ""
        folder = document.source if document.source.is_dir() else document.source.parent
        path = (folder / urllib.parse.unquote(parts.path)).resolve() if parts.path else document.source
        if not path.exists() or not path.is_relative_to(SOURCE):
            raise Fault(f"{document.name}: {link} leads nowhere")
        return path, urllib.parse.unquote(parts.fragment)

    def kept(self, document, path):
        """The address of a file that is copied into the site."""
        copied = path.relative_to(DOCS if path.is_relative_to(DOCS) else SOURCE)
        self.files[copied] = path
        return address(copied, document.page)

    def led(self, document, link):
        path, anchor = self.target(document, link)
        if path is None:
            return link
        if path not in self.documents:
            return self.kept(document, path)
        other = self.documents[path]
        if anchor and anchor not in other.ids:
            raise Fault(f"{document.name}: {link} leads to no heading")
        place = address(other.page, document.page) if other is not document else ""
        return place + (f"#{anchor}" if anchor else "") or "#"

    def figure(self, document, image):
        """A picture with its caption, live if it is of an entry."""
        path, words = self.target(document, image.attrs["src"])[0], plain(image)
        if not words:
            raise Fault(f"{document.name}: {path.name} has no words")
        width, height = size_of(path)
        entry = path.stem.removeprefix("guide-").replace("-", "_")
        live = ""
        if entry in self.entries:
            self.entries[entry] += 1
            live = f' data-entry="{entry}"' + (' data-tool="maps"' if entry.endswith("_maps") else "")
        words = html.escape(words)
        return (f'<figure{live}><img src="{self.kept(document, path)}" alt="{words}" width="{width}" height="{height}" '
                f'loading="lazy"><figcaption aria-hidden="true">{words}</figcaption></figure>\n')

    def text(self, document):
        """The document as HTML."""
        out = []
        for token in document.tokens:
            if token.type == "html_block":
                if not re.fullmatch(r"(<!--.*?-->\s*)+", token.content, re.S):
                    raise Fault(f"{document.name}: HTML that is no comment: {token.content}")
                continue
            if token.type == "table_open":
                out.append(element('<div class="scroll">'))
            out.append(token)
            if token.type == "table_close":
                out.append(element("</div>\n"))
            parts = token.children or []
            for part in parts:
                if part.type == "html_inline":
                    raise Fault(f"{document.name}: HTML in a line: {part.content}")
                if part.type == "link_open":
                    part.attrs["href"] = self.led(document, part.attrs["href"])
            if any(part.type == "image" for part in parts):
                if len(parts) > 1 or out[-2].type != "paragraph_open":
                    raise Fault(f"{document.name}: a picture is within a line")
                out[-2:] = [element(self.figure(document, parts[0]))]
        after_figure = lambda i: out[i].type == "paragraph_close" and out[i - 1].content.startswith("<figure")
        return self.reader.renderer.render([t for i, t in enumerate(out) if not after_figure(i)], self.reader.options, {})

    def parts(self):
        """The headings of the home page, each with the documents that it lists."""
        parts, home = [], self.documents[HOME]
        for i, token in enumerate(home.tokens):
            if token.type == "heading_open" and token.tag == "h2":
                parts.append((plain(home.tokens[i + 1]), []))
            links = [t for t in token.children or [] if t.type == "link_open"]
            if parts and links:
                k = token.children.index(links[0])
                target = self.target(home, links[0].attrs["href"])[0]
                parts[-1][1].append((token.children[k + 1].content, self.documents[target]))
        return parts

    @staticmethod
    def link(document, name, target, more=""):
        here = ' aria-current="page"' if target is document else ' aria-current="true"' if target.source in document.source.parents else ""
        return f'<a href="{address(target.page, document.page)}"{here}{more}>{html.escape(name)}</a>'

    def pages(self, document, parts):
        return "".join(f'<p>{html.escape(title)}</p><ul>' + "".join(
            f"<li>{self.link(document, name, other)}</li>" for name, other in listed) + "</ul>" for title, listed in parts)

    @staticmethod
    def contents(document):
        """The sections of a page, and the sections within them."""
        out, depth = [], 1
        for level, name, text in document.headings[1:]:
            if level > 3:
                continue
            out.append("<ul>" * max(0, level - depth) if level > depth else "</li>" + "</ul></li>" * (depth - level))
            out.append(f'<li><a href="#{name}">{html.escape(text)}</a>')
            depth = level
        return f"<p>On this page</p>{''.join(out)}" + "</li></ul>" * (depth - 1) if out else ""

    def turn(self, document, row):
        """The page before and the one after."""
        if document not in row:
            return ""
        i = row.index(document)
        before = self.link(document, row[i - 1].title, row[i - 1], ' rel="prev"') if i else "<span></span>"
        after = self.link(document, row[i + 1].title, row[i + 1], ' rel="next"') if i + 1 < len(row) else ""
        return f'<nav class="turn" aria-label="Pages before and after">{before}{after}</nav>'

    def write(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        figures = self.folder / "figures.js"
        subprocess.run([self.cli, "page", FIGURES, "--all", "--show", "figure", "--allow", "cage,maps", "--lang", "en", "--size",
                        FIGURE_SIZE, "--points", "5M", "-q", "-o", figures], check=True)
        # A frame inherits the policy of its page; the script and the style of the figures are known by their hashes.
        hashes = re.findall(r"(script|style)-src '(sha256-[\w+/=]+)'", figures.read_text(encoding="utf-8"))
        if [kind for kind, _ in hashes] != ["script", "style"]:
            raise Fault("figures.js: its policy was not found")
        script, style = (f"'self' '{value}'" for _, value in hashes)
        policy = (f"default-src 'none'; script-src {script} 'wasm-unsafe-eval'; worker-src blob:; style-src {style}; "
                  "img-src 'self' data: blob:; base-uri 'none'; form-action 'none'")
        parts = self.parts()
        listed = [self.documents[HOME]] + [d for _, some in parts for _, d in some]
        for document in self.order:
            siblings = [d for d in self.order if d.source.parent == document.source.parent]
            row = listed if document in listed else sorted(siblings, key=lambda d: d.source)
            contents = self.contents(document) if document.source != HOME else ""
            page = TEMPLATE.format(
                policy=policy, root=document.root, text=self.text(document), contents=contents,
                title=html.escape(document.title + ("" if document.source == HOME else " – Barycage")),
                pages=self.pages(document, parts), turn=self.turn(document, row),
                aside=f'<nav class="contents" aria-label="On this page">{contents}</nav>' if contents else "")
            path = self.folder / document.page
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(page, encoding="utf-8")
        unseen = [entry for entry, times in self.entries.items() if not times]
        if unseen:
            raise Fault(f"{FIGURES.name}: no document shows {', '.join(unseen)}")
        self.files["barycage.svg"] = SOURCE / "resources/barycage.svg"
        self.files.update({name: pathlib.Path(__file__).parent / name for name in OUR_FILES})
        for copied, path in self.files.items():
            (self.folder / copied).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, self.folder / copied)


def main():
    cli, folder = map(pathlib.Path, sys.argv[1:])
    try:
        Site(cli.resolve(), folder).write()
    except Fault as fault:
        sys.exit(f"build.py: {fault}")


if __name__ == "__main__":
    main()
