"""The checks of a disturbed link find what they are there to find."""
import unittest

from gs_protocol import commander
from gs_protocol.centre import Entry
from gs_protocol.messages import Message


def entry(sequence, name, **fields):
    return Entry(name, "kitchen-1", Message(0, name, sequence, fields, 0, 7))


def answer(sequence, request):
    return entry(sequence, "command answer", request=request)


def relay(sequence, closed):
    return entry(sequence, "relay", closed=closed)


class Commands(unittest.TestCase):
    COMMANDED = {1: False, 2: True, 3: False}

    def doubled(self, *log):
        return commander.doubled(commander.changes_by_request(log, 7), self.COMMANDED)

    def test_that_were_carried_out_once_are_right(self):
        self.assertEqual(self.doubled(answer(0, 1), relay(1, False), answer(2, 1), entry(3, "measurement"),
                                      answer(4, 2), relay(5, True), answer(6, 3), relay(7, False)), [])

    def test_that_were_carried_out_twice_are_found(self):
        self.assertEqual(self.doubled(answer(0, 1), relay(1, False), answer(2, 2), relay(3, True),
                                      answer(4, 1), relay(5, False)), [(1, False)] * 2)

    def test_changes_without_a_command_or_against_it_are_found(self):
        self.assertEqual(self.doubled(entry(4, "measurement"), relay(5, False)), [(None, False)])
        self.assertEqual(self.doubled(answer(4, 1), relay(5, True)), [(1, True)])
        self.assertEqual(self.doubled(relay(5, True)), [], "what was lost before it may be its command")

    def test_changes_of_another_start_are_another_matter(self):
        self.assertEqual(commander.changes_by_request([answer(4, 1), relay(5, False)], 8), [])

    def test_more_changes_than_commands_are_found(self):
        commanded = [False, True, False, True]
        for relays in ([], [False], [False, True], [True, False], commanded):
            self.assertTrue(commander.is_part_of(relays, commanded))
        for relays in ([False, True, False, True, False], [True, False, True, False], [False, False, False]):
            self.assertFalse(commander.is_part_of(relays, commanded))


if __name__ == "__main__":
    unittest.main()
