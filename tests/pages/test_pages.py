"""Charts hold the data of tables, and pages hold what a folder has; whatever stands in a file is text."""
import html.parser
import math
import pathlib
import re

import numpy as np
import pytest
from test_results import sheet

from clothbench import bodies, charts, page, results

SOURCE = pathlib.Path(__file__).resolve().parents[2]
RUNS = "title,contestant,model,seconds,worst_rmse_over_length,bar_over_length,front\n"
HOSTILE = "</p></script><script>alert(1)</script><img src=x onerror=alert(2)><!--"

def words_of(svg):
    return " ".join(re.findall(r"<text[^>]*>([^<]*)<", svg.decode())).replace("\u2212", "-")

def drawn(svg, colour):
    """How many points of this colour a chart has."""
    return len(re.findall(rf"<use [^>]*style=\"fill: {colour}", svg.decode()))

def test_lines_leave_out_what_is_no_number():
    svg = charts.lines("t", "x", "y", [("one", "#112233", [(1, 2), (2, math.inf), (3, math.nan), (4, 5), (5, 1e308), (6, 1e-320)])])
    assert drawn(svg, "#112233") == 2 and "one" in words_of(svg)
    assert charts.lines("t", "x", "y", [("one", None, [(math.nan, 1)])]) is None
    assert svg == charts.lines("t", "x", "y", [("one", "#112233", [(4, 5), (1, 2)])], math.inf)  # by x
    assert charts.classes("t", "x", "y", [("1e308", "1", "a"), ("nan", "2", "b")]) is None
    assert charts.classes("t", "x", "y", [("1e308", "1", "a"), ("1", "2", "b")]) == \
        charts.classes("t", "x", "y", [("1", "2", "b")])

@pytest.mark.parametrize("values, want", [
    ([3, 47], (0, 50)), ([0.0013, 0.8], (0.001, 1)), ([16681.0053720005, 2.1e6], (10000, 5e6)),
    ([5, 5], (5, 6)),
])
def test_ticks_are_round_and_nothing_is_cut(values, want):
    low, high, marks = charts.ticks(values, charts.is_log(values))
    assert (low, high) == pytest.approx(want) and low <= min(values) and high >= max(values)
    assert len(marks) >= 2 and all(len(charts.words_of(m)) <= 6 for m in marks)
    assert [charts.words_of(v) for v in (0.00025, 1e5, 0.5, 20)] == ["2.5e-4", "1e5", "0.5", "20"]

def test_labels_do_not_overlap():
    figure, axes = charts.new_axes("t", "x", "y")
    charts.place_labels(axes, [(0.5, 0.02, f"line {n}", "#000000") for n in range(10)])
    places = sorted(t.get_position()[1] for t in axes.texts)
    room = charts.SIZE * 1.1 / 72 / charts.PLACE[3]
    assert len(places) == 10 and min(np.diff(places)) >= room and places[0] > -0.1 and places[-1] < 1.1
    charts.plt.close(figure)

def table(tmp_path, text, name="t.csv"):
    (tmp_path / name).write_text(text)
    return results.tables(tmp_path / name)[0]

def test_speed_has_the_best_of_each_model(tmp_path):
    t = table(tmp_path, RUNS + "slow,a,iga,9,0.009,0.001,1\nquick,b,iga,1.26,0.01,0.001,1\n"
              "rough,c,iga,0.1,0.02,0.001,1\nother,d,shell,2.52,0.001,0.001,1\nother,d,shell,3,0.002,0.001,0\n"
              "far,e,hex,0.2,0.5,0.001,1\nnone,f,vbd,,0.001,0.001,0\n")
    assert [one[2] for one in page.best(t.rows)] == ["quick", "other", "far"]
    svg = page.speed_chart(t, "s")
    assert all(w in words_of(svg) for w in ("quick", "other", "far", "error bar")) and "slow" not in words_of(svg)
    assert drawn(svg, charts.COLOURS["shell"]) == 1 and page.bar_of(t) == 0.001
    assert page.said_of_speed(t) == ("The least time to an error of 1 % of the length on edge_drop is 1.3 s, by "
                                     "quick; the next model, other, takes 2 times as long.")

def test_charts_of_plans_and_maps(tmp_path):
    t = table(tmp_path, "panel,line,mesh [m],drop\nA,one,0.5,1\nA,one,0.25,2\nA,two,0.5,\nB,two,0.5,3\n")
    made = page.line_charts(t, "chart")
    assert [words for _, words in made] == ["A", "B"] and "mesh [m]" in words_of(made[0][0])
    assert drawn(made[0][0], charts.OTHERS[0]) == 2
    t = table(tmp_path, "number,case,kind,way,gamma,labels,outcome\n1,p,mass,1,7,feasible,\n2,p,mass,10,7,died,\n"
              "3,p,none,100,7,died,\n4,q,none,100,7,died,\n")
    (svg, words), (other, name) = page.map_charts(t)
    assert (words, name) == ("p", "q") and all(w in words_of(svg) for w in ("died: 2", "mass", "100"))
    assert words_of(svg).index("way") < words_of(svg).index("kind")  # x before y
    assert "gamma" not in words_of(svg) and "died: 1" in words_of(other)

