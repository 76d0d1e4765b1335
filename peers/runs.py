#!/usr/bin/env python3
"""Runs simulators that are installed on exported scenes, and holds their frames against the truth.

    runs.py rows PROGRAM PLACE NAME NET SCENE...            # rows of peers/baselines.csv, printed
    runs.py drive PLACE NAME FOLDER FRAMES.csv KEY=VALUE... # one export, by one driver
    runs.py protocol PROGRAM PLACE NAME # a page a title of cases.txt, PLACE/protocol/TITLE

NAME is a simulator's or all; NET n,m or - for that of each case. PLACE has the copies of the
drivers, and what npm brought.
"""
import csv
import datetime
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import baselines  # noqa: E402
import scene as export  # noqa: E402

UNTIL = {"edge_drop": 0.5}  # s; elsewhere as far as the truth is known
WIDTH = {"strip_swing": 0.2}  # of the length: nets have square cells, as the springs' rule needs
FEWEST = 5                  # points across
PATIENCE = 1800             # s of patience with a run
# What `score --protocol` is given: folder, scene, nets and settings; the 21 x 21 of edge_drop twice.
WEFT = ["material.warp=90"]
PROTOCOL = [("free_fall", "free_fall", ["21,21"], []), ("hanging", "hanging", ["21,21"], []),
            ("rest_small", "rest_small", ["11,11", "21,21", "41,41"], []),
            ("rest_large", "rest_large", ["21,21"], []),
            ("edge_drop", "edge_drop", ["11,11", "21,21", "41,41"], []),
            ("warp_hang", "woven_hang", ["21,5"], []), ("weft_hang", "woven_hang", ["21,5"], WEFT),
            ("warp_level", "woven_level", ["21,5"], []),
            ("weft_level", "woven_level", ["21,5"], WEFT)]


def command(place, name):
    folder = place / name
    if (folder / "drive.mjs").exists():
        return ["node", str(folder / "drive.mjs")]
    if name == "blender":
        return ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "-P",
                str(folder / "drive.py"), "--"]
    if (folder / "drive.py").exists():
        return ["python3", str(folder / "drive.py")]
    return [str(folder / "drive")]


def said(run):
    """The last line that says anything."""
    lines = [line.strip() for line in (run.stdout + run.stderr).splitlines() if line.strip()]
    return lines[-1] if lines else f"it ended with {run.returncode} and without a word"


def started(words):
    try:
        return subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        raise export.Refused(f"it was stopped after {PATIENCE} s") from None


def drive(place, name, folder, out, settings):
    """Frames in `out`, if there are any; what the driver told. Refused with a sentence."""
    scene = export.Scene(folder)
    export.refuse(scene, name)
    export.write_plain(scene)
    if scene.fabric:
        print(f"{name:<10} of this fabric it loses {export.LOST[name]}", file=sys.stderr)
    if scene.meets_itself:
        print(f"{name:<10} its sheet does not meet itself", file=sys.stderr)
    raw = pathlib.Path(folder) / "frames.txt"
    run = started(command(place, name) + [str(folder), str(raw), *settings])
    told = [line for line in run.stdout.splitlines() if line.startswith('{"version')]
    if run.returncode or not told:
        raise export.Refused(said(run))
    if not export.to_csv(scene, raw, out):
        pathlib.Path(out).unlink()
    return json.loads(told[0])


def contest(program, name, folder, out, net, settings):
    """The same of one of the program's contestants; its seconds are set-up and so many frames."""
    words = dict(word.split("=") for word in settings)
    end = words.get("until") or export.Scene(folder).times[-1]
    run = started([program, "run", f"{folder}/scene.yaml", "--model", name, "--set",
                   f"discretization.points=[{net}]", "--set", f"time.step={words['step']}",
                   "--set", f"time.end={end}", "--out", str(out)])
    version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
    told = {"version": re.search(r"^program +\S+ +(\S+)", version, re.M)[1] + " " +
            re.search(r"^commit +(\w{7})", version, re.M)[1]}
    died = re.search(r"died at ([\d.e-]+) s", run.stderr)
    if died:
        return {**told, "died": float(died[1]), "seconds": 0}
    if run.returncode:
        raise export.Refused(said(run))
    setup, frames, each = (float(re.search(text, run.stderr, re.M)[1]) for text in (
        r"^set-up +([\d.e+-]+)", r"^frames +(\d+)", r"^ms a frame +median ([\d.e+-]+)"))
    return {**told, "seconds": setup / 1000 + frames * each / 1000}


def cases(name, wanted="-"):
    """(simulator, title, net, settings, scenes) of the lines of cases.txt; all at the net `wanted`,
    if one is, each but once."""
    seen = set()
    text = (pathlib.Path(__file__).parent / "cases.txt").read_text()
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if line.startswith("#") or name not in ("all", cells[0]):
            continue
        net = cells[2] if wanted == "-" else wanted
        if (cells[1], net, cells[3]) not in seen:
            yield cells[0], cells[1], net, cells[3].split(), cells[4].split()
        seen.add((cells[1], net, cells[3]))


def net_of(scene, net):
    across, along = WIDTH.get(scene, 1), net.split(",")
    return net if across == 1 else ",".join(
        [along[0], str(max(FEWEST, round((int(along[1]) - 1) * across) + 1))])


