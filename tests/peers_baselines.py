#!/usr/bin/env python3
"""peers/ without any simulator: the rows of a run, the table that is kept and how rows get into it,
a scene as the drivers get it, and a sentence for whatever is none or cannot be handed over.
    peers_baselines.py PROGRAM FOLDER-OF-baselines.py
"""
import math
import pathlib
import subprocess
import sys
import tempfile

from checks import check, finish, says

program, peers = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path[:0] = [str(peers), str(peers / "calculix")]
import baselines  # noqa: E402
import drive  # noqa: E402
import runs  # noqa: E402
import scene as export  # noqa: E402

HEAD = "simulator,version,scene,net,step,time,error,bar,floor,seconds,diagnosis,date"
ABOUT = {"simulator": "Mine, 5 substeps", "scene": "edge_drop", "net": "3x3", "step": "0.005",
         "date": "2026-01-31"}
TOLD = {"version": "1.0", "seconds": 0.12345678}
SCORE = {"rows": [{"time": 0.1, "error": 0.0123456789, "bar": 1e-4, "floor": 0},
                  {"time": 0.2, "error": 0.5, "bar": 2e-4, "floor": 0}],
         "diagnosis": [{"kind": "lag", "value": 1, "text": "Lags."},
                       {"kind": "still", "value": 0, "text": "Hardly moves."}]}
JUDGED = """\
"Mine, 5 substeps",1.0,edge_drop,3x3,0.005,0.1,0.0123457,0.0001,0,0.1235,,2026-01-31
"Mine, 5 substeps",1.0,edge_drop,3x3,0.005,0.2,0.5,0.0002,0,0.1235,Lags. Hardly moves.,2026-01-31
"""
DIED = """\
"Mine, 5 substeps",1.0,edge_drop,3x3,0.005,0.235,,,,,Died at 0.235 s: it burst.,2026-01-31
"""
REFUSED = """\
"Mine, 5 substeps",1.0,edge_drop,3x3,0.005,,,,,,"no ball, no contact",2026-01-31
"""
scratch = tempfile.TemporaryDirectory()  # gone when the test ends
folder = pathlib.Path(scratch.name)
table = folder / "table.csv"


def written(told, score):
    with open(table, "w", newline="") as file:
        baselines.write(baselines.case_rows(ABOUT, {**TOLD, **told}, score), file)
    return table.read_text()


def rows_of_runs():
    for what, told, score, rows in [
        ("a row a time, the diagnosis at the last", {}, SCORE, JUDGED),
        ("a death after all", {"died": 0.235, "why": "it\n burst"}, SCORE, JUDGED + DIED),
        ("a death before any", {"died": 0.235, "why": "it burst"}, None, DIED),
        ("a refusal", {"refused": "no ball,\nno contact"}, None, REFUSED),
        ("what a spreadsheet would run", {"refused": "=cmd|x"}, None,
         REFUSED.replace('"no ball, no contact"', "'=cmd|x")),
        ("frames refused", {}, {"rows": [], "refused": "no ball, no contact"}, REFUSED),
    ]:
        check(what, written(told, score) == rows)
    check("objects of score", [len(runs.sheets_of(text)) for text in ("", "{}\n", "[{}\n,{}\n]\n")]
          == [0, 1, 2])
    check("nothing found is said", baselines.UNEXPLAINED in written({}, {**SCORE, "diagnosis": []}))


def read(text):
    table.write_text(text)
    return baselines.read(table)


