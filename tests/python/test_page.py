# SPDX-License-Identifier: MIT
"""The page of an entry in a cell of a notebook."""
import base64
import hashlib
import html.parser
import json
import re
import shutil
import string
import subprocess
import urllib.request

import barycage as bc
import pytest


class Page(html.parser.HTMLParser):
    """Its scripts and styles, by id or by name, and the document of a frame."""

    def __init__(self, text):
        super().__init__()
        self.parts, self.frame, self._at = {}, None, None
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.frame = attrs.get("srcdoc", self.frame)
        self._at = attrs.get("id", tag) if tag in ("script", "style") else None

    def handle_endtag(self, tag):
        self._at = None

    def handle_data(self, data):
        if self._at:
            self.parts[self._at] = self.parts.get(self._at, "") + data


def page_of(entry):
    outer = Page(entry._repr_html_())
    return outer.frame, Page(outer.frame).parts


def test_the_page_holds_the_entry(maple):
    text, parts = page_of(maple)
    assert json.loads(parts["content"])["text"] == str(maple)
    assert bc.parse(json.loads(parts["content"])["text"])[0] == maple
    assert set(json.loads(parts["texts"])) == {"en", "de", "es", "fr", "mk"}
    digits = string.digits + string.ascii_uppercase + string.ascii_lowercase + "!#$%()*+,-./:;=?@[]^_|~"
    first = sum(digits.index(digit) * 85 ** (4 - i) for i, digit in enumerate(parts["engine"][:5]))
    assert b"\x1f\x8b" == first.to_bytes(4, "big")[:2]
    assert "{{" not in re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)
    assert len(maple._repr_html_()) < 500_000


def test_only_its_own_scripts_run(maple):
    text, parts = page_of(maple)
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', text)[1]
    for part, directive in (("script", "script-src"), ("style", "style-src")):
        digest = base64.b64encode(hashlib.sha256(parts[part].encode()).digest()).decode()
        assert f"{directive} 'sha256-{digest}'" in policy


def test_no_name_ends_the_page():
    name = '</script><script>alert(1)</script>"&lt;'
    entry = bc.Entry([[[.5, 0, 0], [0, .5, 0]], [[.5, 0, 1], [0, .5, 1]]], name=name)
    text, parts = page_of(entry)
    assert json.loads(parts["content"])["text"] == str(entry)
    assert text.count("<script") == 5 and "alert(1)</script>" not in text


def test_what_only_the_window_shows(maple):
    inside = bc.parse("a {\n; barycage: branch 0 1\n; barycage: by 1 0\n; barycage: by 0 1\n; barycage: by 0 1\n"
                      " .5 0 0 .5 0 0 1\n .5 0 0 .5 1 0 1\n}")[0]
    assert inside._repr_html_() is None and inside._repr_png_()


class Driver:
    """Chromium without a window."""

    def __init__(self):
        self._process = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        port = next(found[1] for line in self._process.stdout if (found := re.search(r"successfully on port (\d+)", line)))
        self._address = f"http://127.0.0.1:{port}"
        chrome = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run"]}
        made = self._call("/session", {"capabilities": {"alwaysMatch": {"goog:chromeOptions": chrome}}})
        self._address += "/session/" + made["sessionId"]
        self("timeouts", {"script": 300_000})

    def _call(self, path, content=None, method="POST"):
        request = urllib.request.Request(self._address + path, method=method,
                                         data=None if content is None else json.dumps(content).encode())
        return json.load(urllib.request.urlopen(request))["value"]

    def __call__(self, path, content):
        return self._call("/" + path, content)

    def close(self):
        self._call("", method="DELETE")
        self._process.terminate()
        self._process.wait()


@pytest.fixture
def driver():
    if not shutil.which("chromedriver"):
        pytest.skip("needs chromium-driver")
    driver = Driver()
    yield driver
    driver.close()


LIVE = """
const done = arguments[0], canvas = document.getElementById("canvas");
const look = () => document.body.dataset.state === "live" && done([document.getElementById("name").textContent,
  new Set(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data).size]);
new MutationObserver(look).observe(document.body, { attributes: true });
look();
"""


@pytest.mark.parametrize("which", ["maple", "cube"])
def test_a_browser_draws_it_in_a_frame(which, request, driver, tmp_path):
    entry = request.getfixturevalue(which)
    path = tmp_path / "cell.html"
    path.write_text(f"<!doctype html><meta charset=utf-8><body>{entry._repr_html_()}")
    driver("url", {"url": path.as_uri()})
    frame, = driver("elements", {"using": "css selector", "value": "iframe"})
    driver("frame", {"id": frame})
    name, tones = driver("execute/async", {"script": LIVE, "args": []})
    assert name == entry.name and tones > 10
