"""Frames of a serial line: 00 COBS(message, CRC-32) 00."""
import zlib

LONGEST_MESSAGE = 560


class BadFrame(ValueError):
    pass


def stuff(data):
    out = bytearray()
    group = bytearray()
    for byte in data:
        if byte == 0:
            out += bytes([len(group) + 1]) + group
            group.clear()
        else:
            group.append(byte)
            if len(group) == 254:
                out += b"\xff" + group
                group.clear()
    return bytes(out) + bytes([len(group) + 1]) + bytes(group)


def unstuff(data):
    out = bytearray()
    at = 0
    while at < len(data):
        code = data[at]
        group = data[at + 1:at + code]
        if len(group) != code - 1:
            raise BadFrame("the last group is incomplete")
        out += group
        at += code
        if code != 255 and at < len(data):
            out.append(0)
    return bytes(out)


def encode(message):
    return b"\0" + stuff(message + zlib.crc32(message).to_bytes(4, "little")) + b"\0"


def decode(stuffed):
    """The message in a frame without its zeros."""
    data = unstuff(stuffed)
    if not 5 <= len(data) <= LONGEST_MESSAGE + 4:
        raise BadFrame("%d bytes" % len(data))
    message, crc = data[:-4], data[-4:]
    if zlib.crc32(message).to_bytes(4, "little") != crc:
        raise BadFrame("wrong CRC")
    return message


class Splitter:
    """Splits a stream of bytes at zeros."""

    def __init__(self):
        self.rest = b""

    def feed(self, data):
        *frames, self.rest = (self.rest + data).split(b"\0")
        return [frame for frame in frames if frame]
