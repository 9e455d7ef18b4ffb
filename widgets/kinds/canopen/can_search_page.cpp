// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/can_search_page.h"

#include "catalog/catalog.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/device_of_type.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"

#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableView>

namespace codewheel {
namespace {

QString whatIsAsked()
{
    return CanSearchPage::tr("Each number from 1 to 127 is asked for its device type and its identity, with "
                             "at most 30 % of the bus. Nothing is written.");
}

} // namespace

CanSearchPage::CanSearchPage(QWidget *parent)
    : Page(parent)
    , m_start(describe(new QPushButton(lineIcon(Icon::search), tr("&Search"), this), "canSearch", {}))
    , m_cancel(describe(new QPushButton(lineIcon(Icon::cancel), tr("&Cancel"), this), "canCancel",
                        tr("Ends the search (Alt+C)")))
    , m_take(describe(new QPushButton(lineIcon(Icon::add), tr("&Take over"), this), "canTake",
                      tr("Adds the ticked nodes to the bus structure and the project (Alt+T)")))
    , m_progress(describe(new QProgressBar(this), tr("Progress of the search"), {}))
    , m_message(new InlineMessage(this))
    , m_found(new CanFoundModel(this))
    , m_table(new QTableView(this))
    , m_empty(new EmptyState(Icon::search, tr("No search yet"), whatIsAsked(), this))
    , m_content(new QStackedWidget(this))
{
    setAccessibleName(title());
    for (QPushButton *button : {m_start, m_cancel, m_take})
        button->setAutoDefault(false);
    m_progress->hide();
    setUpQuietTable(*m_table, *m_found, tr("Nodes found"));
    m_table->setToolTip(tr("Space chooses a node"));
    FittedColumns::useIn(*m_table, CanFoundModel::device);
    m_content->addWidget(m_empty);
    m_content->addWidget(m_table);
    auto *buttons = layOutRow({m_start, m_cancel, Stretch{1}, m_take}, {.spacing = grid::unit});
    layOutColumn(this, {buttons, m_progress, m_message, {m_content, 1}},
                 {.spacing = grid::unit, .margins = allAround(grid::margin)});
    setTabOrder(m_start, m_cancel);
    setTabOrder(m_cancel, m_table);
    setTabOrder(m_table, m_take);
    setFocusProxy(m_start);
    connect(m_start, &QPushButton::clicked, this, &CanSearchPage::ask);
    connect(m_message, &InlineMessage::actionTriggered, this, &CanSearchPage::start);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_bus)
            m_bus->cancelScan();
    });
    connect(m_take, &QPushButton::clicked, this, [this] {
        Q_EMIT takeOverWanted(m_found->chosen());
        m_found->show(rowsOf(m_last));
        showWhatIsPossible();
    });
    connect(m_found, &CanFoundModel::chosenChanged, this, &CanSearchPage::showWhatIsPossible);
    showWhatIsPossible();
}

CanSearchPage::~CanSearchPage()
{
    m_table->setModel(nullptr);
}

void CanSearchPage::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = bus;
    m_isSearching = false;
    m_progress->hide();
    m_message->withdraw();
    m_last.clear();
    m_found->show({});
    m_empty->setTexts(tr("No search yet"), whatIsAsked());
    m_content->setCurrentWidget(m_empty);
    if (bus != nullptr) {
        connect(bus, &CanopenSession::scanned, this, &CanSearchPage::showScan);
        connect(bus, &CanopenSession::stateChanged, this, &CanSearchPage::showWhatIsPossible);
        connect(bus, &QObject::destroyed, this, [this] { setBus(nullptr); });
    }
    showWhatIsPossible();
}

QString CanSearchPage::whyNot() const
{
    if (!m_bus || !m_bus->isOpen() || !m_bus->latest().connected)
        return tr("The CAN bus is not connected. Connect it first.");
    if (!m_bus->isOperating())
        return tr("The search sends on the bus, and in Watch nothing is sent. Switch to Operate first. Nodes "
                  "that tell of themselves are in the CAN bus panel without it.");
    return {};
}

void CanSearchPage::ask()
{
    if (const QString why = whyNot(); !why.isEmpty()) {
        m_message->showMessage(Role::attention, why);
        return;
    }
    m_message->showMessage(Role::attention, whatIsAsked(), tr("&Ask now"));
    m_message->focusSafe();
}

void CanSearchPage::start()
{
    m_message->withdraw();
    if (!whyNot().isEmpty() || m_isSearching)
        return;
    m_isSearching = true;
    m_last.clear();
    m_found->show({});
    m_empty->setTexts(tr("Searching"), whatIsAsked());
    m_content->setCurrentWidget(m_empty);
    m_progress->setRange(0, canopen::lastNode);
    m_progress->setValue(0);
    m_progress->show();
    m_bus->scan();
    showWhatIsPossible();
}

// What a node tells only the catalog understands.
std::vector<CanFoundRow> CanSearchPage::rowsOf(const std::vector<canopen::FoundNode> &found) const
{
    std::vector<CanFoundRow> rows;
    for (const canopen::FoundNode &one : found) {
        CanFoundRow &row = rows.emplace_back(CanFoundRow{.found = one, .device = {}, .deviceKey = {}});
        row.deviceKey = deviceOfNode(m_bus->catalog(), one.deviceType, one.identity);
        const DeviceDescription *described = m_bus->catalog().find(row.deviceKey);
        row.device = described != nullptr ? described->fullName()
                     : one.deviceType
                         ? sentence(tr("no encoder (device type %1)"), {hexNumber(*one.deviceType, 8)})
                         : tr("not known");
        row.isThere = m_bus->encoder(m_bus->placeOf(CanopenAddress{one.node}.place())) != nullptr;
    }
    return rows;
}

void CanSearchPage::showScan(const NodesScanned &scan)
{
    m_last = scan.found;
    m_found->show(rowsOf(m_last));
    m_progress->setValue(scan.asked);
    m_progress->setFormat(tr("%1 of %2 asked").arg(scan.asked).arg(canopen::lastNode));
    if (!scan.found.empty())
        m_content->setCurrentWidget(m_table);
    if (scan.isDone)
        showEnd(scan);
    showWhatIsPossible();
}

void CanSearchPage::showEnd(const NodesScanned &scan)
{
    m_isSearching = false;
    m_progress->hide();
    const QString cancelled = scan.isCancelled ? tr("The search was cancelled.") + u' ' : QString();
    if (!scan.found.empty()) {
        m_message->showMessage(scan.isCancelled ? Role::attention : Role::running,
                               cancelled +
                                   tr("Nodes found: %n.", nullptr, static_cast<int>(scan.found.size())));
        return;
    }
    m_empty->setTexts(scan.isCancelled ? tr("The search was cancelled") : tr("No node has answered"),
                      tr("Check the rate of the bus, its terminators, wiring and supply. A node that was "
                         "stopped does not answer; one without a number is found by LSS."));
}

void CanSearchPage::showWhatIsPossible()
{
    const QString why = whyNot();
    m_start->setEnabled(!m_isSearching && m_bus != nullptr);
    m_start->setToolTip(why.isEmpty() ? tr("Asks who is there, after a question (Alt+S)") : why);
    m_cancel->setEnabled(m_isSearching);
    m_take->setEnabled(!m_isSearching && !m_found->chosen().empty());
}

} // namespace codewheel
