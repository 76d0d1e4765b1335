"""Makes the tables and charts of the pages from doc/results/: doc/figures fills them in.

A function makes the table of its name; CHARTS at the end has those of charts.
doc/results/NAME.csv is what a command printed with --format csv, behind a line that says which
command, commit, processor and day (doc/refresh).
"""
import functools
import itertools
import math
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOP / "python"))
from clothbench import results  # noqa: E402
from clothbench.results import number  # noqa: E402

RESULTS = TOP / "doc" / "results"

@functools.cache
def tables(path):
    """Of a file: [(caption, rows)], a row a dict of its cells."""
    return [(t.caption, t.rows) for t in results.tables(path)]

def result(name):
    return tables(RESULTS / f"{name}.csv")

def part(name, words, column):
    """The rows of the table whose caption has these words and which has the column."""
    for caption, rows in result(name):
        if words in caption and rows and column in rows[0]:
            return rows
    raise KeyError(f"doc/results/{name}.csv has no table '{words}' with {column}")

def row(rows, **cells):
    for r in rows:
        if all(r[key] == want for key, want in cells.items()):
            return r
    raise KeyError(f"no row {cells}")

def digits(value, count):
    """So many significant ones, without an exponent."""
    text = f"{float(value):#.{count}g}"
    return f"{float(text):.0f}" if "e+" in text else text.rstrip(".")

def percent(value):
    """Of a number in per cent; above 99 and below 100 the nines are told."""
    return digits(value, 3 if 99 <= value < 100 else 2) + " %"

