# SPDX-License-Identifier: MIT
"""The page in a cell of a notebook: the attractor in its cage, live, as web pages have it."""
from __future__ import annotations

import base64
import functools
import hashlib
import html
import json
import pathlib

from . import _core

PARTS = pathlib.Path(__file__).parent / "page"
MOST_MAPS = 2000
WIDTH, HEIGHT = 640, 640  # pixels at most of the cell


@functools.lru_cache(maxsize=None)
def _part(name: str) -> bytes:
    return (PARTS / name).read_bytes()


@functools.lru_cache(maxsize=None)
def _script(modules: tuple[str, ...]) -> str:
    return _core.joined_script([_part(name).decode() for name in modules])


@functools.lru_cache(maxsize=None)
def _engine(name: str) -> str:
    return _core.in_base85(_part(name))


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def page(text: str, name: str, dimension: int, still: bytes) -> str:
    """The page of the entry with this text; `still` is a PNG for readers without JavaScript."""
    texts = json.loads(_part("texts.json"))
    script = _script(tuple(_core.page_modules()))
    style = _core.filled(_core.plain_style(_part("page.css").decode()), {"background": "transparent"})
    moves = "; barycage: animation " in text
    content = {"text": text, "show": "figure", "allow": ["cage", "maps", "code"], "language": "", "points": 20_000_000}
    return _core.filled(_part("page.html").decode(), {
        "language": "en",
        "title": html.escape(name),
        "caption": "",
        "plain": texts["en"]["plain"],
        "texts": _core.embedded(json.dumps(texts)),
        "show": "figure",
        "style": style,
        "style-hash": _hash(style),
        "still": "data:image/png;base64," + base64.b64encode(still).decode(),
        "content": _core.embedded(json.dumps(content)),
        "engine": _engine(f"engine{'' if dimension == 3 else '_plane'}{'_moving' if moves else ''}.wasm.gz"),
        "worker": _script(tuple(_core.worker_modules())),
        "script": script,
        "script-hash": _hash(script),
    })


def frame(text: str, name: str, dimension: int, still: bytes) -> str:
    """The page within another one."""
    srcdoc = html.escape(page(text, name, dimension, still))
    return (f'<iframe title="{html.escape(name)}" width="100%" height="{HEIGHT}" '
            f'style="border: 0; max-width: {WIDTH}px" srcdoc="{srcdoc}"></iframe>')
