"""Makes one page from a folder of results: pictures, speed against error, statements, all else."""
import base64
import contextlib
import os
import pathlib
import re
from dataclasses import dataclass, field

import jinja2
import numpy as np

from . import charts, results
from .results import Bad, best, grouped, number, where

# Bytes of a page, and of what is in it, which are together less: the rest is for its words.
PAGE_MOST, PICTURES_MOST, CHARTS_MOST, MOTIONS_MOST, CELLS_MOST = 5_000_000, 1_900_000, 1_200_000, 500_000, 900_000
ROWS_MOST, NOTES_MOST, STATEMENTS_MOST, FOLDERS_MOST, FILES_MOST, RUNS_MOST, TIMES_MOST = 150, 12, 400, 400, 400, 8, 4

# The paper's figures: number, the folder of the study, the names of its files, the times [s] at
# which the paper shows them (none: those of the files), and what it shows.
FIGURES = [
    ("6", "study_fig6", ["fig6_springs", "fig6_projective", "fig6_plate", "fig6_shell_nonlinear"],
     [0.5, 1, 1.5, 2], "mass-spring, projective dynamics and the plate, two corners held"),
    ("7", "study_drops", ["edge_*"], [0.5, 1.5, 2, 3.25, 3.5, 4.25],
     "an edge held: the sheet falls, swings through, and back"),
    ("8", "study_drops", ["corners_*"], [0.5, 1.5, 2, 3.25, 3.5, 4.25], "two corners held"),
    ("9", "study_contact", ["contact_printed", "contact_incremental", "contact_shell",
                            "contact_springs", "contact_projective"], [],
     "a sheet falls onto the ground, a corner first"),
    ("10", "study_thickness", ["printed_1*", "printed_2*", "printed_5*"], [], "a cloak of 1, 2 and 5 mm"),
    ("12", "study_mesh", ["corners_*", "edge_*"], [1.025], "nets of 5, 10, 15 and 20 points a side"),
    ("13", "study_degree", ["corners_*", "edge_*"], [1.7], "degrees 2, 3 and 4 on one net"),
    ("14", "study_mesh-degree", ["corners_*", "edge_*"], [1.025, 1.7], "net and degree together"),
    ("15", "study_flag", ["flag_*"], [0.75, 1, 2.075], "a flag sinks"),
    ("16", "study_artefacts", ["flag_*", "drop_*"], [], "normal, super-elongation, floating, penetration"),
]
RUN_KEYS = ("title", "contestant", "model", "seconds", "worst_rmse_over_length", "front")
CLAIM_KEYS = ("claim", "verdict", "sentence")

@dataclass
class Strip:
    """Pictures of one run, [(address, words below)]."""
    label: str
    pictures: list
    scene: str

@dataclass
class Part:
    id: str
    title: str
    words: list = field(default_factory=list)
    trouble: list = field(default_factory=list)
    quick: bool = False
    made: str = ""
    charts: list = field(default_factory=list)  # [(address, words)]
    strips: list = field(default_factory=list)
    tables: list = field(default_factory=list)
    claims: list = field(default_factory=list)

    def add_chart(self, svg, words):
        self.charts += [(address(svg), words)] if svg else []

# --- words -----------------------------------------------------------------------------------

UNITS = {"s": "s", "ms": "ms", "m": "m", "pa": "Pa", "percent": "%", "degrees": "degrees", "l": "L",
         "b": "B", "rad_per_s": "rad/s", "m_per_s": "m/s", "m_per_s2": "m/s²", "m2_per_s2": "m²/s²",
         "kg_per_m3": "kg/m³"}
UNIT = re.compile("(.*?[^_0-9])(?<!_and)_(" + "|".join(sorted(UNITS, key=len, reverse=True)) + ")$")

def head(key):
    """A column's, from its key: rmse_over_length_0.1_s is RMSE / length 0.1 [s]."""
    found = UNIT.match(key)
    name = (found[1] if found else key).replace("_over_", " / ").replace("_", " ")
    return re.sub("^rmse", "RMSE", name) + (f" [{UNITS[found[2]]}]" if found else " [s]" * (key == "time"))

