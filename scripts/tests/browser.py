# SPDX-License-Identifier: Apache-2.0
"""Pages in headless Chromium: what a reader at a given width sees."""

import html
import json
import re
import subprocess

from conftest import need

# The page stands in a frame of the wanted width, as the browser's own window cannot be as narrow as a phone.
_FRAME = """<!DOCTYPE html><meta charset="utf-8"><body style="margin: 0">
<iframe id="page" style="border: 0; color-scheme: {scheme}; width: {width}px; height: {height}px"
 src="{uri}"></iframe><pre id="seen"></pre>
<script>
document.getElementById("page").onload = () => {{
  const page = document.getElementById("page").contentDocument, root = page.documentElement;
  const inside = (element) => {{
    for (let up = element.parentElement; up; up = up.parentElement) if (up.classList.contains("wide")) return true;
    return false;
  }};
  const box = (element) => element.getBoundingClientRect();
  const channels = (color) => (color.match(/[0-9.]+/g) || []).map(Number);
  const luminance = (color) => channels(color).slice(0, 3)
    .map((c) => c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4)
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = (element) => {{
    for (let up = element; up; up = up.parentElement) {{
      const color = getComputedStyle(up).backgroundColor;
      if (channels(color)[3] !== 0) return color;
    }}
    return "rgb(255, 255, 255)";
  }};
  const contrast = (element) => {{
    const [low, high] = [getComputedStyle(element).color, ground(element)].map(luminance).sort((a, b) => a - b);
    return [(high + 0.05) / (low + 0.05), element.tagName + "." + element.className];
  }};
  const texts = [...page.body.querySelectorAll("*")].filter((e) => [...e.childNodes].some(
    (node) => node.nodeType === 3 && node.textContent.trim()));
  const wide = [...page.body.querySelectorAll("*")].filter((e) => !inside(e) && box(e).right > root.clientWidth + 1);
  document.getElementById("seen").textContent = JSON.stringify({{
    width: root.clientWidth, scroll_width: root.scrollWidth,
    height: root.scrollHeight, text: page.body.innerText.length,
    images: [...page.images].map((image) => (
      {{ natural: image.naturalWidth, shown: Math.round(box(image).width), alt: image.alt }})),
    marks: [...page.querySelectorAll(".mark")].map((e) => [box(e).x, box(e).y]),
    paper: ground(page.body), contrast: texts.map(contrast).sort((a, b) => a[0] - b[0])[0],
    scrolling: [...page.querySelectorAll(".wide")].filter((e) => e.scrollWidth > e.clientWidth + 1).map(
      (e) => [e.tabIndex, getComputedStyle(e).backgroundImage.split("linear-gradient").length - 1]),
    too_wide: wide.map((e) => e.tagName + "." + e.className),
    smallest_text_px: Math.min(...[...page.body.querySelectorAll("*")].filter((e) => e.innerText && !e.children.length)
      .map((e) => parseFloat(getComputedStyle(e).fontSize))),
  }});
}};
</script>"""


def _run(folder, width, height, page, scheme, *options):
    wrapper = folder / "frame.html"
    wrapper.write_text(_FRAME.format(width=width, height=height, scheme=scheme, uri=page.resolve().as_uri()))
    words = [
        need("chromium"),
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--hide-scrollbars",
        "--allow-file-access-from-files",
        "--virtual-time-budget=3000",
        f"--user-data-dir={folder / 'profile'}",
        *options,
        wrapper.as_uri(),
    ]
    return subprocess.run(words, capture_output=True, text=True, timeout=120, check=True).stdout


def look(page, folder, width, height=1000, scheme="light"):
    """What the page of a file looks like at this width: sizes in CSS pixels."""
    dom = _run(folder, width, height, page, scheme, "--dump-dom")
    seen = re.search('<pre id="seen">(.+?)</pre>', dom, re.DOTALL)
    assert seen, f"chromium did not show {page}"
    return json.loads(html.unescape(seen.group(1)))
