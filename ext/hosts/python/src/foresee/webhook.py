"""Changes for a web server: one POST each, in order, at least once.

    hook = Webhook("https://example.org/alerts?key=…", say=print, stop=lambda: False)
    hook.deliver({"watch": "alerts", "seq": 7, "op": "+", "a": 1, "b": 2})      # returns once the server has answered 2xx

What fails is repeated until it succeeds, with growing pauses or the one that Retry-After requests: later changes wait. A change may
arrive twice; the header Idempotency-Key is then the same.
"""
import http.client
import json
import random
import ssl
import time
import urllib.error
import urllib.request
from urllib.parse import urlsplit

from .process import Refusal

TIMEOUT = 10.0
SHORTEST_PAUSE, LONGEST_PAUSE = 0.25, 60.0
LONGEST_RETRY_AFTER = 300.0


class NoRedirect(urllib.request.HTTPRedirectHandler):
    """urllib would repeat a redirected POST as a GET."""

    def redirect_request(self, *arguments):
        return None


class Webhook:
    def __init__(self, url, say, stop):
        parts = urlsplit(url)
        if parts.scheme not in ("http", "https") or not parts.hostname:
            raise Refusal("--webhook is no web address; write http://host/path or https://host/path")
        # Tokens are often in path or query: messages name the host alone.
        self.url, self.host, self.say, self.stop = url, parts.hostname, say, stop
        self.opener = urllib.request.build_opener(NoRedirect)
        self.retries = 0

    def deliver(self, change):
        """Whether it arrived; not where stop() became true before."""
        body = json.dumps(change).encode()
        key = f"{change['watch']}-{change['seq']}-{change['a']}-{change['b']}"
        pause = SHORTEST_PAUSE
        while True:
            problem, wait = self.post(body, key)
            if problem is None:
                return True
            wait = pause * random.uniform(0.75, 1.25) if wait is None else wait
            self.retries += 1
            self.say(f"{self.host}: {problem}; change {change['seq']} again in {wait:.1f} s")
            give_up = time.monotonic() + wait
            while time.monotonic() < give_up:
                if self.stop():
                    return False
                time.sleep(min(0.05, wait))
            pause = min(2 * pause, LONGEST_PAUSE)

    def post(self, body, key):
        """(None, None) where it succeeded, else (problem, the pause that the server requests)."""
        request = urllib.request.Request(self.url, data=body, method="POST", headers={
            "Content-Type": "application/json", "User-Agent": "foresee", "Idempotency-Key": key})
        try:
            with self.opener.open(request, timeout=TIMEOUT) as answer:
                answer.read()
                return None, None
        except urllib.error.HTTPError as error:
            with error:
                return f"answers {error.code} {error.reason}", retry_after(error.headers)
        except urllib.error.URLError as error:
            return str(error.reason), None
        except (OSError, http.client.HTTPException, ssl.SSLError) as error:
            return f"{type(error).__name__}: {error}", None


def retry_after(headers):
    """The seconds that a server requests; a date counts as none."""
    try:
        return min(max(float(headers.get("Retry-After", "")), 0.0), LONGEST_RETRY_AFTER)
    except ValueError:
        return None
