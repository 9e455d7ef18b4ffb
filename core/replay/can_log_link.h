// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "replay/can_log.h"

namespace codewheel {

// The link to a CAN bus of which there is a log: what was received then comes in again, in virtual time,
// which passes only in receive() and wait(). Nothing can be sent. Behind the end of the log nothing comes.
class CanLogLink final : public CanLink
{
public:
    CanLogLink(QString path, std::string interface);
    CanLogLink(const CanLogLink &) = delete;
    CanLogLink &operator=(const CanLogLink &) = delete;

    Result<void> open(CanUse use) override; // at its beginning; refused: onlyLogged, fileNotReadable
    void close() override { m_isOpen = false; }
    Instant now() const override { return m_now; }
    void wait(Instant until) override { m_now = std::max(m_now, until); }
    Result<CanNews> receive(Instant until) override;
    Result<bool> send(const CanFrame &frame) override;
    CanStatus status() const override { return {.listensOnly = true}; }
    QString name() const override { return m_log.path(); }
    bool isSimulated() const override { return true; } // what is told there reaches nobody
    void interrupt() override {}

private:
    Result<void> usable() const;

    CanLog m_log;
    bool m_isOpen = false;
    Instant m_now{};
    Instant m_begin{};                // on our clock
    std::optional<Instant> m_first{}; // of its times
};

} // namespace codewheel