def short(words):
    """A number to four digits, other words as they are."""
    if len(words) < 7:
        return words
    value = number(words)
    return words if value != value else f"{value:.4g}"

def is_number(words):
    return number(words) == number(words)

def tone(words):
    return {"holds": "yes", "met": "yes", "does not hold": "no", "MISSED": "no", "died": "no"}.get(words, "")

def filled(table):
    """The keys of columns in which something stands."""
    return [k for k in table.keys if any(r[k] for r in table.rows)] or table.keys

def round2(value):
    return f"{float(f'{value:.1e}'):.15g}"

def address(data, kind="svg+xml"):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"

# --- charts of tables ------------------------------------------------------------------------

def bar_of(table):
    """The truth's largest error bar over the length at the times of a table of runs, or None."""
    given = [number(r.get("bar_over_length")) for r in table.rows] + [
        number(v) for r in where(table.rows, contestant="") for k, v in r.items() if k.startswith("rmse_over_length")]
    return max((v for v in given if v > 0), default=None)

def speed_chart(table, title, everything=True):
    """Error over seconds, a line for the best contestant of each model."""
    def line(name, model, who, front):
        points = [(number(r["seconds"]), 100 * number(r["worst_rmse_over_length"]))
                  for r in where(table.rows, contestant=who) if (r["front"] == "1") == front]
        return name, charts.colour_of(model), [p for p in points if min(p) > 0]

    bar, known = bar_of(table), [one[2:] for one in best(table.rows)]
    return charts.lines(title, "seconds of work, one thread", "RMSE / length [%]", [line(*one, True) for one in known],
                        bar and 100 * bar, [line(*one, False) for one in known if everything])

def line_charts(table, title):
    """Charts of a table with panel, line, x and y: a line's words may name a model."""
    x, y = table.keys[2:4]
    made = []
    for panel, rows in grouped(table.rows, "panel").items():
        named = list(grouped(rows, "line").items())
        for begin in range(0, len(named), charts.LINES_MOST):
            made.append((charts.lines(panel or title, x, y, [
                (name, charts.colour_of(name, begin + n), [(number(r[x]), number(r[y])) for r in of])
                for n, (name, of) in enumerate(named[begin:begin + charts.LINES_MOST])]), panel or title))
    return made

def map_charts(table):
    """Maps of a sweep's cases: the last axis along x, the one before it along y, a panel for each case of
    the others. Axes are the first columns that tell all rows apart."""
    keys = table.keys[1:]
    cases = next((keys[:n] for n in range(2, 9) if len({tuple(r[k] for k in keys[:n]) for r in table.rows})
                  == len(table.rows)), [])
    *others, y, x = cases or ["", ""]
    panels = {}
    for r in table.rows if cases else ():
        words = ", ".join(r[k] if k in ("case", "model", "study") else f"{k} = {r[k]}" for k in others)
        panels.setdefault(words, []).append((r[x], r[y], r["labels"]))
    return [(charts.classes(words, x, y, panel), words) for words, panel in panels.items()]

def time_chart(table, title, key, bar=None):
    """Errors over time in per cent of the length, a line for each file or level."""
    of = next((k for k in ("file", "level", "model") if k in table.keys), None)
    names, name = {}, ""
    for r in table.rows:
        name = (r[of] or name) if of else ""
        names.setdefault(name, []).append((number(r["time_s"]), 100 * number(r[key])))
    bars = {number(r["time_s"]): 100 * number(r[bar]) for r in table.rows} if bar else {}
    drawn = [(n, None, points) for n, points in names.items() if n != "truth"] + [
        ("truth’s error bar", charts.SOFT, list(bars.items()))] * bool(bars)
    return charts.lines(title, "time [s]", "error / length [%]", drawn[-charts.LINES_MOST:])

