// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_load.h"
#include "kinds/canopen/bus/canopen_runner.h"
#include "kinds/canopen/protocol/cob_id.h"

#include <array>
#include <deque>
#include <map>
#include <set>

namespace codewheel {

struct CanopenRunner::Private
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
        int typedFrames = 0;                           // SDO requests by hand that may be answered
        Instant dueAt = Instant::max();                // it may want to send something
        bool answers = true;                           // the last request was answered
        bool sendsPdos = false;                        //
        std::map<int, std::uint32_t> pdos{};           // identifiers that were read; 0: it is off
        std::optional<Instant> heardAt{};
        canopen::Heartbeat heartbeat = canopen::Heartbeat::notHeard; // as told
        bool isDoubledTold = false;                                  // since it has booted
    };

    Private(CanLink &usedLink, int usedRate, CanUse usedFirst, Mail &usedMail);

    // canopen_runner_commands.cpp
    void carryOutCommands();
    void carryOut(canopen_command::StartJob &c);
    void carryOut(canopen_command::Proceed &c);
    void carryOut(canopen_command::Cancel &c);
    void carryOut(canopen_command::SetKnown &c);
    void carryOut(canopen_command::AddNode &c);
    void carryOut(canopen_command::RemoveDevice &c);
    void carryOut(canopen_command::SetRunning &c);
    void carryOut(canopen_command::SetOperate &c);
    void carryOut(canopen_command::AlarmStop &c);
    void carryOut(canopen_command::SendBesideOthers &c);
    void carryOut(canopen_command::TakeUnsureWatch &c);
    void carryOut(canopen_command::MayStopNode &c);
    void carryOut(canopen_command::Send &c);
    void carryOut(canopen_command::Transfer &c);
    void carryOut(canopen_command::Configure &c);
    void carryOut(canopen_command::CancelConfigure &c);
    void carryOut(canopen_command::Scan &c);
    void carryOut(canopen_command::CancelScan &c);
    std::optional<std::size_t> busyDevice() const;
    void stopJobs(const Refusal &why);
    void breakOff(int number); // the transfer of its driver, of which nothing more is sent
    void dropTyped();          // what was not sent yet
    void endScan(bool cancelled);
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
    void settle(int number); // its transfer may have ended; then when it is due is worked out
    void settleAll();
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
    Result<void> openLink(CanUse wanted);
    bool reopen(CanUse wanted); // false: it is gone
    void useAsWanted();
    void sendLastStops(); // before it is closed
    void linkIsGone(const Refusal &why);
    void keepStops(); // of an ALARM STOP that may not have gone out
    void leaveOff();  // transfers under way, which nobody will see the end of
    void waitForLink(Instant until);
    void tryToReopen();

    Node &nodeAt(int number);
    canopen::NodeDriver *driver(std::size_t device) const
    {
        return device < drivers.size() ? drivers[device].get() : nullptr;
    }
    int rateNow() const { return status.rate.value_or(rate); }
    void collect(std::size_t device);
    void look(std::size_t device); // at what it shows
    void tellEvent(decltype(CanopenEvent::what) what, std::size_t device = 0);
    void tell(Message message);
    void tellOfNode(int number, Severity severity, MessageCode id);
    void tellRow(const CanFrame &frame, Instant at, CanopenRow row);
    void publish();
    void publishIfDue();

    CanLink &link;
    const int rate;
    CanUse use;                                                // as opened
    std::vector<std::unique_ptr<canopen::NodeDriver>> drivers; // null: removed
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

    CanopenState state{{.connected = true}};
    CanStatus status{};
    CanopenFigures figures{};
    CanLoad load;
    bool isLoadTold = false;
    ValueTap tap{};
    Instant awakeSince{};
    Instant reopenAt{};
    Instant statusAt{};
    Instant publishedAt{};
    bool isPublishDue = false;
    std::optional<Refusal> notBack{}; // as reported
    Mail &mail;
};

} // namespace codewheel
