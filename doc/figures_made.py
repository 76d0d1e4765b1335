"""Makes the tables and charts of the pages from doc/results/: doc/figures fills them in.

A function makes the table of its name; CHARTS at the end has those of charts.
doc/results/NAME.csv is what a command printed with --format csv, behind a line that says which
command, commit, processor and day (doc/refresh).
"""
import csv
import functools
import itertools
import math
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOP / "python"))
from clothbench import results  # noqa: E402
from clothbench.results import best, grouped, number, where  # noqa: E402

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
    """The first with these cells; there has to be one."""
    return where(rows, **cells)[0]

def digits(value, count):
    """So many significant ones, without an exponent."""
    text = f"{float(value):#.{count}g}"
    return f"{float(text):.0f}" if "e+" in text else text.rstrip(".")

def percent(value):
    """Of a number in per cent; above 99 and below 100 the nines are told."""
    return digits(value, 3 if 99 <= value < 100 else 2) + " %"

def part_of(error):
    """A fraction in per cent; of what is round-off nought, of none or NaN a dash."""
    error = number(error)
    return "-" if math.isnan(error) else digits(100 * error, 2) if abs(error) > 1e-9 else "0"

def markdown(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return "\n".join(lines + ["| " + " | ".join(r) + " |" for r in rows]) + "\n"

def table1():
    rows = part("table1", "Table 1", "apart_most")
    paper = {r["row"] + r["column"]: r["value"]
             for r in tables(TOP / "tests" / "reference" / "paper_tables.csv")[-1][1] if r["table"] == "1"}

    def line(title, model, net, truth):
        timed = where(rows, study="printed", scene="corners", model=model, net=net)
        near = " ".join(f"{number(r['apart']):.3f}" for r in timed)
        error = row(rows, study="static", model=truth, net=net)["off"]
        return [title, net, digits(timed[0]["frame_ms"], 3), digits(timed[0]["of_reference"], 2),
                "baseline" if model == "iga" else near, percent(100 * float(error))]

    def printed(title, who, near):
        time, iga = (float(paper[name + "seconds"]) for name in (who, "IGA-Galerkin"))
        return [f"paper: {title}", paper[who + "net"], f"{1000 * time:.0f}", digits(time / iga, 3), near, "-"]

    return markdown(["", "net", "ms a frame", "cost / IGA", "RMSE to IGA at 0.1 ... 1 s [m]", "error"], [
        line("IGA, paper's", "iga", "10x10x2", "iga"), line("hexahedra", "hex", "32x32x2", "hex"),
        line("hexahedra, incompatible modes", "hex incompatible", "10x10x2", "hex incompatible"),
        line("shell, p = 2, nonlinear", "shell", "10x10", "shell linear"),
        printed("IGA", "IGA-Galerkin", "baseline"),
        printed("FEM", "FEM", f"at most {paper['FEMRMSE at most']}"), printed("shell", "shell IGA", "-")])

STATED = ["section", "the paper states", "here", "verdict", "turns on the reading"]

def stated():
    return part("paper", "statements of the paper", "verdict")

def statements():
    """Of each by its first reading what we found, once where neighbours share it, and the readings
    that turn it."""
    here = [r["sentence"].partition("; ")[0].replace("|", "/") for r in stated()]
    return markdown(STATED, [
        [r["source"], r["claim"], "the same" if words == above else words, r["verdict"],
         "; ".join(re.findall("on the reading (.*?), by which", r["turns"]))]
        for r, words, above in zip(stated(), here, [None, *here])])

def verdicts():
    """How many of the paper's statements hold, and how many of these turn on a reading."""
    return markdown(["verdict", "statements", "of which another reading turns"], [
        [verdict, str(len(of)), str(sum(bool(r["turns"]) for r in of))]
        for verdict, of in grouped(stated(), "verdict").items()])

# The statements that README has, by how they begin.
FIRST = ["mass-spring over", "hexahedra come within", "hexahedra of 32x32x2", "a frame grows as", "rows 14 and 15"]

def first_statements():
    return markdown(STATED, [
        [r["source"], r["claim"], r["sentence"].partition("; `no`")[0], r["verdict"], "yes" if r["turns"] else "no"]
        for begin in FIRST for r in stated() if r["claim"].startswith(begin)])

def frames(name, kinematics="printed"):
    return where(part(name, "milliseconds a frame", "frame_ms"), kinematics=kinematics)

def table23():
    """Each over the row Fig. 12b; of Table 3 the last row, which alone is new."""
    plan = (TOP / "bench" / "plans" / "table2.yaml").read_text()
    captions = dict(re.findall(r'(\w+): \{caption: "([^"]*)"', plan))

    def line(name, r, unit, what, degree, net):
        same = {key: r[key] for key in ("study", "degree", "net") if key in r}
        linear = [digits(of["frame_ms"], 2) for of in where(frames(name, "linear"), **same)]
        return [what, degree, net, digits(r["frame_ms"], 3), *(linear or "-"), f"{float(r['paper_ms']):.0f}",
                *(f"{float(r[key]) / float(unit[key]):.2f}" for key in ("frame_ms", "paper_ms"))]

    rows, (first, *_, last) = frames("table2"), frames("table3")
    return markdown(["", "degree", "net", "printed", "prefactored", "paper", "relative", "paper's"], [
        line("table2", r, row(rows, study="fig12b"), *captions[r["study"]].replace(": ", " ").rsplit(" ", 2))
        for r in rows] + [line("table3", last, first, "Table 3", last["degree"], last["net"])])

def table4():
    counts = part("table4", "Physics, or", "feasible")

    def cells(answer):
        key = re.sub("[^a-z]", "_", answer)
        return [", ".join(row(counts, reading=reading, scene=scene)[key].split(",")[0]
                          for scene in ("flag", "edge_drop"))
                for reading in ("printed", "incremental", "linear", "nonlinear solid", "nonlinear shell")]

    return markdown(["", "paper", "printed", "incremental", "linear", "nonlinear solid", "shell"], [
        [r["answer"], str(18 - int(r["always_no"]))] + cells(r["answer"])
        for r in part("table4", "In hindsight", "always_no")])

def worst(check, model, keep=lambda field, ratio, nu: True):
    """The largest error of a check's rows of a model, whose title begins so, of `fabrics` in bending lengths;
    `keep` is asked whether it is a field's, and of h/L and nu, which are 0 where a row does not name them."""
    errors = []
    for r in [r for _, rows in result("verify") for r in rows if r["check"] == check]:
        found = re.search(r"h/L = ([\d.e-]+), nu = ([\d.]+)", r["quantity"])
        if (re.fullmatch(model, r["model"]) and r["verdict"] != "not applicable" and r["error"] not in ("", "inf")
                and (check != "fabrics" or r["quantity"].startswith("bending length"))
                and keep(r["quantity"].startswith("field"), *(map(float, found.groups()) if found else (0, 0)))):
            errors.append(abs(float(r["error"])))
    return percent(100 * max(errors)) if errors else "-"

def verify():
    net, rows = r"[^=]*\d+x\d+.*", []
    for title, strip, plate in [
        *((title, f"{name}, nonlinear, {more}", f"{name}, linear, {more}") for title, name, more in [
            ("IGA, p = 2", "IGA", ""), ("IGA, p = 2, selective", "IGA, selective", ""),
            ("IGA, p = 3, selective", "IGA, selective", "p = 3, "), ("hexahedra", "hexahedra", ""),
            ("hexahedra, incompatible", "hexahedra, incompatible", "")]),
        ("shell, p = 3", "shell, p = 3, ", "shell, linear, p = 3, "),
        *((name, f"{name}, ", f"{name}, ") for name in ("mass-spring, matched", "mass-spring, leapfrog"))]:
        cells = [worst(check, strip + net) for check in ("elastica", "fabrics", "sze")] + [
            worst("cantilever", plate + net, keep) for keep in (
                lambda field, h, nu: 0 < h <= 0.01, lambda field, h, nu: field and h == 0.1 and nu <= 0.3,
                lambda field, h, nu: field and h == 0.1 and nu == 0.49)] + [worst("frequencies", plate + net)]
        if set(cells) != {"-"}: # a result older than the contestant
            rows.append([title] + cells)
    return markdown(["", "`elastica`, Gamma 0.01 to 1e4", "`fabrics`: bending length",
                     "`sze`: end shear", "`cantilever`, h/L 1e-2 to 1e-5",
                     "h/L = 0.1, nu to 0.3", "nu = 0.49", "`frequencies`, 63 plates"], rows)

def seconds(text):
    return digits(text, 2) if text else "-"

def compare(chosen=None):
    """A row a contestant: seconds to each target, the lowest error and what limits it."""
    least, lowest = (part("compare", *of) for of in [("Least seconds", "seconds_0.01"), ("Lowest RMSE", "sentence")])
    targets = ("0.03", "0.02", "0.01", "0.005", "0.002")
    rows = [[time["title"]] + [seconds(time[f"seconds_{e}"]) for e in targets] +
            [percent(100 * number(best["lowest_rmse_over_length"])), best["sentence"].partition(":")[0]]
            for who in chosen or [r["contestant"] for r in least]
            for time, best in [(row(least, contestant=who), row(lowest, contestant=who))]]
    return markdown([""] + [f"{100 * float(e):g} %" for e in targets] + ["lowest", "limited by"], rows)

def compare_models():
    """Of each model who is first to 1 %; where nobody gets there, who comes nearest."""
    return compare([who for *_, who in best(part("compare", "Every run", "worst_rmse_over_length"))])

def compare_scenes():
    """A row a model: its contestants' least seconds, else their lowest error."""
    scenes = grouped(part("compare_scenes", "Contestants over scenes", "target_rmse_over_length"), "scene")
    titles = {r["contestant"]: r["title"] for caption, rows in result("compare_scenes")
              if "Least seconds" in caption for r in rows}

    def least(scene, model):
        of = where(scene, model=model)
        times = [number(r["seconds"]) for r in of if r["seconds"]]
        errors = [number(r["lowest_rmse_over_length"]) for r in of if r["lowest_rmse_over_length"]]
        return digits(min(times), 2) if times else f"({percent(100 * min(errors))})" if errors else "died"

    def first(scene):
        """Who, how many times faster than the next model's first, and what was asked."""
        times = sorted((float(r["seconds"]), r["contestant"], r["model"]) for r in scene if r["seconds"])
        others = [t for t in times if t[2] != times[0][2]]
        asked = scene[0]["target_rmse_over_length"]
        return [titles[times[0][1]] if times else "nobody", digits(others[0][0] / times[0][0], 2) if others else "-",
                percent(100 * float(asked)) if asked else "-", percent(100 * float(scene[0]["bar_over_length"])),
                f"{float(scene[0]['span_s']):g}"]

    ends = ["**first**", "**times less than the next model**", "error asked for", "truth's bar", "seconds shown"]
    return markdown([""] + [f"`{name}`" for name in scenes], [
        [f"`{model}`"] + [least(scene, model) for scene in scenes.values()]
        for model in dict.fromkeys(r["model"] for scene in scenes.values() for r in scene)] +
        list(map(list, zip(ends, *map(first, scenes.values())))))

def truths():
    """A row for every scene that comes with the program."""
    reasons = dict(re.findall(r"^# (\w+) has no truth: (.*)\.$", (RESULTS / "truths.csv").read_text(), re.M))
    rows = []
    for r in part("truths", "What is known", "truth"):
        cells = ["-", reasons.get(r["scene"], "not stored")]
        if r["truth"] != "none":
            bar = 100 * float(r["error_bar_over_length"])
            cells = [f"{float(r['known_to_s']):g} s", digits(bar, 2) + " %" if bar > 1e-6 else "round-off"]
        rows.append([f"`{r['scene']}`", r["truth"], *cells])
    return markdown(["scene", "truth", "known to", "error bar there, or why there is none"], rows)

def said(diagnosis):
    """Its sentences up to the first explanation."""
    sentences = re.split(r"(?<=[.?]) (?=[A-Z])", diagnosis)
    short = [re.split(r"[:;(?]|[.]$", s)[0].strip() for s in sentences]
    return "; ".join(s[0].lower() + s[1:] for s in short)

def reached(rows, time):
    """The error at `time`, the last one of all, in per cent; bold where `score` has nothing to say
    against it."""
    last = rows[-1]
    if not last["error"]:
        return f"died, {float(last['time']):.2g} s" if last["time"] else "refused"
    said_sound = re.search(r"^Nothing |^Is at its net|\. Nothing ", last["diagnosis"])
    error = part_of(next((r["error"] for r in rows if r["time"] == time), last["error"]))
    return f"**{error}**" if said_sound else error

def peer_cases():
    """{scene: {(simulator, net, step): rows}} of other people's simulators."""
    rows = tables(TOP / "peers" / "baselines.csv")[-1][1]
    return {scene: grouped(of, "simulator", "net", "step") for scene, of in grouped(rows, "scene").items()}

def peers():
    """A row a simulator, a column a scene."""
    scenes = peer_cases()
    judged = {name: min((of[-1] for of in cases.values() if of[-1]["bar"]), key=lambda r: float(r["time"]))
              for name, cases in scenes.items()}
    finest = {(scene, title, step): reached(of, judged[scene]["time"])
              for scene, cases in scenes.items() for (title, _, step), of in cases.items()}
    return markdown([""] + [f"`{name}`, {float(r['time']):g} s" for name, r in judged.items()], [
        ["truth: its error bar"] + [part_of(r["bar"]) for r in judged.values()]] + [
        [title] + [finest.get((scene, title, step), "") for scene in scenes]
        for title, step in dict.fromkeys((title, step) for title, _, step in scenes["hanging"])])

def peers_drop():
    """A row a case of other people's simulators on edge_drop."""
    cases = peer_cases()["edge_drop"]
    rows = [["truth: its error bar", "", "", "", " ".join(part_of(r["bar"]) for r in next(iter(cases.values()))[::2]),
             "", ""]]
    for (simulator, net, step), drop in cases.items():
        if not simulator.startswith("clothbench"):
            errors = " ".join(part_of(r["error"]) for r in drop[::2]) if drop[0]["error"] else "failed"
            rows.append([simulator, drop[0]["version"], net, f"{1000 * float(step):g} ms", errors,
                         seconds(drop[0]["seconds"]), said(drop[-1]["diagnosis"])])
    return markdown(["", "version", "points", "step", "error at 0.1, 0.3, 0.5 s, % of the length", "seconds",
                     "`score` says"], rows)

def protocol():
    """A row a simulator with the verdicts of `score --protocol`; what is not known stands where
    nothing else is."""
    subjects = ["order of the step", "damping", "clamp", "finer nets", "contact"]

    def cell(rows, subject):
        words = list(grouped(where(rows, subject=subject), "verdict"))
        return ", ".join([w for w in words if w != "not known"] or words)

    return markdown(["", *subjects], [
        [name] + [cell(rows, subject) for subject in subjects]
        for name, rows in grouped(tables(TOP / "peers" / "protocol.csv")[-1][1], "simulator").items()
        if not name.startswith("clothbench")])

STRESS = [("IGA, paper's", "iga_paper"), ("IGA, selective", "iga_selective"),
          ("hex, incompatible", "hex_incompatible"), ("shell, cured, p = 3", "shell_selective_3"),
          ("triangles", "triangles"), ("mass-spring", "mass_spring"),
          ("leapfrog", "mass_spring_leapfrog"), ("XPBD", "position_based"),
          ("PD", "projective_dynamics"), ("PD, 1000", "projective_dynamics_1000")]
CASES = [("tip, h/L = 1e-2", "thin_2"), ("h/L = 1e-5", "thin_5"), ("nu = 0.4999", "poisson_04999"),
         ("length 1000 widths", "narrow"), ("mm, inches, E/rho from 1e-3 to 1e3", "millimetres inches soft stiff"),
         ("10,000 steps undamped: energy", "swing_10000"), ("spinning stiff bar: energy", "spinning_bar"),
         ("ends pushed 10 % nearer", "buckling"), ("edge jerked by L/2 in a step", "thrown"),
         ("dropped at 1000 g: energy", "violent_drop"), ("hung from two corners", "two_corners")]

def stress():
    rows = part("stress", "", "until_s")
    order = {"met": 0, "not applicable": 1, "MISSED": 2}

    def end_of(model, cases):
        """The worst of some ends, in a word."""
        verdict, error = max(((r["verdict"], number(r["error"])) for c in cases
                              for r in where(rows, check=c, contestant=model)), key=lambda r: order.get(r[0], 3))
        return {"met": "ok", "MISSED": "off" if error > 1 else f"off {percent(100 * error)}",
                "not applicable": "refused"}.get(verdict, verdict)

    cases = grouped(rows, "check")
    return markdown([""] + [title for title, _ in STRESS], [
        [title] + [end_of(model, of.split()) for _, model in STRESS] for title, of in CASES] + [
        [f"met, of {len(cases)} cases"] + [str(sum(end_of(model, [c]) == "ok" for c in cases)) for _, model in STRESS]])

def stability():
    """The largest step up to which all are feasible."""
    columns, runs = ["1e3", "1e5", "1e7", "1e9"], part("stability", "", "labels")

    def largest(model, stiffness):
        of = where(runs, name=model, young_over_density=stiffness)
        good = list(itertools.takewhile(lambda r: r["labels"] == "feasible", of))
        return f"{1000 * float(good[-1]['time.step']):g} ms" if good else "none"

    return markdown(["E/rho"] + columns + ["died"], [
        [title] + [largest(model, c) for c in columns] +
        [str(sum("died" in r["labels"] for r in where(runs, name=model)))]
        for title, model in STRESS if where(runs, name=model)])

def mesh():
    nets = ["5x5x2", "10x10x2", "15x15x2", "20x20x2"]
    held = part("study_mesh", "two corners held, the paper's scheme", "roughness")
    free = part("study_mesh", "undamped", "roughness")
    truth, last = free[-1], [where(free, level=n)[-1] for n in nets]

    def shape(r):
        return f"{digits(r['roughness'], 2)}, {float(r['stretch']):.2f}"

    return markdown([""] + nets + ["truth"], [
        [f"two corners held, paper's scheme, {float(held[-1]['time_s']):g} s: roughness, largest stretch"] +
        [shape(where(held, level=n)[-1]) for n in nets] + ["-"],
        [f"one edge held, undamped, {float(last[0]['time_s']):g} s: roughness, largest stretch"] +
        [shape(r) for r in last + [truth]],
        ["... error (of the truth: its error bar)"] + [percent(100 * float(e)) for e in (
            *(r["error_over_length"] for r in last), truth["error_bar_over_length"])]])

def cures():
    """The worst error of each cure over studies, with nu up to `most`, or that alone where it is 0.49."""
    found = part("study_cures", "the cures for locking", "tip_of_reference")

    def off(space, studies, most):
        return percent(100 * max(abs(float(r["tip_of_reference"]) - 1) for r in where(found, space=space)
                                 if r["study"] in studies and (0.49 if most == 0.49 else 0) <= float(r["poisson"]) <= most))

    return markdown(["", "none", "selective", "selective, degree 3"], [
        [title] + [off(f"IGA {space}", studies, most)
                   for space in ("(2,2,1), none", "(2,2,1), selective", "(3,3,1), selective")]
        for title, most, studies in [
            ("linear, h/L 1e-2 and thinner", 0.5, ["linear"]),
            ("linear, h/L = 0.1, nu up to 0.3", 0.3, ["linear_thick"]),
            ("linear, h/L = 0.1, nu = 0.49", 0.49, ["linear_thick"]),
            ("nonlinear, Gamma = 10", 0.5, ["gamma_10", "gamma_10_thick"]),
            ("nonlinear, Gamma = 100 (two spans bend)", 0.5, ["gamma_100"])]])

def locking():
    tips = part("study_locking", "tip of a cantilevered sheet", "tip")

    def kept(degree, poisson, column):
        cells = row(tips, space=f"IGA ({degree},{degree},1) 10x10x2", poisson=poisson, thickness="1 mm")
        return percent(100 * float(cells[column]))

    return markdown(["10x10x2, 1 mm thick", "nu = 0", "nu = 0.3", "nu = 0.3 over nu = 0"], [
        [f"degree {degree}", kept(degree, "0", "tip"), kept(degree, "0.3", "tip"),
         kept(degree, "0.3", "tip_of_reference")] for degree in (2, 3, 4)])

SPLITS = [(1, 1), (1, 4), (1, 16), (1, 64), (4, 1), (4, 4), (4, 16), (16, 1), (16, 4)]

def iteration_cells(study, contestant, net, splits, column="error"):
    """The cells of splits [(substeps, iterations)], "" where they were not run."""
    rows = where(result("study_iterations")[-1][1], study=study, contestant=contestant, net=net)
    return [next((r[column] for r in where(rows, substeps=str(s), iterations=str(n))), "") for s, n in splits]

def iterated():
    """The contestants of study iterations, in its order."""
    return list(grouped(result("study_iterations")[-1][1], "contestant"))

def iterations_soft():
    """A row a contestant, a column a split: how stiff a hanging strip seems, over what it seems after the
    most iterations, and what is lost or won a second."""
    def stiffness(contestant, split):
        rows = where(result("study_iterations")[-1][1], study="hanging", contestant=contestant, substeps=str(split[0]))
        found = where(rows, iterations=str(split[1]))
        most = max(rows, key=lambda r: int(r["iterations"]))
        return digits(number(found[0]["stiffness"]) / number(most["stiffness"]), 2) if found else "-"

    return markdown(["substeps x iterations"] + [f"{s} x {n}" for s, n in SPLITS], [
        [title] + [stiffness(title, split) for split in SPLITS] for title in iterated()] + [
        [f"{title}, % lost a second"] + list(map(part_of, iteration_cells("edge_drop", title, "21x21", SPLITS, "loss")))
        for title in iterated()])

def iterations_split():
    """At equal work, 64 sweeps of 121 points a frame or 16 of 441: error of each split; without
    scenes on which all are about as far off as the truth's bar."""
    splits = [(net, s, work // s) for net, work in (("11x11", 64), ("21x21", 16)) for s in (1, 4, 16)]
    lines = []
    for scene, title in itertools.product(("edge_drop", "flag", "corners_patch"), iterated()):
        errors = [iteration_cells(scene, title, net, [split])[0] for net, *split in splits]
        least = min((number(e) for e in errors if e), default=None)
        if least is not None and title != "CG":
            lines.append([f"`{scene}`", title] + [
                f"**{part_of(e)}**" if number(e) == least else part_of(e) for e in errors])
    return markdown(["", ""] + [f"{net}, {s} x {n}" for net, s, n in splits], lines)

def by_scene(heads, scenes, rows, bar, *more):
    """A column for each of scenes {name: rows}, and more; the first row has their truths' bars, from a column."""
    bars = [part_of(max((r[bar] for r in of if r[bar]), key=number, default="")) for of in scenes.values()]
    return markdown(heads + [f"`{name}`" for name in scenes] + list(more),
                    [["the truth's bar"] + [""] * (len(heads) - 1) + bars + ["-"] * len(more)] + rows)

def errors_by_net(name, cures, bound, joined=" ".join):
    """A row a model and cure, a column a scene: errors in per cent from coarse to fine; in bold those
    above bound(rows, row, errors of coarser nets) and the truth's bar."""
    rows = result(name)[-1][1]
    scenes = grouped(rows, "name")

    def cell(scene, cells):
        of, bar = where(scene, **cells), max(number(r["truth_bar_end"]) for r in scene if r["truth_bar_end"])
        errors = [number(r["truth_error_end"]) for r in of]
        return joined([f"**{part_of(e)}**" if e > bound(rows, r, errors[:n]) + bar else part_of(e)
                       for n, (r, e) in enumerate(zip(of, errors))])

    return by_scene([""], scenes, [
        [f"`{model}`{more}"] + [cell(scene, {"model": model} | cells) for scene in scenes.values()]
        for model in grouped(rows, "model") for more, cells in cures.items()], "truth_bar_end")

def falls(name):
    """The coarsest and the finest net's; in bold where one on the way is above a coarser net's error
    by more than the truth's bar."""
    def ends(cells):
        known = [c for c in cells if c != "-"]
        text = " to ".join(c.strip("*") for c in (known[0], known[-1])) if known else "-"
        return f"**{text}**" if any("*" in c for c in known) else text

    return errors_by_net(name, {"": {}}, lambda rows, r, before:
                         min((e for e in before if e == e), default=math.inf), ends)

refinement, refinement_nets = (functools.partial(falls, name) for name in ("refinement", "refinement_nets"))

def remedies():
    """As it comes and uncured; in bold: above the uncured net's error by more than the truth's bar."""
    remedy = "discretization.remedy"

    def bound(rows, r, before):
        same = {key: r[key] for key in ("name", "model", "discretization.points")}
        return number(row(rows, **same, **{remedy: "none"})["truth_error_end"])

    return errors_by_net("remedies", {"": {remedy: "auto"}, ", uncured": {remedy: "none"}}, bound)

def meshes():
    """A row a rule and mesh: errors at the end in per cent, and how far a cantilever's tip is off the
    elastica's, each on the coarsest and the finest net, and the seconds of 21x21 points."""
    rows = part("study_meshes", "irregular", "tip")

    def cell(scene, rule, mesh):
        nets = list(grouped(where(scene, rule=rule, mesh=mesh), "points").values())
        return " to ".join(part_of(r["error"]) if r["error"] else
                           f"{100 * (number(r['tip']) - 1):+.1f}" if r["tip"] else "-"
                           for r in (nets[0][-1], nets[-1][-1])) if nets else "-"

    def seconds(rule, mesh):
        of = where(rows, study="edge_drop", rule=rule, mesh=mesh, points="21x21")
        return digits(number(of[0]["stepping_s"]), 2)

    scenes = grouped(rows, "study")
    return by_scene(["rule", "mesh"], scenes, [
        [rule, mesh] + [cell(scene, rule, mesh) for scene in scenes.values()] + [seconds(rule, mesh)]
        for rule, mesh in grouped(rows, "rule", "mesh")], "error_bar", "seconds")

def touching():
    """Of each scene the errors where its truth ends, the distances to the shell at its end, and depths
    of bodies in the sheet; a column a contestant."""
    rows = [r for r in part("study_touching", "touches", "crossings") if r["level"] != "truth"]
    levels, made = list(grouped(rows, "level")), []

    def shown(run, column, time, scale):
        if not run or not run[0]["stepping_s"]:
            return "refused"
        if any(number(r["crossings"]) > 0 for r in run):
            return "crosses"
        if column == "penetration":
            return digits(scale * max((number(r[column]) for r in run if r[column]), default=0), 2)
        of = next((r[column] for r in where(run, time_s=time)), "")
        return digits(scale * number(of), 2) if of else "-" if run[-1]["crossings"] else "died"

    for scene, of in grouped(rows, "study").items():
        lines = []
        for column, what in [("error", "error"), ("apart", "to the shell")]:
            if known := [r for r in of if r[column]]:
                last = max(known, key=lambda r: number(r["time_s"]))
                lines.append((f"{what} at {number(last['time_s']):g} s",
                              part_of(last["error_bar"]) if column == "error" else "-", column, last["time_s"], 100))
        if any(number(r["penetration"]) > 0 for r in of):
            lines.append(("body in the sheet [mm]", "-", "penetration", None, 1000))
        made += [[f"`{scene}`: {title}", bar] + [shown(where(of, level=level), *how) for level in levels]
                 for title, bar, *how in lines]
    return markdown(["", "truth's bar"] + levels, made)

def fabrics():
    """A row a model, a column a scene: its last errors with the fabric's law and with the mean."""
    rows = [r for r in part("study_fabrics", "law", "error") if r["error_bar"]]
    scenes = {scene: [of[-1] for of in grouped(rows, "model", "law").values()]
              for scene, rows in grouped(rows, "study").items()}

    def cell(rows, model):
        return ", ".join(part_of(next((r["error"] for r in where(rows, model=model, law=law)), ""))
                         for law in ("its own", "isotropic mean"))

    return by_scene([""], scenes, [[model] + [cell(of, model) for of in scenes.values()]
                                   for model in grouped(rows, "model")], "error_bar")

def by_calculix(first, sheets):
    """A row for each table of CalculiX's: how far contestants are from it, and its own bar."""
    rows = [r for _, rows in result("verify_outside") for r in rows
            if re.match(rf"calculix_{sheets}_(rest|motion)", r["quantity"])]
    titles, made = list(grouped(rows, "model")), []
    for quantity, run in grouped(rows, "quantity").items():
        name, when = re.match(r"calculix_(?:denim_)?(\w+)_(rest|motion)", quantity).groups()
        made.append([f"`{name}`", "at rest" if when == "rest" else "until 0.3 s",
                     percent(100 * float(run[0]["error_bar"]))] +
                    [percent(100 * float(of[0]["error"])) if (of := where(run, model=t)) else "-" for t in titles])
    return markdown([first, "", "CalculiX's bar"] + titles, made)

def denim():
    return by_calculix("denim", r"denim_\w+")

def outlines():
    return by_calculix("", "(trapezoid|hole)")

def weaves():
    """A row a fabric: the least and the largest of its starts, and what is published."""
    lines = (TOP / "tests/reference/drape_published.csv").read_text().splitlines()
    published = {r["fabric"]: r for r in csv.DictReader(line for line in lines if line[0] != "#")}

    def of(rows, column, scale, count):
        return " to ".join(digits(scale * f(number(r[column]) for r in rows), count) for f in (min, max))

    return markdown(["", "drape coefficient", "published", "folds"], [
        [fabric, of(rows, "drape", 100, 2) + " %", "{low} to {high} %".format(**published[fabric]), of(rows, "folds", 1, 1)]
        for fabric, rows in grouped(part("study_weaves", "", "drape"), "fabric").items()])

def speed_against_error():
    """A model is better the lower and the further left its line is."""
    runs = part("compare", "Every run", "worst_rmse_over_length")
    bar = max(number(r["error_bar_over_length"])
              for r in part("truth_edge_drop", "Truth of edge_drop", "error_bar_over_length")
              if number(r["time_s"]) <= 0.5)
    drawn = [(title, model, [(number(r["seconds"]), 100 * number(r["worst_rmse_over_length"]))
                             for r in where(runs, title=title, front="1")
                             if 5e-4 <= number(r["worst_rmse_over_length"]) <= 0.2])
             for _, _, title, model, _ in best(runs)]
    return {"title": "Half a second of motion of the paper’s sheet: error over seconds", "bar": 100 * bar,
            "x": "seconds of work, one thread", "y": "RMSE / length [%]", "real_time": 0.5, "drawn": drawn}

CHARTS = {"speed_against_error": speed_against_error}
