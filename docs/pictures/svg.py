"""One palette and the parts of every picture: light and dark, a title that is the message, axes with names and units.

foresee is always blue, with the widest lines; rivals are greys with their own dashes and marks; what meets is orange. The colours differ
for all kinds of colour vision (tests/house/pictures_test.py), the greys also in grey print. A picture is text of SVG, the same on every
machine.
"""
import math
from xml.sax.saxutils import escape

# name: (light, dark)
PALETTE = {
    "ground": ("#ffffff", "#0f1720"), "ink": ("#1b2733", "#dbe7ef"), "soft": ("#566674", "#93a6b5"), "rule": ("#dde5ea", "#25333f"),
    "foresee": ("#0b62c4", "#5aa9ff"), "grey1": ("#39434c", "#dfe5ea"), "grey2": ("#535e68", "#b3bdc6"), "grey3": ("#6d7882", "#8a96a0"),
    "grey4": ("#8c969f", "#626e78"), "meet": ("#c2410c", "#fb923c"), "water": ("#e9f1f6", "#10202c"), "land": ("#d9d5c9", "#2a3634"),
    "coast": ("#a8a291", "#4d5c58"), "track": ("#7d98ab", "#7393ab"), "quay": ("#8c7b6b", "#a08f7e"),
}
FONT = "system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif"


def number(value):
    return f"{value:.1f}".rstrip("0").rstrip(".")


def style():
    """f-NAME fills, s-NAME strokes."""
    def rules(which):
        return " ".join(f".f-{name} {{ fill: {shades[which]} }} .s-{name} {{ stroke: {shades[which]} }}" for name, shades in PALETTE.items())
    return f"<style>\n{rules(0)}\n@media (prefers-color-scheme: dark) {{ {rules(1)} }}\n</style>"


class Picture:
    """Parts are added in the order in which they are painted."""

    def __init__(self, width, height, title, description=""):
        self.width, self.height, self.parts = width, height, []
        self.parts.append(f'<svg xmlns="http://www.w3.org/2000/svg" width="{number(width)}" height="{number(height)}" '
                          f'viewBox="0 0 {number(width)} {number(height)}" font-family="{FONT}" font-size="12" role="img">')
        self.parts.append(f"<title>{escape(title)}</title>")
        if description:
            self.parts.append(f"<desc>{escape(description)}</desc>")
        self.parts.append(style())
        self.ground = len(self.parts)
        self.parts.append(f'<rect class="f-ground" width="{number(width)}" height="{number(height)}" rx="8"/>')

    def add(self, part):
        self.parts.append(part)

    def heading(self, text, under=""):
        """The message, and a line below it that says what is shown."""
        self.text(20, 28, text, size=16, weight="bold")
        if under:
            self.text(20, 47, under, "soft")

    def text(self, x, y, text, colour="ink", anchor="start", size=12, weight="", turn=0, extra=""):
        more = (f' font-weight="{weight}"' if weight else "") + (f' transform="rotate({turn} {number(x)} {number(y)})"' if turn else "")
        sized = f' font-size="{size}"' if size != 12 else ""
        self.add(f'<text class="f-{colour}" x="{number(x)}" y="{number(y)}" text-anchor="{anchor}"{sized}{more}{extra}>{escape(text)}</text>')

    def line(self, x0, y0, x1, y1, colour, width=1, dash="", extra=""):
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.add(f'<line class="s-{colour}" x1="{number(x0)}" y1="{number(y0)}" x2="{number(x1)}" y2="{number(y1)}" '
                 f'stroke-width="{width}"{dashed}{extra}/>')

    def path(self, points, colour, width=1.5, dash="", closed=False, extra=""):
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        d = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points) + ("Z" if closed else "")
        self.add(f'<path class="s-{colour}" d="{d}" fill="none" stroke-width="{width}" stroke-linejoin="round"{dashed}{extra}/>')

    def rect(self, x, y, width, height, colour, extra=""):
        self.add(f'<rect class="f-{colour}" x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}"{extra}/>')

    def circle(self, x, y, r, colour, hollow=False, extra=""):
        paint = f'class="s-{colour}" fill="none" stroke-width="1.5"' if hollow else f'class="f-{colour}"'
        self.add(f'<circle {paint} cx="{number(x)}" cy="{number(y)}" r="{number(r)}"{extra}/>')

    def halo(self, x, y, text, size=12, weight=""):
        """Text that stays readable on lines."""
        self.text(x, y, text, size=size, weight=weight, extra=' stroke-width="3" paint-order="stroke" stroke-linejoin="round"')
        self.parts[-1] = self.parts[-1].replace('class="f-ink"', 'class="f-ink s-ground"', 1)

    def moving(self, animations):
        """The part that was added last changes so."""
        part = self.parts[-1]
        self.parts[-1] = part[:-2] + ">" + animations + "</circle>" if part.endswith("/>") else part.replace("</text>", animations + "</text>")

    def cut(self, height):
        """Another height, once what is drawn is known."""
        for place in (0, self.ground):
            self.parts[place] = self.parts[place].replace(f'height="{number(self.height)}"', f'height="{number(height)}"').replace(
                f'{number(self.width)} {number(self.height)}"', f'{number(self.width)} {number(height)}"')
        self.height = height

    def mark(self, x, y, shape, colour, r=3.5):
        """A filled or hollow sign, so that lines differ without colour."""
        if shape == "dot":
            self.circle(x, y, r, colour)
        elif shape == "ring":
            self.add(f'<circle class="f-ground s-{colour}" cx="{number(x)}" cy="{number(y)}" r="{number(r)}" stroke-width="1.5"/>')
        else:
            corners = {"square": [(-1, -1), (1, -1), (1, 1), (-1, 1)], "up": [(0, -1.2), (1.1, 0.9), (-1.1, 0.9)],
                       "down": [(0, 1.2), (1.1, -0.9), (-1.1, -0.9)], "diamond": [(0, -1.3), (1.3, 0), (0, 1.3), (-1.3, 0)]}[shape]
            d = "M" + "L".join(f"{number(x + r * dx)} {number(y + r * dy)}" for dx, dy in corners) + "Z"
            self.add(f'<path class="f-{colour}" d="{d}"/>')

    def written(self):
        return "\n".join([*self.parts, "</svg>", ""])


