"""A TCP proxy that disturbs what passes, at random but from a seed: of MQTT packets and of frames.

What travels to the outlet is "down", the rest "up". `did` counts disturbances by (direction, name).
An acknowledgement counts in the direction of the message that it acknowledges."""
import collections
import heapq
import itertools
import random
import select
import socket
import threading
import time

Odds = collections.namedtuple("Odds", "redeliver hold swallow cut corrupt drop", defaults=(0.0,) * 6)
UP, DOWN = "up", "down"


class Pair:
    """A client's connection and the one to the server."""

    def __init__(self, client, server):
        self.client, self.server = client, server
        for end in (client, server):
            end.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.rest = {client: b"", server: b""}
        self.due = collections.defaultdict(float)  # by direction and topic: order is kept in each
        self.pending = {client: {}, server: {}}  # by the end that it came from: number -> topic
        self.state = {}

    def other(self, end):
        return self.server if end is self.client else self.client


class Proxy(threading.Thread):
    """Subclasses have split(data) -> (units, rest) and disturb(pair, end, unit) -> [(delay_s, topic,
    bytes)] for the units that came in at `end`; topic None waits for all that came before.
    `client` is "outlet" or "centre"; `odds` has one for each direction, or is empty."""

    def __init__(self, target_port, client, odds, seed):
        super().__init__(daemon=True)
        self.target_port, self.client = target_port, client
        self.odds = {direction: odds.get(direction, Odds()) for direction in (UP, DOWN)}
        self.random = random.Random(seed)
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.port = self.listening.getsockname()[1]
        self.pairs = {}  # by socket, those that are read
        self.made = []
        self.later = []  # heap of (due, number, end, bytes)
        self.numbers = itertools.count()
        self.did = collections.Counter()
        self.could = collections.Counter()  # units that could have been disturbed, likewise
        self.passed = 0  # messages
        self.to_go = {}  # units until the next disturbance, by direction and name
        self.seen = []  # the first packets of clients, for tests
        self.shut = False  # refuses new connections
        self.deaf = False  # accepts none, so that they wait
        self.ending = False
        self.start()

    def close(self):
        self.ending = True
        self.join()
        for pair in self.made:
            self.cut(pair)
        self.listening.close()

    def direction(self, pair, end):
        """Of what came in at this end."""
        return UP if (end is pair.client) == (self.client == "outlet") else DOWN

    def chance(self, direction, name):
        """Not left to chance altogether: the distance to the next one is half to one and a half of
        the mean."""
        odds = getattr(self.odds[direction], name)
        if not odds:
            return False
        key = direction, name
        self.could[key] += 1
        self.to_go[key] = self.to_go.get(key, self.distance(odds)) - 1.0
        if self.to_go[key] > 0.0:
            return False
        self.to_go[key] += self.distance(odds)
        self.did[key] += 1
        return True

    def distance(self, odds):
        return (0.5 + self.random.random()) / odds

    def run(self):
        while not self.ending:
            now = time.monotonic()
            wait_s = min(max(self.later[0][0] - now, 0.0), 0.05) if self.later else 0.05
            heard = [*self.pairs] if self.deaf else [self.listening, *self.pairs]
            for end in select.select(heard, [], [], wait_s)[0]:
                if end is self.listening:
                    self.accept()
                elif end in self.pairs:
                    self.read(end)
            self.send_what_is_due()

    def accept(self):
        client = self.listening.accept()[0]
        if self.shut:
            client.close()
            return
        try:
            server = socket.create_connection(("127.0.0.1", self.target_port))
        except OSError:
            client.close()
            return
        self.made.append(Pair(client, server))
        self.pairs[client] = self.pairs[server] = self.made[-1]

    def cut_all(self):
        """From any thread: both ends of each connection see it end."""
        for end in list(self.pairs):
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass

    def cut(self, pair):
        for end in (pair.client, pair.server):
            self.pairs.pop(end, None)
            end.close()

    def read(self, end):
        pair = self.pairs[end]
        try:
            data = end.recv(65536)
        except OSError:
            data = b""
        if not data:
            # What came before the end still passes.
            self.schedule(pair, end, 0.0, None, None)
            return
        units, pair.rest[end] = self.split(pair.rest[end] + data)
        for unit in units:
            if self.chance(self.direction(pair, end), "cut"):
                self.cut(pair)
                return
            for delay_s, topic, out in self.disturb(pair, end, unit):
                self.schedule(pair, end, delay_s, topic, out)

    def schedule(self, pair, end, delay_s, topic, out):
        held = pair.due.values() if topic is None else [pair.due[end, topic]]
        due = max([time.monotonic() + delay_s, *held])
        if topic is not None:
            pair.due[end, topic] = due
        if out is None:
            pair.rest[end] = b""
            self.pairs.pop(end, None)
        number = next(self.numbers)
        if isinstance(topic, bytes):
            pair.pending[end][number] = topic
        heapq.heappush(self.later, (due, number, pair.other(end), out))

    def send_what_is_due(self):
        while self.later and self.later[0][0] <= time.monotonic():
            _, number, end, out = heapq.heappop(self.later)
            pair = self.pairs.get(end)
            if pair is None:
                continue
            self.note_order(pair, pair.other(end), number)
            if out is None:
                self.cut(pair)
                continue
            try:
                end.sendall(out)
            except OSError:
                self.cut(pair)


    def note_order(self, pair, end, number):
        pending = pair.pending[end]
        topic = pending.pop(number, None)
        if any(earlier < number and other != topic for earlier, other in pending.items()):
            self.did[self.direction(pair, end), "overtake"] += topic is not None


