"""gs-outlet whose attempt to connect again gets no answer, as from a firewall that drops packets."""
import os
import signal
import socket
import time
import unittest

from gs_protocol.product import wait
from gs_protocol.proxy import FrameProxy, MqttProxy
from gs_protocol.rig import Rig

SYN_SENT = "02"


def fill(port):
    """Connects to a listener that accepts nothing, until there is no answer any more."""
    filling = []
    while True:
        filling.append(socket.socket())
        filling[-1].settimeout(0.5)
        try:
            filling[-1].connect(("127.0.0.1", port))
        except TimeoutError:
            filling.pop().close()
            return filling


def unanswered(port):
    with open("/proc/net/tcp", encoding="ascii") as file:
        return any(row.split()[2].endswith(":%04X" % port) and row.split()[3] == SYN_SENT
                   for row in file.readlines()[1:])


class Unanswered:
    LINK = PROXY = None

    def setUp(self):
        self.rig = Rig(self.LINK, through=self.make_proxy)
        self.addCleanup(self.rig.close)

    def make_proxy(self, port, client):
        """The last one is the outlet's."""
        self.proxy = self.PROXY(port, client, {}, 1)
        self.addCleanup(self.proxy.close)
        return self.proxy.port

    def cut(self):
        self.proxy.deaf = True
        time.sleep(0.2)  # the proxy notices
        self.proxy.listening.listen(0)
        filling = fill(self.proxy.port)
        for client in filling:
            self.addCleanup(client.close)
        self.proxy.cut_all()
        self.assertTrue(wait(lambda: unanswered(self.proxy.port)))
        return filling

    def test_it_goes_on_measuring(self):
        lost = self.rig.answer("ask status", "status")["samples_lost"]
        filling = self.cut()
        self.rig.station.run_for(4.0)  # 32000 samples
        self.assertTrue(unanswered(self.proxy.port))
        for client in filling:
            client.close()
        self.proxy.listening.listen(100)
        self.proxy.deaf = False
        self.rig.mark = len(self.rig.centre.log)
        self.rig.next("measurement")
        self.assertLess(self.rig.answer("ask status", "status")["samples_lost"] - lost, 8000)

    def test_it_ends_when_it_is_asked_to(self):
        self.cut()
        os.kill(self.rig.product.process.pid, signal.SIGTERM)
        self.assertEqual(self.rig.product.process.wait(20), 0)


class UnansweredByABroker(Unanswered, unittest.TestCase):
    LINK, PROXY = "mqtt", MqttProxy


class UnansweredAtALine(Unanswered, unittest.TestCase):
    LINK, PROXY = "serial", FrameProxy


if __name__ == "__main__":
    unittest.main()
