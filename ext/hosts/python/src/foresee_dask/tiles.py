"""Which rectangles? Half-open ones that cover the plane, about equally dear, cut where they copy least.

A sample of boxes is cut at the median of its low corners, on the axis that copies fewer boxes, the dearest part first. A part is as dear as
its objects and the pairs that it owns, told from the sample: data that is skewed has few objects and many pairs in some tiles. Ties,
infinite corners, and boxes as large as a part end the cutting there. The same sample gives the same tiles.
"""
import heapq
from math import inf, isfinite
from typing import NamedTuple, Optional

SAMPLE = 20_000
LOOKS = 1_000_000       # pairs of sampled boxes compared at most: about a second
COPIES_NOTHING = 1.8    # of a part's boxes in its two halves together: a cut beyond separates nothing
PAIR_SHIPPED = 0.1      # what a pair costs beside an object that is shipped; docs/how-to/tiles_on_dask.md
PAIR_IN_PLACE = 1.0     # and beside one that is read where it is


class Tile(NamedTuple):
    """None: no bound. `objects` are those expected."""
    name: str
    x0: Optional[float]
    x1: Optional[float]
    y0: Optional[float]
    y1: Optional[float]
    objects: float = 0.0
    weight: float = 0.0

    def bounds(self):
        return self[1:5]


def meets(tile, axes):
    """The condition on predictive_sweep by which an object is needed, and its inputs: generous where there is no bound."""
    sides = [("x0 <", tile.x1), ("x1 >=", tile.x0)] + [("y0 <", tile.y1), ("y1 >=", tile.y0)] * (axes > 1)
    given = [(f"b.{side} ?", bound) for side, bound in sides if bound is not None]
    return " AND ".join(side for side, _ in given) or "1", tuple(bound for _, bound in given)


class _Part:
    """A rectangle, the boxes (x0, x1, y0, y1, side) that meet it and the reference points of pairs that it owns."""

    def __init__(self, name, low, high, boxes, points):
        self.name, self.low, self.high, self.boxes, self.points = name, low, high, boxes, points

    def place(self, axis):
        """Where to cut: the median of the low corners inside, or the next one that leaves some on either side."""
        inside = sorted(low for low in (box[2 * axis] for box in self.boxes) if self.low[axis] < low < inf)
        middle = inside[len(inside) // 2] if inside else None
        if inside and middle == inside[0] and len(inside) == len(self.boxes):
            middle = next((low for low in inside if low > middle), None)
        return middle

    def halves(self):
        best = None
        for axis in (0, 1):
            at = self.place(axis)
            if at is None:
                continue
            left = [box for box in self.boxes if box[2 * axis] < at]
            right = [box for box in self.boxes if box[2 * axis + 1] >= at]
            copies = len(left) + len(right)
            if copies <= COPIES_NOTHING * len(self.boxes) and (best is None or copies < best[0]):
                best = copies, axis, at, left, right
        if best is None:
            return None
        _, axis, at, left, right = best
        end = tuple(at if i == axis else high for i, high in enumerate(self.high))
        begin = tuple(at if i == axis else low for i, low in enumerate(self.low))
        return (_Part(self.name + "a", self.low, end, left, [p for p in self.points if p[axis] < at]),
                _Part(self.name + "b", begin, self.high, right, [p for p in self.points if p[axis] >= at]))


def reference_points(boxes, two_tables):
    """The low corners of what pairs of the sample share; and which fraction of the sample was looked at, 1/stride."""
    stride = 1
    while True:
        some = sorted(boxes[::stride])
        points, looks = [], 0
        for i, a in enumerate(some):
            for j in range(i + 1, len(some)):
                b = some[j]
                looks += 1
                if b[0] > a[1]:
                    break
                if a[2] <= b[3] and b[2] <= a[3] and not (two_tables and a[4] == b[4]):
                    points.append((b[0], max(a[2], b[2])))
            if looks > LOOKS:
                break
        else:
            return points, stride
        stride *= 2


def cut(boxes, wanted, objects, pair_costs, two_tables=False, within=Tile("", None, None, None, None)):
    """At most `wanted` tiles of `within`, the dearest first, for so many objects in all of which `boxes` are a sample."""
    points, stride = reference_points(boxes, two_tables)
    scale = objects / max(len(boxes), 1)
    pair = pair_costs * (scale * stride) ** 2

    def weight(part):
        return scale * len(part.boxes) + pair * len(part.points)

    def bound(value, default):
        return default if value is None else value

    whole = _Part(within.name, (bound(within.x0, -inf), bound(within.y0, -inf)), (bound(within.x1, inf), bound(within.y1, inf)),
                  boxes, points)
    growing, done = [(-weight(whole), whole.name, whole)], []
    while growing and len(growing) + len(done) < wanted:
        _, _, part = heapq.heappop(growing)
        halves = part.halves()
        if halves is None:
            done.append(part)
        for half in halves or ():
            heapq.heappush(growing, (-weight(half), half.name, half))
    parts = done + [part for _, _, part in growing]
    parts.sort(key=lambda part: (-weight(part), part.name))

    def shown(value):
        return value if isfinite(value) else None

    return [Tile(part.name, shown(part.low[0]), shown(part.high[0]), shown(part.low[1]), shown(part.high[1]),
                 scale * len(part.boxes), weight(part)) for part in parts]
