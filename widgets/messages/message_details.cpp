// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_details.h"

#include "vocabulary/sentence.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/messages/message_model.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace codewheel {

MessageDetails::MessageDetails(QWidget *parent)
    : QFrame(parent)
    , m_head(new QLabel(this))
    , m_text(new QLabel(this))
{
    setAccessibleName(tr("Details of the message"));
    auto *rows = layOut<QVBoxLayout>(this, grid::unit, grid::unit);
    for (QLabel *label : {m_head, m_text}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        label->setFocusPolicy(Qt::NoFocus);
        rows->addWidget(label);
    }
    m_head->setFont(textFont(TextSize::small));
}

void MessageDetails::show(const MessageModel &messages, int row)
{
    const StoredMessage newest = messages.message(row);
    const auto cell = [&messages](const StoredMessage &message, int column) {
        return messages.text(message, column);
    };
    const qint64 count = messages.countOf(row);
    QStringList head;
    if (count > 1)
        head << sentence(tr("%1 times from %2 to %3", "count, date and time"),
                         {QLocale().toString(count),
                          cell(messages.oldestMessage(row), MessageModel::timeColumn),
                          cell(newest, MessageModel::timeColumn)});
    else
        head << cell(newest, MessageModel::timeColumn);
    head << cell(newest, MessageModel::severityColumn) << cell(newest, MessageModel::placeColumn);
    head.removeAll(QString());
    m_head->setText(head.join(QStringLiteral("  ·  ")));
    m_text->setText(cell(newest, MessageModel::textColumn));
}

} // namespace codewheel
