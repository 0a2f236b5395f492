"""Links that redeliver, reorder between topics, swallow acknowledgements, corrupt and cut at random:
no command is carried out twice, no event is doubled, and no restart is invented or missed.

GS_PROTOCOL_MESSAGES is the number of messages that pass in each test; GS_PROTOCOL_SEED the seed."""
import collections
import itertools
import json
import os
import time
import unittest

from gs_protocol.bench_rig import AtLink
from gs_protocol.commander import Commander
from gs_protocol.proxy import DOWN, UP, FrameProxy, MqttProxy, Odds
from gs_protocol.rig import Rig

MESSAGES = int(os.environ.get("GS_PROTOCOL_MESSAGES", "1500"))
MESSAGES_OF_A_START = 75  # at the monitor
SEED = int(os.environ.get("GS_PROTOCOL_SEED", "1"))
PACKETS_UP = Odds(redeliver=0.05, hold=0.05, swallow=0.05, cut=0.003)
FRAMES_UP = Odds(redeliver=0.02, swallow=0.01, cut=0.002, corrupt=0.01, drop=0.01)



class Disturbed:
    """LINK, and PROXY and ODDS of the proxies."""

    def setUp(self):
        self.proxies = []
        super().setUp()

    def through(self, port, client):
        self.proxies.append(self.PROXY(port, client, self.ODDS, SEED + len(self.proxies)))
        self.addCleanup(self.proxies[-1].close)
        return self.proxies[-1].port

    def passed(self):
        return sum(proxy.passed for proxy in self.proxies)

    def check_disturbances(self):
        did = sum((proxy.did for proxy in self.proxies), collections.Counter())
        for direction, odds in self.ODDS.items():
            names = [name for name, chance in odds._asdict().items() if chance]
            for name in names:
                could = sum(proxy.could[direction, name] for proxy in self.proxies)
                # The greatest distance between two is one and a half of the mean, for each proxy.
                least = could * getattr(odds, name) / 1.5 - len(self.proxies)
                self.assertGreater(could, 0, (direction, name))
                self.assertGreaterEqual(did[direction, name], least, (direction, name))
            if (direction, self.LINK) == (UP, "mqtt"):
                names.append("overtake")
                self.assertGreaterEqual(did[direction, "overtake"], MESSAGES // 300)
            print("  %s: %s" % (direction, ", ".join("%d %s" % (did[direction, name], name) for name in names)))
        return did


class Outlet(Disturbed):
    """gs-outlet, commanded by a centre that is written from the text."""

    def setUp(self):
        super().setUp()
        self.questions = itertools.cycle((("ping", 1), ("identify",), ("ask status",)))
        self.rig = Rig(self.LINK, through=self.through)
        self.addCleanup(self.rig.close)

    def test_carries_out_no_command_twice_and_its_restarts_are_seen(self):
        commander, starts = Commander(self.rig), 1
        while self.passed() < MESSAGES:
            self.turn(commander)
            if self.passed() > MESSAGES * starts / 4:
                starts += 1
                self.restart(commander)
        self.turn_until(commander, lambda: self.relays()[self.rig.peer.start_number])
        self.rig.station.run_for(1.0)
        centre = self.rig.centre
        self.assertEqual(len(centre.all("restart")), starts - 1)
        self.assertEqual(len(self.relays()), starts)
        commands = commander.check(self, centre.log)
        lost = sum(centre.all("lost"))
        self.assertGreaterEqual(commands.changes + lost + starts, commands.sent)
        self.assertGreater(commands.sent, MESSAGES // 400)
        print("\n%s: %d messages, %s, %d restarts, %d lost" % (self.LINK, self.passed(), commands, starts - 1, lost))
        did = self.check_disturbances()
        # The copies arrived, and were found to be late.
        self.assertGreaterEqual(len(centre.all("late")), did[UP, "redeliver"] // 2)
        self.assertGreaterEqual(self.dropped, did[DOWN, "redeliver"] // 4)
        print("  late at the centre: %d, dropped by the outlet: %d" % (len(centre.all("late")), self.dropped))

    def relays(self):
        relays = collections.defaultdict(list)
        for relay in self.rig.centre.all("relay"):
            relays[relay.start_number].append(relay)
        return relays

    @property
    def dropped(self):
        """By all starts, as they reported it last."""
        last = {status.start_number: status["messages_dropped"] for status in self.rig.centre.all("status")}
        return sum(last.values())

    def turn(self, commander):
        for _ in range(4):
            self.rig.station.run_for(0.01)
            commander.turn()
        self.rig.ask(*next(self.questions))

    def turn_until(self, commander, condition):
        end = time.monotonic() + 60.0
        while not condition():
            self.assertLess(time.monotonic(), end, self.rig.centre.log[-3:])
            self.turn(commander)

    def restart(self, commander):
        """So late that the start before it was seen, with a command and its effect."""
        old = self.rig.peer.start_number
        self.turn_until(commander, lambda: self.relays()[old])
        self.rig.product.restart()
        self.turn_until(commander, lambda: self.rig.peer.start_number != old)


class Monitor(Disturbed, AtLink):
    """gsbench monitor, with an outlet that is written from the text."""

    def test_doubles_no_event_and_sees_each_restart(self):
        bench = self.monitor("--quiet")
        events = starts = 1
        while self.passed() < MESSAGES:
            self.measure(4)
            self.station.until(lambda: self.connected(bench))
            events += 1
            self.outlet.say("event", float(events), 0.0)
            self.outlet.say_hello()
            if self.passed() > MESSAGES_OF_A_START * starts:
                events = self.until_seen(bench, events)
                starts += 1
                self.outlet.start(starts)
                self.outlet.hellos = starts % 2
                self.outlet.sample = 0
                if starts % 2 == 0:
                    self.outlet.say_hello()
        events = self.until_seen(bench, events)
        bench.process.terminate()
        self.assertEqual(bench.exit_code(), 0, bench.err)
        objects = [json.loads(line) for line in bench.out]
        seen = [int(one["baseline_hz"]) for one in objects if one.get("kind") == "event"]
        self.assertEqual(seen, sorted(set(seen)), "an event was doubled")
        self.assertGreater(len(seen), events * 3 // 4)
        restarts = [one for one in objects if one["event"] == "fault" and "restarted" in one["fault"]]
        self.assertEqual(len(restarts), starts - 1, restarts)
        print("\n%s: %d messages, %d of %d events seen, %d restarts"
              % (self.LINK, self.passed(), len(seen), events, starts - 1))
        self.check_disturbances()

    def connected(self, bench):
        """Both ends: what is sent while one of them is not connected is lost."""
        broken, mended = (bench.text().count(words) for words in ("lost its broker", "connected to its broker"))
        return self.LINK != "mqtt" or (self.station.ready and broken == mended)

    def until_seen(self, bench, events):
        """Sends events until one of this start has been printed; so a start is never lost whole."""
        own = '"start_number":%d,' % self.outlet.identity["start_number"]
        for _ in range(2000):
            if any(own in line and '"kind":"event"' in line for line in bench.out):
                return events
            events += 1
            self.outlet.say("event", float(events), 0.0)
            self.station.run_for(0.02)
        self.fail("no event of this start was seen: %s" % bench.out[-3:])


class OutletOverSerial(Outlet, unittest.TestCase):
    LINK, PROXY = "serial", FrameProxy
    ODDS = {UP: FRAMES_UP, DOWN: Odds(redeliver=0.05, swallow=0.03, cut=0.006, corrupt=0.03, drop=0.03)}


class OutletOverMqtt(Outlet, unittest.TestCase):
    LINK, PROXY = "mqtt", MqttProxy
    ODDS = {UP: PACKETS_UP, DOWN: Odds(redeliver=0.2, hold=0.2, swallow=0.2, cut=0.006)}


# Hardly anything but `identify` goes down.


class MonitorAtLine(Monitor, unittest.TestCase):
    LINK, PROXY = "serial", FrameProxy
    ODDS = {UP: FRAMES_UP, DOWN: Odds(redeliver=0.3, swallow=0.2, cut=0.04, corrupt=0.2, drop=0.2)}


class MonitorAtBroker(Monitor, unittest.TestCase):
    LINK, PROXY = "mqtt", MqttProxy
    ODDS = {UP: PACKETS_UP, DOWN: Odds(redeliver=0.3, hold=0.3, swallow=0.3, cut=0.01)}


if __name__ == "__main__":
    unittest.main()
