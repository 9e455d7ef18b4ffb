// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_runner.h"

#include <deque>

namespace codewheel {

struct EscLineRunner::Private
{
    // Who asked for the request under way.
    enum class Asker : std::uint8_t { terminal, scan, device };

    struct Device
    {
        std::unique_ptr<RequestDriver> driver; // null: removed
        QString name;
        LineCounter counter;
        std::uint64_t turn = 0; // when it was last asked, in requests of the line
        bool answers = false;   // its last request was answered
        Instant shownAt{};      // its newest position
        Instant round{};        // from one position to the next
    };

    struct UnderWay
    {
        Asker asker = Asker::device;
        std::size_t device = 0; // Asker::device
        Instant begun{};
        esc::Exchange exchange;
    };

    Private(ByteLink &link, const SerialSettings &settings, const esc::Timing &timing, Mail &mail);

    // line_runner_commands.cpp
    void carryOutCommands();
    void carryOut(line_command::StartJob &c);
    void carryOut(line_command::Proceed &c);
    void carryOut(line_command::Cancel &c);
    void carryOut(line_command::SetKnown &c);
    void carryOut(line_command::AddDevice &c);
    void carryOut(line_command::RemoveDevice &c);
    void carryOut(line_command::SetRunning &c);
    void carryOut(line_command::SetOperate &c);
    void carryOut(line_command::AlarmStop &c);
    void carryOut(line_command::Send &c);
    void carryOut(line_command::Scan &c);
    void carryOut(line_command::CancelScan &c);
    void carryOut(line_command::TakeOtherAdapter &c);
    void carryOut(line_command::SetFractionBits &c);
    void carryOut(line_command::SetSwapsWarningBytes &c);
    Result<void> mayStart(std::size_t device, const Job &job) const;
    void stopJobs(const Refusal &why);
    void dropTyped();
    void endScan(bool cancelled);
    void tellTaken();

    // line_runner.cpp
    void step(Instant until);
    bool begin(); // the next request; false: nobody wants anything now
    bool beginTyped();
    int baudRateAt(EscLineAddress address) const; // also for what is typed for it
    bool beginScanStep();
    bool ask(Asker asker, std::size_t device, const esc::Request &request, int baudRate);
    void goOn(Instant until); // with the request under way
    void end(UnderWay ended);
    void deviceAnswered(std::size_t device, const esc::Request &request, const esc::ExchangeResult &result);
    void typedEnded(const esc::Request &request, const esc::ExchangeResult &result);
    void listen(Instant until); // for what comes unasked
    bool useBaudRate(int baudRate);

    // line_runner_turns.cpp
    bool beginDevice();
    std::optional<std::size_t> deviceInTurn() const;
    std::optional<Instant> nextWish() const;
    bool isDoubtful(std::size_t device) const; // its last request was not answered
    bool isSilent(std::size_t device) const;   // and is known not to answer
    bool anyAnswers() const;
    std::optional<Instant> turnOf(std::size_t device) const; // when it is due; empty: it wants nothing
    void noteTurn(const UnderWay &ended);
    void noteRound(std::size_t device);
    Instant lateAfter(std::size_t device) const;
    void forgetTurns();

    // line_runner_port.cpp
    void portIsGone(const Refusal &why);
    void tearOff(); // the request under way: it will never be answered
    void waitForPort(Instant until);
    void tryToReopen();
    void portIsNotBack(const Refusal &why);
    void takeLowLatency();

    RequestDriver *driver(std::size_t device) const { return devices[device].driver.get(); }
    void collect(std::size_t device);
    void tellEvent(decltype(EscLineEvent::what) what, std::size_t device = 0);
    void tellRows(std::vector<esc::EscLineRow> rows);
    void tell(Message message);
    void publish();

    ByteLink &link;
    SerialSettings settings;
    esc::Timing timing;
    int baudRate;
    std::vector<Device> devices;
    std::optional<UnderWay> underWay;
    std::deque<esc::Request> typed;
    std::optional<EscLineScan> scan;
    LineCounter counter;
    std::uint64_t turns = 0;
    Instant doubtfulFrom{}; // before that, none that did not answer is asked while others answer
    LineState state{{.connected = true}};
    ValueTap tap{};
    Instant awakeSince{};
    Instant reopenAt{};
    std::optional<Refusal> notBack; // as reported
    bool latencyTold = false;
    Mail &mail;
};

} // namespace codewheel
