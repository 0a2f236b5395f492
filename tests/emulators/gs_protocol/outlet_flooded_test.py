"""gs-outlet on a serial line whose centre sends without a pause."""
import os
import signal
import threading
import unittest

from gs_protocol import frames
from gs_protocol.rig import Rig

AT_ONCE = 1000


class Flooded(unittest.TestCase):
    def setUp(self):
        self.rig = Rig("serial")
        self.addCleanup(self.rig.close)
        self.ended = False
        self.sent = 0

    def flood(self):
        """Sends the same message again and again: each copy is dropped, without an answer."""
        self.rig.mark = len(self.rig.centre.log)
        copies = frames.encode(self.rig.centre.say(self.rig.name, "identify")) * AT_ONCE
        self.rig.next("hello")
        connection = self.rig.station.line.connection
        self.flooding = threading.Thread(target=self.send, args=(connection, copies))
        self.flooding.start()
        self.addCleanup(self.stop)

    def send(self, connection, copies):
        try:
            while not self.ended:
                connection.sendall(copies)
                self.sent += AT_ONCE
        except OSError:
            pass  # the outlet has ended

    def stop(self):
        self.ended = True
        self.flooding.join()

    def test_it_goes_on_measuring_and_takes_every_message(self):
        before = self.rig.answer("ask status", "status")
        self.flood()
        self.rig.until(lambda: self.sent > 10 * AT_ONCE)
        self.rig.mark = len(self.rig.centre.log)
        self.rig.next("measurement", 50)
        self.assertTrue(self.flooding.is_alive())
        self.stop()
        after = self.rig.answer("ask status", "status")
        self.assertEqual(after["messages_dropped"] - before["messages_dropped"], self.sent)
        self.assertEqual(after["messages_bad"], before["messages_bad"])
        self.assertLess(after["samples_lost"] - before["samples_lost"], 8000)

    def test_it_ends_when_it_is_asked_to(self):
        self.flood()
        self.rig.until(lambda: self.sent > 100 * AT_ONCE)
        os.kill(self.rig.product.process.pid, signal.SIGTERM)
        self.assertEqual(self.rig.product.process.wait(20), 0)


if __name__ == "__main__":
    unittest.main()
