"""An outlet without algorithms: it answers all messages, and sends what a test asks it to."""
import collections

from . import messages, numbering, settings
from .messages import Malformed

SESSIONS = 4
PAST_SESSIONS = 16  # of which the last request is remembered
IDENTITY = {"protocol_version": 3, "id": "outlet-7", "start_number": 0xC0FFEE07, "board": "python",
            "instance": 0x12345678, "firmware_version": 1000, "build": 0xDEADBEEF, "capabilities": 1,
            "sample_rate_hz": 8000, "nominal_hz": 50, "tracker_delay_s": 0.0625,
            "voltage_delay_s": 0.03125}


class Session:
    def __init__(self):
        self.count = numbering.Count()
        self.request = 0


class Outlet:
    """`send(message, on_hello, sure)` is called for each message; `sure` asks for QoS 1. It returns
    whether the link accepted the message."""

    def __init__(self, send, **identity):
        self.send = send
        self.identity = dict(IDENTITY, **identity)
        self.first = self.last = None  # messages that were sent
        self.sample = 0
        self.stored = None  # values of the settings accepted last: in non-volatile storage
        self.start(self.identity["start_number"])

    def start(self, start_number):
        self.identity["start_number"] = start_number
        self.hellos = self.sent = 0
        self.sessions = collections.OrderedDict()  # the one accepted from longest ago comes first
        self.past = {}  # session that was replaced -> its last request; the oldest comes first
        self.closed, self.cause = True, 0
        self.commanded = False
        self.reports = self.bad = self.unsent = self.dropped = 0
        self.errors = collections.Counter()
        self.relay_changes = []  # for tests: (request, closed)

    def say_hello(self, session=0):
        version, digest = self.settings_state()
        fields = [self.identity[name] for name, _ in messages.UPLINK[1][1][:12]]
        self.hellos += 1
        message = messages.uplink("hello", self.hellos - 1, self.sample, None, *fields, version, digest,
                                  session, self.sent)
        self.transmit(message, True, True)

    def say(self, name, *values):
        sequence = self.sent
        self.sent += 1
        message = messages.uplink(name, sequence, self.sample, self.identity["start_number"], *values)
        self.transmit(message, False, name != "measurement")

    def transmit(self, message, *how):
        self.first, self.last = self.first or message, message
        self.unsent += not self.send(message, *how)

    def measure(self, frequency_hz=50.0, rocof_hz_s=0.0, voltage_pu=1.0, validity=1):
        self.sample += 128
        self.reports += 1
        self.say("measurement", frequency_hz, rocof_hz_s, voltage_pu, validity)

    def settings_state(self):
        return (self.stored[1], settings.digest(self.stored)) if self.stored else (0, 0)

    def fail(self, code, detail=None):
        self.errors[code] += 1
        self.say("error", code, self.errors[code] if detail is None else detail)

    def receive_bad_frame(self):
        self.bad += 1
        self.fail(1)

    def receive(self, data):
        """The order of the section 'What an outlet does with a message'."""
        if not data:
            return
        try:
            message = messages.read_downlink(data)
            if message.name == "settings":
                message["values"] = settings.read_map(message["values"])
        except Malformed:
            self.bad += 1
            return self.fail(2)
        session = self.session_of(message)
        if session is None:
            self.dropped += 1
            return self.fail(8, message.session)
        if session.count.accept(message.sequence) is None:
            self.dropped += 1
            return None
        self.sessions.move_to_end(message.session)
        if message.name is None:
            self.bad += 1
            return self.fail(3)
        return getattr(self, "on_" + message.name.replace(" ", "_"))(session, message)

    def remember(self, number, session):
        if session.request == 0:
            return
        self.past.pop(number, None)
        if len(self.past) == PAST_SESSIONS:
            self.past.pop(next(iter(self.past)))
        self.past[number] = session.request

    def session_of(self, message):
        if message.session not in self.sessions and message.name == "identify":
            begun = Session()
            begun.request = self.past.get(message.session, 0)
            if len(self.sessions) == SESSIONS:
                self.remember(*self.sessions.popitem(last=False))
            self.sessions[message.session] = begun
        return self.sessions.get(message.session)

    def on_identify(self, _, message):
        self.say_hello(message.session)

    def on_ping(self, _, message):
        self.say("echo", message["token"])

    def on_ask_status(self, *_):
        self.say("status", self.reports, self.closed, self.cause, 0, 0, self.bad, self.unsent, self.dropped)

    def on_ask_self_test(self, *_):
        self.say("self test", 0, 0x5EED)

    def on_settings(self, _, message):
        error = settings.error_of(message["values"], self.identity["nominal_hz"], self.settings_state()[0])
        if error == 0:
            self.stored = settings.completed(message["values"])
        self.say("settings answer", error, *self.settings_state(), self.stored is not None)

    def on_command(self, session, message):
        if message["start_number"] != self.identity["start_number"]:
            self.dropped += 1
            return self.fail(9, message["request"])
        fresh = message["request"] > session.request
        changes = fresh and message["close_relay"] != self.closed
        if fresh:
            session.request = message["request"]
        if changes:
            self.closed = message["close_relay"]
            self.cause = 0 if self.closed else 3
            self.relay_changes.append((message["request"], self.closed))
        self.say("command answer", message["request"], self.closed, message.session)
        if changes:
            self.say("relay", self.closed, self.cause)
        return None
