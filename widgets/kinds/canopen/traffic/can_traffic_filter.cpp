// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/traffic/can_traffic_filter.h"

#include "kinds/canopen/bus/canopen_traffic.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/trace/traffic_table.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

namespace codewheel {

CanTrafficFilter::CanTrafficFilter(TrafficTable &table, QWidget *parent)
    : QWidget(parent)
    , m_table(table)
    , m_text(new QLineEdit(this))
{
    auto *menu = new QMenu(this);
    for (const CanService service : canServices)
        addChoice(*menu, canServiceText(service), true, [this, service](bool shown) {
            if (shown)
                m_hidden.erase(service);
            else
                m_hidden.insert(service);
        });
    menu->addSeparator();
    addChoice(*menu, tr("What comes again and again (PDO, SYNC, polling)"), true,
              [this](bool shown) { m_table.filter().hideAutomatic(!shown); });
    m_table.filter().hideAutomatic(false);
    addChoice(*menu, tr("A transfer as one row"), m_asTransfers, [this](bool on) { m_asTransfers = on; });

    auto *button = new QToolButton(this);
    button->setText(tr("Show"));
    button->setIcon(lineIcon(Icon::filter));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(menu);
    describe(button, "canTrafficRows", tr("Rows to show"),
             tr("Which rows are shown. Those that are hidden are kept."));
    describe(m_text, "canTrafficText", tr("Filter by text"),
             tr("Shows only rows with this in them: 185, can:5, 6004h, boot-up"));
    m_text->setPlaceholderText(tr("Node, object or text"));
    m_text->setClearButtonEnabled(true);
    connect(m_text, &QLineEdit::textChanged, this, &CanTrafficFilter::apply);

    auto *row = layOut<QHBoxLayout>(this, grid::margin);
    row->addWidget(button);
    row->addWidget(m_text, 1);
    apply();
}

QAction *CanTrafficFilter::addChoice(QMenu &menu, const QString &text, bool isOn,
                                     const std::function<void(bool)> &choose)
{
    QAction *action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(isOn);
    connect(action, &QAction::toggled, this, [this, choose](bool on) {
        choose(on);
        apply();
    });
    return action;
}

void CanTrafficFilter::apply()
{
    m_table.filter().setWanted([this](const TrafficRow &row) { return isWanted(row); });
    Q_EMIT changed();
}

// A row without a direction tells a whole transfer, or that another connection begins, which is always seen.
bool CanTrafficFilter::isWanted(const TrafficRow &row) const
{
    if (!row.kind && !row.identifier)
        return true;
    const bool isTransfer = !row.kind && row.identifier;
    if (m_asTransfers ? row.isOfTransfer : isTransfer)
        return false;
    const auto frame = isTransfer ? std::nullopt : canFrameOf(row.bytes);
    const CanService service = isTransfer ? CanService::sdo
                               : frame    ? canServiceOf(*frame)
                                          : CanService::other;
    return !m_hidden.contains(service) && hasText(row);
}

bool CanTrafficFilter::hasText(const TrafficRow &row) const
{
    const QString wanted = m_text->text().trimmed();
    const auto has = [&wanted](const QString &text) { return text.contains(wanted, Qt::CaseInsensitive); };
    return wanted.isEmpty() || (row.identifier && has(row.identifier->text())) ||
           (row.place && has(row.place->node.toString())) || (row.meaning && has(row.meaning()));
}

} // namespace codewheel