def test_pictures_show_what_moves():
    flat = np.stack(np.meshgrid([0, 1, 2.0], [0, 1, 2.0], [0]), -1)[None, :, :, 0]
    none = np.zeros((2, 0, 4, 3))
    first, other, gone = charts.sheets([("#3a9bdc", bodies.quads(flat[0]) * k + [0, 0, z], none)
                                        for k, z in ((1, 0), (np.array([1, 1, 0]), 1), (math.nan, 0))])
    assert len({first, other, gone}) == 3 and len(gone) < len(first)

SCENE = """name: mine
obstacles:
  - plane: {point: [0, 0, -1], normal: [0, 0, 2], friction: 0.3}
  - sphere: {center: [0.5, 0.5, -0.4], radius: 0.3}  # a ball
    path: [[0, 0, 0, 0], [1, 0, 0, 0.5]]
  - capsule:
      from: [0, -0.1, 0]
      to: [0, 0.3, 0]
      radius: 0.05
  - box: {center: [1, 0, 0], size: [0.2, 0.4, 0.6]}
    turn:
      axis: [0, 0, 2]
      about: [1, 0, 0]
      angles:
        - [0, 0]
        - [1, 90]
  - mesh: {file: cone2.obj, at: [0, 0, 0], scale: 2}
time: {step: 0.005, end: 1.0}
material: {young: 1e5, density: 0.5}
# --set material.young=5e4
"""

def test_bodies_of_a_scene_lie_where_they_are():
    triangles = {4: np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0.0]]])}
    of = bodies.of_scene(SCENE, triangles)
    assert [kind for kind, _ in of] == ["plane", "sphere", "capsule", "box", "mesh"]
    low, high = np.zeros(3), np.ones(3)

    def extent(n, t):
        planes, solids = bodies.surfaces([of[n]], t, low, high)
        points = (solids if len(solids) else planes).reshape(-1, 3)
        return np.concatenate([points.min(0), points.max(0)])

    assert np.allclose(extent(1, 0), [0.2, 0.2, -0.7, 0.8, 0.8, -0.1], atol=0.003)
    assert np.allclose(extent(1, 0.5) - extent(1, 0), [0, 0, 0.25] * 2)
    assert np.allclose(extent(2, 0), [-0.05, -0.15, -0.05, 0.05, 0.35, 0.05], atol=0.003)
    assert np.allclose(extent(3, 0), [0.9, -0.2, -0.3, 1.1, 0.2, 0.3])
    assert np.allclose(extent(3, 1), [0.8, -0.1, -0.3, 1.2, 0.1, 0.3])
    assert np.allclose(extent(4, 0), [0, 0, 0, 1, 1, 0])
    assert np.allclose(extent(0, 0)[[2, 5]], -1) and extent(0, 0)[0] < 0 and extent(0, 0)[3] > 1
    assert [k for k, _ in bodies.of_scene(SCENE + "# --set obstacles=[{sphere: {radius: 1}}]\n", {})] == ["sphere"]
    assert not sum(len(q) for q in bodies.surfaces(  # told badly: without a centre, with words, with infinity
        bodies.of_scene("obstacles: [{sphere: {radius: 1}}, {box: {center: x, size: 1}}, {sphere: {center: "
                        "[1e999, 0, 0], radius: 1}}]", {}), 0, low, high))

def test_pictures_show_bodies():
    flat = np.stack(np.meshgrid([0, 1, 2.0], [0, 1, 2.0], [0]), -1)[None, :, :, 0]
    made = {charts.sheets([("#3a9bdc", bodies.quads(flat[0]), bodies.surfaces(bodies.of_scene(text, {}), t, np.zeros(3), np.ones(3)))])[0]
            for text in ("", SCENE, SCENE.replace("radius: 0.3", "radius: 0.2")) for t in (0, 0.5)}
    assert len(made) == 5  # without bodies nothing moves

