"""Settings: keys, ranges, the order of the checks, and the digest."""
import math
import struct
import zlib

from . import cbor, messages
from .messages import Malformed

BIG = 1e9


def f32(value):
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


def above(low, value):
    return low < value <= BIG


def within(low, high):
    return lambda value, nominal: f32(low) <= value <= f32(high)


def positive(value, nominal):
    return above(0.0, value)


def near_nominal(value, nominal):
    return f32(0.8 * nominal) <= value <= nominal


def rows_in_range(rows, nominal):
    return bool(rows) and all(0.0 < rows[i] <= nominal and -BIG <= rows[i + 1] <= 0.0
                              for i in range(0, len(rows), 2))


def any_value(value, nominal):
    return -BIG <= value <= BIG


# key: name, type, error, range
KEYS = {
    1: ("version", "u32", 11, any_value),
    2: ("gain_hz_per_mw", "f32", 2, positive),
    3: ("sigma_per_s", "f32", 2, positive),
    4: ("discriminant_per_s2", "f32", 2, any_value),
    5: ("initial_slope_per_s", "f32", 2, positive),
    6: ("threshold_mw", "f32", 3, positive),
    7: ("largest_loss_mw", "f32", 3, positive),
    8: ("accumulated_mw", "f32", 4, within(0.0, BIG)),
    9: ("switch_off_hz", "f32", 5, near_nominal),
    10: ("conditions", "rows", 6, rows_in_range),
    11: ("condition_hits", "u16", 7, within(0, 1000)),
    12: ("rocof_samples", "u8", 7, within(2, 32)),
    13: ("event_drops", "u8", 7, within(1, 10)),
    14: ("event_drop_hz", "f32", 8, within(0.0, 1.0)),
    15: ("event_departure_hz", "f32", 8, within(0.0, 1.0)),
    16: ("lse_samples", "u8", 7, within(2, 64)),
    17: ("ekf_samples", "u8", 7, within(1, 200)),
    18: ("measurement_sigma_hz", "f32", 9, within(1e-5, 1.0)),
    19: ("loss_sigma_mw", "f32", 9, positive),
    20: ("event_lag_s", "f32", 9, within(0.0, 0.1)),
    21: ("t_x_sigma_s", "f32", 9, within(1e-4, 0.5)),
    22: ("trusted_residual_hz", "f32", 9, within(1e-4, 1.0)),
    23: ("switch_off_samples", "u8", 7, within(1, 50)),
    24: ("phase_noise_rad", "f32", 10, within(1e-5, 0.1)),
    25: ("jerk_rad_s3_per_sqrt_hz", "f32", 10, within(1e-3, 1e3)),
    26: ("innovation_gate_rad", "f32", 10, within(1e-3, 3.0)),
    27: ("innovation_gate_amplitude", "f32", 10, within(1e-3, 1.0)),
    28: ("dead_bus_pu", "f32", 10, within(0.01, 0.5)),
    29: ("method", "u8", 12, within(0, 1)),
    30: ("threshold_hz", "f32", 12, near_nominal),
    31: ("nadir_margin_hz", "f32", 12, within(0.0, 0.1)),
    32: ("decision_reports", "u8", 7, within(8, 200)),
    33: ("delay_s", "f32", 13, within(0.0, 5.0)),
    34: ("restore_hz", "f32", 13, within(0.0, 70.0)),
    35: ("restore_dwell_s", "f32", 13, within(0.0, 3600.0)),
    36: ("restore_spread_s", "f32", 13, within(0.0, 3600.0)),
}
NUMBER = {row[0]: key for key, row in KEYS.items()}

# Those of the exchange in the text.
EXAMPLE = {
    1: 1, 2: 2.0**-10, 3: 0.25, 4: 0.0625, 5: 1.25, 6: 352.0, 7: 2745.0, 8: 100.0, 9: 49.0,
    10: [49.75, -0.5, 49.5, -0.25], 11: 20, 12: 8, 13: 5, 14: 2.0**-6, 15: 2.0**-5, 16: 10, 17: 40,
    18: 2.0**-8, 19: 88.0, 20: 2.0**-7, 21: 0.0234375, 22: 0.01171875, 23: 3, 24: 2.0**-10, 25: 0.75,
    26: 0.05078125, 27: 0.0625, 28: 0.125, 29: 1, 30: 49.5, 31: 2.0**-8, 32: 40, 33: 0.125, 34: 49.75,
    35: 64.0, 36: 256.0}
REQUIRED = (1, 2, 3, 5, 6, 7, 9, 10, 19, 30)


def read_map(pairs):
    """The values by key. Raises Malformed. Values under unknown keys may be of any type."""
    values = {}
    for key, value in pairs:
        messages.typed(key, "u64")
        if key in values and key in KEYS:
            raise Malformed("key %d twice" % key)
        if key in KEYS and KEYS[key][1] == "rows":
            if not isinstance(value, list) or isinstance(value, cbor.Pairs):
                raise Malformed("conditions are no array")
            if len(value) % 2 or len(value) > 64:
                raise Malformed("%d numbers in the conditions" % len(value))
            for number in value:
                messages.typed(number, "f32")
        elif key in KEYS:
            messages.typed(value, KEYS[key][1])
        values[key] = value
    return values


def newer(version, accepted):
    return version != 0 and (accepted == 0 or 1 <= (version - accepted) % (1 << 32) < 1 << 31)


def next_version(version):
    return (version + 1) % (1 << 32) or 1


def converges(values):
    sigma, discriminant = values[3], values[4]
    tau_s = 0.5 + 0.016 * (values[16] + values[17])
    return (discriminant > -f32(sigma * sigma) and abs(discriminant) * tau_s * tau_s <= 16.0
            and sigma * tau_s <= 24.0)


def error_of(given, nominal, accepted):
    """The settings error, 0 if the values are accepted. A missing key has the example's value as its
    default, but those that are required have none."""
    if any(key not in KEYS for key in given):
        return 1
    values = completed(given)
    for key in sorted(KEYS)[1:]:
        if key not in values or not KEYS[key][3](values[key], nominal):
            return KEYS[key][2]
    from_hz = values[10][::2]
    if not converges(values):
        return 2
    if any(low >= high for high, low in zip(from_hz, from_hz[1:])):
        return 6
    if values[19] > values[7]:
        return 9
    return 0 if newer(values.get(1, 0), accepted) else 11


def completed(given):
    return {key: given[key] if key in given else EXAMPLE[key]
            for key in KEYS if key in given or key not in REQUIRED}


def words(key, value):
    if KEYS[key][1] == "rows":
        return struct.pack("<I%df" % len(value), len(value) // 2, *value)
    return struct.pack("<f" if KEYS[key][1] == "f32" else "<I", value)


def digest(values):
    """Of values for every key."""
    return zlib.crc32(b"".join(words(key, values[key]) for key in sorted(KEYS)))
