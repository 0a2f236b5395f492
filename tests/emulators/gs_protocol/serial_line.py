"""Serial lines over TCP: frames through a socket, and an outlet or a centre at one end."""
import os
import select
import socket
import time
import tty

from . import frames
from .centre import Centre
from .outlet import Outlet


class Pty:
    """A pseudo-terminal; the other end opens `device`. For Line, it is like a connection."""

    def __init__(self):
        self.descriptors = os.openpty()
        tty.setraw(self.descriptors[1])
        self.device = os.ttyname(self.descriptors[1])

    def fileno(self):
        return self.descriptors[0]

    def recv(self, count):
        return os.read(self.fileno(), count)

    def sendall(self, data):
        while data:
            data = data[os.write(self.fileno(), data):]

    def close(self):
        for descriptor in self.descriptors:
            os.close(descriptor)


class Line:
    """Has this connection, or listens on a free port: one peer is connected at a time, and the newest
    one counts."""

    def __init__(self, connection=None):
        self.listening = [] if connection else [socket.create_server(("127.0.0.1", 0))]
        self.port = self.listening[0].getsockname()[1] if self.listening else None
        self.connection = connection
        self.splitter = frames.Splitter()

    def close(self):
        self.hang_up()
        for listening in self.listening:
            listening.close()

    def hang_up(self):
        if self.connection is not None:
            self.connection.close()
        self.connection = None

    def write(self, data):
        """False if nobody is connected."""
        if self.connection is None:
            return False
        try:
            self.connection.sendall(data)
            return True
        except OSError:
            self.hang_up()
            return False

    def send(self, message):
        return self.write(frames.encode(message))

    def receive(self, timeout_s):
        """Messages, and None for each bad frame. Takes a new connection if there is one."""
        sockets = self.listening + ([self.connection] if self.connection else [])
        ready = select.select(sockets, [], [], timeout_s)[0]
        if any(listening in ready for listening in self.listening):
            self.hang_up()
            self.connection = self.listening[0].accept()[0]
            self.connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.splitter = frames.Splitter()
            return []
        return [message for _ in ready for message in self.read()]

    def read(self):
        try:
            data = self.connection.recv(65536)
        except OSError:
            data = b""
        if not data:
            self.hang_up()
        for frame in self.splitter.feed(data):
            try:
                yield frames.decode(frame)
            except frames.BadFrame:
                yield None


class Station:
    """What outlets and centres at any link have in common: turn() takes what has arrived and what
    `passes` does not lose."""

    def passes(self, message):
        return True

    def until(self, condition, timeout_s=20.0):
        """Takes messages until the condition holds. Returns whether it does."""
        end = time.monotonic() + timeout_s
        while not condition():
            if time.monotonic() > end:
                return False
            self.turn(0.02)
        return True

    def run_for(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.turn(0.02)


class SerialOutlet(Station):
    def __init__(self, **identity):
        self.line = Line()
        self.outlet = Outlet(lambda message, on_hello, sure: self.line.send(message), **identity)

    def close(self):
        self.line.close()

    def turn(self, timeout_s=0.0):
        for message in self.line.receive(timeout_s):
            if message is None:
                self.outlet.receive_bad_frame()
            else:
                self.outlet.receive(message)


class SerialCentre(Station):
    """Identifies every 0.5 s until a hello with its own session has arrived."""

    REPEAT_S = 0.5

    def __init__(self, session=None, line=None):
        self.line = line or Line()
        self.centre = Centre(lambda outlet, message: self.line.send(message), serial=True, session=session)
        self.bad_frames = 0
        self.next_identify = 0.0

    def close(self):
        self.line.close()

    @property
    def name(self):
        return "line"

    def identified(self):
        return self.centre.peers[self.name].identified

    def turn(self, timeout_s=0.0):
        for message in self.line.receive(timeout_s):
            if message is None:
                self.bad_frames += 1
            elif self.passes(message):
                self.centre.receive(self.name, message)
        if not self.identified() and self.line.connection and time.monotonic() >= self.next_identify:
            self.next_identify = time.monotonic() + self.REPEAT_S
            self.centre.say(self.name, "identify")
