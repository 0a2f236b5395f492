"""CBOR as the protocol uses it. cbor2 writes; reading is strict about what cbor2 hides: the width of
floats, and indefinite lengths."""
import io
import math
import struct
import sys

import cbor2


sys.setrecursionlimit(3000)  # 560 bytes nest 560 deep, and each level takes up to three calls


class Malformed(ValueError):
    pass


class F32(float):
    """A float that is written with 32 bits."""


def _write_f32(encoder, value):
    encoder.write(b"\xfa\x7f\xc0\x00\x00" if math.isnan(value) else struct.pack(">Bf", 0xFA, value))


def dumps(value):
    """Floats become 32-bit ones."""
    stream = io.BytesIO()
    encoder = cbor2.CBOREncoder(stream, default=lambda self, wrapped: _write_f32(self, wrapped.value))
    encoder.encode(_wrapped(value))
    return stream.getvalue()


class _Wrapped:
    def __init__(self, value):
        self.value = value


def _wrapped(value):
    if isinstance(value, float):
        return _Wrapped(value)
    if isinstance(value, (list, tuple)):
        return [_wrapped(item) for item in value]
    if isinstance(value, dict):
        return {key: _wrapped(item) for key, item in value.items()}
    return value


class Other:
    """A well-formed item of a type that no field has."""


class Pairs(list):
    """A map, with keys that occur twice."""


class Reader:
    def __init__(self, data):
        self.data = data
        self.at = 0

    def take(self, count):
        if self.at + count > len(self.data):
            raise Malformed("truncated")
        self.at += count
        return self.data[self.at - count:self.at]

    def head(self):
        first = self.take(1)[0]
        major, info = first >> 5, first & 31
        if info < 24:
            return major, info, info
        if info > 27:
            raise Malformed("indefinite length or reserved")
        return major, info, int.from_bytes(self.take(1 << (info - 24)), "big")

    def item(self):
        """Recursion is as deep as 560 bytes allow."""
        major, info, value = self.head()
        if major == 0:
            return value
        if major == 1:
            return -1 - value
        if major == 2:
            self.take(value)
            return Other()
        if major == 3:
            return self.take(value).decode("latin-1")
        if major == 4:
            return [self.item() for _ in range(self.counted(value))]
        if major == 5:
            return Pairs((self.item(), self.item()) for _ in range(self.counted(value)))
        if major == 6:
            self.item()
            return Other()
        if info == 24 and value < 32:
            raise Malformed("simple value in the long form")
        if info == 26:
            return F32(struct.unpack(">f", value.to_bytes(4, "big"))[0])
        return {20: False, 21: True}.get(value, Other()) if info < 24 else Other()

    def counted(self, count):
        if count > len(self.data) - self.at:
            raise Malformed("truncated")
        return count


def loads(data):
    """The item that `data` is. Raises Malformed, also if bytes follow."""
    reader = Reader(data)
    value = reader.item()
    if reader.at != len(data):
        raise Malformed("bytes follow")
    return value
