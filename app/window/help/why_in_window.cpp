// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/why_in_window.h"

#include "app/window/buses/bus_views.h"
#include "app/window/buses/plant.h"
#include "app/window/connect/trouble_of.h"
#include "app/window/window_actions.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/label_text.h"
#include "widgets/structure/structure_view.h"
#include "widgets/why/why_page.h"

#include <QAction>
#include <QStackedWidget>

#include <utility>

namespace codewheel {

WhyInWindow::WhyInWindow(Parts parts, QObject *parent)
    : QObject(parent)
    , m_parts(std::move(parts))
    , m_page(new WhyPage({.troubleOf = [](const Refusal &why) { return troubleOf(why); },
                          .buttonFor =
                              [this](DataCheck::Action wanted) {
                                  const QAction *action = actionFor(wanted);
                                  return action != nullptr && action->isEnabled()
                                             ? asLabel(plainLabel(action->text()))
                                             : QString();
                              }},
                         &m_parts.pages))
{
    m_page->setObjectName(QStringLiteral("whyPage"));
    m_parts.pages.addWidget(m_page);
    setHelpTopic(*m_page, "why.md");
    connect(m_parts.actions.whyNoData, &QAction::triggered, this, &WhyInWindow::open);
    connect(&m_parts.structure, &StructureView::whyRequested, this, [this](Place row) {
        m_parts.structure.chooseRow(row);
        open();
    });
    connect(m_page, &WhyPage::actionWanted, this, [this](DataCheck::Action wanted) {
        if (QAction *action = actionFor(wanted))
            action->trigger();
    });
}

void WhyInWindow::open()
{
    look();
    m_parts.pages.setCurrentWidget(m_page);
    m_page->setFocus();
}

void WhyInWindow::showFrame()
{
    if (m_page->isVisible())
        look();
}

void WhyInWindow::look()
{
    const auto row = m_parts.structure.row();
    const BusAtWork *bus = row ? m_parts.plant.find(row->bus) : nullptr;
    if (bus != nullptr)
        m_page->showChecks(about(*row), bus->dataChecks(row->node));
    else
        showLastTry();
}

// Nothing is planned or connected, so no row can be chosen: but a connection may just have failed.
void WhyInWindow::showLastTry()
{
    for (const BusAtWork *its : m_parts.plant.all())
        if (const DataChecks checks = its->dataChecks({}); !checks.empty() && checks.front().why) {
            m_page->showChecks(m_parts.plant.nameOf(its->id()), checks);
            return;
        }
    m_page->showChecks({}, {});
}

// The bus is named where there are several.
QString WhyInWindow::about(Place row) const
{
    if (row.isEmpty())
        return m_parts.plant.nameOf(row.bus);
    const QString name = m_parts.structure.nameOf(row).simplified();
    const QString bus = nameAmongOthers(row.bus);
    return bus.isEmpty() ? name : QStringLiteral("%1: %2").arg(bus, name);
}

// The page is about the chosen row, so those of the window apply to the same bus.
QAction *WhyInWindow::actionFor(DataCheck::Action action) const
{
    const auto row = m_parts.structure.row();
    const BusViews *views = row ? m_parts.viewsOf(row->bus) : nullptr;
    switch (action) {
    case DataCheck::Action::none:
        return nullptr;
    case DataCheck::Action::start:
        return m_parts.actions.start;
    case DataCheck::Action::operate:
        return m_parts.actions.operate;
    case DataCheck::Action::compare:
        return m_parts.actions.compare;
    case DataCheck::Action::monitor:
        return m_parts.actions.openMonitor;
    case DataCheck::Action::positionMode:
        return &m_parts.isInPositionMode;
    case DataCheck::Action::connectBus:
    case DataCheck::Action::connection:
    case DataCheck::Action::registers:
    case DataCheck::Action::confirm:
    case DataCheck::Action::search:
    case DataCheck::Action::startNode:
        break;
    }
    return views != nullptr ? views->actionFor(action) : nullptr;
}

} // namespace codewheel
