// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/dial_panel.h"

#include "catalog/device_description.h"
#include "catalog/protocol_rules.h"
#include "history/track.h"
#include "vocabulary/encoder_session.h"
#include "widgets/dial/dial_head.h"
#include "widgets/dial/rod_dial.h"
#include "widgets/dial/shaft_dial.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QStackedWidget>

namespace codewheel {

DialPanel::DialPanel(QWidget *parent)
    : QWidget(parent)
    , m_head(new DialHead(this))
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::encoder, {}, {}, this))
    , m_shaft(new ShaftDial(this))
    , m_rod(new RodDial(this))
{
    setFocusPolicy(Qt::ClickFocus); // so that it is what Print means
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_shaft);
    m_pages->addWidget(m_rod);
    layOutColumn(this, {m_head, {m_pages, 1}},
                 {.spacing = 0, .margins = QMargins(grid::margin, 0, grid::unit, grid::margin)});
}

std::optional<PrintedView> DialPanel::printedView() const
{
    const QWidget *shown = m_pages->currentWidget();
    return shown == m_shaft ? m_shaft->printedView() : shown == m_rod ? m_rod->printedView() : std::nullopt;
}

void DialPanel::contextMenuEvent(QContextMenuEvent *event)
{
    if (!m_encoder)
        return;
    QMenu menu(this);
    const auto addTrend = [&](const QString &text, Channel channel) {
        connect(menu.addAction(lineIcon(Icon::trend), text), &QAction::triggered, this,
                [this, channel, place = m_encoder->place()] {
                    Q_EMIT trendWanted({place, channel, {}});
                });
    };
    addTrend(tr("Show &position in trend"), Channel::position);
    addTrend(tr("Show &speed in trend"), Channel::speed);
    if (m_print != nullptr && printedView())
        menu.addAction(m_print);
    menu.exec(event->globalPos());
}

void DialPanel::setEncoder(EncoderSession *encoder, std::optional<Place> offline)
{
    if (encoder != nullptr && encoder == m_encoder)
        return; // what is typed and told there stays
    m_encoder = encoder;
    const bool isRod = encoder != nullptr && codewheel::isRod(encoder->device());
    m_shaft->setEncoder(isRod ? nullptr : encoder);
    m_rod->setEncoder(isRod ? encoder : nullptr);
    if (offline)
        m_empty->setTexts(tr("%1 is not connected").arg(offline->shown()),
                          tr("Its position is shown once its bus is connected."));
    else
        m_empty->setTexts(tr("No encoder is chosen"), tr("Choose one in the bus structure."));
    if (encoder == nullptr)
        m_pages->setCurrentWidget(m_empty);
    else
        m_pages->setCurrentWidget(isRod ? static_cast<QWidget *>(m_rod) : m_shaft);
}

void DialPanel::setAbsent(Place planned)
{
    setEncoder(nullptr);
    m_empty->setTexts(tr("There is no encoder at %1", "2.0").arg(planned.shown()),
                      tr("The project plans it, but it is not on the bus that is connected. Its position is "
                         "shown once it is."));
}

void DialPanel::setAway(Place pinned)
{
    setEncoder(nullptr);
    m_empty->setTexts(tr("There is no encoder at %1", "2.0").arg(pinned.shown()),
                      tr("The dial is pinned to this place. Unpinned, it follows the bus structure."));
}

} // namespace codewheel
