// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/faults/unseen_faults.h"

#include "journal/message_fields.h"
#include "vocabulary/refusal_text.h"

#include <QGuiApplication>
#include <QWindow>

namespace codewheel {
namespace {

// What concerns no bus concerns the program.
QString whereItIs(const Message &message)
{
    const QString place = placeName(message.place);
    return place.isEmpty() ? QGuiApplication::applicationDisplayName() : place;
}

} // namespace

UnseenFaults::UnseenFaults(std::chrono::milliseconds pause, QObject *parent)
    : QObject(parent)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(pause);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_isDue)
            tell();
    });
    connect(&m_notice, &DesktopNotice::clicked, this, &UnseenFaults::windowWanted);
    connect(&m_notice, &DesktopNotice::staysSilent, this, &UnseenFaults::beepWanted);
    connect(qGuiApp, &QGuiApplication::focusWindowChanged, this, [this](const QWindow *window) {
        if (window != nullptr)
            forget();
    });
}

void UnseenFaults::setWishes(bool notifies, bool withSound)
{
    m_notifies = notifies;
    m_withSound = withSound;
    if (!notifies)
        forget();
}

void UnseenFaults::take(const Message &message)
{
    if (!m_notifies || message.severity != Severity::fault || QGuiApplication::focusWindow() != nullptr)
        return;
    ++m_unseen;
    m_last = message;
    m_isDue = true;
    if (!m_pause.isActive())
        tell();
}

void UnseenFaults::tell()
{
    m_isDue = false;
    m_pause.start();
    const QString where = whereItIs(m_last);
    m_notice.show({.title = m_unseen == 1 ? tr("Fault: %1", "place").arg(where)
                                          : tr("%n faults, the last: %1", "place", m_unseen).arg(where),
                   .body = messageText(m_last),
                   .withSound = m_withSound});
    Q_EMIT told();
}

void UnseenFaults::forget()
{
    m_unseen = 0;
    m_isDue = false;
    m_notice.withdraw();
}

} // namespace codewheel