def export_scene(program, scene, net, folder, changes=()):
    """On so many points, or the scene's own mesh."""
    words = [program, "export", scene, "--out", str(folder),
             *(word for change in changes for word in ("--set", change))]
    run = subprocess.run([*words, "--points", net], capture_output=True, text=True)
    if "has a mesh of its own" in run.stderr:
        run = subprocess.run(words, capture_output=True, text=True)
    if run.returncode:
        raise export.Refused(said(run))


def sheets_of(text):
    """The objects of `score --format json`: a list of several, one by itself, or none."""
    found = json.loads(text or "[]")
    return found if isinstance(found, list) else [found]


def run_case(program, place, case, scenes):
    """One case on several scenes: told[scene] or why not; frames are left in a folder, scored as
    one sheet."""
    name, title, net, settings, _ = case
    nets = {scene: net_of(scene, net) for scene in scenes}
    about = {"simulator": title, "step": settings[0][5:],
             "date": f"{datetime.datetime.now(datetime.timezone.utc):%F}"}
    with tempfile.TemporaryDirectory(dir=place) as work:
        work = pathlib.Path(work)
        frames, told = work / "frames", {}
        frames.mkdir()
        for scene in scenes:
            print(f"{name:<10} {title}, {scene}, {nets[scene]}, step {about['step']} s",
                  file=sys.stderr, flush=True)
            words = settings + ([f"until={UNTIL[scene]}"] if scene in UNTIL else [])
            try:
                export_scene(program, scene, nets[scene], work / scene)
                if (place / name).exists():
                    told[scene] = drive(place, name, work / scene, frames / f"{scene}.csv", words)
                else:
                    told[scene] = contest(program, name, work / scene, frames / f"{scene}.h5",
                                          nets[scene], words)
            except export.Refused as e:
                told[scene] = {"version": "unknown", "refused": str(e)}
        run = subprocess.run([program, "score", str(frames), "--format", "json"],
                             capture_output=True, text=True)
        sheets = {sheet["scene"]: sheet for sheet in sheets_of(run.stdout)}
    for scene in scenes:
        columns = {**about, "scene": scene, "net": nets[scene].replace(",", "x")}
        yield from baselines.case_rows(columns, told[scene], sheets.get(scene))


def make_protocol(program, place, case):
    """The folder of one title; rows of `score --protocol`, with what was refused."""
    name, title, _, settings, _ = case
    out = place / "protocol" / re.sub(r"[^a-z0-9]+", "_", title.lower())
    shutil.rmtree(out, ignore_errors=True)
    version, refused = "unknown", {}
    for folder, scene, nets, more in PROTOCOL:
        for net in nets + nets[1:2] * (scene == "edge_drop"):
            stem = net.replace(",", "x")
            twice = "-2" * any((out / folder).glob(f"{stem}.*"))
            print(f"{title}, {folder}, {stem}{twice}", file=sys.stderr, flush=True)
            words = settings + ([f"until={UNTIL[scene]}"] if scene in UNTIL else [])
            (out / folder).mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryDirectory(dir=place) as work:
                try:
                    export_scene(program, scene, net, f"{work}/scene", more)
                    frames = str(out / folder / f"{stem}{twice}")
                    told = (drive(place, name, f"{work}/scene", frames + ".csv", words)
                            if (place / name).exists() else
                            contest(program, name, f"{work}/scene", frames + ".h5", net, words))
                    version = told["version"]
                    if folder != scene:
                        shutil.copy(f"{work}/scene/scene.yaml", out / folder)
                    if "died" in told:
                        refused.setdefault("it died", []).append(f"{folder} {stem}{twice}")
                except export.Refused as e:
                    refused.setdefault(str(e), []).append(f"{folder} {stem}{twice}")
        if not any(file.suffix in (".csv", ".h5") for file in (out / folder).iterdir()):
            shutil.rmtree(out / folder)
    (out / "engine.yaml").write_text("".join(f"{key}: {json.dumps(value)}\n" for key, value in (
        ("name", title), ("version", version), ("step", float(settings[0][5:])))))
    run = subprocess.run([program, "score", "--protocol", str(out), "--format", "csv"],
                         capture_output=True, text=True)
    if run.returncode:
        raise export.Refused(said(run))
    for row in csv.DictReader(run.stdout.splitlines()):
        yield {"simulator": title, "version": version, **row}
    for why, where in refused.items():
        yield {"simulator": title, "version": version, "subject": "not run", "verdict": "not run",
               "sentence": f"{', '.join(where)}: {' '.join(why.split())}."}


def main(words):
    if words[:1] == ["rows"] and len(words) > 5:
        program, place, name, net, *scenes = words[1:]
        for case in cases(name, net):
            wanted = [s for s in scenes if s in case[4] or case[4] == ["all"]]
            if wanted:
                rows = run_case(program, pathlib.Path(place), case, wanted)
                baselines.write(rows, sys.stdout)
                sys.stdout.flush()
    elif words[:1] == ["protocol"] and len(words) == 4:
        titles = {case[1]: case for case in reversed(list(cases(words[3])))}
        baselines.write((row for case in reversed(titles.values())
                         for row in make_protocol(words[1], pathlib.Path(words[2]), case)), sys.stdout,
                        ["simulator", "version", "subject", "verdict", "sentence"])
    elif words[:1] == ["drive"] and len(words) > 5:
        place, name, folder, out, *settings = words[1:]
        try:
            print(json.dumps(drive(pathlib.Path(place), name, folder, out, settings)))
        except export.Refused as e:
            sys.exit(str(e))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