def charts_of(table, title):
    """[(SVG, words)] of what a table can show."""
    words = table.caption or title
    if table.keys[:2] == ["panel", "line"] and len(table.keys) >= 4:
        made = line_charts(table, title)
    elif table.keys[0] == "number" and table.has("labels", "outcome"):
        made = map_charts(table)
    elif table.has("level", "stepping_s", "to_finest_over_length"):
        y, what, bar = "to_finest_over_length", "distance from the finest / length", None
        if any(r.get("error_over_length") for r in table.rows):
            y, what = "error_over_length", "error / length"
            bar = number(table.rows[-1].get("error_bar_over_length"))
        last = {r["level"]: r for r in table.rows if r["level"] != "truth" and number(r[y]) > 0}
        drawn = [(level, None, [(number(r["stepping_s"]), number(r[y]))]) for level, r in last.items()]
        made = [(charts.lines(words, "seconds of stepping", what, drawn[:charts.LINES_MOST], bar), words)]
    elif table.has("time_s", "error_bar_over_length", "growth"):
        made = [(time_chart(table, words, "error_bar_over_length"), words)]
    elif table.has("file", "time_s", "error", "bar"):
        made = [(time_chart(table, words, "error", "bar"), words)]
    else:  # runs stand together, before all parts
        made = []
    return [(address(svg), words) for svg, words in made if svg]

# --- pictures of runs ------------------------------------------------------------------------

@dataclass
class Room:
    """The bytes of pictures that a page has left, and the files whose pictures found none."""
    left: int = PICTURES_MOST
    without: list = field(default_factory=list)

FACTS = {"points": "{} points", "degree": "degree {}", "kinematics": "{}", "remedy": "remedy {}",
         "parameters": "{} springs", "integrator": "{} steps", "step": "steps of {} ms", "substeps": "{} substeps",
         "iterations": "{} iterations", "thickness": "{} mm thick", "young": "E = {} Pa", "poisson": "nu = {}",
         "density": "rho = {} kg/m³", "value": "damping {}"}

def fact(key, words):
    """What a run was made with, as one says it."""
    if words[:1] == "[":
        counts = words.strip("[]").removesuffix(",1").split(",")
        words = counts[0] if key == "degree" and len(set(counts)) == 1 else " x ".join(counts)
    elif is_number(words):
        words = charts.words_of(float(f"{number(words) * (1000 if key in ('thickness', 'step') else 1):.6g}"))
    return FACTS[key].format(words)

def labels(runs, prefix=""):
    """{name: what stands below pictures}: a run's name but for its numbers, its model, its points, and
    in what else runs of this model differ, with units."""
    made = {}
    for run in runs:
        name = " ".join(w for w in run.name.removeprefix(prefix).split("_") if not re.fullmatch(r"\d+|mm", w))
        same = [r for r in runs if (r.model, r.title) == (run.model, run.title)]
        told = [fact(key, run.facts[key]) for key in FACTS if key in run.facts and (
            key == "points" or len({r.facts.get(key) for r in same}) > 1)
            and (key not in ("substeps", "iterations") or run.facts[key] != "0")]  # 0: as many as it takes
        made[run.name] = (name + ": " if name else "") + ", ".join(
            [run.title or run.model, *(words for words in told if words not in name)])
    twice = [name for name, words in made.items() if list(made.values()).count(words) > 1]
    return made | {name: f"{made[name]} ({name.replace('_', ' ')})" for name in twice}

def by_number(file):
    """Sorts files by name, and the numbers in it by size."""
    return [int(n) if n.isdigit() else n for n in re.split(r"(\d+)", file.name)]

def strips(files, times, room, trouble, prefix="", most=TIMES_MOST):
    """A row of pictures for each result file, those of a scene in one view and scale."""
    runs = []
    for file in files[:RUNS_MOST]:
        try:
            runs += filter(None, [results.run(file, most, times)])
        except Bad as bad:
            trouble.append(str(bad))
    made, words = {}, labels(runs, prefix)
    for scene in dict.fromkeys(run.scene for run in runs):
        of = [run for run in runs if run.scene == scene]
        drawn = iter(charts.pictures_of(of))
        made |= {run.name: [next(drawn, b"") for _ in run.time] for run in of}
    size = sum(len(p) for pictures in made.values() for p in pictures) * 4 // 3
    if size > room.left:
        room.without += [run.name for run in runs]
        return []
    room.left -= size
    return [Strip(words[run.name], [(address(p, "png"), f"{t:g} s") for p, t in zip(made[run.name], run.time)],
                  run.scene) for run in runs]

