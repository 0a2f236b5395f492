"""The reader's end of one count of messages."""

MODULUS = 1 << 32


class Count:
    def __init__(self):
        self.next = None  # none yet: the first message is accepted whatever its number
        self.first = None  # its number if none is missing before it, where known

    def accept(self, sequence):
        """The messages lost before this one, or None if it is late or a duplicate."""
        expected = self.first if self.next is None else self.next
        gap = 0 if expected is None else (sequence - expected) % MODULUS
        if gap >= MODULUS // 2:
            if self.next is not None:
                return None
            gap = 0
        self.next = (sequence + 1) % MODULUS
        return gap
