// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

namespace codewheel {

// One place of a sound description that is put out of order, and what has to be said about it.
struct Breakage
{
    const char *from;
    const char *to;
    int line;
    const char *key;
    const char *reason; // a part of it
};

inline void PrintTo(const Breakage &breakage, std::ostream *out)
{
    *out << breakage.from << " -> " << breakage.to;
}

} // namespace codewheel
