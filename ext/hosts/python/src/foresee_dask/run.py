"""The tiles on Dask: who does which, what if a worker dies, how far is it? The only module that knows Dask.

A tile is a task that says how it went; its file says that it is done. Dask may run a task twice, or again after its worker died: files appear
whole or not at all, and what is there is left alone. A tile that fails three times ends the run; the same command goes on with the rest.
"""
import json
import logging
import os
import shutil
import sys
import tempfile
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, replace

from . import Refusal, plan as plans, shards, tile_join
from .files import sweep_up, write_text
from .merge import missing
from .progress import Progress

ATTEMPTS = 3
MANY_COPIES = 2.0
HOME = "127.0.0.1"      # left out, Dask's HTTP servers listen to the whole network
LOGGING = "DASK_LOGGING__DISTRIBUTED"
DEATHS = 5      # of workers under one task, before Dask gives it back as failed: one bad worker must not fail innocent tiles


class Engine:
    """Dask, begun when it is first needed: processes of one thread on this machine, or the cluster of a scheduler."""

    def __init__(self, workers, scheduler):
        self.workers, self.scheduler, self.open, self._client = workers, scheduler, ExitStack(), None

    @property
    def client(self):
        if self._client is None:
            self._client = self._connected()
        return self._client

    def _connected(self):
        try:
            import dask
            from distributed import Client, LocalCluster
        except ImportError:
            raise Refusal("Dask is not installed: apt-get install python3-distributed, or run the tiles by tile_join") from None
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        if self.scheduler:
            try:
                return self.open.enter_context(Client(self.scheduler))
            except (OSError, TimeoutError, ValueError) as error:
                raise Refusal(f"no scheduler at {self.scheduler}: {error}") from None
        if LOGGING not in os.environ:       # of workers, also of those that begin later
            os.environ[LOGGING] = "critical"
            self.open.callback(os.environ.pop, LOGGING, None)
        dask.config.set({"distributed.scheduler.allowed-failures": DEATHS, "distributed.worker.daemon": True})
        space = tempfile.mkdtemp(prefix="foresee-dask-")
        self.open.callback(shutil.rmtree, space, ignore_errors=True)
        cluster = self.open.enter_context(LocalCluster(
            n_workers=self.workers, threads_per_worker=1, host=HOME, dashboard_address=f"{HOME}:0", worker_dashboard_address=f"{HOME}:0",
            memory_limit=0, local_directory=space, silence_logs=logging.CRITICAL, preload=["foresee_dask.quiet"]))
        return self.open.enter_context(Client(cluster))

    def gather(self, function, arguments):
        """function(*arguments) for each; a single one is called here."""
        if len(arguments) < 2:
            return [function(*one) for one in arguments]
        with _of_workers("looking at the shards"):
            return self.client.gather(self.client.map(lambda one: function(*one), arguments, pure=False))

    def check(self, plan):
        with _of_workers("asking for the extension"):
            found = self.client.run(_wrong_with, plan)
        for worker, wrong in found.items():
            if wrong:
                raise Refusal(f"worker {worker}: {wrong}")


@contextmanager
def _of_workers(what):
    """What a worker raises, a module that it lacks or its death, in words."""
    try:
        yield
    except Refusal:
        raise
    except Exception as error:
        raise Refusal(f"{what}, a worker failed: {type(error).__name__}: {error}".splitlines()[0]) from None


def _wrong_with(plan):
    try:
        tile_join.check_commit(plan, shards.connect(plan.extension))
    except Refusal as refusal:
        return str(refusal)


def attempt(plan, tile):
    """A task never raises: what went wrong comes back in words."""
    try:
        return tile_join.join_tile(plan, tile)
    except Refusal as refusal:
        return {"refused": str(refusal)}
    except Exception as error:
        return {"failed": f"{type(error).__name__}: {error}"}


def join(folder, asked, paths, extension, tiles=None, workers=None, scheduler=None, **sample):
    """The manifest of the whole answer in `folder`."""
    workers = workers or os.cpu_count()
    engine = Engine(workers, scheduler)
    with engine.open:
        plan = plans.make(folder, asked, paths, extension, tiles, engine.gather, workers, **sample)
        plan.threads = (os.cpu_count() // len(plan.tiles) - 1) if len(plan.tiles) < os.cpu_count() else 0
        if missing(plan):
            warn(plan)
            engine.check(brief(plan))
            _run(engine.client, plan)
            sweep_up(plan.folder)
    return _manifest(plan)


def warn(plan):
    if plan.copies > MANY_COPIES:
        print(f"an object is in {plan.copies:.1f} tiles on average: their boxes are as large as tiles; fewer tiles or a shorter horizon cost"
              " less", file=sys.stderr)


def brief(plan):
    """What a worker needs of it."""
    return replace(plan, tiles=[])


def _run(client, plan):
    from distributed import as_completed
    progress = Progress(len(list(plan.leaves())))
    for_workers = brief(plan)
    running, failures, asked = as_completed(), {}, {}

    def ask(tile):
        future = client.submit(attempt, for_workers, tile, pure=False, priority=tile.weight, key=f"{tile.name}-{os.urandom(6).hex()}")
        asked[future.key] = tile
        running.add(future)

    for tile in plan.leaves():
        if plan.pairs(tile).exists():
            progress.done(tile_join.done(plan, tile)["rows"], before=True)
        else:
            ask(tile)
    for future in running:
        tile = asked.pop(future.key)
        result = future.result() if future.status == "finished" else {"failed": _why(future)}
        if "refused" in result:
            raise Refusal(result["refused"])
        if "failed" in result:
            failures[tile.name] = failures.get(tile.name, 0) + 1
            if failures[tile.name] == ATTEMPTS:
                raise Refusal(f"tile {tile.name} failed three times: {result['failed']}")
            ask(tile)
        elif "cut" in result:
            progress.more(len(result["cut"]) - 1)
            for part in result["cut"]:
                ask(part)
        else:
            progress.done(result["rows"])
    progress.end()


def _why(future):
    if future.status != "error":
        return "the scheduler is gone"
    error = future.exception()
    return f"{type(error).__name__}: {error}".splitlines()[0]


def _manifest(plan):
    """Written last, the same whoever did what."""
    found = [{**tile._asdict(), **tile_join.done(plan, tile)} for tile in plan.leaves()]
    manifest = {"question": asdict(plan.question), "commit": plan.commit, "fingerprint": plan.fingerprint(),
                "shards": [shard["path"] for shard in plan.shards], "rows": sum(tile["rows"] for tile in found), "tiles": found}
    text = json.dumps(manifest, indent=1) + "\n"
    path = plan.path("manifest.json")
    if not path.exists() or path.read_text() != text:
        write_text(path, text)
    return manifest
