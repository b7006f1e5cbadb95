// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>

namespace funicular {

/// The caller's data is wrong. The message names the argument, the first offending index and the way out.
class InvalidInput : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

} // namespace funicular
