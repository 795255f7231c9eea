"""What is to be done, and what is done? The folder of an answer:

    plan.json         question, commit, shards with their stamps, tiles: written first, by whoever begins
    pairs-00017.db    the rows of one tile: a file that is there is a tile done
    cut-00017.json    the tiles into which one was cut that held over twice its share
    manifest.json     tiles, rows, question, commit: written last

A plan that is there is gone on with, if question, commit and shards are the same; otherwise it is refused, and says what differs.
"""
import dataclasses
import json
import os
import sqlite3
from contextlib import closing
from pathlib import Path
from math import ceil, inf

from . import Refusal, shards, tiles
from .files import write_text
from .load import as_shards
from .question import Question, differences, fingerprint, quoted

OBJECTS = 400_000     # a tile: most of what it costs is then its objects, and few lie on its edges


@dataclasses.dataclass
class Plan:
    folder: str
    extension: str
    asked: Question
    question: Question      # asked, with now
    commit: str
    shards: list
    declared: dict
    tiles: list
    share: float            # of objects that a tile has on average
    copies: float           # tiles in which an object is on average
    threads: int = 0

    def path(self, name):
        return Path(self.folder) / name

    def fingerprint(self):
        return fingerprint(dataclasses.asdict(self.question), self.commit,
                           [[of["stamp"] for of in shard["tables"].values()] for shard in self.shards])

    def axes(self):
        return sum(axis in self.declared[self.question.table] for axis in "xyz")

    def columns(self, table):
        """Those that are shipped: motion, and what the answer shows of the others."""
        return self.declared[table] + [quoted(name) for name in self.question.carried(table)]

    def leaves(self, of=None):
        """The tiles that have a file in the end: those that were cut give way to their parts."""
        for tile in self.tiles if of is None else of:
            parts = self.parts(tile)
            yield from [tile] if parts is None else self.leaves(parts)

    def parts(self, tile):
        marker = self.path(f"cut-{tile.name}.json")
        return [tiles.Tile(*part) for part in json.loads(marker.read_text())] if marker.exists() else None

    def pairs(self, tile):
        return self.path(f"pairs-{tile.name}.db")

    def write(self):
        write_text(self.path("plan.json"), json.dumps({**dataclasses.asdict(self), "folder": None}, indent=1))


def read(folder):
    try:
        fields = json.loads((Path(folder) / "plan.json").read_text())
    except FileNotFoundError:
        return None
    except (ValueError, OSError) as error:
        raise Refusal(f"{folder}/plan.json cannot be read: {error}") from None
    return Plan(**{**fields, "folder": str(folder), "asked": Question.of(fields["asked"]), "question": Question.of(fields["question"]),
                   "tiles": [tiles.Tile(*tile) for tile in fields["tiles"]]})


def make(folder, asked, paths, extension, wanted, gather, workers=1, sample=tiles.SAMPLE):
    """The plan of `folder`: the one that is there, or a new one. `gather(function, arguments)` calls a function on many, anywhere."""
    asked.check()
    folder, extension = Path(folder).resolve(), os.path.abspath(extension)
    commit = shards.commit(shards.connect(extension))
    shards.refuse_twice(paths)
    folder.mkdir(parents=True, exist_ok=True)
    paths = as_shards(extension, paths, asked.tables(), folder)
    looked = [shards.look(extension, path, asked.tables()) for path in paths]
    declared = {table: shards.declaration(looked, table, asked.carried(table)) for table in asked.tables()}
    shards.refuse_other_frames(looked)
    for shard in looked:
        if not shard["tables"]:
            raise Refusal(f"{shard['path']} has no moving_objects table {' or '.join(asked.tables())}")

    there = read(folder)
    if there is not None:
        _refuse_other(there, asked, commit, looked)
        there.extension = extension
        return there
    if any(folder.glob("pairs-*.db")):
        raise Refusal(f"{folder} holds pairs and no plan.json: give --out another folder")

    surveyed = gather(shards.survey, [(extension, shard, asked.now is None) for shard in looked])
    for table in asked.tables():
        shards.refuse_shared_ids(extension, surveyed, table)
    newest = [of["newest"] for shard in surveyed for of in shard["tables"].values() if of["newest"] is not None]
    question = asked if asked.now is not None else asked.at(max(newest, default=0.0))
    _try(extension, question, declared)

    objects = sum(int(of["objects"]) for shard in surveyed for of in shard["tables"].values())
    wanted = wanted or max(8 * workers, ceil(objects / OBJECTS))
    fraction = min(1.0, max(sample, 40 * wanted if sample == tiles.SAMPLE else 0) / max(objects, 1))
    boxes = [box for part in gather(sampled, [(extension, shard, question, fraction) for shard in looked]) for box in part]
    plan = Plan(str(folder), extension, asked, question, commit, looked, declared, [], 0, 1)
    _cut(plan, boxes, wanted, len(boxes) / fraction)
    plan.write()
    return plan


def _cut(plan, boxes, wanted, objects):
    """Numbers tiles by weight: the dearest is asked first."""
    costs = tiles.PAIR_SHIPPED if len(plan.shards) > 1 else tiles.PAIR_IN_PLACE
    found = tiles.cut(boxes, wanted, objects, costs, len(plan.question.tables()) > 1)
    plan.tiles = [tile._replace(name=f"{number:05}") for number, tile in enumerate(found)]
    plan.share = sum(tile.objects for tile in found) / len(found)
    plan.copies = sum(tile.objects for tile in found) / max(objects, 1)


def sampled(extension, shard, question, fraction):
    """The boxes (x0, x1, y0, y1, side) of that fraction of a shard's objects, chosen by their ids."""
    boxes = []
    with closing(shards.connect(extension)) as db, shards.reading(db, shard["path"]):
        for table in shard["tables"]:
            sweep, inputs = question.sweep(table, "shard")
            side = question.tables().index(table)
            boxes += [(x0, x1, -inf if y0 is None else y0, inf if y1 is None else y1, side) for x0, x1, y0, y1 in db.execute(
                f"SELECT x0, x1, y0, y1 FROM {sweep} WHERE (id + (id >> 31) & 0x7fffffff) * 2654435761 & 0xffffffff < ?",
                (*inputs, int(fraction * 2**32)))]
    return boxes


def _try(extension, question, declared):
    """Asks the question of empty tables: what is wrong with it is wrong for all."""
    db = shards.connect(extension)
    try:
        for table, motion in declared.items():
            columns = motion + ["+" + quoted(name) for name in question.carried(table)]
            db.execute(f"CREATE VIRTUAL TABLE {quoted(table)} USING moving_objects({', '.join(columns)})")
        db.execute(*question.rows("main", (None,) * 4)).fetchall()
    except sqlite3.Error as error:
        raise Refusal(str(error)) from None


def _refuse_other(there, asked, commit, looked):
    def refuse(what):
        raise Refusal(f"{there.folder} holds another answer: {what}; give --out another folder")

    if there.asked != asked:
        refuse(differences(asked, there.asked))
    if there.commit != commit:
        refuse(f"the extension is {there.commit} there and {commit} here")
    before = {shard["path"]: shard["tables"] for shard in there.shards}
    now = {shard["path"]: shard["tables"] for shard in looked}
    for path in sorted(before.keys() ^ now.keys()):
        refuse(f"shard {path} is {'there and not here' if path in before else 'here and not there'}")
    for path in sorted(now):
        if any(before[path][table]["stamp"] != of["stamp"] for table, of in now[path].items()):
            refuse(f"shard {path} has changed since")
