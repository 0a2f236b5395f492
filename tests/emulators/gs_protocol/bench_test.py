"""gsbench devices and monitor with an outlet written from the text, at a line and at a broker."""
import math
import unittest

from gs_protocol import cbor, messages
from gs_protocol.bench_rig import AtLink, faults, kinds


class Watched(AtLink):
    def test_it_is_listed_with_what_its_hello_says(self):
        code, found = self.devices()
        self.assertEqual(code, 0)
        self.assertEqual({key: found[0][key] for key in ("id", "board", "instance", "firmware", "build",
                                                         "sample_rate_hz", "nominal_hz", "keeps_settings",
                                                         "has_watchdog", "settings_digest")},
                         {"id": "outlet-7", "board": "python", "instance": 0x12345678, "firmware": "0.1.0",
                          "build": "deadbeef", "sample_rate_hz": 8000, "nominal_hz": 50,
                          "keeps_settings": True, "has_watchdog": False, "settings_digest": "00000000"})

    def test_it_is_refused_with_a_hello_out_of_range_or_of_another_version(self):
        for name, value in (("nominal_hz", 55), ("tracker_delay_s", math.nan), ("sample_rate_hz", 0),
                            ("voltage_delay_s", 1.5), ("id", "$x"), ("id", ""), ("protocol_version", 4)):
            with self.subTest(name=name):
                good = self.outlet.identity[name]
                self.outlet.identity[name] = value
                self.outlet.say_hello()
                code, found = self.devices()
                self.outlet.identity[name] = good
                self.assertEqual(code, 4)
                self.assertEqual(len(found), 1)
                self.assertNotEqual(found[0]["fault"], "")
                self.assertNotIn("board", found[0])

    def test_all_its_messages_are_printed_once_with_their_fields(self):
        bench = self.monitor()
        say = self.outlet.say
        for message in (("event", 50.0, -0.125), ("LSE", 500.0), ("estimate", 512.0, 8.0, -0.25, 2),
                        ("decision", 512.0, 8.0, math.nan, 128.0, 0.0, 7, 0, True), ("relay", False, 1),
                        ("aborted",), ("relay", True, 0)):
            say(*message)
            self.outlet.sample += 1
        self.measure(100)
        objects = self.end(bench)
        self.assertEqual(faults(objects), [])
        for kind in ("event", "lse", "estimate", "decision", "aborted"):
            self.assertEqual(len(kinds(objects, kind)), 1, kind)
        self.assertEqual(len(kinds(objects, "relay")), 2)
        self.assertEqual(len(kinds(objects, "measurement")), 100)
        self.assertEqual(kinds(objects, "estimate")[0]["loss_mw"], 512.0)
        self.assertEqual([one["sample"] for one in kinds(objects, "measurement")][-1], self.outlet.sample)

    def test_redelivered_messages_are_neither_restarts_nor_printed_twice(self):
        bench = self.monitor()
        self.outlet.say_hello()
        self.measure(5)
        self.outlet.say("event", 50.0, -0.25)
        self.outlet.say("relay", False, 1)
        redelivered = list(self.sent)
        self.measure(5)
        for message in redelivered:
            self.send_again(message)
        # A late number is late whatever its sample.
        start = self.outlet.identity["start_number"]
        self.outlet.send(cbor.dumps([4, 0, self.outlet.sample + 1, start, 1.0, 1.0]), False, True)
        self.measure(5)
        objects = self.end(bench)
        self.assertEqual(faults(objects), [])
        self.assertEqual([len(kinds(objects, kind)) for kind in ("event", "relay", "measurement")],
                         [1, 1, 15])

    def test_an_event_stamped_before_a_measurement_is_no_restart(self):
        bench = self.monitor()
        self.measure(20)
        self.outlet.sample -= 1000
        self.outlet.say("event", 50.0, -0.25)
        self.outlet.sample += 1000
        self.measure(5)
        objects = self.end(bench)
        self.assertEqual(faults(objects), [])
        event = objects.index(kinds(objects, "event")[0])
        self.assertEqual(objects[event - 1]["sample"], objects[event]["sample"] + 1000)

    def test_a_restart_is_seen_once_also_without_its_hello(self):
        bench = self.monitor()
        for number, with_hello in ((1, True), (2, False), (3, False)):
            self.measure(5)
            old = self.sent[-1]
            sample = self.outlet.sample
            self.outlet.start(number)
            self.outlet.sample = 0
            if with_hello:
                self.outlet.say_hello()
            else:
                self.outlet.hellos += 1
            self.measure(3)
            self.assertTrue(self.station.until(lambda: len([line for line in bench.out
                                                            if "restarted" in line]) == number), bench.out)
            self.assertIn("restarted after its sample %d" % sample, bench.text())
            self.send_again(old)  # late
        self.measure(5)
        objects = self.end(bench)
        self.assertEqual(len(faults(objects)), 3, faults(objects))

    def test_identify_is_sent_again_until_a_hello_answers_it_and_any_hello_describes_the_outlet(self):
        received = []
        receive, self.outlet.receive = self.outlet.receive, received.append
        bench = self.bench("monitor", "--json")
        for session in (0, 77, 0):  # unasked, and answers to another centre
            count = len(received)
            self.outlet.say_hello(session)
            self.assertTrue(self.station.until(lambda: len(received) > count + (self.LINK == "serial")))
        self.assertTrue(self.station.until(lambda: bench.out))
        read = [messages.read_downlink(data) for data in received]
        self.assertEqual({message.name for message in read}, {"identify"})
        self.assertEqual(len({message.session for message in read}), 1)
        self.assertEqual([message.sequence for message in read], list(range(len(read))))
        self.outlet.receive = receive
        self.outlet.say_hello()
        self.assertTrue(self.station.until(lambda: self.outlet.sessions))
        self.measure(5)
        objects = self.end(bench)
        self.assertEqual((faults(objects), len(kinds(objects, "measurement"))), ([], 5))
        self.assertEqual(next(one for one in objects if one["event"] == "joined")["board"], "python")

    def test_lost_messages_are_counted(self):
        bench = self.monitor()
        self.measure(5)
        self.outlet.sent += 7
        self.measure(5)
        objects = self.end(bench)
        self.assertEqual(len(faults(objects)), 1)
        self.assertTrue(faults(objects)[0].startswith("7 of its messages were lost"), faults(objects))

    def test_messages_have_at_most_560_bytes(self):
        bench = self.monitor()
        start = self.outlet.identity["start_number"]
        for length in (561, 560):
            empty = len(cbor.dumps([9, self.outlet.sent, 0, start, "x" * 300])) - 300
            message = cbor.dumps([9, self.outlet.sent, 0, start, "x" * (length - empty)])
            self.assertEqual(len(message), length)
            self.outlet.send(message, False, True)
        self.outlet.sent += 1
        objects = self.end(bench)
        self.assertEqual(len(kinds(objects, "aborted")), 1)
        self.assertEqual(len(faults(objects)), 1, faults(objects))

    def test_what_cannot_be_read_is_a_fault_and_nothing_else(self):
        bench = self.monitor()
        self.measure(5)
        start = self.outlet.identity["start_number"]
        self.outlet.send(cbor.dumps([3, self.outlet.sent, 0, start, 50.0, 0.0, 1.0, 3]), False, True)
        self.outlet.send(cbor.dumps([99, self.outlet.sent, 0, start]), False, True)
        self.outlet.sent += 1
        self.outlet.send(cbor.dumps([9, self.outlet.sent, 0, start, "more", {"x": [1.0]}]), False, True)
        self.outlet.sent += 1
        self.measure(5)
        objects = self.end(bench)
        self.assertEqual(len(faults(objects)), 2, faults(objects))
        self.assertEqual(len(kinds(objects, "aborted")), 1)
        self.assertEqual(len(kinds(objects, "measurement")), 10)


