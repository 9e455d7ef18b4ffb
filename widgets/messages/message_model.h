// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"
#include "widgets/models/table_model_base.h"

#include <QDateTime>
#include <QPointer>

namespace codewheel {

class BusSession;

struct MessageRow
{
    QDateTime at;
    Message message;
};

// Everything that happened to bus and devices, oldest first; the oldest are dropped when there are too many.
// Kept as codes and arguments: texts are made when they are shown, so that the language can change.
class MessageModel : public TableModelBase<MessageRow>
{
    Q_OBJECT

public:
    enum Column { timeColumn, severityColumn, placeColumn, textColumn, columnTotal };
    static constexpr int capacity = 100'000;

    explicit MessageModel(QObject *parent = nullptr);

    // Takes the messages of this ring, and its date and time, from now on.
    void setBus(BusSession &bus);
    void add(const Message &message, QDateTime at);
    // Something that happens now: stamped with the time of the bus, where there is one.
    void addNow(Message message);

    // As shown in this column; with Column::timeColumn to the millisecond.
    static QString text(const MessageRow &row, int column);

protected:
    int columns() const override { return columnTotal; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const MessageRow &row, int column, int role) const override;

private:
    QPointer<BusSession> m_bus;
};

// "Information", "Attention", "Fault".
QString severityName(Severity severity);

} // namespace codewheel
