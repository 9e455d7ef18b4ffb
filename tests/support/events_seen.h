// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QEvent>
#include <QStringList>

namespace codewheel::test {

// Who gets events of one type from now on: from a widget, or from all objects of the program.
class EventsSeen : public QObject
{
public:
    explicit EventsSeen(QEvent::Type type, QObject &watched = *qApp)
        : m_type(type)
    {
        watched.installEventFilter(this);
    }

    QString text() const { return m_seen.join(u' '); } // by class and name, in the order in which they came
    qsizetype count() const { return m_seen.size(); }

private:
    bool eventFilter(QObject *object, QEvent *event) override
    {
        if (event->type() == m_type)
            m_seen << QString::fromLatin1(object->metaObject()->className()) + object->objectName();
        return false;
    }

    QEvent::Type m_type;
    QStringList m_seen;
};

} // namespace codewheel::test
