// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"

#include <QSortFilterProxyModel>

namespace codewheel {

class MessageModel;

// Which messages are shown: of this severity or worse, of one place, with this text somewhere in the row.
class MessageFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    struct Place
    {
        bool all = true;
        std::optional<DeviceNumber> number = {}; // nothing: the bus itself

        friend bool operator==(const Place &, const Place &) = default;
    };

    explicit MessageFilter(MessageModel &messages, QObject *parent = nullptr);

    void setSeverity(Severity least);
    void setPlace(const Place &place);
    void setText(const QString &text); // case does not matter

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    const MessageModel &m_messages;
    Severity m_least = Severity::information;
    Place m_place;
    QString m_text;
};

} // namespace codewheel
