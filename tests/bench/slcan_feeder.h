// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <string>
#include <vector>

namespace codewheel::bench {

// The frames of a full bus of 1 Mbit/s: 64 nodes with a PDO every 10 ms, and in between PDOs of others.
// Each with the microsecond at which it is through.
struct TimedFrame
{
    CanFrame frame;
    std::int64_t at = 0; // us
};
std::vector<TimedFrame> fullBus(int seconds);

// An SLCAN adapter behind a pseudo terminal in a process of its own, whose processor time does not count.
// Once it is opened it sends these frames, at their times or as fast as they are read.
class SlcanFeeder
{
public:
    enum class Pace { real, asFastAsRead };

    SlcanFeeder(const std::vector<TimedFrame> &frames, Pace pace);
    ~SlcanFeeder(); // ends the process
    SlcanFeeder(const SlcanFeeder &) = delete;
    SlcanFeeder &operator=(const SlcanFeeder &) = delete;

    const std::string &port() const { return m_port; }

private:
    std::string m_port;
    int m_process = 0;
};

} // namespace codewheel::bench
