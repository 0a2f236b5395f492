"""An outlet written from the text at one link, and gsbench with the options that reach it."""
import json

from . import mqtt, serial_line
from .product import Bench, Broker, Folder

STATION = 'title = "Python"\nkind = "physical"\n[mqtt]\nurl = "mqtt://127.0.0.1:%d"\n'


class AtLink:
    """LINK is "serial" or "mqtt". through() may put a proxy before a port."""

    LINK = None

    def through(self, port, client):
        """`client` is "outlet" or "centre"."""
        return port

    def setUp(self):
        self.folder = Folder()
        self.addCleanup(self.folder.close)
        if self.LINK == "mqtt":
            self.broker = Broker(self.folder.path)
            self.addCleanup(self.broker.close)
            station = self.folder.write("station.toml", STATION % self.through(self.broker.port, "centre"))
            self.where = ("--station", station)
        self.station = self.new_outlet()
        self.outlet = self.station.outlet
        self.sent = []
        self.outlet.send = self.kept(self.outlet.send)

    def new_outlet(self, **identity):
        if self.LINK == "mqtt":
            station = mqtt.MqttOutlet(self.through(self.broker.port, "outlet"), **identity)
        else:
            station = serial_line.SerialOutlet(**identity)
            self.where = ("--port", "tcp://127.0.0.1:%d" % self.through(station.line.port, "centre"))
        self.addCleanup(station.close)
        return station

    def kept(self, send):
        def keep_and_send(*message):
            self.sent.append(message)
            return send(*message)
        return keep_and_send

    def send_again(self, message):
        self.outlet.send(*message)

    def bench(self, *words):
        bench = Bench(*words, *self.where)
        self.addCleanup(bench.close)
        return bench

    def devices(self):
        bench = self.bench("devices", "--json")
        self.assertTrue(self.station.until(lambda: not bench.running(), 60.0))
        code = bench.exit_code()
        return code, bench.json()

    def monitor(self, *words):
        bench = self.bench("monitor", "--json", *words)
        self.assertTrue(self.station.until(lambda: bench.out, 60.0), "the outlet did not join")
        return bench

    def measure(self, count):
        for _ in range(count):
            self.outlet.measure()
            self.station.run_for(0.004)

    def end(self, bench):
        """The objects that were printed until an error that is sent now, and the code of exit."""
        self.outlet.fail(4)
        self.assertTrue(self.station.until(lambda: any('"kind":"error"' in line for line in bench.out)))
        bench.process.terminate()
        bench.exit_code()
        return [json.loads(line) for line in bench.out]


def kinds(objects, kind):
    return [one for one in objects if one.get("kind") == kind]


def faults(objects):
    return [one["fault"] for one in objects if one["event"] == "fault"]
