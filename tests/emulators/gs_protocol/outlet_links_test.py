"""gs-outlet at a broker and at a line: connection, departure, restarts, and two centres."""
import os
import signal
import unittest

from gs_protocol import messages, serial_line, settings
from gs_protocol.product import ProductOutlet, at_broker, connected, free_port, wait
from gs_protocol.proxy import MqttProxy
from gs_protocol.rig import NAME, Rig

CONNECT, SUBSCRIBE = 1, 8


def packets(proxy, kind):
    return [packet for packet in proxy.seen if packet[0] >> 4 == kind]


class Behind(unittest.TestCase):
    """A broker, and a proxy between it and the outlet."""

    def setUp(self):
        self.rig = Rig("mqtt", through=self.make_proxy)
        self.addCleanup(self.rig.close)
        self.centre = self.rig.centre
        self.rig.mark = len(self.centre.log)

    def make_proxy(self, port, client):
        """The last one is the outlet's."""
        self.proxy = MqttProxy(port, client, {}, 1)
        self.addCleanup(self.proxy.close)
        return self.proxy.port

    def test_it_connects_with_a_clean_start_a_will_and_the_id_of_its_unit(self):
        connect = packets(self.proxy, CONNECT)[0]
        self.assertIn(b"\0\x04MQTT\x05", connect)
        flags = connect[connect.index(b"MQTT\x05") + 5]
        self.assertEqual(flags & 0x3E, 0x20 | 0x04 | 0x08 | 0x02, "will retained, QoS 1; clean start")
        self.assertEqual(connect[connect.index(b"MQTT\x05") + 6:][:2], b"\0\x0a", "keep alive")
        self.assertIn(b"\0\x12kitchen-1-00000001", connect)
        self.assertIn(b"\0\x12gs/kitchen-1/hello\0\0", connect)
        subscribe = packets(self.proxy, SUBSCRIBE)[0]
        self.assertTrue(subscribe.endswith(b"\0\x11gs/kitchen-1/down\x21"), subscribe)

    def test_a_new_connection_is_no_restart_and_no_command_waits_for_it(self):
        start = self.rig.peer.start_number
        self.proxy.shut = True
        self.proxy.cut_all()
        self.rig.next("departed")
        self.centre.command(NAME, False)
        self.proxy.shut = False
        hello = self.rig.next("hello")[0]
        self.assertEqual(hello.start_number, start)
        self.assertTrue(self.rig.peer.connected)
        self.assertEqual(self.centre.all("restart"), [])
        self.assertEqual(self.rig.since_asked("relay", "command answer"), [])
        # The request was not carried out. Repeated, it is.
        self.centre.repeat_command(NAME, False)
        self.assertFalse(self.rig.next("relay")[0]["closed"])

    def test_after_a_new_connection_its_hello_comes_before_what_it_kept(self):
        rig = Rig("mqtt", "--loss", "900", "--loss-at", "4", through=self.make_proxy)
        self.addCleanup(rig.close)
        self.assertEqual(rig.answer("settings", "settings answer", settings.EXAMPLE | {8: 0.0})["error"], 0)
        rig.mark = len(rig.centre.log)
        self.proxy.shut = True
        self.proxy.cut_all()
        rig.next("departed")
        self.assertEqual(rig.centre.all("event", rig.mark), [])
        rig.station.run_for(6.0)  # the loss passes meanwhile
        self.proxy.shut = False
        rig.next("relay")
        seen = [entry.what for entry in rig.centre.log[rig.mark:]]
        seen = [what for what in seen[seen.index("departed") + 1:] if what != "late"]  # MQTT repeats
        self.assertEqual(seen[0], "hello", seen)
        kept = [what for what in seen if what in ("event", "LSE", "decision", "relay")]
        self.assertEqual(kept[:4], ["event", "LSE", "decision", "relay"])

    def test_it_departs_if_it_is_silent_and_comes_back(self):
        start = self.rig.peer.start_number
        os.kill(self.rig.product.process.pid, signal.SIGSTOP)
        try:
            self.assertTrue(self.rig.station.until(lambda: self.centre.all("departed", self.rig.mark), 60.0))
        finally:
            os.kill(self.rig.product.process.pid, signal.SIGCONT)
        self.rig.next("hello")
        self.assertTrue(self.rig.peer.connected)
        self.assertEqual((self.rig.peer.start_number, self.centre.all("restart")), (start, []))

    def test_it_departs_when_it_is_ended(self):
        self.rig.product.close()
        self.rig.next("departed")
        self.assertFalse(self.rig.peer.connected)
        later = self.rig.another()
        later.run_for(0.5)
        self.assertEqual(later.centre.log, [])

    def test_a_centre_that_comes_later_learns_of_it_by_the_retained_hello(self):
        later = self.rig.another()
        self.assertTrue(later.until(lambda: len(later.centre.all("hello")) == 2))
        self.assertEqual([hello["session"] for hello in later.centre.all("hello")][1], later.centre.session)

    def test_units_of_one_id_are_twins_unless_one_takes_the_place_of_the_other(self):
        def add(instance):
            product = ProductOutlet(NAME, *at_broker(self.rig.broker.port), "--instance", instance)
            self.addCleanup(product.close)
            return product

        def remove(product):
            self.rig.mark = len(self.centre.log)
            product.close()
            self.rig.next("departed")

        remove(self.rig.product)
        two = add("2")
        self.rig.until(lambda: self.rig.peer.instance == 2)
        self.rig.answer("ping", "echo", 1)
        self.assertEqual(self.centre.all("twins"), [])
        three = add("3")
        self.rig.next("twins")
        self.assertRaises(ValueError, self.rig.ask, "ping", 1)
        remove(three)
        self.rig.until(lambda: self.rig.peer.instance == 2)  # nobody asks it but the centre
        self.rig.answer("ping", "echo", 2)
        later = self.rig.another()
        self.assertTrue(later.until(lambda: later.centre.peers[NAME].identified), "its hello is retained again")
        later.close()
        remove(two)
        add("4")
        self.rig.until(lambda: self.rig.peer.instance == 4 and self.rig.peer.identified)
        self.rig.answer("ping", "echo", 1)

    def test_two_centres_do_not_disturb_each_other(self):
        other = self.rig.another()
        self.assertTrue(other.until(lambda: other.centre.peers[NAME].hello is not None
                                    and other.centre.peers[NAME].hello["session"] == other.centre.session))
        for _ in range(20):
            other.centre.say(NAME, "ping", 2)
            self.rig.answer("ping", "echo", 1)
        self.centre.command(NAME, False)
        opened = self.rig.next("command answer")[0]
        self.assertEqual(opened["session"], self.centre.session)
        other.centre.command(NAME, True)  # its request 1, too
        self.assertTrue(other.until(lambda: len(other.centre.all("relay")) == 2))
        self.assertEqual([(answer["session"], answer["closed"]) for answer in other.centre.all("command answer")],
                         [(self.centre.session, False), (other.centre.session, True)])
        self.assertTrue(other.until(lambda: len(other.centre.all("echo")) >= 40))
        self.assertEqual(self.rig.since_asked("error", "lost", "late"), [])


