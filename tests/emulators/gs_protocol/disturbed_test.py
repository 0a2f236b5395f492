"""Links that redeliver, reorder between topics, swallow acknowledgements, corrupt and cut at random:
no command is carried out twice, no event is doubled, and no restart is invented or missed.

GS_PROTOCOL_MESSAGES is the number of messages that pass in each test; GS_PROTOCOL_SEED the seed."""
import collections
import json
import os
import time
import unittest

from gs_protocol.bench_rig import AtLink
from gs_protocol.proxy import FrameProxy, MqttProxy, Odds
from gs_protocol.rig import Rig

MESSAGES = int(os.environ.get("GS_PROTOCOL_MESSAGES", "1500"))
SEED = int(os.environ.get("GS_PROTOCOL_SEED", "1"))
MQTT_ODDS = Odds(redeliver=0.05, hold=0.02, swallow=0.05, cut=0.0015)
FRAME_ODDS = Odds(redeliver=0.02, swallow=0.01, cut=0.002, corrupt=0.01, drop=0.01)


class Commander:
    """Opens and closes the relay in turn. Each command waits for the answer to the one before, and is
    repeated if that does not come."""

    REPEAT_S = 2.0

    def __init__(self, rig):
        self.rig = rig
        self.start = self.pending = None
        self.since = 0.0
        self.commanded = collections.defaultdict(list)  # by start: the states

    def turn(self):
        peer = self.rig.peer
        if peer.start_number != self.start:
            self.start, self.pending = peer.start_number, None
        commanded = self.commanded[self.start]
        if self.pending is None:
            commanded.append(bool(len(commanded) % 2))
            self.pending = self.rig.centre.command(self.rig.name, commanded[-1])
            self.since = time.monotonic()
            self.rig.mark = len(self.rig.centre.log)
        elif any(answer["request"] == self.pending and answer["session"] == self.rig.centre.session
                 for answer in self.rig.centre.all("command answer", self.rig.mark)):
            self.pending = None
        elif time.monotonic() > self.since + self.REPEAT_S:
            self.since = time.monotonic()
            self.rig.centre.repeat_command(self.rig.name, commanded[-1])


def is_part_of(relays, commanded):
    """A change that nobody commanded, or that came twice, is not in the sequence of the commands."""
    rest = iter(commanded)
    return all(closed in rest for closed in relays)


class Changes(unittest.TestCase):
    def test_that_were_doubled_are_no_part_of_the_commands(self):
        commanded = [False, True, False, True]
        for relays in ([], [False], [False, True], [True, False], commanded):
            self.assertTrue(is_part_of(relays, commanded))
        for relays in ([False, True, False, True, False], [True, False, True, False], [False, False, False]):
            self.assertFalse(is_part_of(relays, commanded))


class Outlet:
    """gs-outlet, commanded by a centre that is written from the text."""

    def setUp(self):
        self.proxies = []
        self.rig = Rig(self.LINK, through=self.add_proxy)
        self.addCleanup(self.rig.close)

    def add_proxy(self, port):
        self.proxies.append(self.PROXY(port, self.ODDS, SEED + len(self.proxies)))
        self.addCleanup(self.proxies[-1].close)
        return self.proxies[-1].port

    def passed(self):
        return sum(proxy.passed for proxy in self.proxies)

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
        commands = changes = 0
        for start, commanded in commander.commanded.items():
            relays = [relay["closed"] for relay in self.relays()[start]]
            self.assertTrue(is_part_of(relays, commanded), (relays, commanded))
            commands, changes = commands + len(commanded), changes + len(relays)
        lost = sum(centre.all("lost"))
        self.assertGreaterEqual(changes + lost + starts, commands)
        self.assertGreater(commands, MESSAGES // 200)
        did = sum((proxy.did for proxy in self.proxies), collections.Counter())
        for name, odds in self.ODDS._asdict().items():
            self.assertGreaterEqual(did[name], int(odds > 0), name)
        print("%s: %d messages, %d commands, %d changes of the relay seen, %d restarts, %d lost; %s"
              % (self.LINK, self.passed(), commands, changes, starts - 1, lost, dict(did)))

    def relays(self):
        relays = collections.defaultdict(list)
        for relay in self.rig.centre.all("relay"):
            relays[relay.start_number].append(relay)
        return relays

    def turn(self, commander):
        for _ in range(4):
            self.rig.station.run_for(0.01)
            commander.turn()
        self.rig.ask("ping", 1)

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


class Monitor(AtLink):
    """gsbench monitor, with an outlet that is written from the text."""

    def setUp(self):
        self.proxies = []
        super().setUp()

    def through(self, port, end):
        self.proxies.append(self.PROXY(port, self.ODDS, SEED + 10 + len(self.proxies)))
        self.addCleanup(self.proxies[-1].close)
        return self.proxies[-1].port

    def test_doubles_no_event_and_sees_each_restart(self):
        bench = self.monitor("--quiet")
        events = starts = 1
        while sum(proxy.passed for proxy in self.proxies) < MESSAGES:
            self.measure(4)
            self.station.until(lambda: self.connected(bench))
            events += 1
            self.outlet.say("event", float(events), 0.0)
            if sum(proxy.passed for proxy in self.proxies) > MESSAGES * starts / 8:
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
        self.assertGreater(len(seen), events // 2)
        restarts = [one for one in objects if one["event"] == "fault" and "restarted" in one["fault"]]
        self.assertEqual(len(restarts), starts - 1, restarts)
        did = sum((proxy.did for proxy in self.proxies), collections.Counter())
        for name, odds in self.ODDS._asdict().items():
            self.assertGreaterEqual(did[name], int(odds > 0), name)
        print("%s: %d messages, %d of %d events seen, %d restarts; %s"
              % (self.LINK, sum(proxy.passed for proxy in self.proxies), len(seen), events, starts - 1,
                 dict(did)))

    def connected(self, bench):
        """Both ends: what is sent while one of them is not connected is lost."""
        broken, mended = (bench.text().count(words) for words in ("lost its broker", "connected to its broker"))
        return self.LINK != "mqtt" or (self.station.client.is_connected() and broken == mended)

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
    LINK, PROXY, ODDS = "serial", FrameProxy, FRAME_ODDS


class OutletOverMqtt(Outlet, unittest.TestCase):
    LINK, PROXY, ODDS = "mqtt", MqttProxy, MQTT_ODDS


class MonitorAtLine(Monitor, unittest.TestCase):
    LINK, PROXY, ODDS = "serial", FrameProxy, FRAME_ODDS


class MonitorAtBroker(Monitor, unittest.TestCase):
    LINK, PROXY, ODDS = "mqtt", MqttProxy, MQTT_ODDS


if __name__ == "__main__":
    unittest.main()
