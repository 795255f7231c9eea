"""The charts of the accuracy report: who is wrong and who is fast in which family, and which stage of the engine decides."""
import csv

from svg import Picture

# (method, parameter) of accuracy.csv: its two lines of heading
METHODS = {
    ("filtered", ""): ("foresee", "exact"), ("double", ""): ("textbook", "double"), ("double-fma", ""): ("textbook", "with FMA"),
    ("float", ""): ("textbook", "float"), ("boost-quartic", ""): ("Boost", "quartic"), ("bisection", "1e-06"): ("bisection", "to 1e-6"),
    ("bisection", "1e-12"): ("bisection", "to 1e-12"), ("stepping", "1000"): ("stepping", "1,000 steps"),
}
ROW, CELL, GAP = 19, 66, 22


def rows(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def percent(share):
    return f"{100 * share:.2g}" if share < 0.1 else f"{100 * share:.0f}"


def times(ratio):
    return f"{ratio:.2g}" if ratio < 9.95 else f"{ratio:,.0f}"


def wrong(folder):
    """A map of methods and families: percent wrong, and the time relative to foresee; the fastest that is never wrong is framed."""
    table = {(row["family"], row["method"], row["parameter"]): row for row in rows(folder / "accuracy.csv")}
    families = list(dict.fromkeys(family for family, _, _ in table))

    def share(family, method):
        row = table.get((family, *method))
        return None if row is None else (int(row["missed"]) + int(row["invented"])) / int(row["pairs"])

    def cost(family, method):
        row = table.get((family, *method))
        return None if row is None else float(row["ns_median"])

    winners = {family: min((method for method in METHODS if share(family, method) == 0), key=lambda method: cost(family, method))
               for family in families}
    mine = sum(winner == ("filtered", "") for winner in winners.values())
    message = f"foresee is never wrong; in {mine} of {len(families)} families no other method without a wrong decision is faster"
    left, top = 176, 118
    width = CELL * len(METHODS)
    picture = Picture(left + 2 * width + GAP + 20, top + ROW * (len(families) + 1) + 50, message,
                      "Two maps of 30 families of hard pairs and 8 methods: wrong decisions in percent, and time relative to foresee.")
    picture.heading(message, "families of 2,000 hard pairs; framed: the fastest method without a wrong decision in that family")
    for side, title in enumerate(("wrong decisions, percent of pairs (missed and invented)", "time per pair, foresee = 1")):
        start = left + side * (width + GAP)
        picture.text(start, top - 44, title, weight="bold", size=13)
        for column, (method, names) in enumerate(METHODS.items()):
            for line, name in enumerate(names):
                picture.text(start + CELL * (column + 0.5), top - 24 + 13 * line, name, "foresee" if column == 0 else "soft", "middle", 11,
                             "bold" if column == 0 else "")
        y, before = top, "box"
        for family in families:
            if not family.startswith(before):  # a gap between boxes and balls
                y, before = y + ROW / 2, "ball"
            if side == 0:
                picture.text(left - 8, y + 13, family, anchor="end", size=11)
            for column, method in enumerate(METHODS):
                x, error, ours = start + CELL * column, share(family, method), cost(family, ("filtered", ""))
                picture.rect(x + 1, y + 1, CELL - 2, ROW - 2, "rule", ' fill-opacity="0.45"')
                if error is None:
                    picture.text(x + CELL / 2, y + 13, "–", "soft", "middle", 11)
                elif side == 0:
                    if error:
                        picture.rect(x + 1, y + 1, CELL - 2, ROW - 2, "meet", f' fill-opacity="{0.12 + 0.78 * error ** 0.5:.2f}"')
                    colour = "soft" if not error else "ground" if error > 0.7 else "ink"  # readable on its cell, light and dark
                    picture.text(x + CELL / 2, y + 13, percent(error) if error else "0", colour, "middle", 11)
                else:
                    ratio = cost(family, method) / ours
                    if ratio > 1:
                        picture.rect(x + 1, y + 1, CELL - 2, ROW - 2, "grey2", f' fill-opacity="{min(0.7, 0.06 + 0.13 * len(str(int(ratio)))):.2f}"')
                    picture.text(x + CELL / 2, y + 13, times(ratio), "soft" if error and ratio < 100 else "ink", "middle", 11,
                                 extra=' text-decoration="line-through"' if error else "")
                if method == winners[family]:
                    picture.add(f'<rect class="s-foresee" x="{x + 1:g}" y="{y + 1:g}" width="{CELL - 2}" height="{ROW - 2}" fill="none" stroke-width="1.8"/>')
            y += ROW
    picture.text(left, y + 24, "0: no wrong decision; struck out: the method is wrong in that family; –: not for this shape", "soft")
    return picture


def stages(folder):
    """Bars of two rows: which stage decides about a pair, and which rounds the start of a contact."""
    table = rows(folder / "stages.csv")
    message = "Ordinary pairs are decided in double arithmetic; only touching and coinciding paths need exact numbers"
    left, top, width = 176, 92, 420
    picture = Picture(left + 2 * width + 78, top + 17 * len(table) + 40, message,
                      "For each family: percent of pairs decided by each stage, and percent of contact starts rounded by each.")
    picture.heading(message)
    for side, (title, total, parts) in enumerate((
            ("which stage decides (percent of pairs)", "pairs", (("chord", "grey4"), ("certified", "grey2"), ("exact", "foresee"))),
            ("which stage rounds the start (percent of contacts)", "hits",
             (("at_once", "grey4"), ("double_double", "grey2"), ("exact_time", "foresee"))))):
        start = left + side * (width + 48)
        names = {"chord": "chord", "certified": "certified double", "exact": "exact", "at_once": "at once", "double_double": "double-double",
                 "exact_time": "exact"}
        picture.text(start, top - 34, title, weight="bold", size=13)
        x = start
        for part, colour in parts:
            picture.rect(x, top - 22, 10, 10, colour)
            picture.text(x + 15, top - 13, names[part], "soft")
            x += 130
        for place, row in enumerate(table):
            y = top + 17 * place
            if side == 0:
                picture.text(left - 8, y + 11, row["family"], anchor="end", size=11)
            x, whole = start, int(row[total])
            if not whole:
                picture.text(start + 4, y + 11, "no contact", "soft", size=11)
            for part, colour in parts:
                length = width * int(row[part]) / whole if whole else 0
                if length:
                    picture.rect(x, y, length, 13, colour)
                x += length
        for share in range(0, 101, 25):
            picture.text(start + width * share / 100, top + 17 * len(table) + 16, f"{share} %", "soft", "middle", 11)
    return picture
