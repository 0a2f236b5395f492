"""gsbench run with two outlets written from the text, one at a line and one at a broker. They follow
the voltage of an emulated DAC head, so that their clocks are aligned, but not its frequency."""
import collections
import json
import math
import os
import queue
import subprocess
import threading
import unittest

from gs_protocol import mqtt, serial_line, settings
from gs_protocol.product import PROGRAMS, Bench, Broker, Folder, start, stop

STATION = """title = "Outlets in Python"
kind = "physical"
[source]
kind = "head"
port = "%s"
gain = 236.0
voltage_limit_v = 240.0
boot_s = 5.0
[mqtt]
url = "mqtt://127.0.0.1:%d"
[[outlet]]
place = "line-1"
link = "tcp://127.0.0.1:%d"
[[outlet]]
place = "shelf"
serial_number = "radio-1"
link = "mqtt"
"""
PROFILE = """title = "Steady"
source = "None"
[grid]
system = "ieee24"
[signal]
duration_s = 3.0
[[outlet]]
count = 2
[[expect]]
measure = "event.count"
min = 1
max = 1
"""
NOMINAL_V2 = (230.0 / 236.0) ** 2  # mean square at the pin of the DAC
WINDOW = 30  # blocks of 2 ms: twice voltage_delay_s
BLOCK_SAMPLES = 16
STEADY_REPORTS = 100


class Head:
    """The source, and what it plays: the mean square of each 2 ms."""

    def __init__(self):
        self.process = start([os.path.join(PROGRAMS, "emulated_head")], stdout=subprocess.PIPE,
                             text=True)
        self.port = self.process.stdout.readline().strip()
        self.blocks = queue.Queue()
        self.reader = threading.Thread(target=lambda: [self.blocks.put(float(line))
                                                       for line in self.process.stdout])
        self.reader.start()

    def close(self):
        self.process.terminate()
        self.reader.join()
        stop(self.process)


class Run(unittest.TestCase):
    def setUp(self):
        self.folder = Folder()
        self.addCleanup(self.folder.close)
        self.head = Head()
        self.addCleanup(self.head.close)
        self.broker = Broker(self.folder.path)
        self.addCleanup(self.broker.close)
        delays = {"tracker_delay_s": 0.03, "voltage_delay_s": 0.03}
        self.line = serial_line.SerialOutlet(id="line-1", start_number=1, instance=1, **delays)
        self.radio = mqtt.MqttOutlet(self.broker.port, id="radio-1", start_number=2, instance=2, **delays)
        self.stations = (self.line, self.radio)
        for station in self.stations:
            self.addCleanup(station.close)
        self.window = collections.deque(maxlen=WINDOW)
        self.count = self.steady = 0
        self.was_steady = self.dipped = self.started = False

    def turn(self):
        for station in self.stations:
            station.turn(0.002)
        while not self.head.blocks.empty():
            self.window.append(self.head.blocks.get())
            self.count += 1
            if self.count % (128 // BLOCK_SAMPLES) == 0:
                self.report(math.sqrt(sum(self.window) / len(self.window) / NOMINAL_V2))

    def report(self, voltage_pu):
        """A measurement of each outlet; and one event, 1.6 s after the voltage is steady again after
        the bench's first markers."""
        # While the source is switched on, the voltage is between, too; it may be read late.
        self.dipped = self.dipped or (self.line.outlet.stored is not None and self.was_steady
                                      and 0.3 < voltage_pu < 0.95)
        self.steady = self.steady + 1 if 0.99 < voltage_pu < 1.01 else 0
        self.was_steady = self.was_steady or self.steady > 0
        for station in self.stations:
            outlet = station.outlet
            valid = voltage_pu > 0.1
            outlet.measure(*((50.0, 0.0, voltage_pu, 1) if valid else (math.nan, math.nan, voltage_pu, 0)))
            if self.dipped and self.steady == STEADY_REPORTS and not self.started:
                self.disturb(station)
                outlet.say("event", 50.0, -0.25)
                outlet.send(outlet.last, False, True)  # a second copy
        self.started = self.started or (self.dipped and self.steady == STEADY_REPORTS)

    def disturb(self, station):
        """Before its event. For tests."""

    def run_bench(self):
        station = self.folder.write("station.toml", STATION % (self.head.port, self.broker.port,
                                                               self.line.line.port))
        profile = self.folder.write("profile.toml", PROFILE)
        bench = Bench("run", profile, "--station", station, "--json", "--out", self.folder.path)
        self.addCleanup(bench.close)
        while bench.running():
            self.turn()
        code = bench.exit_code()
        self.assertIn(code, (0, 4), bench.err)
        return json.loads(bench.text())

    def expect_passed(self, station, found):
        outlet = station.outlet
        measured = {one["name"]: one for one in found["measurements"]}
        self.assertEqual((found["verdict"], found["fault"]), ("PASS", None))
        self.assertEqual(found["id"], outlet.identity["id"])
        self.assertEqual(measured["event.count"]["value"], 1)
        self.assertEqual(measured["validity.valid_share"]["value"], 100.0)
        self.assertEqual(measured["tracker.error.max"]["value"], 0.0)
        # The clock is that of the head.
        self.assertAlmostEqual(found["clock"]["drift_ppm"], 0.0, delta=10.0)
        # Every key was sent, and the bench checked the digest of the answer.
        self.assertEqual((outlet.stored[1], len(outlet.stored)), (1, len(settings.KEYS)))
        self.assertEqual((outlet.bad, outlet.dropped), (0, 0))

    def test_takes_their_hellos_settings_measurements_and_events(self):
        self.radio.outlet.stored = settings.EXAMPLE | {1: 0xFFFFFFFF}  # the next one is 1
        self.radio.outlet.say_hello()
        result = self.run_bench()
        for station, found in zip(self.stations, result["outlets"]):
            self.expect_passed(station, found)

    def test_takes_a_repeated_hello_for_no_restart_and_sees_one_whose_hello_is_lost(self):
        self.assertTrue(self.radio.until(lambda: self.radio.outlet.first))
        first_hello = self.radio.outlet.first

        def disturb(station):
            if station is self.radio:
                station.outlet.send(first_hello, True, True)
            else:
                station.outlet.start(77)
                station.outlet.hellos = 1

        self.disturb = disturb
        restarted, repeated = self.run_bench()["outlets"]
        self.assertEqual(restarted["verdict"], "ERROR")
        self.assertIn("restarted", restarted["fault"])
        self.expect_passed(self.radio, repeated)


if __name__ == "__main__":
    unittest.main()