class Lines(unittest.TestCase):
    """The other kinds of serial lines that gs-outlet has."""

    def expect_answers(self, line):
        station = serial_line.SerialCentre(line=line)
        self.addCleanup(station.close)  # for a second time if nothing fails
        self.assertTrue(station.until(station.identified))
        station.centre.say(station.name, "ping", 5)
        self.assertTrue(station.until(lambda: station.centre.all("echo") == [{"token": 5}]))
        self.assertEqual((station.bad_frames, station.centre.all("lost")), (0, []))
        station.close()

    def start(self, *link):
        product = ProductOutlet(NAME, *link)
        self.addCleanup(product.close)

    def test_it_waits_for_a_centre_at_a_tcp_port_and_for_the_next_one(self):
        port = free_port()
        self.start("--listen", "127.0.0.1:%d" % port)
        for _ in range(2):
            connection = wait(lambda: connected(port))
            self.expect_answers(serial_line.Line(connection))

    def test_it_opens_a_pseudo_terminal(self):
        pty = serial_line.Pty()
        self.start("--serial", pty.device)
        self.expect_answers(serial_line.Line(pty))


class Restarts:
    LINK = None

    def setUp(self):
        self.rig = Rig(self.LINK)
        self.addCleanup(self.rig.close)
        self.centre = self.rig.centre
        self.rig.next("measurement")

    def restart(self):
        start = self.rig.peer.start_number
        self.rig.mark = len(self.centre.log)
        self.rig.product.restart()
        self.rig.until(lambda: self.rig.peer.start_number != start and self.rig.station_is_identified())
        self.rig.next("measurement", 10)
        self.assertEqual(len(self.centre.all("restart")), 1)
        self.assertEqual(self.rig.since_asked("malformed", "error"), [])
        self.assertIn(start, self.rig.peer.earlier)
        return start

    def test_a_restart_is_seen_once_and_its_hello_reports_the_kept_settings(self):
        self.assertEqual(self.rig.answer("settings", "settings answer", settings.EXAMPLE)["error"], 0)
        old = self.restart()
        hello = self.rig.peer.hello
        self.assertEqual((hello["settings_version"], hello["settings_digest"]),
                         (1, settings.digest(settings.EXAMPLE)))
        error = self.rig.answer("command", "error", 1, False, old)
        self.assertEqual(error, {"code": 9, "detail": 1})

    def test_a_restart_whose_hello_is_lost_is_seen_by_the_next_message(self):
        lost = []

        def loses_first_hello(message):
            unasked = message and messages.read_uplink(message).get("session") == 0
            if unasked:
                lost.append(message)
            return not unasked

        self.rig.station.passes = loses_first_hello
        self.restart()
        self.assertEqual(len(lost), 1)
        first = self.centre.all("restart")[0]
        self.assertEqual(first.kind, 3)
        self.assertLessEqual(first.sequence, 1)

    def test_messages_of_an_old_session_are_refused_after_a_restart(self):
        errors = []

        def keeps_errors(data):
            message = data and messages.read_uplink(data)
            if message and message.name == "error":
                errors.append(message)
            return False  # the centre learns nothing, and so does not identify

        self.rig.station.passes = keeps_errors
        self.rig.product.restart()

        def refused():
            self.rig.ask("ping", 1)
            return errors

        self.rig.until(refused)
        self.assertEqual(errors[0], {"code": 8, "detail": self.centre.session})


class RestartsOverSerial(Restarts, unittest.TestCase):
    LINK = "serial"


class RestartsOverMqtt(Restarts, unittest.TestCase):
    LINK = "mqtt"


if __name__ == "__main__":
    unittest.main()