class FrameProxy(Proxy):
    """Drops, repeats and corrupts frames, and cuts the connection within one."""

    def split(self, data):
        *frames, rest = data.split(b"\0")
        return [frame for frame in frames if frame], rest

    def disturb(self, pair, end, frame):
        self.passed += 1
        direction = self.direction(pair, end)
        if self.chance(direction, "drop"):
            return []
        if self.chance(direction, "corrupt"):
            at = self.random.randrange(len(frame))
            frame = frame[:at] + bytes([frame[at] ^ self.random.randrange(1, 256)]) + frame[at + 1:]
        whole = b"\0" + frame + b"\0"
        if self.chance(direction, "swallow"):
            whole = whole[:self.random.randrange(len(whole))]  # interrupted
        out = [(0.0, "", whole)]
        if self.chance(direction, "redeliver"):
            out.append((0.0, "", whole))
        return out


PUBLISH, PUBACK, DISCONNECT = 3, 4, 14


class MqttProxy(Proxy):
    """Redelivers PUBLISH of QoS 1, at once and later; holds one topic while others pass, and counts
    what overtakes another topic so; swallows PUBACK; cuts. An acknowledgement of a copy does not
    pass. An outlet reads one topic: nothing can overtake on the way to it."""

    LONGEST_HOLD_S = 0.1

    def split(self, data):
        packets = []
        while True:
            length, size, at = 0, 0, 1
            while at < len(data):
                length |= (data[at] & 127) << size
                size += 7
                at += 1
                if data[at - 1] < 128:
                    break
            else:
                return packets, data
            if len(data) < at + length:
                return packets, data
            packets.append((data[:at + length], at))
            data = data[at + length:]

    def disturb(self, pair, end, unit):
        packet, at = unit
        if end is pair.client and len(self.seen) < 100:
            self.seen.append(packet)
        kind = packet[0] >> 4
        if kind == PUBACK:
            return self.puback(pair, end, packet, int.from_bytes(packet[at:at + 2], "big"))
        if kind != PUBLISH:
            return [(0.0, None if kind == DISCONNECT else "control", packet)]
        self.passed += 1
        size = int.from_bytes(packet[at:at + 2], "big")
        topic = packet[at + 2:at + 2 + size]
        direction = self.direction(pair, end)
        hold_s = self.random.random() * self.LONGEST_HOLD_S if self.chance(direction, "hold") else 0.0
        out = [(hold_s, topic, packet)]
        if packet[0] & 6 == 2 and self.chance(direction, "redeliver"):
            number = packet[at + 2 + size:at + 4 + size]
            pair.state[end, int.from_bytes(number, "big")] = True
            later_s = hold_s + self.random.random() * self.LONGEST_HOLD_S
            out.append((later_s, (topic, next(self.numbers)), bytes([packet[0] | 8]) + packet[1:]))
        return out

    def puback(self, pair, end, packet, number):
        # The first of a repeated message is for its copy: both have been received by the second.
        if pair.state.pop((pair.other(end), number), False):
            return []
        acknowledged = self.direction(pair, pair.other(end))
        return [] if self.chance(acknowledged, "swallow") else [(0.0, "control", packet)]
