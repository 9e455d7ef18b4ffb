// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <QString>

namespace codewheel {

// What a frame says by one of the protocols on CAN, in a short sentence; empty: nothing.
using FrameMeaning = QString (*)(const CanFrame &);

// Those of the kinds of bus. kinds/protocols.cpp has them.
std::span<const FrameMeaning> frameMeanings();

// By the first that knows it. Errors, and J1939, of which only the head is told, are said for all kinds.
QString frameMeaning(const CanFrame &frame);

} // namespace codewheel