def test_labels_say_what_differs(tmp_path):
    for name, points, degree, changed in (("drop_10_2", "[10,10,2]", "[2,2,1]", "5e4"), ("drop_10_3", "[10,10,2]", "[3,3,1]", "5e4"),
                                          ("drop_10_4", "[10,10,2]", "[3,3,1]", "0.1e6")):
        sheet(tmp_path / f"{name}.h5", model_title="IGA", scene=SCENE + f"# --set material.young={changed}\n",
              discretization=f"discretization.points={points}\ndiscretization.degree={degree}\n")
    runs = [results.run(file) for file in sorted(tmp_path.glob("*.h5"))]
    assert list(page.labels(runs, "drop_").values()) == [
        "IGA, 10 x 10 x 2 points, degree 2, E = 50000 Pa", "IGA, 10 x 10 x 2 points, degree 3, E = 50000 Pa",
        "IGA, 10 x 10 x 2 points, degree 3, E = 1e5 Pa"]
    assert list(page.labels(runs[:1]).values()) == ["drop: IGA, 10 x 10 x 2 points"]
    assert len(set(page.labels([runs[0], runs[0].__class__(**vars(runs[0]) | {"name": "drop_11_2"})]).values())) == 2

class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags, self.events = [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.events += [name for name, _ in attributes if name.startswith("on")]

def test_page_of_others(tmp_path):
    """A user's own plans, sweeps, compares and runs, one of them damaged, all with odd names."""
    mine = tmp_path / "study_mine"
    mine.mkdir()
    (mine / "printed.csv").write_text(f'# {HOSTILE}\n"{HOSTILE}"\n"{HOSTILE}"\n\n# Sentences of the paper\n'
                                      f'source,claim,verdict,sentence\n4.1,"{HOSTILE}",holds,x\n,our own statement,not judged: the machine was busy,x\n')
    (mine / "mine_chart.csv").write_text(f'panel,line,"{HOSTILE}",y\n,"{HOSTILE}",1,2\n')
    (tmp_path / "compare_mine").mkdir()
    (tmp_path / "compare_mine" / "compare.csv").write_text(RUNS + f'"{HOSTILE}",a,iga,1,0.01,,1\n')
    (tmp_path / "sweep_bad").mkdir()
    (tmp_path / "sweep_bad" / "table.csv").write_text("a,b\n1\n")
    (tmp_path / "run_edge_drop").mkdir()
    sheet(tmp_path / "run_edge_drop" / "mine.h5", np.random.default_rng(2).random((2, 2, 100, 100, 3)),
          scene_name=HOSTILE)
    (tmp_path / "study_mine" / "away.csv").symlink_to("/etc/passwd")
    text = page.report(tmp_path)
    found = Page(text)
    assert found.tags.count("script") == 2 and not found.events and "alert(1)</script><img" not in text
    assert found.tags.count("img") >= 4  # both frames, two charts
    assert "our own statement" in text and "The machine was busy: 1 statement on time is not judged" in text
    assert "Of the paper’s 1 statements" in text and ":2: 1 cells below 2 keys" in text
    assert "root:" not in text and len(text.encode()) < page.PAGE_MOST
    assert "not measured: clothbench compare edge_drop" in text

def test_what_has_no_room_is_told():
    wide = results.Table("wide", ["k"], [{"k": "x" * 1000} for _ in range(400)],
                         notes=["n"] * 30)
    parts = page.fit([page.Part("a", "a", charts=[("x" * 100_000, "c")] * 20, tables=t) for t in ([wide], [])]
                     + [page.Part("b", "b", charts=[("x" * 100_000, "c")])])
    assert [len(p.charts) for p in parts] == [11, 0, 0] and "no room for 9" in parts[0].words[0]
    assert len(wide.rows) == page.ROWS_MOST and "250 more rows" in wide.notes[0]
    assert len(wide.notes) == page.NOTES_MOST + 2
    most = page.PICTURES_MOST + page.CHARTS_MOST + page.MOTIONS_MOST * 4 // 3 + page.CELLS_MOST
    assert most < page.PAGE_MOST - 300_000

def test_page_of_the_program_s_own_results():
    text = page.report(SOURCE / "doc" / "results")
    rows = results.tables(SOURCE / "doc" / "results" / "paper.csv")[0].rows
    verdicts = {r["verdict"] for r in rows}
    assert {"holds", "does not hold"} <= verdicts and len(text.encode()) < page.PAGE_MOST
    assert all(page.jinja2.utils.markupsafe.escape(r["claim"]) in text for r in rows)

def test_protocol(tmp_path):
    (tmp_path / "protocol.csv").write_text(
        f'# clothbench score --protocol | x\n# "{HOSTILE}": its cloth\nsubject,verdict,tone,sentence\n'
        f'error,off,bad,"{HOSTILE}"\n# 1 file\n\n# Errors\nfile,vertices,time_s,error,bar,floor\n'
        f'a,9,0.1,0.01,0.001,0\na,9,0.2,0.02,0.001,0\n')
    text = page.protocol(tmp_path / "protocol.csv")
    assert Page(text).tags.count("script") == 0 and "<dt>error</dt>" in text and "<img" in text
