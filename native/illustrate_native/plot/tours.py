"""A short way through things with two ends each: local search by 2-opt and Or-opt.

Croes, "A method for solving traveling-salesman problems" (1958); Or (1976). A thing may be gone
through from either end. Ends are looked at again only where something beside them changed.
"""

from __future__ import annotations

import numpy as np

from .strokes import Flags, Floats, Indices

LONGEST_MOVED = 3  # things that Or-opt moves at once
LEAST_GAIN = 1e-9


def improved(first: Floats, last: Floats, home: Floats) -> tuple[Indices, Flags]:
    """The sequence of things and which are gone through backwards.

    first, last: (s, 2) where each begins and ends, in the sequence to begin with. The way begins
    at home and returns to the origin.
    """
    tour = _Tour(first, last, home)
    while tour.waiting.any():
        for edge in range(1, len(tour.waiting)):
            while tour.waiting[tour.thing[edge]]:
                if not (tour.turn_at(edge) or tour.move_from(edge)):
                    tour.waiting[tour.thing[edge]] = False
    return tour.thing[1:-1] - 1, tour.is_turned[1:-1]


class _Tour:
    """Things in sequence between two that stay: home and the origin.

    Edge i leads to thing i from the one before it.
    """

    def __init__(self, first: Floats, last: Floats, home: Floats) -> None:
        count = len(first)
        self._begin = np.array([complex(*home), *(first @ (1, 1j)), 0j])
        self._end = np.array([complex(*home), *(last @ (1, 1j)), 0j])
        self.thing = np.arange(count + 2)
        self.is_turned = np.zeros(count + 2, bool)
        self.waiting = np.ones(count + 2, bool)
        self.waiting[0] = False
        self._way = np.zeros(count + 2)
        self._measure(slice(1, count + 2))

    def _measure(self, edges: slice) -> None:
        before = slice(edges.start - 1, edges.stop - 1)
        self._way[edges] = np.abs(self._begin[edges] - self._end[before])

    def turn_at(self, edge: int) -> bool:
        """Turns round the run between this edge and another where that saves most."""
        begin, end, way = self._begin, self._end, self._way
        change = np.abs(end[:-1] - end[edge - 1]) + np.abs(begin[1:] - begin[edge])
        change -= way[1:] + way[edge]
        change[edge - 1] = 0.0
        other = int(np.argmin(change)) + 1
        if change[other - 1] >= -LEAST_GAIN:
            return False
        low, high = min(edge, other), max(edge, other)
        self._reverse(low, high)
        self._touch(low - 1, low, high - 1, high)
        return True

    def _reverse(self, low: int, high: int) -> None:
        """Turns round things low .. high - 1."""
        run = slice(low, high)
        begin = self._begin[run][::-1].copy()
        self._begin[run] = self._end[run][::-1]
        self._end[run] = begin
        self.thing[run] = self.thing[run][::-1].copy()
        self.is_turned[run] = ~self.is_turned[run][::-1]
        self._measure(slice(low, high + 1))

    def move_from(self, edge: int) -> bool:
        """Moves a short run that begins here to where that saves most."""
        for size in range(1, LONGEST_MOVED + 1):
            if edge + size < len(self.thing) and self._move(edge, edge + size):
                return True
        return False

    def _move(self, low: int, high: int) -> bool:
        """Moves things low .. high - 1."""
        begin, end, way = self._begin, self._end, self._way
        saved = way[low] + way[high] - abs(begin[high] - end[low - 1])
        if saved <= LEAST_GAIN:
            return False
        straight = np.abs(end[:-1] - begin[low]) + np.abs(begin[1:] - end[high - 1])
        turned = np.abs(end[:-1] - end[high - 1]) + np.abs(begin[1:] - begin[low])
        added = np.minimum(straight, turned) - way[1:]
        added[low - 1 : high] = np.inf
        target = int(np.argmin(added)) + 1
        if added[target - 1] - saved >= -LEAST_GAIN:
            return False
        self._shift(low, high, target, bool(turned[target - 1] < straight[target - 1]))
        return True

    def _shift(self, low: int, high: int, target: int, is_turned: bool) -> None:
        """Puts things low .. high - 1 before the one at `target`, which is not among them."""
        if is_turned:
            self._reverse(low, high)
        size = high - low
        left, right = (target, high) if target < low else (low, target)
        by = size if target < low else -size
        for array in (self._begin, self._end, self.thing, self.is_turned):
            array[left:right] = np.roll(array[left:right], by)
        self._measure(slice(left, right + 1))
        place = target if target < low else target - size
        seam = high if target < low else low
        self._touch(place - 1, place, place + size - 1, place + size, seam - 1, seam)

    def _touch(self, *places: int) -> None:
        """Things that are to be looked at again."""
        self.waiting[self.thing[list(places)]] = True
        self.waiting[0] = False
