"""gs-outlet measures a loss of power: the messages of an event, read from the text."""
import math
import os
import tempfile
import unittest

from gs_protocol import settings
from gs_protocol.rig import Rig

RATE_HZ = 8000


def fall_then_nothing(path):
    """The frequency falls by 1 Hz/s from 2 s on; from 2.4 s on there is no voltage."""
    with open(path, "w", encoding="ascii") as file:
        file.write("t_s,voltage_pu\n")
        for n in range(4 * RATE_HZ):
            t_s = n / RATE_HZ
            cycles = 50.0 * t_s - 0.5 * max(t_s - 2.0, 0.0) ** 2
            voltage_pu = math.cos(2.0 * math.pi * cycles) if t_s < 2.4 else 0.0
            file.write("%.6f,%.6f\n" % (t_s, voltage_pu))


class Event(unittest.TestCase):
    def rig(self, link, values, *options):
        rig = Rig(link, *options)
        self.addCleanup(rig.close)
        answer = rig.answer("settings", "settings answer", settings.EXAMPLE | values)
        self.assertEqual(answer["error"], 0)
        rig.mark = 0
        return rig

    def expect_whole(self, rig):
        self.assertEqual(rig.since_asked("malformed", "lost", "late", "unknown kind", "restart"), [])

    def test_a_loss_makes_event_estimates_decision_and_relay(self):
        for link, method in (("serial", 0), ("mqtt", 1)):
            rig = self.rig(link, {29: method, 8: 0.0}, "--loss", "900", "--loss-at", "2")
            event = rig.next("event")[0]
            self.assertAlmostEqual(event["baseline_hz"], 50.0, delta=0.02)
            decision = rig.next("decision")[0]
            self.assertGreater(decision["loss_mw"], 0.0)
            self.assertEqual(math.isnan(decision["nadir_hz"]), method == 0)
            self.assertGreaterEqual(decision.sample, event.sample)
            estimates = rig.centre.all("estimate")
            self.assertGreater(len(estimates), 5)
            for estimate in estimates:
                from_event_s = estimate["loss_instant_s"] + rig.peer.hello["tracker_delay_s"]
                self.assertTrue(-0.5 - 1e-6 <= from_event_s <= 1e-6, from_event_s)
                self.assertIn(estimate["trust"], (0, 1, 2, 3, 4, 5) if method == 0 else (0, 1, 5))
            self.assertEqual(len(rig.centre.all("LSE")), 1)
            self.expect_whole(rig)

    def test_a_relay_that_shed_and_that_a_command_opens_keeps_its_cause_until_it_is_closed(self):
        rig = self.rig("mqtt", {29: 1, 8: 0.0}, "--loss", "900", "--loss-at", "2")
        self.assertTrue(rig.next("decision")[0]["shed"])
        self.assertEqual(rig.next("relay")[0], {"closed": False, "cause": 1})
        for close, cause in ((False, 1), (True, 0)):
            rig.mark = len(rig.centre.log)
            rig.centre.command(rig.name, close)
            self.assertEqual(rig.next("command answer")[0]["closed"], close)
            changes = [entry.detail for entry in rig.since_asked("relay")]
            self.assertEqual(changes, [{"closed": True, "cause": 0}] if close else [])
            status = rig.answer("ask status", "status")
            self.assertEqual((status["relay_closed"], status["cause"]), (close, cause))

    def test_an_event_without_voltage_is_aborted(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "fall.csv")
            fall_then_nothing(path)
            rig = self.rig("serial", {29: 0}, "--signal", path)
            rig.next("event")
            rig.next("aborted")
            rig.until(lambda: rig.centre.all("measurement")[-1]["validity"] == 0)
            self.expect_whole(rig)

    def test_an_outlet_without_storage_applies_settings_and_keeps_none(self):
        rig = Rig("serial", "--nominal", "50")
        self.addCleanup(rig.close)
        self.assertEqual(rig.peer.hello["capabilities"] & 1, 0)
        answer = rig.answer("settings", "settings answer", settings.EXAMPLE)
        self.assertEqual(answer, {"error": 0, "version": 1, "digest": settings.digest(settings.EXAMPLE),
                                  "kept": False})
        self.assertEqual(rig.since_asked("error"), [])


if __name__ == "__main__":
    unittest.main()
