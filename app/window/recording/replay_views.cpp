// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/recording/replay_views.h"

#include "app/window/recording/replay_at_work.h"
#include "app/window/window_actions.h"
#include "vocabulary/refusal_text.h"
#include "widgets/help/help_topic.h"
#include "widgets/replay/replay_bar.h"

#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace codewheel {

ReplayViews::ReplayViews(ReplayAtWork &bus, const WindowParts &parts, QObject *parent)
    : BusViews(parent)
    , m_bus(bus)
    , m_parts(parts)
    , m_bar(own(new ReplayBar(*bus.session().playback(), parts.pages.parentWidget())))
    , m_menu(own(new QMenu(&parts.pages)))
{
    parts.notices.insertWidget(0, m_bar);
    m_bar->hide();
    setHelpTopic(*m_bar, "replay.md");
    m_menu->addAction(parts.actions.closeRecording);
    connect(&bus.session(), &EncoderBus::messaged, this, &ReplayViews::tell);
    connect(m_bar, &ReplayBar::closeRequested, parts.actions.closeRecording, &QAction::trigger);
}

// In the bar, not among the messages of now.
void ReplayViews::tell(const Message &message)
{
    QStringList parts{m_bus.session().dateTime(message.at).toLocalTime().toString(QStringLiteral("HH:mm:ss")),
                      message.place ? message.place->toString() : QString(), messageText(message)};
    parts.removeAll(QString());
    m_bar->tell(parts.join(QStringLiteral("  ")));
}

QMenu *ReplayViews::menu() const
{
    return m_menu;
}

// Steps go through the samples of the chosen encoder.
void ReplayViews::setChosen(std::optional<Place> place)
{
    m_bar->setEncoder(place ? std::optional(m_bus.session().inRecording(*place)) : std::nullopt);
}

void ReplayViews::open()
{
    m_bar->setFocus();
}

void ReplayViews::showCurrent()
{
    m_bar->setVisible(isMeant());
}

} // namespace codewheel
