"""How far is it? Tiles, rows and the time left: a bar on a terminal, a line for every tenth elsewhere."""
import sys
import time

WIDTH = 30


class Progress:
    def __init__(self, tiles, out=sys.stderr):
        self.tiles, self.out = tiles, out
        self.finished = self.before = self.rows = self.tenths = 0
        self.started = time.monotonic()

    def more(self, tiles):
        self.tiles += tiles

    def done(self, rows, before=False):
        self.finished += 1
        self.before += before
        self.rows += rows
        self.show()

    def show(self):
        if not self.out.isatty():
            if self.finished * 10 // self.tiles <= self.tenths:
                return
            self.tenths = self.finished * 10 // self.tiles
            print(self.line(), file=self.out, flush=True)
            return
        full = WIDTH * self.finished // self.tiles
        print(f"\r[{'#' * full}{'.' * (WIDTH - full)}] {self.line()} ", end="", file=self.out, flush=True)

    def line(self):
        here = self.finished - self.before
        left = (time.monotonic() - self.started) / here * (self.tiles - self.finished) if here else 0
        return f"{self.finished}/{self.tiles} tiles, {self.rows} rows, {int(left) // 60}:{int(left) % 60:02} left"

    def end(self):
        if self.out.isatty():
            print(file=self.out)
