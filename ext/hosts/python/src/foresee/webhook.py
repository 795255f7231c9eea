"""Changes for a web server: one POST each over one connection, in order, at least once.

    hook = Webhook("https://example.org/alerts?key=…", say=print, stop=lambda: False)
    hook.deliver({"watch": "alerts", "seq": 7, "op": "+", "a": 1, "b": 2})      # returns once the server has answered 2xx

The connection is kept open (HTTP/1.1) and opened again after a failure or when the server has closed it. What fails is repeated until it
succeeds, with growing pauses or the one that Retry-After requests: later changes wait. A change may arrive twice; the header
Idempotency-Key is then the same.
"""
import base64
import http.client
import json
import random
import select
import ssl
import time
import urllib.request
from urllib.parse import unquote, urlsplit

from .process import Refusal

TIMEOUT = 10.0
SHORTEST_PAUSE, LONGEST_PAUSE = 0.25, 60.0
LONGEST_RETRY_AFTER = 300.0


class Webhook:
    def __init__(self, url, say, stop):
        try:
            parts = urlsplit(url)
            is_address = parts.scheme in ("http", "https") and bool(parts.hostname) and parts.port != 0
        except ValueError:          # an invalid port or IPv6 address
            is_address = False
        if not is_address:
            raise Refusal("--webhook is no web address; write http://host/path or https://host/path")
        # Tokens are often in path or query: messages name the host alone.
        self.host, self.say, self.stop = parts.hostname, say, stop
        self.line = Line(parts)
        self.retries = 0

    def deliver(self, change, created=None):
        """Whether it arrived; not where stop() became true before. `created`: the number of the watch (predictive_watches)."""
        body = json.dumps(change).encode()
        watch = change["watch"] if created is None else f"{change['watch']}-{created & 0xFFFFFFFFFFFFFFFF:x}"
        key = f"{watch}-{change['seq']}-{change['a']}-{change['b']}"
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
        try:
            status, reason, headers = self.line.post(body, {"Content-Type": "application/json", "User-Agent": "foresee",
                                                            "Idempotency-Key": key})
        except ssl.SSLError as error:
            return str(error), None
        except (OSError, http.client.HTTPException) as error:
            return str(error) or type(error).__name__, None
        return (None, None) if 200 <= status < 300 else (f"answers {status} {reason}", retry_after(headers))


class Line:
    """The connection to a server, or to the proxy that the environment names for it (http_proxy, https_proxy, no_proxy)."""

    def __init__(self, parts):
        self.path = (parts.path or "/") + (f"?{parts.query}" if parts.query else "")
        self.headers = basic("Authorization", parts)
        server = (parts.hostname, parts.port)
        proxy = None if urllib.request.proxy_bypass(parts.hostname) else urllib.request.getproxies().get(parts.scheme)
        kind = http.client.HTTPSConnection if parts.scheme == "https" else http.client.HTTPConnection
        if not proxy:
            self.connection = kind(*server, timeout=TIMEOUT)
            return
        proxy = urlsplit(proxy if "//" in proxy else f"//{proxy}")
        self.connection = kind(proxy.hostname, proxy.port or 8080, timeout=TIMEOUT)
        if parts.scheme == "https":
            self.connection.set_tunnel(*server, basic("Proxy-Authorization", proxy))
        else:
            self.headers.update({"Host": parts.netloc.rpartition("@")[2], **basic("Proxy-Authorization", proxy)})
            self.path = f"http://{self.headers['Host']}{self.path}"

    def post(self, body, headers):
        """(status, reason, headers) of the answer; an exception closes the connection, and the next call opens another one."""
        is_old = self.is_open()
        try:
            return self.once(body, headers)
        except (ConnectionError, http.client.BadStatusLine):
            if not is_old:
                raise
        # The server may have closed the old connection while the request was on its way.
        return self.once(body, headers)

    def once(self, body, headers):
        try:
            self.connection.request("POST", self.path, body, {**self.headers, **headers})
            answer = self.connection.getresponse()
            answer.read()
            return answer.status, answer.reason, answer.headers
        except BaseException:
            self.connection.close()
            raise

    def is_open(self):
        """A server that has closed the connection makes it readable: it is closed here too."""
        if self.connection.sock and select.select([self.connection.sock], [], [], 0)[0]:
            self.connection.close()
        return self.connection.sock is not None


def basic(header, parts):
    """The header that a user and password of an address require."""
    if parts.username is None:
        return {}
    pair = f"{unquote(parts.username)}:{unquote(parts.password or '')}"
    return {header: "Basic " + base64.b64encode(pair.encode()).decode()}


def retry_after(headers):
    """The seconds that a server requests; a date counts as none."""
    try:
        return min(max(float(headers.get("Retry-After", "")), 0.0), LONGEST_RETRY_AFTER)
    except ValueError:
        return None
