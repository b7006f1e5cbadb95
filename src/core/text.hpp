// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace funicular {

/// A number for a sentence: three significant digits.
[[nodiscard]] inline std::string to_text(double value) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.3g", value);
    return buffer.data();
}

} // namespace funicular
