"""What MkDocs does not know of these books: living figures, tasks, links into the repository, anchors as a forge makes them.

MkDocs calls each function `on_...` by its name. Pages are named here by their paths from the root of the repository.
"""

import html
import json
import posixpath
import re
from pathlib import Path

from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[4]
DOCS = "docs/"
README = "README.md"

FENCED = re.compile(r"(^ *(?:```|~~~).*?^ *(?:```|~~~) *$)", re.MULTILINE | re.DOTALL)
CODE_OR_LINK = re.compile(r"`[^`\n]*`|(?P<sign>!?)\[(?P<text>(?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\((?P<to>[^)\s]+)\)")
LINES = r"(?P<%s>(?:[^\n]+(?:\n|$))+)"
FIGURE = re.compile(r"^<!-- runs: (?P<runs>\{.*?\}) -->\n(?P<still>!\[[^\n]*\]\([^)\s]+\))\n" + LINES % "caption", re.MULTILINE | re.DOTALL)
TASK = re.compile(r"^<!-- task: (?P<task>\{.*?\}) -->\n" + LINES % "question", re.MULTILINE | re.DOTALL)

# What a figure and a task may say; page/figures.js and page/tasks.js read it.
SCENE = {"scenario", "machine", "faults", "set", "frame"}
FIGURES = {
    "picture": SCENE | {"vary"},
    "wave": SCENE | {"vary", "sweep", "wires", "across", "against"},
    "difference": SCENE | {"vary", "against"},
}
SLIDER = {"key", "label", "from", "to", "step", "value", "unit"}
AGAINST = {"machine", "faults", "set"}
TASKS = SCENE | {"sweep", "asks", "measure", "says", "unit", "within", "key", "step"}
ASKS = ["value", "largest", "smallest"]
MEASURES = {"events", "wire", "take"}


def on_config(config):
    config.mdx_configs["toc"] = {**config.mdx_configs.get("toc", {}), "slugify": anchor, "permalink": False}


def anchor(head, separator):
    """The anchor of a head as forges make it, but for a digit at its start."""
    return lettered(re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", separator))


def lettered(anchor):
    """The theme follows no anchor that begins with a digit."""
    return f"at-{anchor}" if anchor[:1].isdigit() else anchor


def on_files(files, config):
    """The README of the repository is the first page."""
    files.append(File.generated(config, "index.md", content=(ROOT / README).read_text(encoding="utf-8")))


def on_page_markdown(markdown, page, config, **_):
    place = README if page.file.src_uri == "index.md" else DOCS + page.file.src_uri
    site = Path(config.site_dir).parent
    parts = FENCED.split(markdown)
    texts = parts[::2]
    page.meta.update(runs=any(map(FIGURE.search, texts)), asks=any(map(TASK.search, texts)))
    parts[::2] = [written_out(text, place, site) for text in texts]
    return "".join(parts)


def written_out(text, place, site):
    """Text outside of code, with its links, figures and tasks as the books have them."""
    text = CODE_OR_LINK.sub(lambda found: linked(found, place, site), text)
    text = FIGURE.sub(lambda found: figure(found, place), text)
    text = TASK.sub(lambda found: task(found, place), text)
    left = re.search(r"<!-- (?:runs|task):[^\n]*", text)
    if left:
        raise PluginError(f"{place}: found {left[0]}, expected JSON in braces, and a picture with its caption, or a question, right below")
    return text


def linked(found, place, site):
    """A link as the books have it: to another page, to a file of the site, or no link."""
    to = found["to"]
    if to is None or re.match(r"[a-z]+:", to):
        return found[0]
    path, hash_, fragment = to.partition("#")
    fragment = lettered(fragment)
    if path == "":
        return f"{found['sign']}[{found['text']}](#{fragment})"
    path = posixpath.normpath(posixpath.join(posixpath.dirname(place), path))
    here = "" if place == README else posixpath.dirname(place).removeprefix("docs").strip("/")
    if path == README:
        path = DOCS + "index.md"
    if path == "docs" or path.startswith(DOCS):
        if (ROOT / path).is_dir():
            path += "/README.md"
        return f"{found['sign']}[{found['text']}]({posixpath.relpath(path.removeprefix(DOCS), here or '.')}{hash_}{fragment})"
    if not (ROOT / path).exists():
        raise PluginError(f"{place}: the link {to} leads to {path}, which is not there")
    if (site / path).is_file():
        return f'<a href="{posixpath.relpath("../" + path, here or ".")}">{found["text"]}</a>'
    return found["text"] if path in found["text"] else f"{found['text']} (`{path}`)"


def figure(found, place):
    runs = read(found["runs"], place, "figure")
    kind = runs.get("kind")
    if kind not in FIGURES:
        raise PluginError(f"{place}: a figure of the kind {kind}; expected one of {', '.join(FIGURES)}")
    known(runs, FIGURES[kind] | {"kind"}, place)
    known(runs.get("against", {}), AGAINST, place)
    for slider in runs.get("vary", []):
        known(slider, SLIDER, place)
    caption = f'<figcaption markdown="1">\n{found["caption"]}</figcaption>'
    return f'<figure class="living" data-runs="{written(runs)}" markdown="1">\n{found["still"]}\n{caption}\n</figure>\n'


def task(found, place):
    asked = read(found["task"], place, "task")
    known(asked, TASKS, place)
    known(asked.get("measure", {}), MEASURES, place)
    if asked.get("asks") not in ASKS or "measure" not in asked:
        raise PluginError(f"{place}: a task needs asks, one of {', '.join(ASKS)}, and measure")
    return f'<section class="task" data-task="{written(asked)}" markdown="1">\n{found["question"]}</section>\n'


def read(text, place, what):
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise PluginError(f"{place}: the {what} {text} is no JSON: {error}") from error


def known(keys, names, place):
    unknown = sorted(set(keys) - names)
    if unknown:
        raise PluginError(f"{place}: found {', '.join(unknown)}, expected keys among {', '.join(sorted(names))}")


def written(value):
    return html.escape(json.dumps(value, separators=(",", ":")))


def on_post_page(output, **_):
    """Without the date of the build, without styles inside the page, which its policy refuses; what scrolls can be scrolled by keys."""
    output = re.sub(r"<!--\s*MkDocs version.*?-->\s*", "", output, flags=re.DOTALL)
    output = re.sub(r' style="text-align: (\w+);"', r' class="\1"', output)
    output = re.sub(r' style="[^"]*"', "", output)
    return re.sub(r"<(pre|table)>", r'<\1 tabindex="0">', output)


def on_post_build(config, **_):
    """No list of pages with dates, and no page whose links hold at the root of a host alone."""
    for name in ["sitemap.xml", "sitemap.xml.gz", "404.html"]:
        (Path(config.site_dir) / name).unlink(missing_ok=True)
