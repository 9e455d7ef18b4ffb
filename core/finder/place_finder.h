// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/found.h"

namespace codewheel {

// Looks who is at one place. Each next() does one step, so its caller can show what it does, and stop. It
// writes nothing to a device.
class PlaceFinder
{
public:
    virtual ~PlaceFinder() = default;

    virtual bool isDone() const = 0;
    virtual FinderNews next() = 0;
    // Nothing more is sent; done after the present step. Any thread.
    virtual void interrupt() = 0;
};

} // namespace codewheel