def figures(top, room):
    """The paper's figures, recomputed, as far as the folder has them."""
    made = []
    for number_, folder, names, times, words in FIGURES:
        place, trouble = top / folder, []
        files = [f for name in names for f in sorted(place.glob(name + ".h5"), key=by_number) if "better" not in f.name]
        begins = {f.name.split("_")[0] + "_" for f in files}
        shown = strips(files, times, room, trouble, begins.pop() if len(begins) == 1 else "", most=6)
        if shown or trouble:
            made.append(Part(f"figure{number_}", f"Fig. {number_}: {words}", trouble=trouble,
                             strips=shown, quick=results.is_quick(place)))
    return made

# --- what a folder holds ---------------------------------------------------------------------

def listed(top):
    """[(name, folder, [file], [trouble])] of a folder and those in it, by name; links are not followed."""
    found, ahead = [], [(top, "")]
    while ahead and len(found) < FOLDERS_MOST:
        folder, name = ahead.pop(0)
        try:
            with os.scandir(folder) as entries:
                entries = sorted(entries, key=lambda e: e.name)
        except OSError as error:
            found.append((name, folder, [], [f"{folder}: {error.strerror}"]))
            continue
        files = [folder / e.name for e in entries if not e.is_dir(follow_symlinks=False)]
        found.append((name, folder, files, []))
        ahead += [(folder / e.name, f"{name}/{e.name}".strip("/")) for e in entries
                  if e.is_dir(follow_symlinks=False) and name.count("/") < 2 and e.name[0] != "."]
    return found

def read_tables(part, files):
    """Adds the tables of files to a part, and their charts; the paper's statements go to a list."""
    for file in files:
        try:
            found = results.tables(file)
        except Bad as bad:
            part.trouble.append(str(bad))
            continue
        part.made = part.made or found[0].made
        part.quick |= "--quick" in part.made
        for table in found:
            if table.has(*CLAIM_KEYS):
                part.claims += table.rows
                continue
            if table.keys[:1] != ["panel"]:
                part.tables.append(table)
            part.charts += charts_of(table, part.title)
    if ours := [r for r in part.claims if not r.get("source", "-")]:  # the paper's stand in a table of their own
        part.tables.append(results.Table("Statements of ours or of this plan", list(CLAIM_KEYS), ours))
    for table in [t for t in part.tables if t.has("check", "verdict")]:
        verdicts = list(grouped(table.rows, "verdict"))
        part.tables.insert(0, results.Table("The number of comparisons of each check, by verdict", ["", *verdicts], [
            {"": check} | {v: str(len(where(of, verdict=v))) for v in verdicts}
            for check, of in grouped(table.rows, "check").items()]))

def parts_of(top, room):
    """A part for each file of tables in the folder itself, and for each folder in it."""
    made = []
    for name, folder, files, trouble in listed(top):
        tables = [f for f in files if f.suffix == ".csv"][:FILES_MOST]
        runs = sorted((f for f in files if f.suffix == ".h5"), key=by_number)
        groups = [(f.stem, [f], []) for f in tables] + ([("runs", [], runs)] if runs else [])
        if name:
            printed = [f for f in tables if f.name == "printed.csv"]
            groups = [(name, printed + [f for f in tables if f.stem.endswith("chart")] if printed else tables, runs)]
        for title, of, h5 in groups:
            part = Part(re.sub(r"\W", "_", title), title.replace("_", " "), trouble=list(trouble),
                        quick=results.is_quick(folder))
            read_tables(part, of)
            if h5 and folder.name not in {f[1] for f in FIGURES}:
                shown = {re.sub(r"(_\d+(x\d+)*)+$", "", f.stem): f for f in h5}  # the largest of each kind
                shown = list(shown.values()) if len(shown) > 1 else h5
                part.strips = strips(shown, None, room, part.trouble)
                if part.strips and len(part.strips) < len(h5):
                    part.words.append(f"Pictures of {len(part.strips)} of {len(h5)} result files.")
            made.append(part)
    return made

