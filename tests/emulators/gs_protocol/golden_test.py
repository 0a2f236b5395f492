"""The examples of the text, byte by byte, read and written; and what the text says of malformed ones."""
import math
import os
import re
import struct
import unittest

from gs_protocol import cbor, frames, messages, numbering, settings
from gs_protocol.cbor import Malformed
from gs_protocol.outlet import IDENTITY

TEXT = os.path.join(os.path.dirname(__file__), "..", "..", "..", "firmware", "wire", "exchange.md")
SESSION, START = 0x5E551011, 0xC0FFEE07


def examples():
    with open(TEXT, encoding="utf-8") as file:
        blocks = re.findall(r"```hex\n(.*?)```", file.read(), re.S)
    return [bytes.fromhex(part) for block in blocks for part in block.split("\n\n")]


class Exchange(unittest.TestCase):
    def test_has_these_messages(self):
        identity = [IDENTITY[name] for name, _ in messages.UPLINK[1][1][:12]]
        identity[3], identity[7] = "mps2-an386", 3
        nan = math.nan
        identify = messages.downlink("identify", 0, SESSION)
        error = messages.uplink("error", 66, 8100, START, 1, 1)
        digest = settings.digest(settings.EXAMPLE)
        self.assertEqual(digest, 0x792388DA)
        self.assertEqual(
            [example.hex(" ") for example in examples()],
            [made.hex(" ") for made in (
                messages.uplink("hello", 0, 0, None, *identity, 0, 0, 0, 0),
                messages.uplink("measurement", 0, 128, START, nan, nan, 0.0, 0),
                identify, frames.encode(identify),
                messages.downlink("settings", 1, SESSION, settings.EXAMPLE),
                messages.uplink("settings answer", 1, 200, START, 0, 1, digest, True),
                messages.uplink("measurement", 63, 8064, START, 49.984375, -0.125, 1.0, 1),
                messages.downlink("command", 2, SESSION, 9, False, START),
                messages.uplink("command answer", 64, 8064, START, 9, False, SESSION),
                messages.uplink("relay", 65, 8064, START, False, 3),
                error, frames.encode(error))])

    def test_is_read_as_it_was_written(self):
        read = [messages.read_uplink(data) for data in (examples()[i] for i in (0, 1, 5, 6, 8, 9, 10))]
        self.assertEqual([message.name for message in read],
                         ["hello", "measurement", "settings answer", "measurement", "command answer",
                          "relay", "error"])
        self.assertEqual(read[0]["id"], "outlet-7")
        self.assertEqual(read[2], {"error": 0, "version": 1, "digest": 0x792388DA, "kept": True})
        self.assertTrue(math.isnan(read[1]["frequency_hz"]))
        identify, sent, command = (messages.read_downlink(examples()[i]) for i in (2, 4, 7))
        self.assertEqual((identify.name, identify.session, identify.sequence), ("identify", SESSION, 0))
        self.assertEqual(settings.read_map(sent["values"]), settings.EXAMPLE)
        self.assertEqual(command, {"request": 9, "close_relay": False, "start_number": START})
        for frame in (examples()[3], examples()[11]):
            self.assertIn(frames.decode(frame.strip(b"\0")), examples())


