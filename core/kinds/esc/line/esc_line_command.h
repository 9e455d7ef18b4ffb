// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_command.h"
#include "kinds/esc/driver/esc_request_driver.h"
#include "kinds/esc/line/esc_line_scan.h"

#include <memory>
#include <vector>

namespace codewheel {

// What the window asks of the line thread. A device is given by its index in the order in which they were
// added.
namespace line_command {
using namespace command;
struct AddDevice
{
    std::unique_ptr<RequestDriver> driver;
    QString name; // for the user
};
// What was typed in the terminal: sent once, in its turn.
struct Send
{
    esc::Request request;
};
// The adapter that was refused as a different one is the right one.
struct TakeOtherAdapter
{};
struct SetFractionBits // of the scaling factor, for all devices
{
    int bits;
};
struct SetSwapsWarningBytes // for one device
{
    std::size_t device;
    bool on;
};
struct Scan
{
    ScanWish wish;
};
} // namespace line_command
using EscLineCommand = AskedCommand<line_command::AddDevice, line_command::Send, line_command::Scan,
                                    line_command::TakeOtherAdapter, line_command::SetFractionBits,
                                    line_command::SetSwapsWarningBytes>;

} // namespace codewheel