class AtLine(Watched, unittest.TestCase):
    LINK = "serial"


class AtBroker(Watched, unittest.TestCase):
    LINK = "mqtt"

    def departed(self, bench):
        return self.station.until(lambda: any('"left"' in line for line in bench.out))

    def test_it_leaves_by_its_will_and_by_an_empty_hello_and_comes_back(self):
        bench = self.monitor("--quiet")
        self.station.depart_with_will()
        self.assertTrue(self.departed(bench), bench.out)
        del bench.out[:]
        back = self.new_outlet()
        self.assertTrue(back.until(lambda: bench.out))
        back.depart()
        self.assertTrue(self.departed(bench), bench.out)

    def test_an_empty_payload_on_another_topic_is_ignored(self):
        bench = self.monitor()
        self.outlet.send(b"", False, True)
        self.measure(3)
        objects = self.end(bench)
        self.assertEqual((faults(objects), len(kinds(objects, "measurement"))), ([], 3))

    def test_a_retained_hello_alone_proves_no_outlet(self):
        bench = self.monitor("--quiet")
        hello = next(message for message in self.sent if message[1])
        self.station.depart()
        self.assertTrue(self.departed(bench))
        other = self.new_outlet(id="other", start_number=5)
        other.publish("gs/outlet-7/hello", hello[0], 1, True)
        listing = self.bench("devices", "--json")
        self.assertTrue(other.until(lambda: not listing.running(), 60.0))
        self.assertEqual(listing.exit_code(), 4)
        found = {one["id"]: one for one in listing.json()}
        self.assertEqual(found["other"]["fault"], "")
        self.assertNotEqual(found["outlet-7"]["fault"], "")
        self.assertNotIn("board", found["outlet-7"])

    def test_an_id_that_is_not_that_of_its_topic_is_a_fault(self):
        self.outlet.identity["id"] = "other"
        code, found = self.devices()
        self.assertEqual((code, [one["id"] for one in found]), (4, ["outlet-7"]))
        self.assertIn("other", found[0]["fault"])

    def test_two_units_with_one_id_are_a_fault(self):
        twin = self.new_outlet(instance=9, start_number=99)
        bench = self.bench("devices", "--json")
        self.assertTrue(self.station.until(lambda: twin.turn() or not bench.running(), 60.0))
        self.assertEqual(bench.exit_code(), 4)
        self.assertNotEqual(bench.json()[0]["fault"], "")


if __name__ == "__main__":
    unittest.main()