def kept_table():
    good = f"{HEAD}\n{JUDGED}{DIED}{REFUSED}"
    check("what is written is read", len(read(good)) == 4)
    for what, text, words in [
        ("no file's worth", "", ":1: the columns"),
        ("another order of columns", good.replace("time,error", "error,time"), ":1: the columns"),
        ("no rows", HEAD + "\n", "has no rows"),
        ("a cell short", good.replace(",3x3", "", 1), ":2: 11 cells"),
        ("no version", good.replace(",1.0,", ",,", 1), ":2: version is empty"),
        ("an error that is none", good.replace("0.0123457", "nan"), ":2: error is 'nan'"),
        ("an error below nought", good.replace(",0.5,0.0002", ",-0.5,0.0002"), ":3: error is"),
        ("a bar that is a word", good.replace("0.0001", "small"), ":2: bar is 'small'"),
        ("a refusal without a word", good.replace('"no ball, no contact"', ""), ":5: neither"),
        ("no seconds", good.replace("0.1235", "", 1), ":2: seconds is"),
    ]:
        says(what, ValueError, words, read, text)


def merging():
    """What was run takes the place of what was kept of it, and of nothing else."""
    def row(simulator, scene, error):
        return dict.fromkeys(baselines.COLUMNS, "1") | {
            "simulator": simulator, "scene": scene, "error": error}

    kept = [row("A", "drop", "1"), row("A", "drop", "2"), row("A", "fall", "3"),
            row("B", "drop", "4")]
    made = [row("A", "drop", "5"), row("A", "flag", "6"), row("C", "drop", "7")]
    check("merged", [r["error"] for r in baselines.merged(kept, made)] == list("53647"))
    net = {**row("A", "drop", "8"), "net": "2"}
    check("another net is another case",
          [r["error"] for r in baselines.merged(kept, [net])] == list("12348"))


def protocol():
    """Rows of a simulator that ran take the place of its own, and of nobody else's."""
    head = "simulator,version,subject,verdict,sentence\n"
    table.unlink()
    made = folder / "made.csv"
    for rows in ["A,1,clamp,a hinge,s\nB,1,clamp,clamped,s\n", "A,2,clamp,clamped,s\n"]:
        made.write_text(head + rows)
        baselines.keep_protocol(table, made)
    check("rows of one simulator are replaced, where they stood",
          table.read_text() == head + "A,2,clamp,clamped,s\nB,1,clamp,clamped,s\n")
    check("a fabric's mean is handed over", 0 < exported("woven_level").D < 1e-3)


def exported(scene, *settings):
    place = pathlib.Path(tempfile.mkdtemp(dir=folder)) / "scene"
    subprocess.run([program, "export", scene, "--points", "5,5", "--out", place,
                    *(word for s in settings for word in ("--set", s))],
                   check=True, capture_output=True)
    return export.Scene(place)


def handed_over():
    """What scenes say reaches the drivers, and what none of them can is refused."""
    drop, ball, rest = exported("edge_drop"), exported("sphere"), exported("rest_small")
    export.write_plain(drop)
    plain = {line.split()[0]: [float(word) for word in line.split()[1:]]
             for line in (drop.folder / "plain.txt").read_text().splitlines()}
    check("vertices, held ones and those outside", len(plain["x"]) == 3 * 30 and
          plain["count"] == [25] and len(plain["held"]) == 10)
    # Square cells: 4/3 D on each edge, 24 D / (9 + 3^(1/2)) over a clamp (models/net/hinge_rule.h).
    clamp = 24 / (9 + 3 ** .5)
    stiffness = {round(k / drop.D, 9) for k in plain["hinges"][4::6]}
    check("hinges bend with D", stiffness == {round(4 / 3, 9), round(clamp, 9)})
    row = [h for h in zip(*[iter(plain["hinges"])] * 6) if drop.held >= set(map(int, h[:2]))]
    check("a clamp's are its own", len(row) == 4 and
          all(abs(h[4] / drop.D - clamp) < 1e-9 for h in row))
    check("a ball", ball.ball == [[0.5, 0.5, -0.3505885, 0.3, 0.3]] and ball.damping == 2)
    check("at rest or not", rest.at_rest and not drop.at_rest and rest.damping == 20)
    for name, words in (("ground", "one ball"), ("moving_edge", "no paths"),
                        ("drag_fall", "no other drag")):
        says(name, export.Refused, words, export.refuse, exported(name), "jolt")
    one = exported("edge_drop", "supports=[{at: {u: 0, v: [0, 1], w: 0.5}, fix: z}]")
    says("a slide", export.Refused, "whole vertices", export.refuse, one, "jolt")
    far = [list(x) for x in drop.x]
    check("not lost", not export.is_lost(drop, 0.5, far))
    for bad in math.nan, math.inf, 100:
        far[3] = [0, bad, 0]
        check(f"{bad} is lost", export.is_lost(drop, 0.5, far))


