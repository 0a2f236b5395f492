"""A centre that opens and closes a relay in turn, and what the outlet's messages say of it."""
import collections
import time


class Commands(collections.namedtuple("Commands", "sent repeats changes attributed")):
    def __str__(self):
        return ("%d commands and %d repeated ones, %d changes of the relay seen, of which %d with their command"
                % self)


class Commander:
    """Each command waits for the answer to the one before. It is repeated if that does not come, and
    every fifth one also if it does, as if the answer had been lost."""

    REPEAT_S = 2.0

    def __init__(self, rig):
        self.rig = rig
        self.start = self.pending = None
        self.since = 0.0
        self.repeats = 0
        self.commanded = collections.defaultdict(dict)  # by start: request -> state

    def turn(self):
        peer, centre = self.rig.peer, self.rig.centre
        if peer.start_number != self.start:
            self.start, self.pending = peer.start_number, None
        commanded = self.commanded[self.start]
        if self.pending is None:
            close = bool(len(commanded) % 2)
            self.pending = centre.command(self.rig.name, close)
            commanded[self.pending] = close
            self.doubtful = self.pending % 5 == 0
            self.since, self.mark = time.monotonic(), len(centre.log)
        elif any(answer["request"] == self.pending and answer["session"] == centre.session
                 for answer in centre.all("command answer", self.mark)):
            if self.doubtful:
                self.repeat(commanded)
                self.doubtful = False
            else:
                self.pending = None
        elif time.monotonic() > self.since + self.REPEAT_S:
            self.repeat(commanded)

    def repeat(self, commanded):
        self.repeats += 1
        self.since, self.mark = time.monotonic(), len(self.rig.centre.log)
        self.rig.centre.repeat_command(self.rig.name, commanded[self.pending])

    def check(self, test, log):
        changes = attributed = 0
        for start, commanded in self.commanded.items():
            relays = [entry.detail["closed"] for entry in log
                      if entry.what == "relay" and entry.detail.start_number == start]
            test.assertTrue(is_part_of(relays, commanded.values()), (relays, commanded))
            carried_out = changes_by_request(log, start)
            test.assertEqual(doubled(carried_out, commanded), [])
            changes, attributed = changes + len(relays), attributed + len(carried_out)
        sent = sum(map(len, self.commanded.values()))
        test.assertGreaterEqual(self.repeats, sent // 10)
        test.assertGreaterEqual(2 * attributed, changes)
        return Commands(sent, self.repeats, changes, attributed)


def is_part_of(relays, commanded):
    """A change that nobody commanded is not in the sequence of the commands."""
    rest = iter(commanded)
    return all(closed in rest for closed in relays)


def changes_by_request(log, start):
    """(request, closed) of each relay message right after the answer to a command: the outlet numbers
    them one after the other. A request is None if another message came before. A change whose
    predecessor was lost is left out."""
    before = {entry.detail.sequence: entry for entry in log
              if getattr(entry.detail, "start_number", None) == start
              and entry.what not in ("hello", "late", "restart")}
    found = []
    for sequence, entry in before.items():
        if entry.what == "relay" and sequence - 1 in before:
            cause = before[sequence - 1]
            found.append((cause.detail["request"] if cause.what == "command answer" else None,
                          entry.detail["closed"]))
    return found


def doubled(carried_out, commanded):
    """Changes that no command explains, and those of requests that have changed the relay before."""
    wrong = [change for change in carried_out if commanded.get(change[0]) != change[1]]
    times = collections.Counter(request for request, _ in carried_out)
    return wrong + [change for change in carried_out if times[change[0]] > 1 and change not in wrong]
