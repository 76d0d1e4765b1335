"""Makes a site of a folder of results: the page of all results, a page for each scene with its
truth, and the manual. It needs no server; everything is in one folder, and links are relative."""
import os
import pathlib
import re
import shutil
import tempfile

import markdown
from markupsafe import Markup

from . import charts, page, results
from .results import Bad

MARK = "clothbench.site"  # the file that says that a folder is a site, which may be replaced
LINKS = [("index.html", "all results"), ("scenes.html", "scenes"), ("manual.html", "manual")]

def check_target(target):
    """Refuses a folder that is no site, or has something else in it."""
    names = sorted(os.listdir(target)) if target.is_dir() and not target.is_symlink() else ["?"] * target.exists()
    others = [n for n in names if n != MARK and pathlib.Path(n).suffix not in (".html", ".svg")]
    if names and (MARK not in names or others):
        raise Bad(f"{target}: is there and is no site that --site made"
                  + (f"; it has {others[0]}" if others and others != ["?"] else ""))

def scene_page(name, scene, truth, table):
    """A scene: pictures of its truth, speed against error, the truth's error bars, its file."""
    part = page.Part(name, name)
    if truth.exists():
        part.strips = page.strips([truth], None, page.Room(), part.trouble)
        for strip in part.strips:
            strip.label = "its truth"
            made = results.run(truth, most=400)
            bars = [(t, 100 * b / made.length) for t, b in zip(made.time, made.bar) if b > 0]
            part.words.append(f"Truth: {made.note}.")
            part.add_chart(charts.lines(
                f"{name}: how well its motion is known", "time [s]", "error bar / length [%]",
                [("truth’s error bar", charts.SOFT, bars)]), "the truth’s error bar over time")
    else:
        part.words.append("No truth of it is stored.")
    if table:
        part.add_chart(page.speed_chart(table, name), "error over seconds of work")
    text = Markup("<h2>Its file</h2><pre>{}</pre>").format(scene.read_text())
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
        if name and not (name.endswith(".md") and leaf in names):
            return 'class="soft"'
        return f'href="{"manual_" + leaf + ".html" if name else ""}{anchor or ""}"'

    html = re.sub(r'href="([^"]*)"', link, html)
    html = re.sub(r'src="(?:doc/)?([^"/]*)"', r'src="\1"', html)
    return page.rendered(title=title_of(path, path.stem), bare=True, links=LINKS, lead=[], html=Markup(html))

def title_of(path, otherwise):
    """The words behind the first # of a file."""
    found = re.search(r"^# *(.*)", path.read_text(), re.M)
    return found[1] if found else otherwise

def contents(title, words, rows):
    """A page with a list of links [(address, name, words)]."""
    row = Markup('<tr><td><a href="{}">{}</a></td><td>{}</td></tr>')
    html = Markup("<table>{}</table>").format(Markup("").join(row.format(*r) for r in rows))
    return page.rendered(title=title, links=LINKS, lead=words, html=html)

def fill(folder, source):
    """Writes all pages into an empty folder."""
    speeds = dict(page.speeds_of(page.parts_of(pathlib.Path(source), page.Room(0))))  # the index has the pictures
    scenes = sorted(results.shared("scenes", "models/scenes").glob("*.yaml"))
    truths, manual = results.shared("truths", "bench/truths"), results.shared("manual", "doc")
    pages = sorted(manual.glob("*.md"))
    made = {"index.html": page.report(source, links=LINKS),
            MARK: "clothbench report --site writes this folder, and replaces it.\n",
            "scenes.html": contents("Scenes", ["What each is, by its file."], [
                (f"scene_{s.stem}.html", s.stem, title_of(s, "")) for s in scenes]),
            "manual.html": contents("The manual", [], [
                (f"manual_{p.stem}.html", title_of(p, p.stem), "") for p in pages])}
    made |= {f"scene_{s.stem}.html": scene_page(s.stem, s, truths / f"{s.stem}.h5", speeds.get(s.stem))
             for s in scenes}
    made |= {f"manual_{p.stem}.html": manual_page(p, {p.stem for p in pages}) for p in pages}
    for name, text in made.items():
        (folder / name).write_text(text)
    for path in manual.glob("*.svg"):
        shutil.copyfile(path, folder / path.name)

def make(source, target):
    """The site appears with all of its pages, or not at all; one that is there is replaced."""
    target = pathlib.Path(target)
    check_target(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f".{target.name}.", dir=target.parent) as above:
            aside = pathlib.Path(above, "site")
            aside.mkdir()
            fill(aside, source)
            if target.exists():
                shutil.rmtree(target)
            os.replace(aside, target)
    except OSError as error:
        raise Bad(f"{target}: cannot be written: {error.strerror}") from None
