"""Which messages of a broker are stored already: one that comes again changes nothing and is not counted.

    applied = Applied(db, "ships", "harbour at 127.0.0.1:1883")
    fresh = applied.fresh(messages)                         # of mqtt_source
    with committed(db): …; applied.keep(fresh)              # in the transaction that stores what they say

Between the COMMIT and the broker's receipt of the acknowledgement a kill makes the broker send a message again: with the DUP flag, and with
the packet identifier and the content of the first time. All three must agree, because a broker uses identifiers again.
"""
import hashlib

from .files import committed

KEPT = 5000             # the last messages; a broker has fewer that it waits for (mosquitto 20, if it is not told otherwise)


class Applied:
    def __init__(self, db, table, session):
        self.db, self.key = db, (table, session)
        self.digests = dict(db.execute("SELECT mid, digest FROM foresee_messages WHERE tbl = ? AND session = ? ORDER BY number", self.key))
        self.number = db.execute("SELECT coalesce(max(number), 0) FROM foresee_messages WHERE tbl = ? AND session = ?", self.key).fetchone()[0]

    def fresh(self, messages):
        return [message for message in messages
                if not (message.qos and message.dup and self.digests.get(message.mid) == digest_of(message))]

    def keep(self, messages):
        """Writes them down, within a transaction. If it fails the program ends, and the next one reads what the file holds."""
        for message in messages:
            if message.qos:
                self.number += 1
                self.digests.pop(message.mid, None)         # the newest ones are last
                self.digests[message.mid] = digest_of(message)
                self.db.execute("INSERT OR REPLACE INTO foresee_messages VALUES (?, ?, ?, ?, ?)",
                                (*self.key, message.mid, self.digests[message.mid], self.number))
        while len(self.digests) > KEPT:
            oldest = next(iter(self.digests))
            del self.digests[oldest]
            self.db.execute("DELETE FROM foresee_messages WHERE tbl = ? AND session = ? AND mid = ?", (*self.key, oldest))

    def forget(self):
        if self.digests:
            self.digests.clear()
            with committed(self.db):
                self.db.execute("DELETE FROM foresee_messages WHERE tbl = ? AND session = ?", self.key)


def digest_of(message):
    return hashlib.blake2b(message.topic.encode() + b"\0" + message.payload, digest_size=8).digest()
