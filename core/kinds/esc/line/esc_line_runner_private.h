// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asking_work.h"
#include "kinds/esc/line/esc_line_runner.h"

#include <deque>

namespace codewheel {

struct EscLineWork final : AskingWork<EscLineCommand, EscLineEvent, EscLineSnapshot, ByteLink, RequestDriver>
{
    // Who asked for the request under way.
    enum class Asker : std::uint8_t { terminal, scan, device };

    struct Device
    {
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

    EscLineWork(ByteLink &usedLink, const SerialSettings &lineSettings, const esc::Timing &lineTiming,
                Mail &usedMail);
    Place placeOf(const RequestDriver &driver) const override { return placeOnLine(driver.address()); }
    Result<void> mayStart(const RequestDriver &driver, const Job &job) const override;
    void show(std::size_t device, EscLineDevice &shown) const override;
    void complete(EscLineSnapshot &made) override;

    // esc_line_runner_commands.cpp
    using AskingWork::carryOut;
    void carryOutNext(EscLineCommand &command) override;
    void carryOut(line_command::AddDevice &c);
    void carryOut(line_command::RemoveDevice &c);
    void carryOut(line_command::Send &c);
    void carryOut(line_command::Scan &c);
    void carryOut(line_command::TakeOtherAdapter &c);
    void carryOut(line_command::SetFractionBits &c);
    void carryOut(line_command::SetSwapsWarningBytes &c);
    void dropTyped() override;
    void endScan(bool cancelled) override;
    void tellTaken();

    // esc_line_runner.cpp
    void step(Instant until) override;
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

    // esc_line_runner_turns.cpp
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
    void forget() override;

    // esc_line_runner_port.cpp
    Result<void> openLink() override { return link.open(settings); }
    void linkIsOpen() override; // whether it answers at once
    void tellGone(const Refusal &why) override;
    void tellNotBack(const Refusal &why, bool isNew) override;
    void linkIsBack() override;
    void leaveOff() override;

    void tellRows(std::vector<esc::EscLineRow> rows);

    SerialSettings settings;
    esc::Timing timing;
    int baudRate;
    std::vector<Device> devices; // as the drivers
    std::optional<UnderWay> underWay;
    std::deque<esc::Request> typed;
    std::optional<EscLineScan> scan;
    LineCounter counter;
    std::uint64_t turns = 0;
    Instant doubtfulFrom{}; // before that, none that did not answer is asked while others answer
    bool latencyTold = false;
};

} // namespace codewheel
