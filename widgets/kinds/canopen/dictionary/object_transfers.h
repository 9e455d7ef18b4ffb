// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_event.h"

#include <QObject>
#include <QPointer>

#include <deque>

namespace codewheel {

class CanopenSession;

// Reads and writes objects of a node, one after the other, for the view of its objects.
class ObjectTransfers final : public QObject
{
    Q_OBJECT

public:
    explicit ObjectTransfers(QObject *parent = nullptr);

    void setBus(codewheel::CanopenSession *bus); // null: none
    void setNode(std::optional<int> node);       // what was to be done with another one is not

    void read(const std::vector<canopen::SdoObject> &objects);
    // Sent once.
    void write(canopen::SdoObject object, const std::vector<std::uint8_t> &octets);
    void cancel(); // what has been sent is waited for

    bool isBusy() const { return m_underWay.has_value(); }
    std::size_t left() const { return m_waiting.size(); }

Q_SIGNALS:
    void ended(const codewheel::canopen::SdoRequest &request, const codewheel::canopen::SdoOutcome &outcome);
    void refused(const codewheel::Refusal &why); // and nothing more is sent
    void changed();                              // busy, or no more

private:
    void sendNext();
    void takeEnd(const TransferEnded &end);

    QPointer<CanopenSession> m_bus;
    std::optional<int> m_node;
    std::deque<canopen::SdoRequest> m_waiting;
    std::optional<canopen::SdoRequest> m_underWay;
};

} // namespace codewheel
