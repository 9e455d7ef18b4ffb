// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "vocabulary/refusal.h"

#include <optional>
#include <vector>

namespace codewheel {

class EncoderBus;
struct Fault;
struct Participant;

// One step on the way of the data from an encoder to the screen: what is expected there, and what came.
struct DataCheck
{
    enum class Id : std::uint8_t {
        link,     // connected
        gateway,  // answers
        running,  // the bus exchanges data, or is polled
        reached,  // the device is there, and not cut off
        master,   // reports no fault of it
        kind,     // it is the planned one
        bytes,    // come at all
        sense,    // they make sense
        echo,     // they are more than our own request
        answer,   // the encoder answers
        upToDate, // what came last
        order,    // of the bytes of a word
        alarms,   //
        state,    // that the encoder reports
        position, //
        devices,  // all of the bus
        writing,  // is allowed
    };
    enum class Outcome : std::uint8_t {
        asExpected,
        remark, // worth knowing; the data comes all the same
        differs,
        notKnown, // because of what differs before, or since nobody tells
    };
    // What can be done from here.
    enum class Action : std::uint8_t {
        none,
        connectBus,
        connection, // its page
        start,
        operate,
        compare,
        registers, // of a gateway
        confirm,   // the diagnostics
        search,    // for encoders on the bus
        monitor,
        positionMode, // the user knows that the encoder is in it
        startNode,    // the encoder itself, which does not run
    };

    Id id = Id::link;
    Outcome outcome = Outcome::asExpected;
    QString what{};
    QString expected{};
    QString came{};
    QString remedy{}; // what is wrong, and what to do; empty as expected
    Action action = Action::none;
    std::optional<Refusal> why{}; // where the computer may tell more about it

    friend bool operator==(const DataCheck &, const DataCheck &) = default;
};
using DataChecks = std::vector<DataCheck>; // in the order in which data travels

// A step before it is known what came.
struct DataStep
{
    DataCheck::Id id;
    QString what;
    QString expected;

    DataCheck passed() const { return passed(expected); }
    DataCheck passed(const QString &came) const;
    DataCheck failed(const QString &came, const QString &remedy,
                     DataCheck::Action action = DataCheck::Action::none) const;
    DataCheck remark(const QString &came, const QString &remedy,
                     DataCheck::Action action = DataCheck::Action::none) const;
    // Failed, or a remark, by its role.
    DataCheck faulty(const Fault &fault) const;
};

// Nothing is known of what is behind the first that differs, except whether writing is allowed.
DataChecks asFarAsKnown(DataChecks checks);
// Null: everything is as expected.
const DataCheck *firstDifference(const DataChecks &checks);
const DataCheck *findCheck(const DataChecks &checks, DataCheck::Id id); // null: not among them

// The steps that every bus has.
//
// `expected`: how it is connected; `refused`: why it could not be, when that was last tried.
DataCheck notConnectedCheck(const QString &expected, const std::optional<Refusal> &refused);
DataCheck linkCheck(const EncoderBus &bus, const QString &expected);
QString kindText(const EncoderBus &bus, const Participant &device); // "FRABA OCD-IB K3, 37h"
DataCheck kindCheck(const EncoderBus &bus, NodeId node, const std::vector<Participant> &planned,
                    QString (*text)(const EncoderBus &, const Participant &) = kindText);
DataCheck upToDateCheck(const EncoderBus &bus, NodeId node);
DataCheck stateCheck(const EncoderBus &bus, NodeId node);
DataCheck positionCheck(const EncoderBus &bus, NodeId node);
DataCheck writingCheck(const EncoderBus &bus);
// Those of its devices that report a fault. Without a device, no data comes.
DataCheck devicesCheck(const EncoderBus &bus);

} // namespace codewheel
