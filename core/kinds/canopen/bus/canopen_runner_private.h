// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asking_work.h"
#include "can/can_load.h"
#include "kinds/canopen/bus/canopen_runner.h"
#include "kinds/canopen/protocol/cob_id.h"

#include <array>
#include <deque>
#include <map>
#include <set>

namespace codewheel {

struct CanopenWork final
    : AskingWork<CanopenCommand, CanopenEvent, CanopenSnapshot, CanLink, canopen::NodeDriver>
{
    // A frame to be sent, and whose it is.
    struct Outgoing
    {
        enum class By : std::uint8_t { transfer, driver, typed, scan, configuration, alarmStop };

        CanFrame frame;
        By by = By::typed;
        int node = 0; // of transfer, driver, scan
        Instant at{}; // when the link took it
        bool isAutomatic = false;
        std::uint64_t number = 0; // that the client of a transfer or a configuration has given it
    };

    // What is kept of each number that was heard, or has a driver, or was asked by hand.
    struct Node
    {
        explicit Node(int number)
            : client(canopen::SdoIdentifiers::predefined(number))
            , watch(number)
        {}

        canopen::SdoClient client;
        canopen::NodeWatch watch;
        std::optional<std::size_t> device{};           // that has this number
        std::optional<canopen::NodeRequest> request{}; // of its driver, under way
        std::deque<canopen::SdoRequest> typed{};       // the first one may be under way
        bool isTypedUnderWay = false;                  //
        bool isPollUnderWay = false;                   // as it was sent; a job may have begun since
        int typedFrames = 0;                           // SDO requests by hand that may be answered
        Instant dueAt = Instant::max();                // it may want to send something
        bool answers = true;                           // the last request was answered
        std::map<int, std::uint32_t> pdos{};           // identifiers that were read; 0: it is off
        std::optional<Instant> heardAt{};
        canopen::Heartbeat heartbeat = canopen::Heartbeat::notHeard; // as told
        bool isDoubledTold = false;                                  // since it has booted
    };

    CanopenWork(CanLink &usedLink, int usedRate, CanUse usedFirst, Mail &usedMail);
    void turn(Instant until) override;
    void slept(std::chrono::milliseconds duration) override;
    void step(Instant until) override;
    Result<void> mayStart(const canopen::NodeDriver &driver, const Job &job) const override;
    Place placeOf(const canopen::NodeDriver &driver) const override;
    void driverHasTold() override { publish(); }
    void show(std::size_t device, AskedDevice &shown) const override;
    void complete(CanopenSnapshot &made) override;

    // canopen_runner_commands.cpp
    using AskingWork::carryOut;
    void carryOutNext(CanopenCommand &command) override;
    void carryOut(canopen_command::StartJob &c);
    void carryOut(canopen_command::AddNode &c);
    void carryOut(canopen_command::RemoveDevice &c);
    void carryOut(canopen_command::AlarmStop &c);
    void carryOut(canopen_command::SendBesideOthers &c);
    void carryOut(canopen_command::TakeUnsureWatch &c);
    void carryOut(canopen_command::MayStopNode &c);
    void carryOut(canopen_command::Send &c);
    void carryOut(canopen_command::Transfer &c);
    void carryOut(canopen_command::Configure &c);
    void carryOut(canopen_command::CancelConfigure &c);
    void carryOut(canopen_command::Scan &c);
    bool useOperate(bool on) override;
    void jobStopped(std::size_t device) override; // its transfer, of which nothing more is sent
    void dropTyped() override;
    void endScan(bool cancelled) override;
    void endConfiguration(const canopen::LssOutcome &outcome);
    void breakOffConfiguration();

    // canopen_runner_sending.cpp
    void send();
    std::optional<Outgoing> nextFrame();
    std::optional<Outgoing> nextCommand();
    std::optional<Outgoing> nextOfConfiguration();
    std::optional<Outgoing> nextOf(int number);
    void beginRequest(int number);
    bool mayAsk(const Node &node) const;
    Freshness::Reason whyNotAsked(const Node &node) const;
    void settle(int number); // its transfer may have ended; then when it is due is worked out
    void settleDevice(std::size_t device) override { settle(drivers[device]->node()); }
    void ended(Node &node, const canopen::SdoOutcome &outcome);
    void answerDriver(Node &node, const canopen::SdoOutcome &outcome);
    void learn(Node &node, const canopen::SdoRequest &request, const canopen::SdoOutcome &outcome);
    void learnPdo(Node &node, int number, int pdo, std::uint32_t told);
    void fate(CanFate fate);
    void wasSent(const Outgoing &sent);
    void noteRequest(const Outgoing &request);
    void noteCommand(const canopen::NmtRequest &command, bool isOurs);

    // canopen_runner_receiving.cpp
    void receive(Instant until);
    Instant wakesAt(Instant until) const;
    void take(const CanFrame &frame);
    void hear(const Node &node, const CanFrame &frame, bool isAnswer);
    int senderOf(const canopen::CobId &cob, std::uint32_t identifier) const;
    void takeError(const CanFrame &frame);
    void takeAnswer(int number, const CanFrame &frame);
    void takeOfOthers(const CanFrame &frame);
    void showToDrivers(const CanFrame &frame, int number);
    void showToDriver(std::size_t device, const CanFrame &frame);
    void compareNode(int number);
    void lookAtBus();
    void lookAtScan();

    // canopen_runner_link.cpp
    Result<void> openLink() override { return link.open(use); }
    void linkIsOpen() override { tellRemark(); }
    Result<void> reopenLink() override;
    void tellGone(const Refusal &why) override;
    void tellNotBack(const Refusal &why, bool isNew) override;
    void linkIsBack() override;
    void forget() override;
    void sendLast() override; // stops of an ALARM STOP
    void leaveOff() override;
    Result<void> openFor(CanUse wanted);
    void tellRemark();
    bool reopen(CanUse wanted); // false: it is gone
    void useAsWanted();
    void keepStops(); // of an ALARM STOP that may not have gone out

    Node &nodeAt(int number);
    int rateNow() const { return status.rate.value_or(rate); }
    void tellOfNode(int number, Severity severity, MessageCode id);
    void tellRow(const CanFrame &frame, Instant at, CanopenRow row);
    void publishIfDue();

    const int rate;
    CanUse use; // as opened
    std::array<std::unique_ptr<Node>, canopen::lastNode + 1> nodes{};
    std::map<std::uint32_t, std::set<std::size_t>> listeners{}; // devices whose PDOs have these identifiers
    std::map<std::uint32_t, int> pdoSenders{};                  // by identifier, as the nodes have told
    int lastAsked = 0;

    std::deque<CanFrame> typed{};
    std::deque<Outgoing> commands{}; // of drivers
    std::deque<canopen::LssRequest> configurations{};
    bool isConfiguring = false; // the first one is under way
    canopen::LssClient lss{};
    std::optional<canopen::NodeScan> scan{};
    std::size_t foundTold = 0;
    std::set<int> started{}; // nodes that we have started; 0: all
    std::set<int> stops{};   // of an ALARM STOP, to be sent

    bool isQueueFull = false;          // of the link
    std::optional<Outgoing> waiting{}; // for it
    std::deque<Outgoing> underWay{};   // whose fate is not known yet

    CanStatus status{};
    bool isDisturbed = false; // errors have been told since a frame was received, or acknowledged
    CanopenFigures figures{};
    SyncHeard sync{};
    CanLoad load;
    bool isLoadTold = false;
    bool isRemarkTold = false;
    Instant statusAt{};
    Instant publishedAt{};
    Instant lookedAt{}; // for what has come in
    bool isPublishDue = false;
};

} // namespace codewheel
