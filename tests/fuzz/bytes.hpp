// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace funicular::fuzz {

/// Choices and numbers from the bytes of a fuzzer, front to back; zeros when they are used up. One choice is
/// one byte (a finite number two), so that a change of a byte is a small change of the scene.
class Bytes {
public:
    Bytes(const std::uint8_t *data, std::size_t size) : next_(data), end_(data + size) {}

    /// A whole number in [least, most], which are less than 256 apart; `least` when the bytes are used up.
    int between(int least, int most) { return least + (most > least ? byte() % (most - least + 1) : 0); }
    /// True for one byte value in `chances`, and never when the bytes are used up.
    bool one_in(int chances) { return byte() % chances == chances - 1; }
    /// In [0, 1].
    double unit() { return sixteen_bits() / 65535.0; }

    /// In [-1, 1], with the values that numbers go wrong at among them.
    double coordinate() {
        static constexpr std::array special{0.0,
                                            1.0,
                                            -1.0,
                                            1e-13,
                                            1e-300,
                                            1e300,
                                            std::numeric_limits<double>::infinity(),
                                            std::numeric_limits<double>::quiet_NaN()};
        if (one_in(128))
            return special[byte() % special.size()];
        // Of a few values, so that nodes coincide and members are parallel now and then.
        if (one_in(4))
            return between(-4, 4) / 4.0;
        return 2 * unit() - 1;
    }

    /// Ten to the power of something between the exponents; zero, negative and not finite now and then.
    double magnitude(int least, int most) {
        switch (const std::uint8_t kind = byte(); kind) {
        case 255:
            return std::numeric_limits<double>::infinity();
        case 254:
            return std::numeric_limits<double>::quiet_NaN();
        case 253:
            return -1;
        case 252:
            return 0;
        default:
            return std::pow(10.0, least + (most - least) * (kind / 251.0));
        }
    }

private:
    std::uint8_t byte() { return next_ == end_ ? 0 : *next_++; }
    int sixteen_bits() {
        const int high = byte();
        return 256 * high + byte();
    }

    const std::uint8_t *next_;
    const std::uint8_t *end_;
};

} // namespace funicular::fuzz
