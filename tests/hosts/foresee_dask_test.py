"""foresee_dask on a local cluster: whatever dies on the way, the files are those of a quiet run, and those the single join's rows."""
import json
import os
import signal
import subprocess
import sys
import time
from contextlib import closing
from pathlib import Path
from unittest import mock

from fleet import SHIPS, Fleet, children, environment, kill, main, ships, skip

from foresee_dask.question import Question


def listening(pids):
    """The addresses on which these processes listen, as /proc/net writes them."""
    sockets = set()
    for pid in pids:
        for file in Path(f"/proc/{pid}/fd").iterdir():
            try:
                sockets.add(os.readlink(file))
            except FileNotFoundError:
                pass
    rows = [line.split() for family in ("tcp", "tcp6") for line in Path(f"/proc/net/{family}").read_text().splitlines()[1:]]
    return [row[1].rsplit(":", 1)[0] for row in rows if row[3] == "0A" and f"socket:[{row[9]}]" in sockets]


class Dask(Fleet):
    def setUp(self):
        super().setUp()
        try:
            import distributed  # noqa: F401
        except ImportError:
            skip("joins on Dask", f"{sys.executable} has no distributed (python3-distributed)")

    def fleet(self, count=600, tiles=24):
        self.rows = ships(count)
        self.expected = self.single(Question("ships", 60.0, now=60.0), ships=(SHIPS, self.rows))
        self.asked = ("join", *self.asking("--tiles", tiles), *self.shards(self.rows))

    def done(self, *more):
        done = self.command(*self.asked, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def begun(self, workers, files):
        """A run that has written so many files."""
        run = subprocess.Popen([sys.executable, "-m", "foresee_dask", *map(str, self.asked), "--workers", str(workers)], env=environment(),
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.wait(run, files)
        return run

    def wait(self, run, files):
        until = time.monotonic() + 60
        while len(list(self.out.glob("pairs-*.db"))) < files and run.poll() is None:
            self.assertLess(time.monotonic(), until)
            time.sleep(0.002)

    def check_whole(self):
        self.assertEqual(self.of_tiles(), self.expected)
        manifest = json.loads((self.out / "manifest.json").read_text())
        self.assertEqual(manifest["rows"], len(self.expected))
        self.assertEqual([file.name for file in self.out.iterdir() if file.name[0] == "."], [])

    def test_equals_the_single_join_and_once_is_enough(self):
        self.fleet()
        said = self.done("--workers", 2)
        self.check_whole()
        self.assertIn(f"{len(self.expected)} rows in 24 tiles", said.stdout)
        self.assertRegex(said.stderr, r"24/24 tiles, \d+ rows, 0:00 left\n$")
        first = self.bytes_of(self.out)
        times = {file: file.stat().st_mtime_ns for file in self.out.iterdir()}
        again = self.done("--workers", 2)
        self.assertEqual((again.stdout, again.stderr), (said.stdout, ""))
        self.assertEqual({file: file.stat().st_mtime_ns for file in self.out.iterdir()}, times)
        self.out.rename(self.folder / "first")
        self.done("--workers", 1)
        self.assertEqual(self.bytes_of(self.out), first)
        self.assertEqual((self.out / "manifest.json").read_text(), (self.folder / "first/manifest.json").read_text())

    def test_workers_are_killed(self):
        self.fleet(1200, 60)
        run = self.begun(2, 3)
        self.assertEqual(kill(children(run)), 2)
        self.wait(run, 20)
        while run.poll() is None and not kill(children(run)[:1]):       # who was killed may not be back yet
            time.sleep(0.002)
        out, errors = run.communicate(timeout=120)
        self.assertEqual(run.returncode, 0, errors)
        self.assertNotIn("Traceback", errors)
        self.check_whole()

    def test_a_run_that_is_cut_off_goes_on(self):
        self.fleet(1200, 60)
        run = self.begun(2, 10)
        workers = children(run)
        run.kill()
        kill(workers)
        run.communicate()
        before = {file: file.stat().st_mtime_ns for file in self.out.glob("pairs-*.db")}
        self.assertLess(len(before), 60)
        self.assertFalse((self.out / "manifest.json").exists())
        self.assertIn("is not whole", self.refused("merge", self.out, self.folder / "all.db"))
        self.done("--workers", 2)
        self.check_whole()
        self.assertEqual({file: file.stat().st_mtime_ns for file in before}, before)

    def test_it_listens_to_nobody_outside_and_an_interrupt_says_how_to_go_on(self):
        self.fleet(1200, 60)
        run = self.begun(2, 5)
        workers = children(run)
        for pid in workers:     # or all may be done before the interrupt
            os.kill(pid, signal.SIGSTOP)
        addresses = listening([run.pid, *workers])
        run.send_signal(signal.SIGINT)
        for pid in workers:
            os.kill(pid, signal.SIGCONT)
        _, errors = run.communicate(timeout=60)
        self.assertGreater(len(addresses), 2)
        self.assertEqual(set(addresses), {"0100007F"})      # 127.0.0.1
        self.assertEqual(run.returncode, 1, errors)
        self.assertEqual(errors.splitlines()[-1], "foresee_dask: cut off; the same command goes on")
        self.assertNotIn("Traceback", errors)

    def test_an_interrupt_in_a_callback_that_drops_exceptions_is_kept(self):
        program = """
import gc, os, signal, time
from foresee_dask import in_one_line

def interrupt(phase, info):
    gc.callbacks.clear()
    os.kill(os.getpid(), signal.SIGINT)

def work():
    gc.callbacks.append(interrupt)
    gc.collect()
    print("went on", flush=True)
    time.sleep(30)
    print("never")

in_one_line(work)
"""
        run = subprocess.run([sys.executable, "-c", program], env=environment(), capture_output=True, text=True, timeout=60)
        self.assertEqual((run.returncode, run.stdout), (1, "went on\n"), run.stderr)
        self.assertEqual(run.stderr, "foresee_dask: cut off; the same command goes on\n")

    def test_a_tile_that_fails_three_times(self):
        self.fleet(600, 8)
        self.assertEqual(self.command("plan", *self.asked[1:]).returncode, 0)
        with closing(self.open(self.asked[-1])) as db:
            db.execute("UPDATE ships_node SET data = zeroblob(length(data)) WHERE nodeno = (SELECT max(nodeno) FROM ships_node)")
        said = self.refused(*self.asked, "--workers", 1)
        self.assertRegex(said, r"foresee_dask: tile \d+ failed three times: .*ships")

    def test_a_scheduler_of_ones_own(self):
        self.fleet(300, 8)
        program = ("import sys\nfrom distributed import LocalCluster\nif __name__ == '__main__':\n"
                   " with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None, host='127.0.0.1') as c:\n"
                   "  print(c.scheduler_address, flush=True)\n  sys.stdin.read()")
        (self.folder / "cluster.py").write_text(program)
        cluster = subprocess.Popen([sys.executable, self.folder / "cluster.py"], env=environment(), cwd=self.folder, text=True,
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        address = cluster.stdout.readline().strip()
        self.done("--scheduler", address)
        self.check_whole()
        cluster.communicate("", timeout=60)
        self.out.rename(self.folder / "first")
        with mock.patch.dict(os.environ, DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT="1s"):
            self.assertIn("no scheduler at tcp://127.0.0.1:1", self.refused(*self.asked, "--scheduler", "tcp://127.0.0.1:1"))


if __name__ == "__main__":
    main()
