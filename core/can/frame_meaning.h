// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <QString>

#include <functional>
#include <vector>

namespace codewheel {

// What a frame says, in a short sentence in the language of the moment it is asked.
using FrameText = std::function<QString()>;
// What a frame says by one of the protocols on CAN; null: nothing. It is given all frames in turn, as some
// are understood only after those before them.
using FrameMeaning = std::function<FrameText(const CanFrame &)>;

// Those of the kinds of bus, which have seen no frame yet. kinds/protocols.cpp has them.
std::vector<FrameMeaning> newFrameMeanings();

// What the frames of one bus say, by the first protocol that knows it. Errors, and J1939, of which only the
// head is told, are said for all kinds.
class CanFrameMeanings
{
public:
    FrameText next(const CanFrame &frame); // never null

private:
    std::vector<FrameMeaning> m_ofKinds = newFrameMeanings();
};

} // namespace codewheel