class Reading(unittest.TestCase):
    def test_takes_any_form_of_integers_and_further_items_of_any_kind(self):
        plain = messages.read_downlink(messages.downlink("ping", 7, 9, 5))
        for more in ("", "f93c00", "a10102", "c101", "fb0000000000000000", "4100", "62c3a4", "f6", "e0", "20"):
            data = bytes.fromhex("%x 06 1a00000007 1b0000000000000009 05" % (0x84 + bool(more)) + more)
            self.assertEqual(messages.read_downlink(data), plain, more)

    def test_refuses_malformed_messages(self):
        ping = messages.downlink("ping", 7, 9, 5)
        hello = messages.uplink("hello", 0, 0, None, *IDENTITY.values(), 0, 0, 0, 0)
        for wrong in (b"", ping[:-1], ping + b"\0", b"\x9f" + ping[1:] + b"\xff", b"\x83" + ping[1:-1],
                      messages.downlink("ping", 7, 9, -5), messages.downlink("ping", 7, 0, 5),
                      messages.downlink("ping", 7, 9, 5.0), cbor.dumps([6, 7, 9, True]),
                      cbor.dumps([2, 7, 9, 0, True, 1]), cbor.dumps([-1, 7, 9]),
                      cbor.dumps([6, 7, 9, 5, "x" * 560])):
            self.assertRaises(Malformed, messages.read_downlink, wrong)
        for name, value in (("sample_rate_hz", 0), ("sample_rate_hz", 1000001), ("nominal_hz", 55),
                            ("tracker_delay_s", math.nan), ("voltage_delay_s", 1.5), ("id", "$x"), ("id", ""),
                            ("id", "x" * 33), ("board", "x" * 17), ("board", "\n")):
            changed = dict(IDENTITY, **{name: value})
            self.assertRaises(Malformed, messages.read_uplink,
                              messages.uplink("hello", 0, 0, None, *changed.values(), 0, 0, 0, 0))
        self.assertEqual(messages.read_uplink(hello)["id"], "outlet-7")
        self.assertIsNone(messages.read_downlink(cbor.dumps([0, 7, 9])).name)
        self.assertEqual(len(cbor.dumps([6, 7, 9, 5, "x" * 552])), messages.LONGEST)

    def test_takes_the_longest_message_of_this_version(self):
        rows = [number for row in range(32) for number in (49.0 - row, -0.5)]
        largest = {key: {"u8": 100, "u16": 1000, "u32": 0xFFFFFFFF}.get(row[1], 1.0)
                   for key, row in settings.KEYS.items()}
        largest.update({10: rows, 13: 10, 16: 64, 17: 200, 23: 50, 29: 1, 32: 200})
        data = messages.downlink("settings", 0xFFFFFFFF, 0xFFFFFFFF, largest)
        self.assertEqual(len(data), 535)
        self.assertEqual(settings.read_map(messages.read_downlink(data)["values"]), largest)

    def test_only_32_bit_floats_are_floats(self):
        for digits in ("f93c00", "fb3ff0000000000000"):
            self.assertRaises(Malformed, messages.typed, cbor.loads(bytes.fromhex(digits)), "f32")
        self.assertEqual(messages.typed(cbor.loads(b"\xfa" + struct.pack(">f", 1.0)), "f32"), 1.0)


class Frames(unittest.TestCase):
    def test_carry_messages_of_any_length(self):
        for length in (1, 2, 249, 250, 251, 252, 253, 254, 505, 560):
            for filling in (b"\0", b"x", b"x\0"):
                message = (filling * length)[:length]
                frame = frames.encode(message)
                self.assertEqual(frames.decode(frame[1:-1]), message)
                self.assertNotIn(0, frame[1:-1])
                self.assertLessEqual(len(frame), 569)

    def test_that_are_bad_are_refused(self):
        good = frames.encode(b"\x83\x03\x00\x01")[1:-1]
        for bad in (good[:-1], good[1:], b"\x01", frames.stuff(b"1234"), frames.encode(b"x" * 561)[1:-1],
                    good[:3] + b"\x07" + good[4:]):
            self.assertRaises(frames.BadFrame, frames.decode, bad)

    def test_may_end_with_an_empty_group_after_a_full_one(self):
        full = b"\xff" + b"x" * 254
        self.assertEqual(frames.stuff(b"x" * 254), full + b"\x01")
        self.assertEqual(frames.unstuff(full), frames.unstuff(full + b"\x01"))


class Numbers(unittest.TestCase):
    def test_are_read_modulo_two_to_the_32(self):
        count = numbering.Count()
        self.assertEqual([count.accept(n) for n in (0xFFFFFFFE, 0xFFFFFFFF, 0, 2, 1, 2, 0x80000002, 3)],
                         [0, 0, 0, 1, None, None, 0x7FFFFFFF, None])

    def test_of_versions_skip_zero(self):
        self.assertEqual(settings.next_version(0xFFFFFFFF), 1)
        self.assertTrue(settings.newer(1, 0xFFFFFFFF))
        self.assertFalse(settings.newer(0, 0xFFFFFFFF))
        self.assertFalse(settings.newer(0x80000001, 1))
        self.assertTrue(settings.newer(0x80000000, 1))


if __name__ == "__main__":
    unittest.main()
