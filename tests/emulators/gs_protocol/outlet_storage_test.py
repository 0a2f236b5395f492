"""gs-outlet whose flash cannot be written: it applies settings all the same, and reports error 5."""
import os
import resource
import unittest

from gs_protocol import settings
from gs_protocol.rig import Rig


class Storage:
    LINK = None

    def at(self):
        self.rig = Rig(self.LINK)
        self.addCleanup(self.rig.close)
        self.stores = 0
        self.assertEqual(self.rig.peer.hello["capabilities"] & 1, 1)

    def send(self, version):
        self.rig.mark = len(self.rig.centre.log)
        self.rig.ask("settings", settings.EXAMPLE | {1: version})
        self.rig.since_asked()
        answer, = self.rig.centre.all("settings answer", self.rig.mark)
        errors = self.rig.centre.all("error", self.rig.mark)
        self.assertEqual([error.sequence for error in errors], [answer.sequence + 1] * len(errors))
        return answer, errors

    def expect(self, version, kept, error=0, in_force=None):
        answer, errors = self.send(version)
        in_force = version if in_force is None else in_force
        self.assertEqual(answer, {"error": error, "version": in_force, "kept": kept,
                                  "digest": settings.digest(settings.EXAMPLE | {1: in_force})})
        if error == 0 and not kept:
            self.stores += 1
            self.assertEqual(errors, [{"code": 5, "detail": self.stores}])
        else:
            self.assertEqual(errors, [])
        self.assertEqual(self.rig.answer("identify", "hello")["settings_version"], in_force)

    def expect_after_restart(self, version):
        self.stores = 0
        start = self.rig.peer.start_number
        self.rig.product.restart()
        self.rig.until(lambda: self.rig.peer.start_number != start and self.rig.peer.identified)
        self.assertEqual(self.rig.peer.hello["settings_version"], version)

    def test_a_flash_that_never_takes_anything(self):
        self.at()
        resource.prlimit(self.rig.product.process.pid, resource.RLIMIT_FSIZE, (0, 0))
        self.expect(1, kept=False)
        self.expect(2, kept=False)
        self.expect(2, kept=False, error=11)
        self.expect(1, kept=False, error=11, in_force=2)
        self.expect_after_restart(0)

    def test_a_flash_that_is_full_keeps_the_settings_before(self):
        self.at()
        self.expect(1, kept=True)
        pid, size = self.rig.product.process.pid, os.path.getsize(self.rig.flash)
        resource.prlimit(pid, resource.RLIMIT_FSIZE, (size, size))
        self.expect(2, kept=False)
        self.expect(2, kept=False, error=11)
        self.expect_after_restart(1)
        self.expect(2, kept=True)
        self.expect(2, kept=True, error=11)
        self.expect_after_restart(2)

    def test_a_flash_that_has_vanished(self):
        self.at()
        self.expect(1, kept=True)
        os.remove(self.rig.flash)
        self.expect(2, kept=False)
        self.expect_after_restart(0)
        self.expect(1, kept=True)


class StorageOverSerial(Storage, unittest.TestCase):
    LINK = "serial"


class StorageOverMqtt(Storage, unittest.TestCase):
    LINK = "mqtt"


if __name__ == "__main__":
    unittest.main()
