// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/known_values.h"
#include "kinds/canopen/driver/node_plan.h"
#include "kinds/canopen/protocol/node_watch.h"
#include "kinds/canopen/protocol/pdo_mapping.h"
#include "vocabulary/instant.h"
#include "vocabulary/position_speed.h"

#include <map>

namespace codewheel::canopen {

// How a node is asked.
struct NodeTimes
{
    Instant timeOut = std::chrono::milliseconds(500);
    // Assumed: of storing, restoring and setting the position, and until a node is back after its reset.
    Instant longTimeOut = std::chrono::seconds(5);
    Instant startTimeOut = std::chrono::seconds(3);            // assumed: until a started node shows it
    Instant positionInterval = std::chrono::milliseconds(100); // where no PDO brings the position
    Instant pdoPatience = std::chrono::seconds(1);             // after the last PDO that brought one
    Instant bitsInterval = std::chrono::seconds(1);            // of alarms and warnings
    Instant silenceInterval = std::chrono::seconds(1);         // of a node that does not answer
    int silentAfter = 2; // reads in a row without an answer, each sent three times
};

// One encoder as currently known: what it shows, what it has, in which state its node is. Shared by the
// driver, which listens and polls, and by the job in progress.
class NodeEncoder
{
public:
    // The description must outlive this.
    NodeEncoder(const DeviceDescription &description, int its, const NodeTimes &how);

    const DeviceDescription &device;
    int node;
    NodeTimes settings;
    Reading reading{};
    NodeWatch watch;
    std::optional<Instant> bootedAt{};
    KnownValues values{};
    std::optional<KnownCams> cams{};
    std::vector<Event> events{};
    std::vector<Message> messages{};

    NodePlan plan() const { return {device, values.values(), cams}; }

    // As it has shown, otherwise as it was told to; empty: not known.
    std::optional<NmtState> state() const;
    // It runs, or may: its state is not known.
    bool mayRun() const;
    Refusal wouldStop() const; // to what would stop it then
    // What it sends by itself, and commands of others.
    void take(const CanFrame &frame, Instant now);
    // A command that we sent.
    void wasCommanded(NmtCommand command, Instant now);
    // It answered.
    void isHeard(Instant now);
    void fallSilent();

    // An answer to a read of this object, or a part of a PDO: every parameter that it holds is known now.
    void take(SdoObject object, const SdoOutcome &answer, Instant now);
    void take(const PdoValue &mapped, Instant now);
    PdoType pdoType(SdoObject object) const;
    void takePosition(std::int64_t position, Instant now);
    // As it is read by the description, and by the driver itself where the description does not name it.
    Value valueOf(SdoObject object, Octets octets, bool isSizeTold) const;
    // How many octets the object has: by its last answer, otherwise by its type.
    std::size_t widthOf(SdoObject object) const;

    // What was written may have changed more than itself.
    void mayHaveChanged(const NodeStep &step);
    void mayHaveChanged(SdoObject object);
    void forgetWhatCanBeWritten(); // the factory values are there, or will be
    void forgetPosition();
    void takeCams(const std::optional<KnownCams> &known); // empty: not known any more

    void tell(Instant now, Severity severity, MessageCode id, std::vector<RefusalArgument> arguments = {});
    void flush();

private:
    ObjectType typeOf(SdoObject object) const;
    void showState();
    void hasBooted(Instant now);
    void takeEmergency(const CanFrame &frame, Instant now);
    void showBits(SdoObject object, std::int64_t bits);
    void compareSpeed(std::int64_t told, Instant now);

    PositionSpeed m_speed;
    std::vector<std::pair<SdoObject, ObjectType>> m_described{}; // the objects of parameters
    std::map<std::uint32_t, std::size_t> m_widths;               // by index and subindex
    bool m_haveCamsChanged = false;
    int m_speedsAtOdds = 0; // in a row
    bool m_isSpeedTold = false;
};

} // namespace codewheel::canopen