class Log:
    """A logarithmic scale from low to high, powers of ten as its ticks."""

    def __init__(self, low, high, names=None):
        self.low, self.high, self.names = math.log10(low), math.log10(high), names or {}

    def share(self, value):
        return (math.log10(value) - self.low) / (self.high - self.low)

    def ticks(self):
        for power in range(math.ceil(self.low - 1e-9), math.floor(self.high + 1e-9) + 1):
            yield 10.0 ** power, self.names.get(power, f"{10 ** power:,}" if 0 <= power < 7 else f"{10.0 ** power:g}")


class Linear:
    """A scale from low to high with the given ticks."""

    def __init__(self, low, high, ticks):
        self.low, self.high, self.at = low, high, ticks

    def share(self, value):
        return (value - self.low) / (self.high - self.low)

    def ticks(self):
        for value in self.at:
            yield value, f"{value:g}"


SECONDS = {-9: "1 ns", -8: "10 ns", -7: "100 ns", -6: "1 µs", -5: "10 µs", -4: "100 µs", -3: "1 ms", -2: "10 ms", -1: "100 ms", 0: "1 s",
           1: "10 s", 2: "100 s", 3: "1,000 s"}


class Panel:
    """Axes with their names, and lines with a label at their right end."""

    def __init__(self, picture, left, top, width, height, x, y, title, x_name, y_name):
        self.picture, self.left, self.top, self.width, self.height, self.x, self.y = picture, left, top, width, height, x, y
        self.labels = []
        picture.text(left, top - 12, title, weight="bold", size=13)
        for value, name in y.ticks():
            at = self.at(None, value)[1]
            picture.line(left, at, left + width, at, "rule")
            picture.text(left - 6, at + 4, name, "soft", "end", 11)
        for value, name in x.ticks():
            at = self.at(value, None)[0]
            picture.line(at, top, at, top + height, "rule")
            picture.text(at, top + height + 16, name, "soft", "middle", 11)
        picture.text(left + width / 2, top + height + 34, x_name, "soft", "middle")
        if y_name:
            picture.text(left - 54, top + height / 2, y_name, "soft", "middle", turn=-90)

    def at(self, x, y):
        return (None if x is None else self.left + self.width * self.x.share(x),
                None if y is None else self.top + self.height * (1 - self.y.share(y)))

    def series(self, points, label, colour, mark="dot", dash="", width=2, over=None, note=""):
        """`over`: a point where the line ends because it exceeded a limit; drawn as a step to an open mark."""
        placed = [self.at(x, y) for x, y in points]
        if placed:
            self.picture.path(placed, colour, width, dash)
        end = placed[-1] if placed else None
        if over:
            target = self.at(*over)
            if placed:
                self.picture.line(*placed[-1], *target, colour, 1.2, "2 3")
            self.picture.mark(*target, "ring", colour)
            end = target
        for place in placed:
            self.picture.mark(*place, mark, colour)
        if label and end:
            self.labels.append([end[1], end, label + note, colour, mark])

    def write_labels(self, gap=14, leader=16):
        """Beside the ends of the lines, each with the mark of its line; pushed apart where they would cover each other."""
        labels = sorted(self.labels, key=lambda label: label[0])
        for _ in range(200):
            for one, two in zip(labels, labels[1:]):
                if (close := gap - (two[0] - one[0])) > 0:
                    one[0], two[0] = one[0] - close / 2, two[0] + close / 2
            if labels and (low := labels[-1][0] - (self.top + self.height + 4)) > 0:
                labels[-1][0] -= low
            if labels and (high := self.top - labels[0][0]) > 0:
                labels[0][0] += high
        right = self.left + self.width + leader
        for y, end, label, colour, mark in labels:
            self.picture.line(end[0] + 5, end[1], right - 1, y, colour, 0.8, extra=' stroke-opacity="0.6"')
            self.picture.mark(right + 3, y, mark, colour)
            self.picture.text(right + 12, y + 4, label, "foresee" if colour == "foresee" else "ink", weight="bold" if colour == "foresee" else "")
