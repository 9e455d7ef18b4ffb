// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/served_clients_model.h"

#include "widgets/kinds/interbus/offer/served_text.h"
#include "widgets/look/fonts.h"

namespace codewheel {

// Both are in the order of their numbers.
void ServedClientsModel::show(const std::vector<ServedClient> &clients)
{
    for (int row = rowCount() - 1; row >= 0; --row)
        if (std::ranges::find(clients, rowAt(row).id, &ServedClient::id) == clients.end())
            removeAt(row);
    const std::size_t before = rows().size();
    for (std::size_t i = 0; i < before; ++i)
        if (rows()[i] != clients[i])
            replace(static_cast<int>(i), clients[i]);
    append({clients.begin() + static_cast<std::ptrdiff_t>(before), clients.end()});
}

QString ServedClientsModel::text(const ServedClient &client, int column) const
{
    switch (column) {
    case address:
        return client.address;
    case since:
        return ServedText::time(client.since);
    case unit:
        return client.unit ? QString::number(*client.unit) : QStringLiteral("\u2013");
    case requests:
        return ServedText::count(client.requests);
    case writes:
        return ServedText::count(client.writes);
    case refused:
        return ServedText::count(client.refused);
    default:
        return ServedText::written(client.written);
    }
}

std::span<const ColumnHead> ServedClientsModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Client"), Qt::AlignLeft, QT_TR_NOOP("Address and port of the client")},
        {QT_TR_NOOP("Unit"), Qt::AlignRight,
         QT_TR_NOOP("The unit of its last request; with seats, its seat")},
        {QT_TR_NOOP("Wrote last"), Qt::AlignLeft, QT_TR_NOOP("Device, OUT word, and when it was on the bus")},
        {QT_TR_NOOP("Requests"), Qt::AlignRight, QT_TR_NOOP("Requests so far")},
        {QT_TR_NOOP("Writes"), Qt::AlignRight,
         QT_TR_NOOP("Requests that wrote something, and were carried out")},
        {QT_TR_NOOP("Refused"), Qt::AlignRight, QT_TR_NOOP("Requests that were answered with an exception")},
        {QT_TR_NOOP("Since"), Qt::AlignLeft, QT_TR_NOOP("When it connected")},
    };
    return all;
}

} // namespace codewheel
