"""Makes a site of a folder of results: the page of all results, a page for each scene with its
truth, and the manual. It needs no server; everything is in one folder, and links are relative."""
import os
import pathlib
import re
import shutil
import tempfile

import jinja2
import markdown

from . import charts, page, results
from .results import Bad

MARK = "clothbench.site"  # the file that says that a folder is a site, which may be replaced
ENDINGS = {".html", ".svg"}
LINKS = [("index.html", "all results"), ("scenes.html", "scenes"), ("manual.html", "manual")]

def check_target(target):
    """Refuses a folder that is no site, or has something else in it."""
    if not target.exists():
        return
    names = sorted(os.listdir(target)) if target.is_dir() and not target.is_symlink() else ["?"]
    others = [n for n in names if n != MARK and pathlib.Path(n).suffix not in ENDINGS]
    if names and (MARK not in names or others):
        raise Bad(f"{target}: is there and is no site that --site made"
                  + (f"; it has {others[0]}" if others and others != ["?"] else ""))

def scene_page(name, scene, truth, table):
    """A scene: pictures of its truth, speed against error, the truth's error bars, its file."""
    part, room, trouble = page.Part(name, name), page.Room(), []
    if truth.exists():
        part.strips = page.strips([truth], None, room, trouble)
        part.trouble = trouble
        for strip in part.strips:
            strip.label = "its truth"
        try:
            made = results.run(truth, most=400)
            bars = [(t, 100 * b / made.length) for t, b in zip(made.time, made.bar) if b > 0]
            part.words.append(f"Truth: {made.note}.")
            svg = charts.lines(f"{name}: how well its motion is known", "time [s]", "error bar / length [%]",
                               [("truth’s error bar", charts.SOFT, bars)])
            part.charts += [(page.address(svg, "svg+xml"), "the truth’s error bar over time")] if svg else []
        except Bad as bad:
            part.trouble = [str(bad)]
    else:
        part.words.append("No truth of it is stored.")
    if table:
        svg = page.speed_chart(table, name)
        part.charts += [(page.address(svg, "svg+xml"), "error over seconds of work")] if svg else []
    text = jinja2.utils.markupsafe.Markup("<h2>Its file</h2><pre>{}</pre>").format(scene.read_text())
    return page.rendered(title=f"The scene {name}", links=LINKS, lead=[], parts=[part], html=text)

def manual_page(path, names):
    """A page of the manual; links to other pages lead to their HTML, others to nowhere."""
    text = re.sub(r"^```\w*\n(.*?)^```", lambda m: re.sub("^", "    ", m[1], flags=re.M),
                  path.read_text(), flags=re.M | re.S)
    html = markdown.markdown(text, extensions=["tables", "toc", "sane_lists"])

    def link(found):
        name, anchor = re.fullmatch(r"([^#]*)(#.*)?", found[1]).groups()
        if re.match("https?:", name):
            return found[0]
        leaf = name.split("/")[-1].removesuffix(".md")
        known = name.endswith(".md") and leaf in names
        return f'href="{"manual_" + leaf + ".html" if name else ""}{anchor or ""}"' if known or not name \
            else 'class="soft"'

    html = re.sub(r'href="([^"]*)"', link, html)
    html = re.sub(r'src="(?:doc/)?([^"/]*)"', r'src="\1"', html)
    title = re.search("^# (.*)", text, re.M)
    return page.rendered(title=title[1] if title else path.stem, bare=True, links=LINKS, lead=[],
                         html=jinja2.utils.markupsafe.Markup(html))

def table_of(title, caption, rows):
    """A page with a list of links."""
    row = jinja2.utils.markupsafe.Markup('<tr><td><a href="{}">{}</a></td><td>{}</td></tr>')
    html = jinja2.utils.markupsafe.Markup("<p>{}</p><table>").format(caption) + \
        jinja2.utils.markupsafe.Markup("").join(row.format(*r) for r in rows) + \
        jinja2.utils.markupsafe.Markup("</table>")
    return page.rendered(title=title, links=LINKS, lead=[], html=html)

def fill(folder, source):
    """Writes all pages into an empty folder."""
    room = page.Room()
    room.left = 0  # tables alone: the index has the pictures
    speeds = dict(page.speeds_of(page.parts_of(pathlib.Path(source), room)))
    (folder / "index.html").write_text(page.report(source, links=LINKS))
    scenes = sorted(results.shared("scenes", "models/scenes").glob("*.yaml"))
    for scene in scenes:
        truth = results.shared("truths", "bench/truths") / f"{scene.stem}.h5"
        (folder / f"scene_{scene.stem}.html").write_text(
            scene_page(scene.stem, scene, truth, speeds.get(scene.stem)))
    first = {s: re.search(r"^# *(.*)", s.read_text(), re.M) for s in scenes}
    (folder / "scenes.html").write_text(table_of("Scenes", "What each is, by its file.", [
        (f"scene_{s.stem}.html", s.stem, first[s][1] if first[s] else "") for s in scenes]))
    manual = results.shared("manual", "doc")
    pages = sorted(manual.glob("*.md"))
    for path in pages:
        (folder / f"manual_{path.stem}.html").write_text(manual_page(path, {p.stem for p in pages}))
    for path in manual.glob("*.svg"):
        shutil.copyfile(path, folder / path.name)
    titles = {p: re.search(r"^# (.*)", p.read_text(), re.M) for p in pages}
    (folder / "manual.html").write_text(table_of("The manual", "", [
        (f"manual_{p.stem}.html", titles[p][1] if titles[p] else p.stem, "") for p in pages]))
    (folder / MARK).write_text("clothbench report --site writes this folder, and replaces it.\n")

def make(source, target):
    """The site appears with all of its pages, or not at all; one that is there is replaced."""
    target = pathlib.Path(target)
    check_target(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        aside = pathlib.Path(tempfile.mkdtemp(prefix=f".{target.name}.", dir=target.parent))
        aside.chmod(0o755)
        try:
            fill(aside, source)
            if target.exists():
                shutil.rmtree(target)
            os.replace(aside, target)
        finally:
            shutil.rmtree(aside, ignore_errors=True)
    except OSError as error:
        raise Bad(f"{target}: cannot be written: {error.strerror}") from None
