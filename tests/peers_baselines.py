#!/usr/bin/env python3
"""peers/baselines.py: the rows of a run, the table that is kept, and a sentence for every way in
which it would be none.
    peers_baselines.py FOLDER-OF-baselines.py
"""
import contextlib
import io
import json
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
peers = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(peers))
import baselines  # noqa: E402

failures = 0


def check(what, holds):
    global failures
    if not holds:
        failures += 1
        print("does not hold: " + what)


HEAD = "simulator,version,scene,net,step,time,error,bar,floor,seconds,diagnosis,date"
ABOUT = ["simulator=Mine, 5 substeps", "version=1.0", "scene=edge_drop", "net=3x3", "step=0.005",
         "seconds=0.12345678", "date=2026-01-31"]
SCORE = {"rows": [{"time": 0.1, "error": 0.0123456789, "bar": 1e-4, "floor": 0},
                  {"time": 0.2, "error": 0.5, "bar": 2e-4, "floor": 0}],
         "diagnosis": [{"kind": "lag", "value": 1, "text": "Lags."},
                       {"kind": "still", "value": 0, "text": "Hardly moves."}]}


def printed(*words):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        baselines.main(["rows", *ABOUT, *words])
    return out.getvalue()


def refusal(folder, text):
    path = folder / "table.csv"
    path.write_text(text)
    try:
        baselines.read(path)
    except ValueError as e:
        return str(e)
    return ""


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    score = folder / "score.json"
    score.write_text(json.dumps(SCORE))
    judged = printed(str(score))
    check("a row a time, the diagnosis at the last", judged ==
          '"Mine, 5 substeps",1.0,edge_drop,3x3,0.005,0.1,0.0123457,0.0001,0,0.1235,,2026-01-31\n'
          '"Mine, 5 substeps",1.0,edge_drop,3x3,0.005,0.2,0.5,0.0002,0,0.1235,'
          'Lags. Hardly moves.,2026-01-31\n')
    score.write_text(json.dumps({**SCORE, "diagnosis": []}))
    check("nothing found is said", baselines.UNEXPLAINED in printed(str(score)))
    failed = printed("--failed", "frame 3 has\na NaN, so there")
    check("a failure is a row with its sentence", failed ==
          '"Mine, 5 substeps",1.0,edge_drop,3x3,0.005,,,,,,"frame 3 has a NaN, so there",'
          '2026-01-31\n')

    good = f"{HEAD}\n{judged}{failed}"
    check("what is written is read", refusal(folder, good) == "")
    for what, text, words in [
        ("no file's worth", "", ":1: the columns"),
        ("another order of columns", good.replace("time,error", "error,time"), ":1: the columns"),
        ("no rows", HEAD + "\n", "has no rows"),
        ("a cell short", good.replace(",3x3", "", 1), ":2: 11 cells"),
        ("no version", good.replace(",1.0,", ",,", 1), ":2: version is empty"),
        ("an error that is none", good.replace("0.0123457", "nan"), ":2: error is 'nan'"),
        ("an error below nought", good.replace(",0.5,0.0002", ",-0.5,0.0002"), ":3: error is"),
        ("a bar that is a word", good.replace("0.0001", "small"), ":2: bar is 'small'"),
        ("a failure without a word", good.replace('"frame 3 has a NaN, so there"', ""),
         ":4: neither judged"),
        ("no seconds", good.replace("0.1235", "", 1), ":2: seconds is"),
    ]:
        said = refusal(folder, text)
        check(f"{what}: '{said}' has '{words}'", words in said)

kept = baselines.read(peers / "baselines.csv")
check("the columns are those that are promised", ",".join(baselines.COLUMNS) == HEAD)
cases = [line.split("|") for line in (peers / "cases.txt").read_text().splitlines()
         if not line.startswith("#")]
for name, title, net, settings in ([cell.strip() for cell in case] for case in cases):
    step = dict(word.split("=") for word in settings.split())["step"]
    for scene in "edge_drop", "free_fall":
        check(f"{title}, {net}, {settings} has rows on {scene}", any(
            r["simulator"] == title and r["scene"] == scene and r["step"] == step and
            r["net"] == net.replace(",", "x") for r in kept))
check("CalculiX stands on top", kept[0]["simulator"].startswith("CalculiX"))
sys.exit(1 if failures else 0)
