"""Draws the chart of README from doc/results/: doc/figures keeps it as doc/speed_against_error.svg.

Time runs to the right, error upwards, both on logarithmic scales: a model is better the lower and
the further left its line is.
"""
import math
from html import escape

from figures_made import best_contestants
from figures_read import digits, number, part

SIDES = {"left": 78, "right": 530, "top": 44, "bottom": 360}
WIDTH, HEIGHT = 860, 420
SECONDS, ERROR = (1e-4, 1), (5e-4, 0.2)
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]


def place(value, ends, low, high):
    """Of a number on a logarithmic axis."""
    share = math.log(value / ends[0]) / math.log(ends[1] / ends[0])
    return low + share * (high - low)


def across(seconds):
    return place(seconds, SECONDS, SIDES["left"], SIDES["right"])


def up(error):
    return place(error, ERROR, SIDES["bottom"], SIDES["top"])


def text(x, y, said, how=""):
    return f'<text x="{x:.1f}" y="{y:.1f}"{how}>{escape(said)}</text>'


def line(x0, y0, x1, y1, how):
    return f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" {how}/>'


def grid():
    for n in range(-4, 1):
        x = across(10 ** n)
        yield line(x, SIDES["top"], x, SIDES["bottom"], 'stroke="#ddd"')
        yield text(x, SIDES["bottom"] + 18, f"{10 ** n:g} s", ' text-anchor="middle"')
    for error in (0.001, 0.01, 0.1):
        y = up(error)
        yield line(SIDES["left"], y, SIDES["right"], y, 'stroke="#ddd"')
        yield text(SIDES["left"] - 8, y + 4, f"{100 * error:g} %", ' text-anchor="end"')


def front(title):
    """[(seconds, error)] of the runs that no other of the contestant beats, and that fit."""
    runs = [(number(r["seconds"]), number(r["worst_rmse_over_length"]))
            for r in part("compare", "Every run", "front")
            if r["title"] == title and r["front"] == "1"]
    return sorted((s, e) for s, e in runs
                  if SECONDS[0] <= s <= SECONDS[1] and ERROR[0] <= e <= ERROR[1])


def known():
    """What the truth is known to, as a share of the length."""
    return max(number(r["error_bar_over_length"])
               for r in part("truth_edge_drop", "Truth of edge_drop", "error_bar_over_length")
               if number(r["time_s"]) <= 0.5)


def speed_against_error():
    drawn = list(grid())
    for n, (title, *_) in enumerate(best_contestants()):
        points = [(across(s), up(e)) for s, e in front(title)]
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        colour = COLOURS[n % len(COLOURS)]
        drawn.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        drawn += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in points]
        y = SIDES["top"] + 22 + 26 * n
        drawn.append(line(SIDES["right"] + 18, y - 4, SIDES["right"] + 42, y - 4,
                          f'stroke="{colour}" stroke-width="3"'))
        drawn.append(text(SIDES["right"] + 50, y, title))
    x, y = across(0.5), up(known())
    drawn.append(line(x, SIDES["top"], x, SIDES["bottom"], 'stroke="#777" stroke-dasharray="6 4"'))
    drawn.append(text(x - 6, SIDES["top"] + 14, "real time", ' text-anchor="end" fill="#555"'))
    drawn.append(line(SIDES["left"], y, SIDES["right"], y, 'stroke="#777" stroke-dasharray="6 4"'))
    drawn.append(text(SIDES["left"] + 6, y + 16, f"the truth is known to {digits(100 * known(), 2)} %",
                      ' fill="#555"'))
    middle = (SIDES["left"] + SIDES["right"]) / 2
    drawn.append(text(SIDES["left"], 22, "Error of half a second of motion of the paper's sheet "
                      "against the seconds that it takes", ' font-weight="bold"'))
    drawn.append(text(middle, SIDES["bottom"] + 42, "seconds of work, one thread",
                      ' text-anchor="middle"'))
    drawn.append(text(-(SIDES["top"] + SIDES["bottom"]) / 2, 18, "RMSE / length",
                      ' text-anchor="middle" transform="rotate(-90)"'))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            'font-family="sans-serif" font-size="14">\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>\n' + "\n".join(drawn) +
            "\n</svg>\n")
