// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/serial_port_link.h"
#include "links/slcan_link.h"
#include "tests/support/peer_process.h"

#include <gtest/gtest.h>

namespace codewheel::test {

// tests/can/slcan_peer.py, an adapter that knows nothing of this program, and the link to it.
class SlcanPeer
{
public:
    explicit SlcanPeer(const QString &options = {}, int rate = 250'000)
        : m_process(QStringLiteral(CODEWHEEL_PYTHON), QStringList{QStringLiteral(CODEWHEEL_SLCAN_PEER)} +
                                                          options.split(u' ', Qt::SkipEmptyParts))
        , m_link(
              std::make_unique<SlcanLink>(std::make_unique<SerialPortLink>(m_process.port()), rate, 115'200))
    {}

    SlcanLink &link() { return *m_link; }
    // What it says to an order.
    QStringList order(const QString &text)
    {
        QStringList lines;
        for (const std::string &line : m_process.order(text))
            lines << QString::fromStdString(line);
        return lines;
    }
    std::string state() { return order(QStringLiteral("state")).value(0).trimmed().toStdString(); }
    void unplug() { m_process.unplug(); }

private:
    PeerProcess m_process;
    std::unique_ptr<SlcanLink> m_link;
};

} // namespace codewheel::test
