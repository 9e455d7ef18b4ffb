// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/gateway/gateway_panel.h"

#include "catalog/hex_code.h"
#include "kinds/interbus/ring/ring_session.h"
#include "widgets/kinds/interbus/gateway/link_figures_model.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/look/role_label.h"

#include <QEvent>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int gatewayPanelHeight = 260; // the rest is scrolled to
constexpr int figureDigits = 9;

} // namespace

GatewayPanel::GatewayPanel(RingSession &bus, QWidget *parent)
    : ScrolledPanel(tr("Gateway"), gatewayPanelHeight, parent)
    , m_bus(bus)
    , m_state(new RoleLabel(content()))
    , m_figures(new LinkFiguresModel(this))
    , m_table(describe(new QTableView(content()), tr("Figures of the link"),
                       tr("Since the bus was connected. A transaction is a request with its answer; the "
                          "median is that of the newest 1000")))
{
    auto *column = layOut<QVBoxLayout>(content(), grid::margin, grid::unit);
    column->addWidget(m_state);
    auto *form = makeForm(nullptr, grid::unit);
    m_gateway = addLine(*form, tr("Gateway"), tr("Where it is reached"));
    m_mode = addLine(*form, tr("Writing"), tr("In Watch only reads are sent"));
    m_status = addLine(*form, tr("Status register"), tr("As the gateway tells it, if it has one"));
    column->addLayout(form);
    auto *connection =
        addButton(tr("Connection…"), tr("Kind of link, host or port, and the registers of the gateway"));
    auto *registers = addButton(tr("Registers…"), tr("The registers of each device, and the word order"));
    column->addLayout(layOutRow({connection, registers, Stretch{1}}));
    connect(connection, &QPushButton::clicked, this, &GatewayPanel::connectionWanted);
    connect(registers, &QPushButton::clicked, this, &GatewayPanel::registersWanted);
    makeTable();
    column->addWidget(m_table);
    column->addStretch(1);
    connect(&bus, &RingSession::updated, this, &GatewayPanel::refresh);
    connect(&bus, &RingSession::stateChanged, this, &GatewayPanel::refresh);
    refresh();
}

GatewayPanel::~GatewayPanel()
{
    m_table->setModel(nullptr);
}

QPushButton *GatewayPanel::addButton(const QString &text, const QString &toolTip)
{
    auto *button = new QPushButton(text, content());
    button->setAutoDefault(false);
    button->setToolTip(toolTip);
    return button;
}

void GatewayPanel::makeTable()
{
    m_table->setModel(m_figures);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->horizontalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + grid::unit);
    m_table->verticalHeader()->setTextElideMode(Qt::ElideRight);
    onEventOf(m_table, {QEvent::Resize}, this, [this] { // the titles give way to the figures
        const int figures = QFontMetrics(numberFont()).horizontalAdvance(QString(figureDigits, u'0'));
        m_table->verticalHeader()->setMaximumWidth(
            std::max(0, m_table->width() - figures - 2 * grid::margin));
    });
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const auto fit = [this] {
        m_table->setFixedHeight(m_figures->rowCount() * m_table->verticalHeader()->defaultSectionSize() +
                                2 * m_table->frameWidth());
    };
    connect(m_figures, &QAbstractItemModel::modelReset, this, fit);
    fit();
}

void GatewayPanel::setGateway(const QString &gateway)
{
    m_gateway->setText(gateway);
}

QString GatewayPanel::stateOf(const Snapshot &ring) const
{
    if (!m_bus.isRunning())
        return tr("Connected, stopped");
    if (ring.outputsAreBlocked)
        return tr("Connected, but its outputs are blocked");
    if (!ring.told)
        return tr("Connected; whether the ring runs is not told");
    if (!ring.told->stands())
        return tr("Connected, and the ring runs");
    return ring.told->hasFailed ? tr("Connected, but the ring has failed")
                                : tr("Connected, but the ring stands still");
}

void GatewayPanel::refresh()
{
    const Snapshot &shown = m_bus.latest();
    const bool isOpen = m_bus.isOpen();
    switch (m_bus.state()) {
    case BusState::open:
        m_state->setState((shown.told && shown.told->stands()) || shown.outputsAreBlocked ? Role::fault
                                                                                          : Role::running,
                          stateOf(shown));
        break;
    case BusState::opening:
        m_state->setState(Role::attention, tr("Connecting"));
        break;
    case BusState::lost:
        m_state->setState(Role::fault, tr("Link lost; it is tried again each second"));
        break;
    case BusState::closed:
        m_state->setState(Role::inactive, tr("Not connected"));
        break;
    }
    const QString none = QStringLiteral("\u2013");
    m_mode->setText(shown.zerosAreDue     ? tr("The zeros of the ALARM STOP are sent until they arrive")
                    : !isOpen             ? none
                    : m_bus.isOperating() ? tr("Operate: OUT is written")
                                          : tr("Watch: only reads are sent"));
    const auto &figures = shown.figures;
    m_status->setText(figures && figures->status ? hexCode(*figures->status, 4) : none);
    m_figures->show(figures);
}

} // namespace codewheel
