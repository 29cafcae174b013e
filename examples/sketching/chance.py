# SPDX-License-Identifier: Apache-2.0
"""Our own random numbers, so that the drawings do not change with the Python version.

Only integers and + - * / sqrt are used anywhere in this folder: these are exact on every machine,
which the sine of a maths library is not.
"""

MASK = (1 << 64) - 1


def mix(value):
    """Scrambles 64 bits (the finaliser of SplitMix64, Steele, Lea and Flood 2014)."""
    value &= MASK
    value = ((value ^ (value >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    value = ((value ^ (value >> 27)) * 0x94D049BB133111EB) & MASK
    return value ^ (value >> 31)


def seed_of(name):
    """A seed from a name (FNV-1a), so that editing one line leaves all others as they were."""
    value = 0xCBF29CE484222325
    for byte in name.encode():
        value = ((value ^ byte) * 0x100000001B3) & MASK
    return value


class Chance:
    def __init__(self, name):
        self.state = seed_of(name)

    def unit(self):
        """Uniform in [0, 1)."""
        self.state = (self.state + 0x9E3779B97F4A7C15) & MASK
        return (mix(self.state) >> 11) / (1 << 53)

    def between(self, low, high):
        return low + (high - low) * self.unit()

    def about(self, size):
        """Bell-shaped around 0; nearly always within +-size."""
        return size * (self.unit() + self.unit() + self.unit() - 1.5) / 1.5

    def happens(self, probability):
        return self.unit() < probability

    def wander(self):
        """A new slow function of one variable: about +-1, one hill or valley per unit."""
        key = mix(self.state ^ 0xA5A5A5A5)
        self.unit()

        def value(x):
            cell = int(x // 1)
            t = x - cell
            low = mix(key + cell * 0x9E3779B97F4A7C15) / MASK
            high = mix(key + (cell + 1) * 0x9E3779B97F4A7C15) / MASK
            return 2 * (low + (high - low) * t * t * (3 - 2 * t)) - 1

        return value
