// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_command.h"
#include "kinds/esc/driver/esc_request_driver.h"
#include "kinds/esc/line/esc_line_scan.h"

#include <memory>
#include <variant>
#include <vector>

namespace codewheel {

// What the window asks of the line thread. A device is given by its index in the order in which they were
// added.
namespace line_command {
using command::AlarmStop;
using command::Cancel;
using command::CancelScan;
using command::Proceed;
using command::RemoveDevice;
using command::SetKnown;
using command::SetOperate;
using command::SetRunning;
using command::StartJob;
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
using EscLineCommand =
    std::variant<line_command::StartJob, line_command::Proceed, line_command::Cancel, line_command::SetKnown,
                 line_command::AddDevice, line_command::RemoveDevice, line_command::SetRunning,
                 line_command::SetOperate, line_command::AlarmStop, line_command::Send, line_command::Scan,
                 line_command::CancelScan, line_command::TakeOtherAdapter, line_command::SetFractionBits,
                 line_command::SetSwapsWarningBytes>;

} // namespace codewheel
