// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_command.h"
#include "kinds/interbus/ring/master_link.h"
#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/words/cyclic_driver.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace codewheel {

class RingGuests;

// What the window asks of the bus thread, besides what a session asks its driver.
namespace command {
struct SetOut
{
    std::size_t device;
    Word word;
};
// The ring that was found (RingFound), the first one or a replacement, with its drivers: those newly made for
// it, and those that continue at another place.
struct UseRing
{
    struct Driver
    {
        std::unique_ptr<CyclicDriver> made;
        std::optional<std::size_t> before; // its index in the previous ring; empty: use the one made
    };
    RingStructure structure;
    std::vector<Word> out; // as read back
    std::vector<Driver> drivers;
};
// The user named the device: a different driver from now on, or none. No job is running.
struct SetDriver
{
    std::size_t device;
    std::unique_ptr<CyclicDriver> driver;
    QString name; // for the message
};
struct StartBus
{};
struct StopBus
{};
// Services of the master; refused with a message if the link reaches none.
struct ReadIn
{};
struct SwitchSegment
{
    int segment;
    bool on;
};
struct ConfirmDiagnostics
{};
// Of a gateway, whose outputs it blocks.
struct AcknowledgeWatchdog
{};
struct KeepConfiguration
{
    KeptConfiguration configuration;
};
// Answered by an event. On connecting, the messages say which one was found.
struct AskKeptConfiguration
{
    bool onConnecting;
};
// From now on these guests may read and write the ring; null: nobody.
struct OfferTo
{
    std::shared_ptr<RingGuests> guests;
};
} // namespace command
using Command = std::variant<command::UseRing, command::SetOut, command::StartJob, command::Proceed,
                             command::Cancel, command::SetKnown, command::SetDriver, command::StartBus,
                             command::StopBus, command::SetOperate, command::AlarmStop, command::ReadIn,
                             command::SwitchSegment, command::ConfirmDiagnostics, command::KeepConfiguration,
                             command::AskKeptConfiguration, command::OfferTo, command::AcknowledgeWatchdog>;

} // namespace codewheel
