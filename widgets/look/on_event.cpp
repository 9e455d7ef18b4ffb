// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/on_event.h"

#include <QPointer>
#include <QWidget>

#include <algorithm>
#include <utility>
#include <vector>

namespace codewheel {
namespace {

class EventWatch final : public QObject
{
public:
    EventWatch(std::initializer_list<QEvent::Type> events, QObject *receiver, std::function<void()> then)
        : QObject(receiver)
        , m_events(events)
        , m_receiver(receiver)
        , m_kind(receiver->metaObject())
        , m_then(std::move(then))
    {}

    // One that is being destroyed may still get some, when it is no more than a widget or an object.
    bool eventFilter(QObject *, QEvent *event) override
    {
        const bool isWhole = m_receiver && m_receiver->metaObject()->inherits(m_kind);
        if (isWhole && std::ranges::find(m_events, event->type()) != m_events.end())
            m_then();
        return false;
    }

private:
    const std::vector<QEvent::Type> m_events;
    const QPointer<QObject> m_receiver;
    const QMetaObject *const m_kind; // where it was asked for
    const std::function<void()> m_then;
};

} // namespace

void onEvent(QWidget *widget, std::initializer_list<QEvent::Type> events, std::function<void()> then)
{
    onEventOf(widget, events, widget, std::move(then));
}

void onEventOf(QObject *watched, std::initializer_list<QEvent::Type> events, QObject *receiver,
               std::function<void()> then)
{
    watched->installEventFilter(new EventWatch(events, receiver, std::move(then)));
}

} // namespace codewheel