# --- what it says ----------------------------------------------------------------------------

def statements_of(parts):
    """The paper's statements, each once, by section; those of ours have no source."""
    found = {}
    for part in parts:
        for r in part.claims:
            if r.get("source", "-"):
                found.setdefault((r.get("source", ""), r["claim"], r.get("reading", "")), r | {"quick": part.quick})
    return sorted(found.values(), key=lambda r: [int(n) for n in re.findall(r"\d+", r.get("source", ""))])

def said_of_statements(rows):
    if not rows:
        return "No statement of the paper was judged yet: clothbench table paper"
    yes, no = (len(where(rows, verdict=word)) for word in ("holds", "does not hold"))
    left = f"; {len(rows) - yes - no} cannot be judged from these runs" if yes + no < len(rows) else ""
    return f"Of the paper’s {len(rows)} statements on which there are runs here, {yes} hold and {no} do not{left}."

def said_of_speed(table):
    if not table:
        return "Speed against error was not measured: clothbench compare edge_drop"
    first = [one for one in best(table.rows) if one[0] < float("inf")]
    if not first:
        return "No run of edge_drop comes within 1 % of the length."
    more = f"; the next model, {first[1][2]}, takes {round2(first[1][0] / first[0][0])} times as long" \
        if len(first) > 1 else ""
    return (f"The least time to an error of 1 % of the length on edge_drop is {round2(first[0][0])} s, "
            f"by {first[0][2]}{more}.")

def said_of_checks(tables):
    words = [r["verdict"] for t in tables if t.has("check", "verdict") for r in t.rows]
    if not words:
        return "Nothing was compared with closed forms: clothbench verify"
    return ("Of the results that claim an accuracy and were compared with closed forms and other programs, "
            f"{words.count('met')} have it and {words.count('MISSED') + words.count('died')} do not.")

def speeds_of(parts):
    """[(scene, table)] of what was compared, edge_drop first."""
    found = {}
    for part in parts:
        for table in part.tables:
            if table.has(*RUN_KEYS):
                scene = re.match(r"Every run on (\w+)", table.caption)
                scene = scene[1] if scene else part.strips[0].scene if part.strips else \
                    part.title.split("/")[-1].replace("compare ", "", 1)
                found.setdefault(scene.replace(" ", "_"), table)
    found = {"edge_drop" if scene == "compare" else scene: table for scene, table in found.items()}
    return sorted(found.items(), key=lambda s: (s[0] != "edge_drop", s[0]))

def speed_part(speeds):
    part = Part("speed", "Speed against error")
    part.words = ["A line for each model: its best contestant on finer and finer nets with shorter and "
                  "shorter steps. Lower is more accurate, further left is faster."]
    for scene, table in speeds:
        part.add_chart(speed_chart(table, scene, scene == "edge_drop"), f"{scene}: error over seconds of work")
    return part

# --- the page --------------------------------------------------------------------------------

def fit(parts):
    """Cuts charts and tables to the room of a page, and says what was left out."""
    room, charts_room = CELLS_MOST, CHARTS_MOST
    for part in parts:
        many = len(part.charts)
        part.charts = [c for c in part.charts if (charts_room := charts_room - len(c[0])) > 0]
        if len(part.charts) < many:
            part.words.append(f"There is no room for {many - len(part.charts)} of its charts.")
        for table in part.tables:
            size = sum(len(cell) + 25 for r in table.rows[:ROWS_MOST] for cell in r.values())
            most = ROWS_MOST if size <= room else 10
            room -= min(size, room)
            if len(table.notes) > NOTES_MOST:
                table.notes[NOTES_MOST:] = [f"{len(table.notes) - NOTES_MOST} more notes are in the file."]
            if len(table.rows) > most:
                table.notes.insert(0, f"{len(table.rows) - most} more rows are in the file.")
                del table.rows[most:]
    return parts

