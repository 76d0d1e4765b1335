#!/usr/bin/env python3
"""The site that `report --site` writes: every link leads to a file and an anchor that are there,
there is a page for each scene, contestant and page of the manual, nothing of a file is taken for
markup, and a folder that is no site is left alone.

    site.py PROGRAM SOURCE-FOLDER
"""
import html.parser
import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
HOSTILE = "</p></script><script>alert(1)</script><img src=x onerror=alert(2)><!--"
# Columns of a table of `compare` on which the chart and the table of a scene stand.
RUNS = "title,contestant,model,side,step_s,iterations,seconds,worst_rmse_over_length,front\n"
VOID = {"meta", "link", "img", "br", "hr"}
failures = []


def check(good, words):
    if not good:
        failures.append(words)


class Page(html.parser.HTMLParser):
    """The links, anchors and tags of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors, self.tags, self.open = [], [], set(), []
        self.feed(path.read_text(encoding="utf-8", errors="replace"))
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags.add(tag)
        self.tags.update(name for name, _ in attributes if name.startswith("on"))
        self.links += [value for name, value in attributes if name in ("href", "src")]
        self.anchors += [value for name, value in attributes if name == "id"]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        while self.open and self.open[-1] in ("p", "li") and self.open[-1] != tag:
            self.open.pop()  # these may be left open
        check(self.open and self.open.pop() == tag, f"</{tag}> closes nothing")


def report(folder, site, **environment):
    return subprocess.run([PROGRAM, "report", folder, "--site", site], text=True, check=False,
                          capture_output=True, env=os.environ | environment)


def check_links(site, *names):
    """Reads the pages of these names, or all but the report, which fills itself in."""
    paths = [site / f"{name}.html" for name in names] or sorted(site.glob("*.html"))
    pages = {path.name: Page(path) for path in paths if path.name != "report.html"}
    for name, page in pages.items():
        check(len(set(page.anchors)) == len(page.anchors), f"{name}: an anchor stands twice")
        check("script" not in page.tags, f"{name} has a script")
        for link in page.links:
            file, _, anchor = link.partition("#")
            if file.startswith(("http://", "https://")):
                continue
            target = file or name
            check((site / target).is_file() and "/" not in target, f"{name}: {link} leads nowhere")
            if anchor and target in pages:
                check(anchor in pages[target].anchors, f"{name}: {link} has no such anchor")
    return pages


def check_whole(folder):
    """The results that come with the program."""
    site = folder / "site"
    done = report(SOURCE / "doc/results", site, CLOTHBENCH_TRUTHS=str(folder / "light"))
    check(done.returncode == 0, f"report --site: exit {done.returncode}: {done.stderr}")
    pages = check_links(site)
    listed = subprocess.run([PROGRAM, "list", "contestants"], text=True, check=True, stdout=subprocess.PIPE)
    wanted = [f"contestant_{line.split()[0]}" for line in listed.stdout.splitlines() if line[0] != " "]
    wanted += [f"scene_{path.stem}" for path in (SOURCE / "models/scenes").glob("*.yaml")]
    wanted += [f"manual_{path.stem}" for path in (SOURCE / "doc").glob("*.md")]
    for name in wanted:
        check(f"{name}.html" in pages, f"there is no page {name}.html")
        check(f"{name}.html" in pages["index.html"].links, f"the index does not lead to {name}.html")
    check("contestant_shell_3.html" in pages["scene_edge_drop.html"].links, "edge_drop has no table")
    check("scene_flag.html" in pages["contestant_shell_3.html"].links, "shell_3 has no table")
    check("circle" in pages["scene_flag.html"].tags, "flag has no chart")
    check("iterations.svg" in pages["manual_iterations.html"].links, "a page lost its picture")
    check("table" in pages["manual_compare.html"].tags, "a page of the manual lost its tables")


def check_hostile(folder):
    """Hostile names in results and in a page of the manual: no tag of theirs is one of the site's."""
    (folder / "results/compare_edge_drop").mkdir(parents=True)
    (folder / "results/stress").mkdir()
    (folder / "manual").mkdir()
    row = f'"{HOSTILE}",{HOSTILE},"{HOSTILE}",5,0.005,,1,0.1,1\n'
    (folder / "results/compare_edge_drop/compare.csv").write_text(RUNS + row + row.replace("1,0.1", "2,0.01"))
    (folder / "results/compare_edge_drop/compare_targets.csv").write_text(
        f'title,contestant,seconds_0.01\n"{HOSTILE}",{HOSTILE},1\n"{HOSTILE}",shell,1\n')
    (folder / "results/compare_scenes.csv").write_text(
        f"scene,contestant,seconds,target_rmse_over_length\n{HOSTILE},shell,1,0.01\n../x,shell,1,0.01\n")
    (folder / "results/stress/printed.csv").write_text(f'case,model,end,in_words\n"{HOSTILE}",shell,{HOSTILE},{HOSTILE}\n')
    (folder / "manual/a.md").write_text(f"# \"q\" {HOSTILE}\n\n{HOSTILE}\n\n## {HOSTILE}\n\n[x](javascript:alert(1)) [y](/etc/passwd)\n")
    site = folder / "hostile"
    light = {"CLOTHBENCH_MANUAL": str(folder / "manual"), "CLOTHBENCH_TRUTHS": str(folder / "light")}
    done = report(folder / "results", site, **light)
    check(done.returncode == 0, f"hostile names: exit {done.returncode}: {done.stderr}")
    check_links(site, "index", "scene_edge_drop", "contestant_shell", "manual_a")
    for path in site.glob("*.html"):
        text = path.read_text()
        for tag in ("<script", "</script", "onerror=alert(2)>", "<!--", "javascript:"):
            check(path.name == "report.html" or tag not in text,
                  f"{path.name}: a file's '{tag}' is in the page as it stands")
    check("&lt;script&gt;alert(1)" in (site / "scene_edge_drop.html").read_text(), "a hostile title is lost")
    check("&lt;script&gt;alert(1)" in (site / "contestant_shell.html").read_text(), "a hostile case is lost")
    check("&quot;q&quot;" in (site / "index.html").read_text(), "a quote of a title is not escaped")
    return site, light


