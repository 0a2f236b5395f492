"""Kinds of messages, their fields and ranges."""
import math

from . import cbor
from .cbor import Malformed

LONGEST = 560
HELLO = 1

TOP = {"u8": 0xFF, "u16": 0xFFFF, "u32": 0xFFFFFFFF, "u64": 0xFFFFFFFFFFFFFFFF}
CAUSE, TRUST = ("enum", 3), ("enum", 5)

UPLINK = {
    1: ("hello", [("protocol_version", "u16"), ("id", ("text", 32)), ("start_number", "u32"),
                  ("board", ("text", 16)), ("instance", "u32"), ("firmware_version", "u32"),
                  ("build", "u32"), ("capabilities", "u32"), ("sample_rate_hz", "i32"),
                  ("nominal_hz", "i32"), ("tracker_delay_s", "f32"), ("voltage_delay_s", "f32"),
                  ("settings_version", "u32"), ("settings_digest", "u32"), ("session", "u32"),
                  ("next_number", "u32")]),
    2: ("settings answer", [("error", ("enum", 13)), ("version", "u32"), ("digest", "u32"),
                            ("kept", "bool")]),
    3: ("measurement", [("frequency_hz", "f32"), ("rocof_hz_s", "f32"), ("voltage_pu", "f32"),
                        ("validity", ("enum", 2))]),
    4: ("event", [("baseline_hz", "f32"), ("baseline_rocof_hz_s", "f32")]),
    5: ("LSE", [("loss_mw", "f32")]),
    6: ("estimate", [("loss_mw", "f32"), ("loss_sigma_mw", "f32"), ("loss_instant_s", "f32"),
                     ("trust", TRUST)]),
    7: ("decision", [("loss_mw", "f32"), ("loss_sigma_mw", "f32"), ("nadir_hz", "f32"),
                     ("required_mw", "f32"), ("shed_before_mw", "f32"), ("hits", "u16"),
                     ("trust", TRUST), ("shed", "bool")]),
    8: ("relay", [("closed", "bool"), ("cause", CAUSE)]),
    9: ("aborted", []),
    10: ("command answer", [("request", "u32"), ("closed", "bool"), ("session", "u32")]),
    11: ("status", [("reports", "u32"), ("relay_closed", "bool"), ("cause", CAUSE),
                    ("phase", ("enum", 2)), ("samples_lost", "u32"), ("messages_bad", "u32"),
                    ("messages_unsent", "u32"), ("messages_dropped", "u32")]),
    12: ("self test", [("failed", "u32"), ("fingerprint", "u32")]),
    13: ("echo", [("token", "u32")]),
    14: ("error", [("code", ("enum", 9)), ("detail", "u32")]),
}

DOWNLINK = {
    1: ("settings", [("values", "map")]),
    2: ("command", [("request", "u32"), ("close_relay", "bool"), ("start_number", "u32")]),
    3: ("identify", []),
    4: ("ask status", []),
    5: ("ask self test", []),
    6: ("ping", [("token", "u32")]),
}


class Message(dict):
    """Fields by name; `name` of the kind, or None if it is unknown. `head` as a tuple."""

    def __init__(self, kind, name, sequence, fields, sample=None, start_number=None, session=None):
        super().__init__(fields)
        self.kind, self.name, self.sequence = kind, name, sequence
        self.sample, self.start_number, self.session = sample, start_number, session


def kind_of(table, name):
    return next(kind for kind, row in table.items() if row[0] == name)


def typed(value, kind):
    """The value if it is of the type; else raises Malformed."""
    whole = isinstance(value, int) and not isinstance(value, bool)
    if kind == "i32":
        right = whole and -(1 << 31) <= value < 1 << 31
    elif kind == "f32":
        right = isinstance(value, float)
    elif kind == "bool":
        right = isinstance(value, bool)
    elif kind == "map":
        right = isinstance(value, cbor.Pairs)
    elif kind[0] == "text":
        right = isinstance(value, str) and len(value) <= kind[1] and all(" " <= c <= "~" for c in value)
    else:
        right = whole and 0 <= value <= (kind[1] if kind[0] == "enum" else TOP[kind])
    if not right:
        raise Malformed("%r is not of type %s" % (value, kind))
    return value


def opened(data, head):
    if len(data) > LONGEST:
        raise Malformed("%d bytes" % len(data))
    items = cbor.loads(data)
    if not isinstance(items, list) or isinstance(items, cbor.Pairs) or len(items) < len(head):
        raise Malformed("no head")
    for item, kind in zip(items, head):
        typed(item, kind)
    return items


def fields_of(items, at, fields):
    if len(items) < at + len(fields):
        raise Malformed("a field is missing")
    return {name: typed(value, kind) for (name, kind), value in zip(fields, items[at:])}


def check_hello(hello):
    letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_."
    right = (hello["id"] and all(c in letters for c in hello["id"])
             and 1000 <= hello["sample_rate_hz"] <= 1000000 and hello["nominal_hz"] in (50, 60)
             and 0.0 <= hello["tracker_delay_s"] <= 1.0 and 0.0 <= hello["voltage_delay_s"] <= 1.0)
    if not right:
        raise Malformed("a field of hello is out of its range")


def read_uplink(data):
    """Raises Malformed. Of another version's hello only protocol_version and id are read."""
    kind, sequence, sample = opened(data, ("u64", "u32", "u64"))[:3]
    items = cbor.loads(data)
    if kind == HELLO:
        if fields_of(items, 3, UPLINK[1][1][:1])["protocol_version"] != 3:
            return Message(kind, "hello", sequence, fields_of(items, 3, UPLINK[1][1][:2]), sample)
        hello = fields_of(items, 3, UPLINK[1][1])
        check_hello(hello)
        return Message(kind, "hello", sequence, hello, sample, hello["start_number"])
    start_number = opened(data, ("u64", "u32", "u64", "u32"))[3]
    name, fields = UPLINK.get(kind, (None, []))
    return Message(kind, name, sequence, fields_of(items, 4, fields), sample, start_number)


def read_downlink(data):
    """Raises Malformed. Values of settings are checked in settings.py."""
    items = opened(data, ("u64", "u32", "u32"))
    kind, sequence, session = items[:3]
    name, fields = DOWNLINK.get(kind, (None, []))
    message = Message(kind, name, sequence, fields_of(items, 3, fields), session=session)
    if session == 0 or message.get("request") == 0:
        raise Malformed("session or request 0")
    return message


def uplink(name, sequence, sample, start_number, *values):
    head = [kind_of(UPLINK, name), sequence, sample]
    return cbor.dumps(head + ([] if name == "hello" else [start_number]) + list(values))


def downlink(name, sequence, session, *values):
    return cbor.dumps([kind_of(DOWNLINK, name), sequence, session, *values])


def same(left, right):
    """Equality in which NaN equals NaN."""
    both = isinstance(left, float) and isinstance(right, float)
    return left == right or (both and math.isnan(left) and math.isnan(right))
