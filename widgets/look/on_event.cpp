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
        , m_then(std::move(then))
    {}

    // A receiver that is being destroyed may still get some.
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (m_receiver && std::ranges::find(m_events, event->type()) != m_events.end())
            m_then();
        return false;
    }

private:
    const std::vector<QEvent::Type> m_events;
    const QPointer<QObject> m_receiver;
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