def check_folder(folder, site, light):
    """A site is replaced as a whole; any other folder, and a site with files of the user's, is not."""
    (site / "gone.html").write_text("a page that no site has any more")
    check(report(folder / "results", f"{site}/", **light).returncode == 0, "a site is not replaced")
    check(not (site / "gone.html").exists(), "a page of the site before is left")
    (site / "notes.txt").write_text("mine")
    (folder / "mine").mkdir()
    (folder / "mine/index.html").write_text("mine")
    for name, words in {"hostile": "notes.txt", "mine": "with something in it; a new folder is needed, or one that this command has written",
                        "manual/a.md": "no folder", "mine/index.html/x": "cannot be made"}.items():
        done = report(folder / "results", folder / name, **light)
        check(done.returncode in (1, 2) and words in done.stderr and len(done.stderr.splitlines()) == 1,
              f"{name}: exit {done.returncode}: {done.stderr}")
    check((folder / "mine/index.html").read_text() == "mine", "a folder that is no site was changed")
    (folder / "results/bad").mkdir()
    (folder / "manual/b.md").write_text("# b\n\n![x](../x.svg)\n")
    done = report(folder / "results", folder / "new", **light)
    check(done.returncode == 2 and "manual/b.md" in done.stderr, f"a bad page: {done.returncode} {done.stderr}")
    left = [path.name for path in folder.iterdir() if ".part" in path.name or path.name == "new"]
    check(not left, f"left over: {left}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "light").mkdir()
        # Empty files stand before stored truths, which take a second to read, but for two.
        for path in (SOURCE / "bench/truths").glob("*.h5"):
            if path.stem not in ("flag", "stack"):
                (folder / "light" / path.name).touch()
        check_whole(folder)
        site, light = check_hostile(folder)
        check_folder(folder, site, light)
    for failure in failures:
        print(failure)
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
