"""gs-outlet takes and refuses settings as the text says."""
import unittest

from gs_protocol import cbor, messages, settings
from gs_protocol.rig import OnOneRig


class Settings(OnOneRig):
    def settings(self, **values):
        """The example's, with the next version, these values by name, and None for a missing key."""
        changed = dict(settings.EXAMPLE)
        changed[1] = settings.next_version(self.version())
        for name, value in values.items():
            changed[settings.NUMBER[name]] = value
        return {key: value for key, value in changed.items() if value is not None}

    def version(self):
        answer = self.centre.all("settings answer")
        return answer[-1]["version"] if answer else 0

    def answer_to_settings(self, values):
        return self.rig.answer("settings", "settings answer", values)

    def test_settings_are_accepted_and_their_digest_agrees(self):
        values = self.settings(accumulated_mw=123.0)
        answer = self.answer_to_settings(values)
        self.assertEqual(answer, {"error": 0, "version": values[1], "digest": settings.digest(values),
                                  "kept": True})
        again = self.answer_to_settings(values)
        self.assertEqual(again, dict(answer, error=11))
        hello = self.rig.answer("identify", "hello")
        self.assertEqual((hello["settings_version"], hello["settings_digest"]),
                         (values[1], settings.digest(values)))

    def test_refusals_describe_the_settings_in_force(self):
        good = self.settings()
        accepted = self.answer_to_settings(good)
        self.assertEqual(accepted["error"], 0)
        for error, name, value in REFUSED:
            with self.subTest(name=name, value=value):
                values = self.settings(**{name: value})
                answer = self.answer_to_settings(values)
                self.assertEqual(answer, dict(accepted, error=error))

    def test_bounds_of_ranges_are_included(self):
        for name, value in INCLUDED:
            with self.subTest(name=name, value=value):
                values = self.settings(**{name: value})
                self.assertEqual(self.answer_to_settings(values),
                                 {"error": 0, "version": values[1], "digest": settings.digest(values),
                                  "kept": True})

    def test_unknown_keys_are_refused_before_anything_else(self):
        for value in (1, 1.0, "text", [1.0], {1: 2}, True):
            values = self.settings(switch_off_hz=0.0)
            values[37] = value
            self.assertEqual(self.answer_to_settings(values)["error"], 1, value)
        values = self.settings()
        values[1 << 40] = 0
        self.assertEqual(self.answer_to_settings(values)["error"], 1)

    def test_checks_are_made_in_their_order(self):
        wrong = dict(sigma_per_s=20.0, conditions=[49.5, -0.5, 49.5, -0.5], loss_sigma_mw=3000.0, version=0)
        for error, mended in ((2, dict(sigma_per_s=0.25)), (6, dict(conditions=[49.5, -0.5])),
                              (9, dict(loss_sigma_mw=88.0)), (11, {})):
            self.assertEqual(self.answer_to_settings(self.settings(**wrong))["error"], error)
            wrong.update(mended)
        self.assertEqual(self.answer_to_settings(self.settings(
            **dict(wrong, restore_hz=71.0, event_drops=0)))["error"], 7)

    def test_the_response_must_converge(self):
        # tau is 0.5 s + 3 reports of 16 ms = 0.548 s: at most 43.80 1/s, and 53.28 1/s².
        short = dict(lse_samples=2, ekf_samples=1)
        for error, name, value in ((0, "sigma_per_s", 43.7), (2, "sigma_per_s", 43.9),
                                   (0, "discriminant_per_s2", 53.2), (2, "discriminant_per_s2", 53.4),
                                   (0, "discriminant_per_s2", -0.0624), (2, "discriminant_per_s2", -0.0625)):
            answer = self.answer_to_settings(self.settings(**short, **{name: value}))
            self.assertEqual(answer["error"], error, (name, value))

    def test_versions_pass_two_to_the_32(self):
        accepted = self.answer_to_settings(self.settings())["version"]
        for version, error in ((accepted + 0x7FFFFFFF, 0), (accepted, 11), (0xFFFFFFFF, 0), (0xFFFFFFFE, 11),
                               (0, 11), (0x7FFFFFFF, 11), (1, 0), (0xFFFFFFFF, 11), (2, 0)):
            self.assertEqual(self.answer_to_settings(self.settings(version=version))["error"], error, version)

    def test_settings_without_a_required_key_are_refused(self):
        for key in settings.REQUIRED:
            name, _, error, _ = settings.KEYS[key]
            self.assertEqual(self.answer_to_settings(self.settings(**{name: None}))["error"], error, name)
        values = self.settings(method=None, delay_s=None)
        self.assertEqual(self.answer_to_settings(values)["error"], 0)

    def test_malformed_settings_are_malformed(self):
        for more in (b"\x01\x01", b"\x61x\x01", b"\x20\x01"):  # twice, a text, negative
            head = messages.downlink("settings", self.rig.peer.sent, self.centre.session)
            body = cbor.dumps(self.settings())
            data = b"\x84" + head[1:] + bytes([body[0], body[1] + 1]) + body[2:] + more
            self.assertEqual(self.rig.answer_to(data, "error")["code"], 2, more)
        for name, value in (("version", 1.0), ("gain_hz_per_mw", 1), ("conditions", [49.5]),
                            ("conditions", [49.0, -1.0] * 33), ("conditions", [49, -1.0]), ("method", True),
                            ("rocof_samples", 256), ("condition_hits", 65536), ("method", -1)):
            with self.subTest(name=name, value=value):
                head = messages.downlink("settings", self.rig.peer.sent, self.centre.session,
                                         self.settings(**{name: value}))
                self.assertEqual(self.rig.answer_to(head, "error")["code"], 2)