def rendered(**what):
    env = jinja2.Environment(loader=jinja2.FileSystemLoader(pathlib.Path(__file__).parent),
                             autoescape=True, trim_blocks=True, lstrip_blocks=True)
    env.filters |= {"head": head, "short": short, "tone": tone, "filled": filled}
    env.tests["number"] = is_number
    return env.get_template("page.html.j2").render(**what)

def picture(file):
    """A run at six times, side by side."""
    run = results.run(file, 6)
    made = charts.pictures_of([run]) if run else []
    if not made:
        raise Bad(f"{file}: has no positions to draw")
    return charts.row_of(made, [f"{t:g} s" for t in run.time])

def motions_of(top):
    """Motions to play: the files of FOLDER/run_SCENE, as 16-bit numbers, centred, those of a scene to
    one scale; of longer runs every n-th frame."""
    runs = []
    files = [f for _, folder, files, _ in listed(top) if folder.name.startswith("run_")
             for f in files if f.suffix == ".h5"][:RUNS_MOST]
    for file in files:
        with contextlib.suppress(Bad):  # its part says so
            runs += filter(None, [results.run(file, most=max(2, MOTIONS_MOST // len(files) // 1152), step=9)])
    made = []
    for run in runs:
        flat = charts.points_of([r for r in runs if r.scene == run.scene])
        middle = (flat.min(0) + flat.max(0)) / 2
        scale = np.abs(flat - middle).max() * 1.25 or 1
        shown = run.side_by_side() if run.surface is None else run.surface[:, None]
        xyz = shown[run.is_good()]
        made.append({"name": f"{run.scene}, {run.name}".replace("_", " "), "colour": charts.colour_of(run.model),
                     "time": [t for t, is_good in zip(run.time, run.is_good()) if is_good],
                     "rows": xyz.shape[1], "columns": xyz.shape[2],
                     "triangles": [] if run.surface is None else run.triangle.tolist(),
                     "cut": run.xyz.shape[3] if run.xyz.shape[1] > 1 else 0,
                     "data": base64.b64encode(
                         np.nan_to_num(32767 * np.clip((xyz - middle) / scale, -1, 1), nan=-32768)
                         .astype("<i2").tobytes()).decode()})
    return [m for m in made if m["time"]]

def protocol(tables):
    """The text of the page on a simulator, from the tables that `score --protocol` left."""
    found = results.tables(tables)
    part = Part("tables", "Tables", made=found[0].made)
    for table in found[1:]:
        part.charts += charts_of(table, "errors")
    part.tables = found[1:]
    return rendered(title=found[0].caption, lead=found[0].notes, parts=fit([part]),
                    verdicts=list(grouped(found[0].rows, "subject").items()))

def report(folder, links=()):
    """The text of the page of all results."""
    top, room = pathlib.Path(folder), Room()
    pictures = figures(top, room)
    parts = parts_of(top, room)
    statements, speeds = statements_of(parts), speeds_of(parts)
    lead = [said_of_statements(statements), said_of_speed(dict(speeds).get("edge_drop")),
            said_of_checks([t for p in parts if "clothbench stress" not in p.made for t in p.tables])]
    if busy := sum("busy" in r["verdict"] for p in parts for r in p.claims):
        lead.append(f"The machine was busy: {busy} {'statements on time are' if busy > 1 else 'statement on time is'}"
                    " not judged.")
    if quick := [p.title for p in parts if p.quick]:
        lead.append("Quick runs, which measure less well: " + ", ".join(quick) + ".")
    if room.without:
        lead.append("There was no room for pictures of: " + ", ".join(room.without[:40]) + ".")
    speed, *parts = fit([speed_part(speeds)] + [p for p in parts if p.tables or p.charts or p.strips or p.trouble])
    return rendered(title="Cloth models on the paper’s scenes and others", folder=str(folder),
                    lead=lead, pictures=pictures, statements=statements[:STATEMENTS_MOST],
                    speed=speeds and speed, parts=parts, motions=motions_of(top), links=links)
