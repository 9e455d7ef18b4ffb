// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_command.h"
#include "kinds/canopen/driver/node_driver.h"
#include "kinds/canopen/protocol/lss_client.h"

#include <memory>

namespace codewheel {

// What the window asks of the thread of a bus. A device is given by its index in the order in which they were
// added.
namespace canopen_command {
using namespace command;
struct AddNode
{
    std::unique_ptr<canopen::NodeDriver> driver;
};
// The user agrees that frames are sent beside another master.
struct SendBesideOthers
{};
struct TakeUnsureWatch
{};
// The user agrees that the next job stops this node for a moment.
struct MayStopNode
{
    std::size_t device;
};
// By hand, each once, in its turn.
struct Send
{
    CanFrame frame;
};
struct Transfer
{
    canopen::SdoRequest request;
};
struct Configure
{
    canopen::LssRequest request;
};
struct CancelConfigure
{};
struct Scan
{};
} // namespace canopen_command
using CanopenCommand =
    AskedCommand<canopen_command::AddNode, canopen_command::SendBesideOthers,
                 canopen_command::TakeUnsureWatch, canopen_command::MayStopNode, canopen_command::Send,
                 canopen_command::Transfer, canopen_command::Configure, canopen_command::CancelConfigure,
                 canopen_command::Scan>;

} // namespace codewheel
