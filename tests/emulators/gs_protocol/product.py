"""The programs under test, and a broker, as processes that end with the test."""
import json
import os
import shutil
import socket
import subprocess
import tempfile
import threading
import time

PROGRAMS = os.environ.get("GSBENCH_PROGRAMS", "../../build/release/bin")


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listening:
        return listening.getsockname()[1]


def wait(condition, timeout_s=20.0):
    end = time.monotonic() + timeout_s
    while True:
        holds = condition()
        if holds or time.monotonic() > end:
            return holds
        time.sleep(0.01)


def connected(port):
    """A connection to this port, or None."""
    try:
        return socket.create_connection(("127.0.0.1", port))
    except OSError:
        return None


def start(command, **options):
    """A process that ends with this one, however that ends. From the main thread only."""
    return subprocess.Popen(["setpriv", "--pdeathsig", "KILL", *command], **options)


def stop(process):
    if process.poll() is None:
        process.terminate()
    process.wait(20)
    for stream in (process.stdin, process.stdout):
        if stream:
            stream.close()


class Broker:
    """Mosquitto with the settings that the text asks for."""

    def __init__(self, folder):
        self.port = free_port()
        path = os.path.join(folder, "broker.conf")
        # As another user, which Mosquitto would become, it would not end with this process.
        with open(path, "w", encoding="ascii") as file:
            file.write("user root\nlistener %d 127.0.0.1\nallow_anonymous true\nmax_inflight_messages 65535\n"
                       "max_queued_messages 0\nset_tcp_nodelay true\n" % self.port)
        self.process = start([shutil.which("mosquitto") or "/usr/sbin/mosquitto", "-c", path],
                             stderr=subprocess.DEVNULL)
        if not wait(self.answers):
            raise RuntimeError("the broker did not start")

    def answers(self):
        connection = connected(self.port)
        if connection:
            connection.close()
        return connection is not None

    def close(self):
        stop(self.process)


class ProductOutlet:
    """gs-outlet with its simulated mains, and options that state link and signal."""

    def __init__(self, name, *options):
        self.command = [os.path.join(PROGRAMS, "gs-outlet"), "--id", name, *options]
        self.process = start(self.command)

    def restart(self):
        """After a loss of power."""
        self.process.kill()
        self.process.wait(20)
        self.process = start(self.command)

    def close(self):
        stop(self.process)


def at_broker(port):
    return "--mqtt", "mqtt://127.0.0.1:%d" % port


def at_line(port):
    return "--tcp", "127.0.0.1:%d" % port


class Bench:
    """A gsbench command. Its lines are collected as they come."""

    def __init__(self, *words, **environment):
        self.process = start([os.path.join(PROGRAMS, "gsbench"), *words], stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, text=True, errors="replace",
                             env=dict(os.environ, **environment))
        self.out, self.err = [], []
        self.readers = [threading.Thread(target=self.collect, args=pair)
                        for pair in ((self.process.stdout, self.out), (self.process.stderr, self.err))]
        for reader in self.readers:
            reader.start()

    @staticmethod
    def collect(stream, lines):
        for line in stream:
            lines.append(line.rstrip("\n"))

    def running(self):
        return self.process.poll() is None

    def text(self):
        return "\n".join(self.out)

    def json(self):
        return json.loads(self.text())

    def exit_code(self):
        self.process.wait(60)
        for reader in self.readers:
            reader.join()
        return self.process.returncode

    def close(self):
        stop(self.process)
        for reader in self.readers:
            reader.join()
        self.process.stderr.close()


class Folder:
    def __init__(self):
        self.path = tempfile.mkdtemp(prefix="gs_protocol-", dir="/dev/shm" if os.path.isdir("/dev/shm") else None)

    def write(self, name, text):
        path = os.path.join(self.path, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def close(self):
        shutil.rmtree(self.path, ignore_errors=True)
