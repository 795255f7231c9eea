"""Reports from an MQTT broker, none of which is lost: a message is acknowledged after the transaction that stores it.

    source = MqttSource("mqtt://127.0.0.1:1883/ais/#", client_id="harbour")
    source.run(commit, seconds=1.0, limit=1000, stop=lambda: False)       # commit(messages), each a Message

QoS 1 and a persistent session: the broker keeps what was not acknowledged, also while this program or the network is down, and sends
it again with the DUP flag (applied.py recognises it). Needs paho (python3-paho-mqtt), version 1.5 or later, also 2. A message holds JSON, one NMEA sentence or several lines of
either; a ship's number may be the topic's last whole number instead.
"""
import re
import select
import time
from typing import NamedTuple
from urllib.parse import unquote, urlsplit

from .process import Refusal

IN_FLIGHT = 20          # messages that mosquitto sends before it waits for an acknowledgement (max_inflight_messages)
PAUSE = 0.002           # seconds without a message: the broker waits for us
LONGEST_WAIT = 30.0     # seconds between attempts to connect


class Message(NamedTuple):
    mid: int                # the packet identifier, 0 with QoS 0
    qos: int
    dup: bool
    topic: str
    payload: bytes


def paho():
    try:
        import paho.mqtt.client as client
    except ImportError:
        raise Refusal("there is no paho.mqtt; install python3-paho-mqtt (Debian), or paho-mqtt with pip") from None
    return client


class Address:
    """mqtt://[user[:password]@]host[:port]/topic, mqtts for TLS."""

    def __init__(self, url):
        try:
            parts = urlsplit(url)
            is_address, port = parts.scheme in ("mqtt", "mqtts") and bool(parts.hostname), parts.port
        except ValueError:          # an invalid port or IPv6 address
            is_address = False
        if not is_address:
            raise Refusal(f"{url.split(':', 1)[0]}: no address of a broker; write mqtt://host:1883/topic/#")
        # A topic may hold # and +, which urlsplit takes for a fragment.
        self.topic = unquote(re.sub(r"^mqtts?://[^/]*/?", "", url)) or "#"
        self.tls = parts.scheme == "mqtts"
        self.host, self.port = parts.hostname, port or (8883 if self.tls else 1883)
        self.user, self.password = parts.username and unquote(parts.username), parts.password and unquote(parts.password)


class MqttSource:
    def __init__(self, url, client_id, say=lambda text: None, new_session=lambda: None):
        self.module, self.address, self.say, self.new_session = paho(), Address(url), say, new_session
        self.pending = []                   # messages that are not acknowledged
        self.client = self.make_client(client_id)

    def make_client(self, client_id):
        source, module = self, self.module

        class Acknowledging(module.Client):
            """Version 1 acknowledges when on_message returns; here acknowledge() does."""

            def _send_puback(self, mid):
                return module.MQTT_ERR_SUCCESS

            def acknowledge(self, mid):
                super()._send_puback(mid)

        versions = (module.CallbackAPIVersion.VERSION1,) if hasattr(module, "CallbackAPIVersion") else ()
        client = Acknowledging(*versions, client_id=client_id, clean_session=False)
        client.on_message = lambda client, data, message: source.pending.append(
            Message(message.mid, message.qos, message.dup, topic_of(message), message.payload))
        client.on_connect = lambda client, data, flags, status, *more: source.connected(flags, status)
        client.on_subscribe = lambda client, data, mid, granted, *more: source.subscribed(granted)
        if self.address.user:
            client.username_pw_set(self.address.user, self.address.password)
        if self.address.tls:
            client.tls_set()
        return client

    def connected(self, flags, status):
        if status != 0:
            self.say(f"the broker refuses the connection: {self.module.connack_string(status)}")
            return
        if not flags.get("session present"):
            self.new_session()          # packet identifiers start again
        self.client.subscribe(self.address.topic, qos=1)

    def subscribed(self, granted):
        if granted[0] >= 128:
            self.say(f"the broker refuses the topic {self.address.topic}")
        else:
            self.say(f"connected to {self.address.host}:{self.address.port}, topic {self.address.topic}")

    def run(self, commit, seconds, limit, stop, in_flight=IN_FLIGHT):
        """Calls commit(messages), and acknowledges them when it returns."""
        wait = 0.2
        while not stop():
            try:
                self.client.connect(self.address.host, self.address.port, keepalive=30)
                wait = 0.2 if self.receive(commit, seconds, limit, stop, in_flight) else wait
            except OSError as error:
                self.say(f"no connection to {self.address.host}:{self.address.port}: {error}; next attempt in {wait:.1f} s")
            # What was received is stored. Its acknowledgement did not go out, so that the broker sends it again.
            if self.pending:
                commit(self.pending)
                self.pending.clear()
            patience = time.monotonic() + wait
            while not stop() and time.monotonic() < patience:
                time.sleep(0.05)
            wait = min(2 * wait, LONGEST_WAIT)

    def receive(self, commit, seconds, limit, stop, in_flight):
        """Until the connection ends; whether any message came."""
        oldest, any_message = None, False
        while not stop():
            count = len(self.pending)
            patience = PAUSE if count >= in_flight else 0.2 if not count else min(0.2, max(0.0, oldest + seconds - time.monotonic()))
            ready = self.wait(patience)
            # loop() also keeps the connection alive; it reads one packet, as long as there are any.
            if self.client.loop(timeout=0 if ready else 0.001) != self.module.MQTT_ERR_SUCCESS:
                self.say("the connection ended")
                return any_message
            if self.pending and not count:
                oldest, any_message = time.monotonic(), True
            count = len(self.pending)
            if count and (count >= limit or time.monotonic() - oldest >= seconds or (count >= in_flight and not ready)):
                self.store(commit)
        if self.pending:
            self.store(commit)
        self.client.disconnect()
        return any_message

    def wait(self, patience):
        socket = self.client.socket()
        if socket is None:
            return True
        if getattr(socket, "pending", lambda: 0)():
            return True
        return bool(select.select([socket], [], [], patience)[0])

    def store(self, commit):
        messages, self.pending = self.pending, []
        try:
            commit(messages)
        except BaseException:
            self.pending = []
            raise
        for message in messages:
            if message.qos:
                self.client.acknowledge(message.mid)


def topic_of(message):
    try:
        return message.topic
    except UnicodeDecodeError:
        return "(a topic that is not UTF-8)"


def number_in(topic):
    """The last whole number of a topic: vessels/211000001/location."""
    return next((level for level in reversed(topic.split("/")) if level.isdigit()), None)
