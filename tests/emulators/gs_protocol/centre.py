"""A centre: it identifies outlets, keeps their numbers, and logs what it accepts."""
import collections
import random

from . import messages, numbering
from .messages import Malformed

Entry = collections.namedtuple("Entry", "what outlet detail")  # detail: a Message, or of the entry


class Peer:
    """One outlet, as the centre sees it."""

    def __init__(self):
        self.start_number = None
        self.earlier = collections.deque(maxlen=16)
        self.hello = None
        self.instance = None  # of the unit that reported this id, until it departs
        self.identified = False  # this start has answered with the centre's session
        self.connected = False
        self.excluded = False
        self.hello_count = self.count = None
        self.sent = 0
        self.request = 0

    def begin(self, start_number):
        if self.start_number is not None:
            self.earlier.append(self.start_number)
        self.start_number = start_number
        self.hello_count, self.count = numbering.Count(), numbering.Count()


class Centre:
    """`send(outlet, message)`. On a serial line there is one outlet, whose name here is that of the
    port; its messages are dropped until its hello has arrived."""

    def __init__(self, send, serial=False, session=None):
        self.send = send
        self.serial = serial
        self.session = session or random.randint(1, 0xFFFFFFFF)
        self.peers = collections.defaultdict(Peer)
        self.log = []

    def note(self, what, outlet, detail=None):
        self.log.append(Entry(what, outlet, detail))

    # Sending.

    def say(self, outlet, name, *values):
        peer = self.peers[outlet]
        if peer.excluded and name != "identify":
            raise ValueError("excluded: " + outlet)
        sequence = peer.sent
        peer.sent = (peer.sent + 1) % numbering.MODULUS
        message = messages.downlink(name, sequence, self.session, *values)
        self.send(outlet, message)
        return message

    def command(self, outlet, close_relay):
        """A new request; returns its number."""
        self.peers[outlet].request += 1
        self.repeat_command(outlet, close_relay)
        return self.peers[outlet].request

    def repeat_command(self, outlet, close_relay):
        peer = self.peers[outlet]
        return self.say(outlet, "command", peer.request, close_relay, peer.start_number)

    # Receiving.

    def receive(self, outlet, data, on_hello_topic=False, retained=False):
        """A message of this outlet, or on a serial line of whatever is connected there."""
        peer = self.peers[outlet]
        if not data:
            if on_hello_topic:
                peer.connected, peer.instance = False, None
                self.note("departed", outlet)
                self.say(outlet, "identify")  # another unit with this id may be there
            return
        try:
            message = messages.read_uplink(data)
        except Malformed as error:
            return self.note("malformed", outlet, str(error))
        if message.start_number is None:
            return self.note("other version", outlet, message)
        if message.name == "hello":
            if self.is_twin(outlet, peer, message, retained):
                return
            peer.connected = peer.connected or on_hello_topic
        begins = message.start_number != peer.start_number
        if message.start_number in peer.earlier:
            return self.note("late", outlet, message)
        if begins:
            self.begin(outlet, peer, message)
        if message.name == "hello":
            return self.take_hello(outlet, peer, message, begins, retained)
        if self.serial and peer.hello is None:
            return self.note("before hello", outlet, message)
        return self.take(outlet, peer.count, message)

    def is_twin(self, outlet, peer, hello, retained):
        known, peer.instance = peer.instance, hello["instance"]
        if known not in (None, hello["instance"]):
            peer.excluded = True
            self.note("twins", outlet)
        elif known is None and not retained:
            peer.excluded = False
        return peer.excluded

    def begin(self, outlet, peer, message):
        if peer.start_number is not None:
            self.note("restart", outlet, message)
        peer.begin(message.start_number)
        peer.hello, peer.identified = None, False
        if message.name != "hello" and not peer.excluded:
            self.say(outlet, "identify")

    def take_hello(self, outlet, peer, hello, begins, retained):
        fresh = self.take(outlet, peer.hello_count, hello)
        if not fresh:
            return
        peer.hello = hello
        if self.serial:
            peer.count.first = hello["next_number"]
        peer.identified = peer.identified or hello["session"] == self.session
        if retained or begins or not (self.serial or peer.identified):
            self.say(outlet, "identify")  # on a serial line, it is repeated all the time

    def take(self, outlet, count, message):
        gap = count.accept(message.sequence)
        if gap is None:
            self.note("late", outlet, message)
            return False
        if gap and message.name != "hello":
            self.note("lost", outlet, gap)
        if message.name is None:
            self.note("unknown kind", outlet, message)
            return False
        self.note(message.name, outlet, message)
        if message == {"code": 8, "detail": self.session}:
            self.say(outlet, "identify")  # the first one was lost
        return True

    # What tests ask.

    def all(self, what, since=0):
        return [entry.detail for entry in self.log[since:] if entry.what == what]
