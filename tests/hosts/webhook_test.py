"""python3 -m foresee alerts --webhook with a web server that fails now and then; killed at random it misses nothing and keeps the order.

FORESEE_LONG=1 kills it fifty times in place of a handful.
"""
import http.server
import json
import random
import threading
import time

from hosts import main
from live import LONG, Command, WatchedShips, free_port, waited

KILLS = 50 if LONG else 3


class Server:
    """A web server on loopback that fails by chance: errors, closed connections, a request for patience.

    With `posts` it closes each connection after so many, without a word before.
    """

    def __init__(self, test, chance=None, port=0, posts=None):
        self.received, self.failures, self.keys, self.connections, self.lines = [], 0, [], 0, []
        owner = self

        class Handler(http.server.BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def setup(self):
                super().setup()
                owner.connections += 1
                self.posts = 0

            def do_POST(self):
                self.posts += 1
                body = self.rfile.read(int(self.headers["Content-Length"]))
                fate = chance.random() if chance else 1.0
                if fate < 0.15:
                    owner.failures += 1
                    self.close_connection = True
                    return                          # no answer at all
                if fate < 0.3:
                    owner.failures += 1
                    self.send_response(chance.choice((500, 503, 404, 302)))
                    self.send_header("Retry-After", "0.05")
                    self.send_header("Content-Length", "0")
                    self.end_headers()
                    return
                owner.received.append(json.loads(body))
                owner.keys.append(self.headers["Idempotency-Key"])
                owner.lines.append((self.path, self.headers["Host"], self.headers["Authorization"]))
                if fate < 0.35:
                    self.close_connection = True
                    return                          # it arrived, and the answer did not
                self.send_response(204)
                self.end_headers()
                self.close_connection = self.posts == posts

            def log_message(self, *arguments):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", port), Handler)
        self.server.handle_error = lambda *arguments: None      # a reader that is killed in the middle of a post
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        test.addCleanup(self.stop)
        self.url = f"http://127.0.0.1:{self.server.server_port}/hook?key=secret"

    def stop(self):
        if self.server:
            self.server.shutdown()
            self.server.server_close()
            self.server = None


class Webhooks(WatchedShips):
    def test_it_is_a_reader_of_its_own(self):
        self.assertEqual(len(self.alerts()), 1)
        server = Server(self)
        self.alerts("--webhook", server.url)
        self.assertEqual(len(server.received), 1)

    def test_a_server_that_fails_now_and_then_gets_every_change_in_order(self):
        self.alerts("--reader", "webhook")
        start = self.published(0)[0]
        server = Server(self, random.Random(43))
        thread = self.write_changes(40, 0.002)
        reader = Command(self, "alerts", self.file, "alerts", "--webhook", server.url)
        thread.join()
        wanted = self.published(start)
        waited(lambda: server.received and server.received[-1]["seq"] == wanted[-1], 60, "the last change")
        self.assertEqual(reader.end(), 0)
        self.assertGreater(server.failures, 3)
        received = [change["seq"] for change in server.received]
        self.assertEqual((received, list(dict.fromkeys(received))), (sorted(received), wanted))
        self.assertRegex(server.keys[0], f"^alerts-[0-9a-f]+-{wanted[0]}-1-3$")
        self.assertFalse(any("secret" in line for line in reader.errors), reader.errors)
        self.assertTrue(reader.said("127.0.0.1: answers 50") or reader.said("127.0.0.1: Remote end closed"), reader.errors)

    def posts_of(self, server, count):
        """What the server got of so many changes, as one reader sends them; the lines on stderr."""
        self.alerts("--reader", "webhook")
        start = self.published(0)[0]
        self.write_changes(count, 0).join()
        wanted = self.published(start)
        errors = self.command("alerts", self.file, "alerts", "--once", "--webhook", server.url)[1]
        self.assertEqual([change["seq"] for change in server.received], wanted)
        return errors

    def test_one_connection_carries_all_posts(self):
        server = Server(self)
        self.assertEqual(self.posts_of(server, 60), "")
        self.assertEqual(server.connections, 1)

    def test_a_connection_that_the_server_closes_is_opened_again(self):
        server = Server(self, posts=7)
        self.assertEqual(self.posts_of(server, 60), "")
        self.assertEqual(server.connections, -(-len(server.received) // 7))

    def test_a_proxy_of_the_environment_gets_the_posts(self):
        self.environment = {**self.environment, "http_proxy": (proxy := Server(self)).url, "no_proxy": ""}
        self.command("alerts", self.file, "alerts", "--once", "--webhook", "http://user:pass%20word@hook.invalid/x?key=1")
        self.assertEqual(len(proxy.received), 1)
        self.assertEqual(proxy.lines, [("http://hook.invalid/x?key=1", "hook.invalid", "Basic dXNlcjpwYXNzIHdvcmQ=")])

    def test_killed_at_random_it_misses_no_post(self):
        self.alerts("--reader", "webhook")
        start, chance = self.published(0)[0], random.Random(47)
        port = free_port()                                           # no server at first
        reader = Command(self, "alerts", self.file, "alerts", "--webhook", f"http://127.0.0.1:{port}/")
        thread = self.write_changes(1000 if LONG else 200, 0.001)
        waited(lambda: reader.said("Connection refused"), what="the first attempt")
        server, runs, before = Server(self, port=port), [], 0
        for _ in range(KILLS):
            waited(lambda: len(server.received) > before or not thread.is_alive())
            time.sleep(chance.uniform(0.0, 0.1))
            reader.kill()
            time.sleep(0.05)
            runs.append([change["seq"] for change in server.received[before:]])
            before = len(server.received)
            reader = Command(self, "alerts", self.file, "alerts", "--webhook", f"http://127.0.0.1:{port}/")
        thread.join()
        wanted = self.published(start)
        waited(lambda: server.received and server.received[-1]["seq"] == wanted[-1], 120, "the last change")
        reader.kill()                                                # a reader that just began has no handler of SIGTERM yet
        runs.append([change["seq"] for change in server.received[before:]])
        seen = [seq for run in runs for seq in run]
        self.assert_nothing_missed(runs, wanted)
        self.assertLessEqual(len(seen) - len(set(seen)), KILLS)      # the one that was being delivered
        print(f"{KILLS} kills of alerts with a web server: {len(set(seen))} changes, none missed, {len(seen) - len(set(seen))} repeated")


if __name__ == "__main__":
    main()
