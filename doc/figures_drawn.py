"""Draws charts from doc/results/, which doc/figures keeps as doc/NAME.svg (CHARTS).

Time or iterations run to the right, errors or stiffnesses upwards, on logarithmic scales.
"""
import math
from html import escape

from figures_made import best_contestants, iterated, softer
from figures_read import digits, number, part

SIDES = {"left": 78, "right": 530, "top": 44, "bottom": 360}
WIDTH, HEIGHT = 860, 420
SECONDS, ERROR = (1e-4, 1), (5e-4, 0.2)
ITERATIONS, STIFFNESS = (0.9, 70), (0.006, 1.4)
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]


def place(value, ends, low, high):
    """Of a number on a logarithmic axis."""
    share = math.log(value / ends[0]) / math.log(ends[1] / ends[0])
    return low + share * (high - low)


def across(value, ends=SECONDS):
    return place(value, ends, SIDES["left"], SIDES["right"])


def up(value, ends=ERROR):
    return place(value, ends, SIDES["bottom"], SIDES["top"])


def text(x, y, said, how=""):
    return f'<text x="{x:.1f}" y="{y:.1f}"{how}>{escape(said)}</text>'


def line(x0, y0, x1, y1, how):
    return f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" {how}/>'


def grid(columns, rows):
    """Lines at [(place, words)]."""
    for x, said in columns:
        yield line(x, SIDES["top"], x, SIDES["bottom"], 'stroke="#ddd"')
        yield text(x, SIDES["bottom"] + 18, said, ' text-anchor="middle"')
    for y, said in rows:
        yield line(SIDES["left"], y, SIDES["right"], y, 'stroke="#ddd"')
        yield text(SIDES["left"] - 8, y + 4, said, ' text-anchor="end"')


def drawn_lines(lines):
    """[(title, [(x, y)])] with a legend."""
    for n, (title, points) in enumerate(lines):
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        colour = COLOURS[n % len(COLOURS)]
        yield f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>'
        yield from (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>'
                    for x, y in points)
        y = SIDES["top"] + 22 + 26 * n
        yield line(SIDES["right"] + 18, y - 4, SIDES["right"] + 42, y - 4,
                   f'stroke="{colour}" stroke-width="3"')
        yield text(SIDES["right"] + 50, y, title)


def page(title, along, upwards, drawn):
    """The whole chart, with its title and what its axes are."""
    middle = (SIDES["left"] + SIDES["right"]) / 2
    drawn += [text(SIDES["left"], 22, title, ' font-weight="bold"'),
              text(middle, SIDES["bottom"] + 42, along, ' text-anchor="middle"'),
              text(-(SIDES["top"] + SIDES["bottom"]) / 2, 18, upwards,
                   ' text-anchor="middle" transform="rotate(-90)"')]
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            'font-family="sans-serif" font-size="14">\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>\n' + "\n".join(drawn) +
            "\n</svg>\n")


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
    """A model is better the lower and the further left its line is."""
    drawn = list(grid([(across(10 ** n), f"{10 ** n:g} s") for n in range(-4, 1)],
                      [(up(error), f"{100 * error:g} %") for error in (0.001, 0.01, 0.1)]))
    drawn += drawn_lines((title, [(across(s), up(e)) for s, e in front(title)])
                         for title, *_ in best_contestants())
    x, y = across(0.5), up(known())
    drawn.append(line(x, SIDES["top"], x, SIDES["bottom"], 'stroke="#777" stroke-dasharray="6 4"'))
    drawn.append(text(x - 6, SIDES["top"] + 14, "real time", ' text-anchor="end" fill="#555"'))
    drawn.append(line(SIDES["left"], y, SIDES["right"], y, 'stroke="#777" stroke-dasharray="6 4"'))
    drawn.append(text(SIDES["left"] + 6, y + 16, f"the truth is known to {digits(100 * known(), 2)} %",
                      ' fill="#555"'))
    return page("Error of half a second of motion of the paper's sheet against the seconds that it "
                "takes", "seconds of work, one thread", "RMSE / length", drawn)


def iterations():
    """What a strip seems to be made of, by contestant: 1 is what it is made of."""
    drawn = list(grid([(across(n, ITERATIONS), f"{n}") for n in (1, 4, 16, 64)],
                      [(up(share, STIFFNESS), f"{share:g}") for share in (0.01, 0.1, 1)]))
    drawn += drawn_lines(
        (title, [(across(n, ITERATIONS), up(share, STIFFNESS))
                 for n in (1, 4, 16, 64) if (share := softer(title, 1, n))])
        for title in iterated())
    return page("A hanging strip, steps of 5 ms: the stiffness that it seems to have",
                "iterations in a step", "of the stiffness after the most", drawn)


CHARTS = {"speed_against_error": speed_against_error, "iterations": iterations}
