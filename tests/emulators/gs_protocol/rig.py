"""gs-outlet at one link, and a centre written from the text at the other end."""
import os

from . import mqtt, serial_line
from .product import Broker, Folder, ProductOutlet, at_broker, at_line

NAME = "kitchen-1"


class Rig:
    """One outlet at one link, and a centre that knows it."""

    def __init__(self, link, *options, through=lambda port, client: port):
        """`through` returns the port in place of that of the broker or the line, for the client
        "outlet"; of the broker also for the first "centre"."""
        self.folder = Folder()
        self.broker = Broker(self.folder.path) if link == "mqtt" else None
        self.station = (mqtt.MqttCentre(through(self.broker.port, "centre"), "first") if self.broker
                        else serial_line.SerialCentre())
        self.more = []
        self.mark = 0  # in the centre's log
        self.centre = self.station.centre
        self.name = NAME if self.broker else self.station.name
        where = at_broker if self.broker else at_line
        port = through((self.broker or self.station.line).port, "outlet")
        self.flash = os.path.join(self.folder.path, "flash")
        self.product = ProductOutlet(NAME, *where(port), *(options or ("--flash", self.flash)))
        self.until(self.station_is_identified)
        self.until(lambda: len(self.centre.all("measurement")) > 1)

    def new_centre(self, client_id):
        return mqtt.MqttCentre(self.broker.port, client_id)

    def another(self, client_id="second"):
        self.more.append(self.new_centre(client_id))
        return self.more[-1]

    def station_is_identified(self):
        return self.peer.identified

    @property
    def peer(self):
        return self.centre.peers[self.name]

    def until(self, condition):
        if not self.station.until(condition):
            raise AssertionError("the outlet did not answer; log: %s" % self.centre.log[-20:])

    def send(self, data):
        self.centre.send(self.name, data)

    def ask(self, what, *values):
        self.centre.say(self.name, what, *values)

    def next(self, what, count=1):
        """Runs until so many entries of this name are in the log since `mark`; returns them."""
        self.until(lambda: len(self.centre.all(what, self.mark)) >= count)
        return self.centre.all(what, self.mark)

    def answer(self, what, name, *values):
        self.mark = len(self.centre.log)
        self.ask(what, *values)
        return self.next(name)[0]

    def answer_to(self, data, name):
        self.mark = len(self.centre.log)
        self.send(data)
        return self.next(name)[0]

    def since_asked(self, *names):
        """What came up to an echo that is asked for now: all answers before it have arrived."""
        self.ask("ping", 424242)
        self.until(lambda: {"token": 424242} in self.centre.all("echo", self.mark))
        return [entry for entry in self.centre.log[self.mark:] if entry.what in names]

    def close(self):
        for what in (self.product, self.station, *self.more, self.broker, self.folder):
            if what is not None:
                what.close()


class OnOneRig:
    """Tests with one outlet for all, at LINK: "serial" or "mqtt"."""

    LINK = None

    @classmethod
    def setUpClass(cls):
        cls.rig = Rig(cls.LINK)

    @classmethod
    def tearDownClass(cls):
        cls.rig.close()

    def setUp(self):
        self.centre = self.rig.centre
        self.rig.mark = len(self.centre.log)

    def status(self):
        return self.rig.answer("ask status", "status")
