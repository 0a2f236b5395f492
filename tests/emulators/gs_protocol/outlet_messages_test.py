"""gs-outlet answers all other messages as the text says: questions, commands, and bad input."""
import struct
import unittest

from gs_protocol import cbor, frames, messages
from gs_protocol.rig import NAME, OnOneRig


class Messages(OnOneRig):
    # Questions.

    def test_identify_gives_a_hello_for_this_session(self):
        hello = self.rig.answer("identify", "hello")
        self.assertEqual((hello["id"], hello["board"], hello["protocol_version"]), (NAME, "host", 3))
        self.assertEqual(hello["session"], self.centre.session)
        self.assertEqual(hello.start_number, self.rig.peer.start_number)

    def test_ping_self_test_and_status_are_answered(self):
        self.assertEqual(self.rig.answer("ping", "echo", 0xFFFFFFFF)["token"], 0xFFFFFFFF)
        first = self.rig.answer("ask self test", "self test")
        self.assertEqual(first["failed"], 0)
        self.assertEqual(self.rig.answer("ask self test", "self test"), first)
        status = self.status()
        self.assertEqual((status["phase"], status["samples_lost"], status["messages_unsent"]), (0, 0, 0))
        self.assertGreaterEqual(self.status()["reports"], status["reports"])

    def test_measurements_come_every_128_samples_and_none_is_lost(self):
        measured = self.rig.next("measurement", 30)
        steps = {after.sample - before.sample for before, after in zip(measured, measured[1:])}
        self.assertEqual(steps, {128})
        self.assertEqual(measured[-1]["validity"], 1)
        self.assertAlmostEqual(measured[-1]["frequency_hz"], 50.0, delta=0.02)
        self.assertAlmostEqual(measured[-1]["voltage_pu"], 1.0, delta=0.01)
        self.assertEqual(self.centre.all("lost", self.rig.mark), [])
        self.assertEqual(self.centre.all("malformed"), [])

    # Commands.

    def test_a_command_moves_the_relay_once_however_often_it_comes(self):
        for close in (False, True):
            request = self.rig.peer.request + 1
            self.rig.mark = len(self.centre.log)
            self.centre.command(self.rig.name, close)
            answer = self.rig.next("command answer")[0]
            self.assertEqual(answer, {"request": request, "closed": close, "session": self.centre.session})
            relay = self.rig.next("relay")[0]
            self.assertEqual(relay, {"closed": close, "cause": 0 if close else 3})
            self.assertEqual(relay.sequence > answer.sequence, True)
        # The same request again, and an older one, in new messages.
        for number, close in ((request, False), (request - 1, False)):
            answer = self.rig.answer("command", "command answer", number, close, self.rig.peer.start_number)
            self.assertEqual(answer["request"], number)
            self.assertTrue(answer["closed"])
        self.assertEqual(self.rig.since_asked("relay"), [])

    def test_redelivered_messages_have_no_effect_and_no_answer(self):
        peer = self.rig.peer
        dropped = self.status()["messages_dropped"]
        sent = [self.centre.say(self.rig.name, "identify")]
        for close in (False, True):
            peer.request += 1
            sent.append(self.centre.repeat_command(self.rig.name, close))
        self.rig.next("command answer", 2)
        self.rig.next("relay", 2)
        self.rig.mark = len(self.centre.log)
        for data in sent:
            self.rig.send(data)
        self.assertEqual(self.rig.since_asked("hello", "relay", "command answer", "error"), [])
        status = self.status()
        self.assertEqual(status["messages_dropped"] - dropped, 3)
        self.assertTrue(status["relay_closed"])

    def test_a_command_for_another_start_is_dropped_with_error_9(self):
        peer = self.rig.peer
        dropped = self.status()["messages_dropped"]
        peer.request += 1
        error = self.rig.answer("command", "error", peer.request, False, peer.start_number ^ 1)
        self.assertEqual(error, {"code": 9, "detail": peer.request})
        self.assertEqual(self.rig.since_asked("relay", "command answer"), [])
        self.assertEqual(self.status()["messages_dropped"] - dropped, 1)
        # The request was not recorded: for this start it is a new one.
        self.rig.answer("command", "command answer", peer.request, False, peer.start_number)
        self.assertFalse(self.rig.next("relay")[0]["closed"])
        self.centre.command(self.rig.name, True)
        self.rig.next("relay", 2)

    def relays_after(self, session, number, *requests):
        """Of commands to open and to close in turn, after identify with this number."""
        self.rig.mark = len(self.centre.log)
        self.rig.send(messages.downlink("identify", number, session))
        for place, request in enumerate(requests):
            self.rig.send(messages.downlink("command", number + 1 + place, session, request, place % 2 == 1,
                                            self.rig.peer.start_number))
        changes = [entry.detail["closed"] for entry in self.rig.since_asked("relay")]
        answers = [answer["request"] for answer in self.centre.all("command answer", self.rig.mark)]
        self.assertEqual(answers, list(requests))
        return changes

    def test_requests_end_at_4294967295_and_go_on_in_another_session(self):
        self.assertEqual(self.relays_after(0x77, 0, 0xFFFFFFFE, 0xFFFFFFFF, 1, 2), [False, True])
        self.assertEqual(self.relays_after(0x78, 0, 1, 2), [False, True])

    def test_the_last_requests_of_16_replaced_sessions_are_remembered(self):
        self.assertEqual(self.relays_after(0x5000, 0, 5, 6), [False, True])
        for session in range(0x5001, 0x5014):  # three are known, and 17 were replaced
            self.assertEqual(self.relays_after(session, 0, 1, 2), [False, True], session)
        self.assertEqual(self.relays_after(0x5001, 9, 1, 2), [])
        self.assertEqual(self.relays_after(0x5002, 9, 2, 1, 3), [False])
        self.assertEqual(self.relays_after(0x5002, 12, 3, 4), [True])

    # Bad input.

    def test_malformed_messages_are_errors_and_do_not_use_up_a_number(self):
        peer, session = self.rig.peer, self.centre.session
        for wrong in (messages.downlink("ping", peer.sent, session),
                      messages.downlink("ping", peer.sent, 0, 1),
                      messages.downlink("ping", peer.sent, session, 1.0),
                      messages.downlink("command", peer.sent, session, 0, True, peer.start_number),
                      messages.downlink("identify", peer.sent, session) + b"\0",
                      cbor.dumps([6, peer.sent, session, 5, "x" * 600]),
                      cbor.dumps([6, peer.sent]), b"\x9f\x06\xff", b"\xff", b"hello"):
            bad = self.status()["messages_bad"]
            error = self.rig.answer_to(wrong, "error")
            too_long = self.LINK == "serial" and len(wrong) > 560
            self.assertEqual(error["code"], 1 if too_long else 2, wrong)
            self.assertEqual(error["detail"], self.errors_like(error))
            self.assertEqual(self.status()["messages_bad"] - bad, 1)
        self.rig.answer("ping", "echo", 1)  # its number was not used up

    def errors_like(self, error):
        return sum(one["code"] == error["code"] for one in self.centre.all("error"))

    def test_unknown_kinds_are_errors_and_use_up_a_number(self):
        for kind in (0, 7, 255, 256, 1 << 40):
            number = self.rig.peer.sent
            self.rig.peer.sent += 1
            data = cbor.dumps([kind, number, self.centre.session, {1: [1.0]}])
            error = self.rig.answer_to(data, "error")
            self.assertEqual((error["code"], error["detail"]), (3, self.errors_like(error)))
            self.rig.mark = len(self.centre.log)
            self.rig.send(messages.downlink("ping", number, self.centre.session, 7))
            self.assertEqual(self.rig.since_asked("error"), [])
            self.assertNotIn({"token": 7}, self.centre.all("echo", self.rig.mark))

    def test_further_items_and_any_form_of_integers_are_taken(self):
        number = self.rig.peer.sent
        self.rig.peer.sent += 1
        data = (bytes.fromhex("87061b") + struct.pack(">Q", number)
                + b"\x1a" + struct.pack(">I", self.centre.session) + bytes.fromhex("1900ff")
                + bytes.fromhex("f93c00 a1016178 c1fb0000000000000000"))
        self.assertEqual(self.rig.answer_to(data, "echo")["token"], 255)

    def test_further_items_may_be_nested_to_any_depth_and_need_a_definite_length(self):
        number, session = self.rig.peer.sent, self.centre.session
        room = messages.LONGEST - len(messages.downlink("ping", number, session, 7))
        for further, right in ((b"\x81" * (room - 1) + b"\xf6", True), (b"\xa1\x00" * (room // 2 - 1) + b"\x01", True),
                               (b"\xc1" * (room - 1) + b"\xf7", True), (b"\x42\xff\xff", True), (b"\xf8\xff", True),
                               (b"\x62\xff\xff", True), (b"\x3b" + b"\xff" * 8, True), (b"\xf8\x18", False),
                               (b"\x81" * 9, False), (b"\x9f\xff", False), (b"\xbf\xff", False),
                               (b"\x5f\x41x\xff", False), (b"\x7f\x61x\xff", False), (b"\x81\x9f\xff", False)):
            data = b"\x85" + messages.downlink("ping", self.rig.peer.sent, session, 7)[1:] + further
            self.assertLessEqual(len(data), messages.LONGEST)
            self.rig.peer.sent += right
            answer = self.rig.answer_to(data, "echo" if right else "error")
            self.assertEqual(answer, {"token": 7} if right else {"code": 2, "detail": self.errors_like(answer)}, further)
            if right:
                self.assertEqual(messages.read_downlink(data)["token"], 7)
            else:
                self.assertRaises(cbor.Malformed, messages.read_downlink, data)

    def test_messages_have_at_most_560_bytes(self):
        for length, name in ((560, "echo"), (561, "error")):
            number = self.rig.peer.sent
            padding = length - len(cbor.dumps([6, number, self.centre.session, 5, "x" * 300])) + 300
            data = cbor.dumps([6, number, self.centre.session, 5, "x" * padding])
            self.assertEqual(len(data), length)
            self.rig.peer.sent += name == "echo"
            answer = self.rig.answer_to(data, name)
            if name == "error":
                self.assertEqual(answer["code"], 1 if self.LINK == "serial" else 2)

    def test_messages_of_unknown_sessions_are_dropped_with_error_8(self):
        dropped = self.status()["messages_dropped"]
        error = self.rig.answer_to(messages.downlink("ping", 0, 77, 1), "error")
        self.assertEqual(error, {"code": 8, "detail": 77})
        error = self.rig.answer_to(cbor.dumps([200, 0, 78]), "error")
        self.assertEqual(error, {"code": 8, "detail": 78})
        self.assertEqual(self.status()["messages_dropped"] - dropped, 2)

    def test_late_messages_are_dropped_and_gaps_are_not(self):
        self.rig.peer.sent += 5
        self.rig.answer("ping", "echo", 1)
        self.rig.mark = len(self.centre.log)
        for back in (2, 6, 0x7FFFFFFF):
            number = (self.rig.peer.sent - back) % (1 << 32)
            self.rig.send(messages.downlink("ping", number, self.centre.session, 9))
        self.rig.since_asked()
        self.assertNotIn({"token": 9}, self.centre.all("echo", self.rig.mark))

    def test_numbers_of_a_session_pass_two_to_the_32(self):
        session = 4242
        self.rig.answer_to(messages.downlink("identify", 0x7FFFFFF0, session), "hello")
        self.assertEqual(self.rig.answer_to(
            messages.downlink("ping", 0xFFFFFFEF, session, 1), "echo")["token"], 1)
        self.assertEqual(self.rig.answer_to(messages.downlink("ping", 3, session, 2), "echo")["token"], 2)

    def test_the_fifth_session_replaces_the_one_that_was_silent_longest(self):
        for session in (101, 102, 103):
            self.rig.answer_to(messages.downlink("identify", 9, session), "hello")
        self.rig.answer("ping", "echo", 1)
        self.assertEqual(self.rig.answer_to(messages.downlink("ping", 10, 101, 3), "echo")["token"], 3)


class MessagesOverSerial(Messages, unittest.TestCase):
    LINK = "serial"

    def test_bad_frames_are_errors(self):
        good = frames.encode(messages.downlink("ping", self.rig.peer.sent, self.centre.session, 1))
        for bad in (good[:5] + bytes([good[5] ^ 1]) + good[6:], good[:4] + b"\0", b"\0\x05\0",
                    b"\0" + b"\x01" * 4 + b"\0", b"\0" + b"x" * 3000 + b"\0"):
            before = self.status()["messages_bad"]
            self.rig.mark = len(self.centre.log)
            self.rig.station.line.write(bad)
            self.assertEqual(self.rig.next("error")[0]["code"], 1, bad[:20])
            self.assertEqual(self.status()["messages_bad"] - before, 1)

    def test_nothing_between_zeros_is_ignored(self):
        before = self.status()
        self.rig.station.line.write(bytes(100))
        self.assertEqual(self.status()["messages_bad"], before["messages_bad"])


class MessagesOverMqtt(Messages, unittest.TestCase):
    LINK = "mqtt"

    def test_empty_payloads_are_ignored(self):
        before = self.status()
        self.rig.send(b"")
        after = self.status()
        for name in ("messages_bad", "messages_dropped"):
            self.assertEqual(after[name], before[name])


if __name__ == "__main__":
    unittest.main()