def markdown(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return "\n".join(lines + ["| " + " | ".join(r) + " |" for r in rows]) + "\n"

def paper():
    """{(table, row, column): value} of the second transcription."""
    path = TOP / "tests" / "reference" / "paper_tables.csv"
    return {(r["table"], r["row"], r["column"]): r["value"] for r in tables(path)[-1][1]}

def table1():
    rows = part("table1", "Table 1", "apart_most")

    def line(title, model, net, truth):
        timed = [r for r in rows if (r["study"], r["scene"], r["model"], r["net"]) ==
                 ("printed", "corners", model, net)]
        near = " ".join(f"{number(r['apart']):.3f}" for r in timed)
        error = row(rows, study="static", model=truth, net=net)["off"]
        return [title, net, digits(timed[0]["frame_ms"], 3), digits(timed[0]["of_reference"], 2),
                "baseline" if model == "iga" else near, percent(100 * float(error))]

    made = [line("IGA, paper's", "iga", "10x10x2", "iga"),
            line("hexahedra", "hex", "32x32x2", "hex"),
            line("hexahedra, incompatible modes", "hex incompatible", "10x10x2",
                 "hex incompatible"),
            line("shell, p = 2, nonlinear", "shell", "10x10", "shell linear")]
    p = paper()
    for title, who, near in [("IGA", "IGA-Galerkin", "baseline"),
                             ("FEM", "FEM", f"at most {p['1', 'FEM', 'RMSE at most']}"),
                             ("shell", "shell IGA", "-")]:
        time, iga = (float(p["1", name, "seconds"]) for name in (who, "IGA-Galerkin"))
        made.append([f"paper: {title}", p["1", who, "net"], f"{1000 * time:.0f}",
                     digits(time / iga, 3), near, "-"])
    return markdown(["", "net", "ms a frame", "cost / IGA",
                     "RMSE to IGA at 0.1 ... 1 s [m]", "error"], made)

def statements():
    """Of each by its first reading what we found, once where neighbours share it, and the readings
    that turn it."""
    made, above = [], None
    for r in part("paper", "statements of the paper", "verdict"):
        here = r["sentence"].partition("; ")[0].replace("|", "/")
        made.append([r["source"], r["claim"], "the same" if here == above else here, r["verdict"],
                     "; ".join(re.findall("on the reading (.*?), by which", r["turns"]))])
        above = here
    return markdown(["section", "the paper states", "here", "verdict", "turns on the reading"], made)

def verdicts():
    """How many of the paper's statements hold, and how many of these turn on a reading."""
    rows = part("paper", "statements of the paper", "verdict")
    return markdown(["verdict", "statements", "of which another reading turns"], [
        [verdict, str(len(of)), str(sum(bool(r["turns"]) for r in of))]
        for verdict in dict.fromkeys(r["verdict"] for r in rows)
        for of in [[r for r in rows if r["verdict"] == verdict]]])

# The statements that README has, by how they begin.
FIRST = ["mass-spring over", "hexahedra come within", "hexahedra of 32x32x2",
         "a frame grows as", "rows 14 and 15"]

def first_statements():
    rows = part("paper", "statements of the paper", "verdict")
    return markdown(["section", "the paper states", "here", "verdict", "turns on the reading"], [
        [r["source"], r["claim"], r["sentence"].partition("; `no`")[0], r["verdict"],
         "yes" if r["turns"] else "no"]
        for begin in FIRST for r in rows if r["claim"].startswith(begin)])

def frames(name, kinematics="printed"):
    return [r for r in part(name, "milliseconds a frame", "frame_ms")
            if r["kinematics"] == kinematics]

def table23():
    """Each over the row Fig. 12b; of Table 3 the last row, which alone is new."""
    plan = (TOP / "bench" / "plans" / "table2.yaml").read_text()
    captions = dict(re.findall(r'(\w+): \{caption: "([^"]*)"', plan))
    made = []
    for name, unit in [("table2", row(frames("table2"), study="fig12b")),
                       ("table3", frames("table3")[0])]:
        def label(r):
            return tuple(r.get(axis) for axis in ("study", "degree", "net"))

        linear = {label(r): digits(r["frame_ms"], 2) for r in frames(name, "linear")}
        for r in frames(name):
            caption = captions[r["study"]] if "study" in r else \
                f"Table 3: {r['degree']} {r['net']}"
            what, _, net = caption.partition(": ")
            made.append([what, *net.split(), digits(r["frame_ms"], 3),
                         linear.get(label(r), "-"),
                         f"{float(r['paper_ms']):.0f}",
                         f"{float(r['frame_ms']) / float(unit['frame_ms']):.2f}",
                         f"{float(r['paper_ms']) / float(unit['paper_ms']):.2f}"])
    return markdown(["", "degree", "net", "printed", "prefactored", "paper", "relative",
                     "paper's"], made[:-4] + made[-1:])

def table4():
    shown = [("printed", "printed"), ("incremental", "incremental"), ("linear", "linear"),
             ("nonlinear solid", "nonlinear solid"), ("shell", "nonlinear shell")]
    counts = part("table4", "Physics, or", "feasible")
    rows = []
    for paper in part("table4", "In hindsight", "always_no"):
        key = re.sub("[^a-z]", "_", paper["answer"])
        cells = [", ".join(row(counts, reading=reading, scene=scene)[key].split(",")[0]
                           for scene in ("flag", "edge_drop")) for _, reading in shown]
        rows.append([paper["answer"], str(18 - int(paper["always_no"]))] + cells)
    return markdown(["", "paper"] + [title for title, _ in shown], rows)

def worst(check, model, keep=lambda quantity: True):
    """The largest error of a check's rows of a model, whose title begins so."""
    errors = [abs(float(r["error"]))
              for _, rows in result("verify") for r in rows
              if r["check"] == check and re.fullmatch(model, r["model"])
              and keep(r["quantity"]) and r["verdict"] != "not applicable"
              and r["error"] not in ("", "inf")]
    return percent(100 * max(errors)) if errors else "-"

def ratio(quantity):
    """h/L of a row of `cantilever`, and its nu."""
    found = re.search(r"h/L = ([\d.e-]+), nu = ([\d.]+)", quantity)
    return (float(found[1]), float(found[2])) if found else (0, 0)

def thick(quantity, nu):
    return quantity.startswith("field") and ratio(quantity)[0] == 0.1 and nu(ratio(quantity)[1])

def verify():
    net = r"[^=]*\d+x\d+.*"
    rows = []
    for title, strip, plate in [
        *((title, f"{name}, nonlinear, {more}", f"{name}, linear, {more}") for title, name, more in [
            ("IGA, p = 2", "IGA", ""), ("IGA, p = 2, selective", "IGA, selective", ""),
            ("IGA, p = 3, selective", "IGA, selective", "p = 3, "), ("hexahedra", "hexahedra", ""),
            ("hexahedra, incompatible", "hexahedra, incompatible", "")]),
        ("shell, p = 3", "shell, p = 3, ", "shell, linear, p = 3, "),
        *((name, f"{name}, ", f"{name}, ") for name in ("mass-spring, matched", "mass-spring, leapfrog"))]:
        strips = [worst(check, strip + net) for check in ("elastica", "fabrics", "sze")]
        plates = [worst("cantilever", plate + net, keep) for keep in (
            lambda q: 0 < ratio(q)[0] <= 0.01, lambda q: thick(q, lambda nu: nu <= 0.3),
            lambda q: thick(q, lambda nu: nu == 0.49))] + [worst("frequencies", plate + net)]
        if set(strips + plates) != {"-"}: # a result older than the contestant
            rows.append([title] + strips + plates)
    return markdown(["", "`elastica`, Gamma 0.01 to 1e4", "`fabrics`: bending length",
                     "`sze`: end shear", "`cantilever`, h/L 1e-2 to 1e-5",
                     "h/L = 0.1, nu to 0.3", "nu = 0.49", "`frequencies`, 63 plates"], rows)

def seconds(text):
    return digits(text, 2) if text else "-"

TARGETS = ("0.03", "0.02", "0.01", "0.005", "0.002")

def contestants():
    """(title, model, seconds to each target, lowest error, what limits it)."""
    least = part("compare", "Least seconds", "seconds_0.01")
    lowest = part("compare", "Lowest RMSE", "lowest_rmse_over_length")
    runs = part("compare", "Every run", "worst_rmse_over_length")
    models = {r["contestant"]: r["model"] for r in runs}
    for time, best in zip(least, lowest):
        yield (time["title"], models[time["contestant"]], [time[f"seconds_{e}"] for e in TARGETS],
               number(best["lowest_rmse_over_length"]), best["sentence"].partition(":")[0])

def compare_table(chosen):
    rows = [[title] + [seconds(t) for t in times] + [percent(100 * error), limit]
            for title, _, times, error, limit in chosen]
    return markdown([""] + [f"{100 * float(e):g} %" for e in TARGETS] + ["lowest", "limited by"],
                    rows)

def compare():
    return compare_table(contestants())

def best_contestants():
    """Of each model who is first to 1 %; where nobody gets there, who comes nearest."""
    best = {}
    for one in contestants():
        time = number(one[2][TARGETS.index("0.01")])
        key = (math.inf if math.isnan(time) else time, one[3])
        if one[1] not in best or key < best[one[1]][0]:
            best[one[1]] = key, one
    return [one for _, one in sorted(best.values(), key=lambda b: b[0])]

def compare_models():
    return compare_table(best_contestants())

def scenes_titles():
    """{contestant: title}, in the order of the tables."""
    return {r["contestant"]: r["title"]
            for caption, rows in result("compare_scenes") if "Least seconds" in caption
            for r in rows}

def won(scene):
    """First and next model's first of [(seconds, contestant, model)] of a scene."""
    rows = sorted((float(r["seconds"]), r["contestant"], r["model"]) for r in scene
                  if r["seconds"])
    return rows[:1] + [r for r in rows if r[2] != rows[0][2]][:1]

def compare_scenes():
    """A row a model: its contestants' least seconds, else their lowest error."""
    by_scene = {}
    for r in part("compare_scenes", "Contestants over scenes", "target_rmse_over_length"):
        by_scene.setdefault(r["scene"], []).append(r)
    titles = scenes_titles()

    def best(scene, model):
        of = [r for r in scene if r["model"] == model]
        times = [number(r["seconds"]) for r in of if r["seconds"]]
        errors = [number(r["lowest_rmse_over_length"]) for r in of if r["lowest_rmse_over_length"]]
        return digits(min(times), 2) if times else f"({percent(100 * min(errors))})" if errors else "died"

    models = dict.fromkeys(r["model"] for scene in by_scene.values() for r in scene)
    rows = [[f"`{model}`"] + [best(scene, model) for scene in by_scene.values()] for model in models]
    firsts = [won(scene) for scene in by_scene.values()]
    ends = [("**first**", lambda scene, first: titles[first[0][1]] if first else "nobody"),
            ("**times less than the next model**",
             lambda scene, first: digits(first[1][0] / first[0][0], 2) if len(first) > 1 else "-"),
            ("error asked for",
             lambda scene, first: percent(100 * float(scene[0]["target_rmse_over_length"]))
             if scene[0]["target_rmse_over_length"] else "-"),
            ("truth's bar",
             lambda scene, first: percent(100 * float(scene[0]["bar_over_length"]))),
            ("seconds shown", lambda scene, first: f"{float(scene[0]['span_s']):g}")]
    rows += [[title] + [say(scene, first) for scene, first in zip(by_scene.values(), firsts)]
             for title, say in ends]
    return markdown([""] + [f"`{name}`" for name in by_scene], rows)

def truths():
    """A row for every scene that comes with the program."""
    reasons = dict(re.findall(r"^# (\w+) has no truth: (.*)\.$",
                              (RESULTS / "truths.csv").read_text(), re.M))
    rows = []
    for r in part("truths", "What is known", "truth"):
        cells = ["-", reasons.get(r["scene"], "not stored")]
        if r["truth"] != "none":
            bar = 100 * float(r["error_bar_over_length"])
            cells = [f"{float(r['known_to_s']):g} s",
                     digits(bar, 2) + " %" if bar > 1e-6 else "round-off"]
        rows.append([f"`{r['scene']}`", r["truth"], *cells])
    return markdown(["scene", "truth", "known to", "error bar there, or why there is none"], rows)

def said(diagnosis):
    """Its sentences up to the first explanation."""
    sentences = re.split(r"(?<=[.?]) (?=[A-Z])", diagnosis)
    short = [re.split(r"[:;(?]|[.]$", s)[0].strip() for s in sentences]
    return "; ".join(s[0].lower() + s[1:] for s in short)

def by_case(rows):
    cases = {}
    for r in rows:
        cases.setdefault((r["simulator"], r["net"], r["step"]), []).append(r)
    return cases

def scenes_of(rows):
    """{scene: rows}"""
    scenes = {}
    for r in rows:
        scenes.setdefault(r["scene"], []).append(r)
    return scenes

def baseline_rows():
    return tables(TOP / "peers" / "baselines.csv")[-1][1]

def reached(rows, time):
    """The error at `time`, the last one of all, in per cent; bold where `score` has nothing to say
    against it."""
    last = rows[-1]
    if not last["error"]:
        return f"died, {float(last['time']):.2g} s" if last["time"] else "refused"
    said_sound = re.search(r"^Nothing |^Is at its net|\. Nothing ", last["diagnosis"])
    error = part_of(next((r["error"] for r in rows if r["time"] == time), last["error"]))
    return f"**{error}**" if said_sound else error

def peers():
    """A row a simulator, a column a scene."""
    scenes = scenes_of(baseline_rows())
    columns = {name: by_case(rows) for name, rows in scenes.items()}
    titles = list(dict.fromkeys((r["simulator"], r["step"]) for r in scenes["hanging"]))
    judged = {name: min((of[-1] for of in columns[name].values() if of[-1]["bar"]),
                        key=lambda r: float(r["time"])) for name in scenes}
    rows = [["truth: its error bar"] + [part_of(r["bar"]) for r in judged.values()]]
    for title, step in titles:
        cells = [[reached(of, judged[scene]["time"]) for (t, _, s), of in found.items()
                  if (t, s) == (title, step)] for scene, found in columns.items()]
        rows.append([title] + [cell[-1] if cell else "" for cell in cells])
    return markdown([""] + [f"`{name}`, {float(r['time']):g} s" for name, r in judged.items()],
                    rows)

def peers_drop():
    """A row a case of other people's simulators on edge_drop."""
    cases = by_case(scenes_of(baseline_rows())["edge_drop"])
    judged = next(iter(cases.values()))
    rows = [["truth: its error bar", "", "", "", " ".join(part_of(r["bar"]) for r in judged[::2]),
             "", ""]]
    for (simulator, net, step), drop in cases.items():
        if simulator.startswith("clothbench"):
            continue
        errors = " ".join(part_of(r["error"]) for r in drop[::2]) if drop[0]["error"] else "failed"
        rows.append([simulator, drop[0]["version"], net, f"{1000 * float(step):g} ms", errors,
                     digits(drop[0]["seconds"], 2) if drop[0]["seconds"] else "-",
                     said(drop[-1]["diagnosis"])])
    return markdown(["", "version", "points", "step",
                     "error at 0.1, 0.3, 0.5 s, % of the length", "seconds", "`score` says"],
                    rows)

def protocol():
    """A row a simulator with the verdicts of `score --protocol`; what is not known stands where
    nothing else is."""
    rows = tables(TOP / "peers" / "protocol.csv")[-1][1]
    subjects = ["order of the step", "damping", "clamp", "finer nets", "contact"]

    def cell(name, subject):
        words = list(dict.fromkeys(r["verdict"] for r in rows
                                   if (r["simulator"], r["subject"]) == (name, subject)))
        return ", ".join([w for w in words if w != "not known"] or words)

    return markdown(["", *subjects],
                    [[name] + [cell(name, subject) for subject in subjects]
                     for name in dict.fromkeys(r["simulator"] for r in rows)
                     if not name.startswith("clothbench")])

def part_of(error):
    """A fraction in per cent; of what is round-off, nought."""
    return digits(100 * float(error), 2) if float(error) > 1e-9 else "0"

STRESS = [("IGA, paper's", "iga_paper"), ("IGA, selective", "iga_selective"),
          ("hex, incompatible", "hex_incompatible"), ("shell, cured, p = 3", "shell_selective_3"),
          ("triangles", "triangles"), ("mass-spring", "mass_spring"),
          ("leapfrog", "mass_spring_leapfrog"), ("XPBD", "position_based"),
          ("PD", "projective_dynamics"), ("PD, 1000", "projective_dynamics_1000")]
UNITS = ["millimetres", "inches", "soft", "stiff"]
CASES = [("tip, h/L = 1e-2", ["thin_2"]), ("h/L = 1e-5", ["thin_5"]),
         ("nu = 0.4999", ["poisson_04999"]), ("length 1000 widths", ["narrow"]),
         ("mm, inches, E/rho from 1e-3 to 1e3", UNITS),
         ("10,000 steps undamped: energy", ["swing_10000"]),
         ("spinning stiff bar: energy", ["spinning_bar"]),
         ("ends pushed 10 % nearer", ["buckling"]),
         ("edge jerked by L/2 in a step", ["thrown"]),
         ("dropped at 1000 g: energy", ["violent_drop"]),
         ("hung from two corners", ["two_corners"])]

def ends():
    """{(case, contestant): (verdict, error)}"""
    return {(r["check"], r["contestant"]): (r["verdict"], number(r["error"]))
            for r in part("stress", "", "until_s")}

def end_of(runs):
    """The worst of some ends, in a word."""
    worst = max(runs, key=lambda r: (["met", "not applicable", "MISSED"].index(r[0])
                                     if r[0] != "died" else 3))
    far = worst[1] > 1
    return {"met": "ok", "MISSED": "off" if far else f"off {percent(100 * worst[1])}",
            "not applicable": "refused"}.get(worst[0], worst[0])

def stress():
    all_ends = ends()
    rows = [[title] + [end_of([all_ends[c, model] for c in cases]) for _, model in STRESS]
            for title, cases in CASES]
    cases = sorted({c for c, _ in all_ends})
    rows.append([f"met, of {len(cases)} cases"] +
                [str(sum(all_ends[c, model][0] == "met" for c in cases))
                 for _, model in STRESS])
    return markdown([""] + [title for title, _ in STRESS], rows)

def stability():
    """The largest step up to which all are feasible."""
    columns = ["1e3", "1e5", "1e7", "1e9"]
    runs = part("stability", "", "labels")

    def largest(model, stiffness):
        of = [r for r in runs if (r["name"], r["young_over_density"]) == (model, stiffness)]
        good = list(itertools.takewhile(lambda r: r["labels"] == "feasible", of))
        return f"{1000 * float(good[-1]['time.step']):g} ms" if good else "none"

    rows = [[title] + [largest(model, c) for c in columns] +
            [str(sum(r["name"] == model and "died" in r["labels"] for r in runs))]
            for title, model in STRESS if any(r["name"] == model for r in runs)]
    return markdown(["E/rho"] + columns + ["died"], rows)

def mesh():
    nets = ["5x5x2", "10x10x2", "15x15x2", "20x20x2"]
    held = part("study_mesh", "two corners held, the paper's scheme", "roughness")
    free = part("study_mesh", "undamped", "roughness")
    truth = free[-1]

    def last(rows, net):
        return [r for r in rows if r["level"] == net][-1]

    def shape(r):
        return f"{digits(r['roughness'], 2)}, {float(r['stretch']):.2f}"

    last_time = f"{float(last(free, nets[0])['time_s']):g}"
    rows = [[f"two corners held, paper's scheme, {float(held[-1]['time_s']):g} s: roughness, "
             "largest stretch"] + [shape(last(held, n)) for n in nets] + ["-"],
            [f"one edge held, undamped, {last_time} s: roughness, largest stretch"] +
            [shape(last(free, n)) for n in nets] + [shape(truth)],
            ["... error (of the truth: its error bar)"] +
            [percent(100 * float(last(free, n)["error_over_length"])) for n in nets] +
            [percent(100 * float(truth["error_bar_over_length"]))]]
    return markdown([""] + nets + ["truth"], rows)

CURES = [("none", "IGA (2,2,1), none"), ("selective", "IGA (2,2,1), selective"),
         ("selective, degree 3", "IGA (3,3,1), selective")]

def cures():
    found = part("study_cures", "the cures for locking", "tip_of_reference")

    def off(studies, least=0, most=0.5):
        """The worst error of each cure, with nu from least to most."""
        return [percent(max(abs(float(r["tip_of_reference"]) - 1) for r in found
                            if r["space"] == space and r["study"] in studies
                            and least <= float(r["poisson"]) <= most) * 100)
                for _, space in CURES]

    return markdown([""] + [title for title, _ in CURES], [
        ["linear, h/L 1e-2 and thinner"] + off(["linear"]),
        ["linear, h/L = 0.1, nu up to 0.3"] + off(["linear_thick"], most=0.3),
        ["linear, h/L = 0.1, nu = 0.49"] + off(["linear_thick"], least=0.49),
        ["nonlinear, Gamma = 10"] + off(["gamma_10", "gamma_10_thick"]),
        ["nonlinear, Gamma = 100 (two spans bend)"] + off(["gamma_100"])])

def locking():
    tips = part("study_locking", "tip of a cantilevered sheet", "tip")

    def kept(degree, poisson, column):
        cells = row(tips, space=f"IGA ({degree},{degree},1) 10x10x2", poisson=poisson,
                    thickness="1 mm")
        return percent(100 * float(cells[column]))

    return markdown(["10x10x2, 1 mm thick", "nu = 0", "nu = 0.3", "nu = 0.3 over nu = 0"], [
        [f"degree {degree}", kept(degree, "0", "tip"), kept(degree, "0.3", "tip"),
         kept(degree, "0.3", "tip_of_reference")] for degree in (2, 3, 4)])

SPLITS = [(1, 1), (1, 4), (1, 16), (1, 64), (4, 1), (4, 4), (4, 16), (16, 1), (16, 4)]

def iteration_rows(**cells):
    return [r for r in result("study_iterations")[-1][1]
            if all(r[key] == want for key, want in cells.items())]

def iterated():
    """The contestants of study iterations, in its order."""
    return list(dict.fromkeys(r["contestant"] for r in iteration_rows()))

def softer(contestant, substeps, iterations):
    """How stiff a hanging strip seems, over what it seems after the most iterations; None: it was
    not run."""
    rows = iteration_rows(study="hanging", contestant=contestant, substeps=str(substeps))
    found = [r for r in rows if r["iterations"] == str(iterations)]
    most = max(rows, key=lambda r: int(r["iterations"]))
    return number(found[0]["stiffness"]) / number(most["stiffness"]) if found else None

def iterations_soft():
    """A row a contestant, a column a split: stiffness, and what is lost or won a second."""
    def loss(contestant, split):
        rows = iteration_rows(study="edge_drop", contestant=contestant, net="21x21",
                              substeps=str(split[0]), iterations=str(split[1]))
        return digits(100 * number(rows[0]["loss"]), 2) if rows else "-"

    heads = [f"{s} x {n}" for s, n in SPLITS]
    stiff = [[title] + [digits(share, 2) if (share := softer(title, *split)) else "-"
                        for split in SPLITS] for title in iterated()]
    lost = [[f"{title}, % lost a second"] + [loss(title, split) for split in SPLITS]
            for title in iterated()]
    return markdown(["substeps x iterations"] + heads, stiff + lost)

def iterations_split():
    """At equal work, 64 sweeps of 121 points a frame or 16 of 441: error of each split; without
    scenes on which all are about as far off as the truth's bar."""
    splits = [("11x11", s, 64 // s) for s in (1, 4, 16)] + [("21x21", s, 16 // s)
                                                          for s in (1, 4, 16)]
    lines = []
    for scene in ("edge_drop", "flag", "corners_patch"):
        for title in iterated():
            found = [iteration_rows(study=scene, contestant=title, net=net, substeps=str(s),
                                    iterations=str(n)) for net, s, n in splits]
            errors = [number(rows[0]["error"]) if rows else math.nan for rows in found]
            if not all(map(math.isnan, errors)) and title != "CG":
                least = min(e for e in errors if not math.isnan(e))
                cells = ["-" if math.isnan(e) else digits(100 * e, 2) for e in errors]
                lines.append([f"`{scene}`", title] +
                             [f"**{c}**" if e == least else c for c, e in zip(cells, errors)])
    return markdown(["", ""] + [f"{net}, {s} x {n}" for net, s, n in splits], lines)

def errors_by_net(name, columns, bound, joined=" ".join):
    """A row for each of `columns`, [(title, cells of its rows)], a column a scene: errors in per cent
    from coarse to fine; in bold those above bound(rows, row, errors of coarser nets) and the truth's bar."""
    rows = result(name)[-1][1]
    scenes = list(dict.fromkeys(r["name"] for r in rows))
    bars = {scene: max(number(r["truth_bar_end"]) for r in rows if r["name"] == scene and r["truth_bar_end"])
            for scene in scenes}

    def cell(of):
        errors = [number(r["truth_error_end"]) for r in of]
        texts = ["-" if math.isnan(e) else digits(100 * e, 2) for e in errors]
        return joined([f"**{text}**" if e > bound(rows, r, errors[:n]) + bars[r["name"]] else text
                       for n, (r, text, e) in enumerate(zip(of, texts, errors))])

    return markdown([""] + [f"`{scene}`" for scene in scenes],
                    [["the truth's bar"] + [digits(100 * bar, 2) for bar in bars.values()]] + [
        [title] + [cell([r for r in rows if r["name"] == scene and cells.items() <= r.items()]) for scene in scenes]
        for title, cells in columns(dict.fromkeys(r["model"] for r in rows))])

def falls(name):
    """The coarsest and the finest net's; in bold where one on the way is above a coarser net's error
    by more than the truth's bar."""
    def ends(cells):
        known = [c for c in cells if c != "-"]
        text = " to ".join(c.strip("*") for c in (known[0], known[-1])) if known else "-"
        return f"**{text}**" if any("*" in c for c in known) else text

    return errors_by_net(
        name, lambda models: [(f"`{model}`", {"model": model}) for model in models],
        lambda rows, r, before: min((e for e in before if e == e), default=math.inf), ends)

refinement, refinement_nets = (functools.partial(falls, name) for name in ("refinement", "refinement_nets"))

def remedies():
    """As it comes and uncured; in bold: above the uncured net's error by more than the truth's bar."""
    remedy = "discretization.remedy"

    def bound(rows, r, before):
        return number(row(rows, **{key: r[key] for key in ("name", "model", "discretization.points")},
                          **{remedy: "none"})["truth_error_end"])

    return errors_by_net("remedies", lambda models: [
        (f"`{model}`" + (", uncured" if cure == "none" else ""), {"model": model, remedy: cure})
        for model in models for cure in ("auto", "none")], bound)

def meshes():
    """A row a rule and mesh: errors at the end in per cent, and how far a cantilever's tip is off the
    elastica's, each on the coarsest and the finest net."""
    rows = part("study_meshes", "irregular", "tip")
    nets = list(dict.fromkeys(r["points"] for r in rows))
    studies = list(dict.fromkeys(r["study"] for r in rows))

    def cell(study, rule, mesh):
        cells = {"study": study, "rule": rule, "mesh": mesh}
        ends = [[r for r in rows if (cells | {"points": net}).items() <= r.items()][-1] for net in (nets[0], nets[-1])]
        return " to ".join(digits(100 * number(r["error"]), 2) if r["error"] else
                           f"{100 * (number(r['tip']) - 1):+.1f}" if r["tip"] else "-" for r in ends)

    bars = [max((number(r["error_bar"]) for r in rows if r["study"] == study and r["error_bar"]), default=math.nan)
            for study in studies]
    return markdown(["rule", "mesh"] + [f"`{study}`" for study in studies], [
        ["the truth's bar", ""] + ["-" if math.isnan(bar) else digits(100 * bar, 2) for bar in bars]] + [
        [rule, mesh] + [cell(study, rule, mesh) for study in studies]
        for rule, mesh in dict.fromkeys((r["rule"], r["mesh"]) for r in rows)])

def touching():
    """Of each scene the errors where its truth ends, the distances to the shell at its end, and depths
    of bodies in the sheet; a column a contestant."""
    runs = {}
    for r in part("study_touching", "touches", "crossings"):
        if r["level"] != "truth":
            runs.setdefault(r["study"], {}).setdefault(r["level"], []).append(r)
    levels = list(next(iter(runs.values())))

    def shown(run, column, time, scale):
        if not run or not run[0]["stepping_s"]:
            return "refused"
        if any(number(r["crossings"]) > 0 for r in run if r["crossings"]):
            return "crosses"
        if column == "penetration":
            return digits(scale * max((number(r[column]) for r in run if r[column]), default=0), 2)
        of = next((r[column] for r in run if r["time_s"] == time), "")
        return digits(scale * number(of), 2) if of else "-" if run[-1]["crossings"] else "died"

    made = []
    for scene, of in runs.items():
        rows = [r for run in of.values() for r in run]
        for column, what in [("error", "error"), ("apart", "to the shell")]:
            if known := [r for r in rows if r[column]]:
                last = max(known, key=lambda r: number(r["time_s"]))
                bar = digits(100 * number(last["error_bar"]), 2) if column == "error" else "-"
                made.append([f"`{scene}`: {what} at {number(last['time_s']):g} s", bar] +
                            [shown(of.get(level), column, last["time_s"], 100) for level in levels])
        if any(r["penetration"] and number(r["penetration"]) for r in rows):
            made.append([f"`{scene}`: body in the sheet [mm]", "-"] +
                        [shown(of.get(level), "penetration", None, 1000) for level in levels])
    return markdown(["", "truth's bar"] + levels, made)

def fabrics():
    """A row a model, a column a scene: its last errors with the fabric's law and with the mean."""
    cells = {}
    for r in part("study_fabrics", "law", "error"):  # later rows replace earlier ones
        if r["error_bar"]:
            scene = cells.setdefault(r["study"], {})
            scene["bar"] = digits(100 * number(r["error_bar"]), 2)
            scene[r["model"], r["law"]] = digits(100 * number(r["error"]), 2) if r["error"] else "-"
    models = dict.fromkeys(key[0] for scene in cells.values() for key in scene if key != "bar")
    rows = [["truth's bar"] + [scene["bar"] for scene in cells.values()]] + [
        [model] + [", ".join(scene.get((model, law), "-") for law in ("its own", "isotropic mean"))
                   for scene in cells.values()] for model in models]
    return markdown([""] + [f"`{name}`" for name in cells], rows)

def denim():
    """A row for each table of CalculiX's: how far contestants are from it, and its own bar."""
    rows = [r for _, rows in result("verify_outside") for r in rows if "denim" in r["quantity"]]
    titles = list(dict.fromkeys(r["model"] for r in rows))
    made = []
    for quantity, run in itertools.groupby(rows, lambda r: r["quantity"]):
        off = {r["model"]: r for r in run}
        name, when = re.match(r"calculix_denim_(\w+)_(rest|motion)", quantity).groups()
        made.append([f"`{name}`", "at rest" if when == "rest" else "until 0.3 s",
                     percent(100 * float(next(iter(off.values()))["error_bar"]))] +
                    [percent(100 * float(off[t]["error"])) if t in off else "-" for t in titles])
    return markdown(["denim", "", "CalculiX's bar"] + titles, made)

def speed_against_error():
    """A model is better the lower and the further left its line is."""
    runs = part("compare", "Every run", "front")
    bar = max(number(r["error_bar_over_length"])
              for r in part("truth_edge_drop", "Truth of edge_drop", "error_bar_over_length")
              if number(r["time_s"]) <= 0.5)
    drawn = [(title, row(runs, title=title)["model"],
              [(number(r["seconds"]), 100 * number(r["worst_rmse_over_length"]))
               for r in runs if r["title"] == title and r["front"] == "1"
               and 5e-4 <= number(r["worst_rmse_over_length"]) <= 0.2])
             for title, *_ in best_contestants()]
    return {"title": "Half a second of motion of the paper’s sheet: error over seconds", "bar": 100 * bar,
            "x": "seconds of work, one thread", "y": "RMSE / length [%]", "real_time": 0.5,
            "drawn": drawn}

CHARTS = {"speed_against_error": speed_against_error}