REFUSED = [
    (2, "gain_hz_per_mw", 0.0), (2, "sigma_per_s", -1.0), (2, "discriminant_per_s2", -0.0625),
    (2, "discriminant_per_s2", 10.0), (2, "sigma_per_s", 19.0), (2, "initial_slope_per_s", 0.0),
    (2, "gain_hz_per_mw", float("nan")), (2, "sigma_per_s", float("inf")), (2, "gain_hz_per_mw", 2e9),
    (3, "threshold_mw", 0.0), (3, "largest_loss_mw", 0.0), (3, "threshold_mw", 1.1e9),
    (4, "accumulated_mw", -1.0), (4, "accumulated_mw", 1.1e9), (5, "switch_off_hz", 39.99),
    (5, "switch_off_hz", 50.01), (6, "conditions", []), (6, "conditions", [50.01, -0.5]),
    (6, "conditions", [0.0, -0.5]), (6, "conditions", [49.0, 0.1]), (6, "conditions", [49.0, -0.5, 49.0, -0.5]),
    (6, "conditions", [49.0, -1.1e9]), (7, "condition_hits", 1001), (7, "rocof_samples", 1),
    (7, "rocof_samples", 33), (7, "event_drops", 0), (7, "event_drops", 11), (7, "lse_samples", 1),
    (7, "lse_samples", 65), (7, "ekf_samples", 0), (7, "ekf_samples", 201), (7, "switch_off_samples", 0),
    (7, "switch_off_samples", 51), (7, "decision_reports", 7), (7, "decision_reports", 201),
    (8, "event_drop_hz", -0.01), (8, "event_drop_hz", 1.01), (8, "event_departure_hz", 1.01),
    (9, "measurement_sigma_hz", 0.9e-5), (9, "measurement_sigma_hz", 1.1), (9, "loss_sigma_mw", 0.0),
    (9, "loss_sigma_mw", 2746.0), (9, "event_lag_s", -0.01), (9, "event_lag_s", 0.11),
    (9, "t_x_sigma_s", 0.9e-4), (9, "t_x_sigma_s", 0.51), (9, "trusted_residual_hz", 1.1),
    (10, "phase_noise_rad", 0.9e-5), (10, "phase_noise_rad", 0.11), (10, "jerk_rad_s3_per_sqrt_hz", 0.0009),
    (10, "jerk_rad_s3_per_sqrt_hz", 1001.0), (10, "innovation_gate_rad", 3.1),
    (10, "innovation_gate_amplitude", 1.1), (10, "dead_bus_pu", 0.009), (10, "dead_bus_pu", 0.51),
    (11, "version", 0), (12, "method", 2), (12, "threshold_hz", 39.99), (12, "threshold_hz", 50.01),
    (12, "nadir_margin_hz", 0.11), (12, "nadir_margin_hz", -0.01), (13, "delay_s", 5.1), (13, "delay_s", -0.1),
    (13, "restore_hz", 70.1), (13, "restore_dwell_s", 3601.0), (13, "restore_spread_s", -1.0)]

INCLUDED = [
    ("switch_off_hz", 40.0), ("switch_off_hz", 50.0), ("threshold_hz", 40.0), ("threshold_hz", 50.0),
    ("conditions", [50.0, 0.0]), ("conditions", [value for row in range(32) for value in (50.0 - row, -0.5)]),
    ("condition_hits", 0), ("condition_hits", 1000), ("rocof_samples", 2), ("rocof_samples", 32),
    ("event_drops", 1), ("event_drops", 10), ("event_drop_hz", 0.0), ("event_drop_hz", 1.0),
    ("lse_samples", 2), ("lse_samples", 64), ("ekf_samples", 1), ("ekf_samples", 200),
    ("measurement_sigma_hz", 1e-5), ("measurement_sigma_hz", 1.0), ("loss_sigma_mw", 2745.0),
    ("event_lag_s", 0.0), ("event_lag_s", 0.1), ("t_x_sigma_s", 1e-4), ("t_x_sigma_s", 0.5),
    ("phase_noise_rad", 1e-5), ("phase_noise_rad", 0.1), ("jerk_rad_s3_per_sqrt_hz", 1e-3),
    ("jerk_rad_s3_per_sqrt_hz", 1e3), ("innovation_gate_rad", 1e-3), ("innovation_gate_rad", 3.0),
    ("dead_bus_pu", 0.01), ("dead_bus_pu", 0.5), ("nadir_margin_hz", 0.0), ("nadir_margin_hz", 0.1),
    ("decision_reports", 8), ("decision_reports", 200), ("delay_s", 0.0), ("delay_s", 5.0),
    ("restore_hz", 0.0), ("restore_hz", 70.0), ("restore_dwell_s", 3600.0), ("accumulated_mw", 0.0),
    ("accumulated_mw", 1e9), ("largest_loss_mw", 1e9), ("discriminant_per_s2", -0.06)]


class SettingsOverSerial(Settings, unittest.TestCase):
    LINK = "serial"


class SettingsOverMqtt(Settings, unittest.TestCase):
    LINK = "mqtt"


if __name__ == "__main__":
    unittest.main()
