// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/slcan_conversation.h"
#include "serial/byte_link.h"

#include <memory>

namespace codewheel {

// The link to a CAN bus through an SLCAN adapter at a serial line.
class SlcanLink final : public CanLink
{
public:
    // The rate of the bus is one of slcanRates; the baud rate is that of the line.
    SlcanLink(std::unique_ptr<ByteLink> line, int rate, int baudRate);
    ~SlcanLink() override;

    // Refused: what the line refuses, watchNotSure, rateRefused, openingRefused, openingNotKnown,
    // adapterSilent.
    Result<void> open(CanUse use) override;
    void close() override;
    void takeUnsureWatch() override { m_takesUnsureWatch = true; }
    Instant now() const override { return m_line->now(); }
    void wait(Instant until) override;
    Result<CanNews> receive(Instant until) override;
    // Refused: lineClosed, onlyWatches, what the line refuses.
    Result<bool> send(const CanFrame &frame) override;
    CanStatus status() const override { return m_talk.status(); }
    std::optional<Refusal> remark() const override; // rateMayBe750
    QString name() const override { return m_line->name(); }
    bool isSimulated() const override { return m_line->isSimulated(); }
    void interrupt() override { m_line->interrupt(); }

    // Of the bus, from when it is next opened after it was closed.
    void setRate(int rate) { m_rate = rate; }
    const SlcanFirmware &firmware() const { return m_talk.firmware(); }
    std::uint64_t skipped() const { return m_talk.skipped(); }

private:
    Result<void> openLine();
    // Writes what is to be written, and takes what comes in. False: it was interrupted.
    Result<bool> proceed(Instant until);
    Result<void> write();
    CanNews takeNews();

    const std::unique_ptr<ByteLink> m_line;
    int m_rate;
    const int m_baudRate;
    CanUse m_use = CanUse::watch;
    bool m_takesUnsureWatch = false;
    bool m_isOpen = false;           // the line
    std::optional<Refusal> m_loss{}; // seen while it waited
    SlcanConversation m_talk;
    std::string m_interface{}; // as its frames name it
};

} // namespace codewheel
