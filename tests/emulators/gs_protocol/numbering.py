"""The reader's end of one count of messages."""

MODULUS = 1 << 32


class Count:
    def __init__(self):
        self.next = None  # none yet: the first message is accepted whatever its number

    def accept(self, sequence):
        """The messages lost before this one, or None if it is late or a duplicate."""
        gap = 0 if self.next is None else (sequence - self.next) % MODULUS
        if gap >= MODULUS // 2:
            return None
        self.next = (sequence + 1) % MODULUS
        return gap
