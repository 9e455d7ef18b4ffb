// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/setup/node_setup_page.h"

#include "widgets/kinds/canopen/setup/node_setup_view.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QScrollArea>

namespace codewheel {

NodeSetupPage::NodeSetupPage(QWidget *parent)
    : Page(parent)
    , m_view(new NodeSetupView)
{
    setAccessibleName(title());
    auto *scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_view);
    layOutColumn(this, {{scroll, 1}}, {.margins = allAround(grid::margin)});
    setFocusProxy(m_view);
    connect(m_view, &NodeSetupView::changed, this, &Page::headChanged);
}

void NodeSetupPage::setBus(CanopenSession *bus)
{
    m_view->setBus(bus);
}

void NodeSetupPage::setAbout(const QString &bus)
{
    m_bus = bus;
    Q_EMIT headChanged();
}

void NodeSetupPage::showNode(std::optional<int> node)
{
    if (!m_view->isBusy() && (!m_view->isToBeProven() || m_view->node() != node))
        m_view->setNode(node);
}

QString NodeSetupPage::about() const
{
    QStringList parts{m_bus, m_view->about()};
    parts.removeAll(QString());
    return parts.join(QStringLiteral("  "));
}

QString NodeSetupPage::effect() const
{
    return m_view->isBusy() ? tr("Sends on the bus.") : tr("Nothing is written before a question.");
}

QString NodeSetupPage::lostByClosing() const
{
    if (m_view->isBusy())
        return goesOn();
    return m_view->isToBeProven()
               ? tr("Whether the device keeps its number and rate without supply has not been checked.")
               : QString();
}

void NodeSetupPage::leave()
{
    m_view->reset();
}

} // namespace codewheel
