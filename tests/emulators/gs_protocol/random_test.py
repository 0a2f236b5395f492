"""gs-outlet and the outlet that is written from the text receive the same messages, right and wrong
ones at random, and answer alike. GS_PROTOCOL_SEED is the seed, GS_PROTOCOL_RANDOM the number."""
import collections
import os
import random
import unittest

from gs_protocol import cbor, messages, settings
from gs_protocol.outlet import Outlet
from gs_protocol.rig import Rig

SEED = int(os.environ.get("GS_PROTOCOL_SEED", "1"))
NUMBER = int(os.environ.get("GS_PROTOCOL_RANDOM", "4000"))
SESSIONS = (11, 12, 13, 14, 15)  # one more than outlets keep
FLOATS = (0.0, -1.0, 1.0, 49.0, 50.0, 1e-5, 0.01, 0.1, 3e9, float("inf"), float("nan"), 40.0, 71.0)
ITEMS = (0, -1, 1.5, "text", b"bytes", True, None, [], [1], {}, {1: 2}, 1 << 40)
UNCOMPARED = {"hello": ("id", "board", "instance", "firmware_version", "build", "tracker_delay_s",
                        "voltage_delay_s", "next_number"),
              "self test": ("fingerprint",), "status": ("reports",)}


class Messages:
    """Random ones; their numbers mostly follow each other."""

    def __init__(self, seed, outlet):
        self.random, self.outlet = random.Random(seed), outlet
        self.next = dict.fromkeys(SESSIONS, 0)
        self.request = 0

    def one(self):
        pick = self.random.choice
        session = pick(SESSIONS)
        kind = pick((1, 1, 1, 2, 2, 3, 3, 4, 5, 6, self.random.randrange(300)))
        ahead = pick((0, 0, 0, 0, 0, -1, 3, 1 << 31, (1 << 31) - 1)) if self.next[session] else 0
        number = (self.next[session] + ahead) % (1 << 32)
        items = [kind, number, session, *self.fields(kind)]
        if pick((False, False, False, True)):
            items.insert(self.random.randrange(len(items) + 1), pick(ITEMS))
        data = self.damaged(cbor.dumps(items)) if pick((False, True)) else cbor.dumps(items)
        if 0 <= ahead < 1 << 31:  # else late
            self.next[session] = (number + 1) % (1 << 32)
        return data

    def fields(self, kind):
        pick = self.random.choice
        if kind == 1:
            return [self.settings()]
        if kind == 2:
            start = self.outlet.identity["start_number"]
            self.request += 1  # newer than all before, of all sessions; or an old one, or none
            request = pick((self.request, self.request, self.random.randrange(self.request), 0))
            return [request, pick((False, True)), pick((start, start, start, 0))]
        return [self.random.randrange(1 << 32)] if kind == 6 else []

    def settings(self):
        """For every key, so that the digest can be compared."""
        values = settings.EXAMPLE | {1: settings.next_version(self.outlet.settings_state()[0])}
        for _ in range(self.random.randrange(4)):
            key = self.random.randrange(2, 37)
            kind = settings.KEYS[key][1]
            if kind == "rows":
                values[key] = [self.random.choice(FLOATS) for _ in range(self.random.randrange(70))]
            elif kind == "f32":
                values[key] = self.random.choice(FLOATS)
            else:
                values[key] = self.random.choice((0, 1, 2, 10, 33, 50, 64, 200, 255, 256, 1000, 1001, 65535))
        if self.random.random() < 0.05:
            values[self.random.choice((0, 37, 99, 1 << 40))] = 1
        return values

    def damaged(self, data):
        data = bytearray(data)
        for _ in range(self.random.choice((0, 1, 1, 2))):
            at = self.random.randrange(len(data))
            how = self.random.randrange(4)
            if how == 0:
                data[at] = self.random.randrange(256)
            elif how == 1:
                data[at] ^= 1 << self.random.randrange(8)
            elif how == 2:
                data.insert(at, self.random.randrange(256))
            else:
                del data[max(at, 1):at + self.random.choice((1, 4, 1000))]
        return bytes(data)


class Random(unittest.TestCase):
    def test_messages_are_answered_as_the_text_says(self):
        rig = Rig("serial")
        self.addCleanup(rig.close)
        answers = []
        outlet = Outlet(lambda message, *_: answers.append(messages.read_uplink(message)) or True,
                        start_number=rig.peer.start_number)
        # Both know the session of the rig; its pings show that an answer is whole.
        outlet.receive(messages.downlink("identify", 0, rig.centre.session))
        outlet.sessions[rig.centre.session].count.next = rig.peer.sent
        before = rig.answer("ask status", "status")
        outlet.receive(messages.downlink("ask status", rig.peer.sent - 1, rig.centre.session))
        self.assertEqual(before["messages_dropped"] + before["messages_bad"], 0)
        made = Messages(SEED, outlet)
        names = collections.Counter()
        for number in range(NUMBER):
            data = made.one()
            del answers[:]
            rig.mark = len(rig.centre.log)
            rig.send(data)
            got = [entry.detail for entry in rig.since_asked(*(row[0] for row in messages.UPLINK.values()))]
            outlet.receive(data)
            outlet.receive(messages.downlink("ping", rig.peer.sent - 1, rig.centre.session, 424242))
            names.update(answer.name for answer in answers)
            self.assertEqual(*map(comparable, (got, answers)),
                             "message %d: %s" % (number, data.hex(" ")))
        print("\n%d messages; answers: %s" % (NUMBER, dict(names)))
        self.assertEqual(set(names), {"hello", "settings answer", "relay", "command answer", "status", "self test",
                                 "echo", "error"})


def comparable(answers):
    """What the text determines."""
    return [(answer.name, {key: value for key, value in answer.items()
                           if key not in UNCOMPARED.get(answer.name, ())})
            for answer in answers if answer.name != "measurement"]


if __name__ == "__main__":
    unittest.main()