def fabrics():
    """What the rows of a fabric become, and who cannot have which."""
    cut = [exported("edge_drop", f"material={{fabric: denim, warp: {warp}}}") for warp in (0, 30)]
    along, bias = cut
    Y, B = along.fabric, along.bends
    check("stretch and shear of nets", along.stretch > along.shear > 0 and bias.stretch == 0)
    check("hinges are those of the rows", {round(h[4] / B["u"], 9) for h in along.hinges(
        [[0, 1, 5], [1, 6, 5], [5, 6, 11], [5, 11, 10]])} >= {1.0})
    check("a weft that bends more", B["u"] > 1.8 * B["v"])
    law = drive.elastic(along)
    check("the law over h", law[1].split(", ")[:3] == [
        "%.12g" % (Y[q] / along.h) for q in ("Y11", "Y12", "Y22")])
    check("axes of the warp", drive.orientation(bias)[1].startswith("0.866025403784, 0.5, 0, -0.5"))
    check("nobody without a sentence", set(export.LOST) >= {
        line[0] for line in runs.cases("all") if (peers / line[0]).exists()})
    for name in export.LOST:
        if name in export.WITHOUT_SPRINGS:
            export.refuse(bias, name)
        else:
            says(f"{name} on the bias", export.Refused, "needs springs", export.refuse, bias, name)
    soft = exported("edge_drop", "material={fabric: feng_421, softening: [-5e-8, -2e-8]}")
    says("softening", export.Refused, "no softening", export.refuse, soft, "calculix")


def garments():
    """A mesh that is sewn, on capsules: for who needs no hinges."""
    runs.export_scene(program, "shirt", "5,5", folder / "shirt")
    check("times of the truth", export.Scene(folder / "shirt").times == [0.06])
    runs.export_scene(program, "shirt", "5,5", folder / "lighter", ["gravity=[0,0,-9]"])
    shirt = export.Scene(folder / "lighter")
    export.refuse(shirt, "bullet")
    says("a garment", export.Refused, "no hinges", export.refuse, shirt, "jolt")
    check("times without a truth", shirt.times == [0.1, 0.2, 0.3, 0.5])
    check("capsules and a ball", len(shirt.ball) == 1 and shirt.meets_itself and
          shirt.capsules[1] == [-0.12, 0, 0.5, 0.12, 0, 0.5, 0.06, 0.3])
    edges = shirt.edges()
    check("edges as links", len({frozenset(e[:2]) for e in edges}) == len(edges) and
          {v for e in edges for v in e[:2]} == set(range(shirt.count)))
    export.write_plain(shirt)
    check("no hinges", "\nhinges\n" in (shirt.folder / "plain.txt").read_text())


def kept_rows():
    kept = baselines.read(peers / "baselines.csv")
    check("the columns are those that are promised", baselines.HEAD == HEAD)
    found = {(r["simulator"], r["net"], r["step"], r["scene"]) for r in kept}
    scenes = list(dict.fromkeys(r["scene"] for r in kept))
    check("all the scenes", len(scenes) == 9)
    for _, title, net, settings, of in runs.cases("all"):
        for scene in scenes if of == ["all"] else of:
            case = title, runs.net_of(scene, net).replace(",", "x"), settings[0][5:], scene
            check(f"{case} has rows", case in found)
    check("square cells on a strip", runs.net_of("strip_swing", "21,21") == "21,5")
    check("CalculiX stands on top", kept[0]["simulator"].startswith("CalculiX"))


rows_of_runs()
kept_table()
merging()
protocol()
handed_over()
fabrics()
garments()
kept_rows()
finish()
