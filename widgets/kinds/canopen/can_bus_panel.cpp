// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/can_bus_panel.h"

#include "kinds/canopen/bus/canopen_session.h"
#include "widgets/job/whole_table.h"
#include "widgets/kinds/canopen/can_node_model.h"
#include "widgets/kinds/canopen/nmt_texts.h"
#include "widgets/look/describe.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/role_label.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

namespace codewheel {
namespace {

constexpr int canPanelHeight = 300; // the rest is scrolled to

} // namespace

CanBusPanel::CanBusPanel(QWidget *parent)
    : ScrolledPanel(tr("CAN bus"), canPanelHeight, parent)
    , m_state(new RoleLabel(content()))
    , m_nodes(new CanNodeModel(this))
    , m_table(new WholeTable(content()))
{
    makeTable();
    auto *form = makeForm(nullptr, grid::unit);
    for (const CanopenFact &fact : canopenFacts())
        m_facts.emplace_back(&fact, addLine(*form, fact.label(), fact.toolTip()));
    auto *column = layOut<QVBoxLayout>(content(), grid::margin, grid::unit);
    column->addWidget(m_state);
    column->addWidget(makeButtons()); // in sight however many nodes there are
    column->addWidget(m_table);
    column->addLayout(form);
    column->addStretch(1);
    setFocusProxy(m_table);
    showState();
}

CanBusPanel::~CanBusPanel()
{
    m_table->setModel(nullptr);
}

void CanBusPanel::makeTable()
{
    setUpQuietTable(*m_table, *m_nodes, tr("Nodes of the CAN bus"));
    m_table->setToolTip(tr("Every node that was heard, and the encoders of this bus that were not"));
    FittedColumns::useIn(*m_table, CanNodeModel::node);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &CanBusPanel::showWhatIsPossible);
}

QWidget *CanBusPanel::makeButtons()
{
    auto *buttons = new QWidget(content());
    auto *rows = layOut<QGridLayout>(buttons, grid::unit); // side by side they are wider than a panel
    for (const NmtAction &action : nmtActions()) {
        auto *button = describe(new QPushButton(action.label(), buttons), action.key, action.toolTip());
        button->setAutoDefault(false);
        const int place = static_cast<int>(m_commands.size());
        rows->addWidget(button, place / 2, place % 2);
        m_commands.push_back(button);
        connect(button, &QPushButton::clicked, this, [this, command = action.command] {
            if (const auto node = chosenNode())
                Q_EMIT commandWanted(*node, command);
        });
    }
    m_setup = describe(new QPushButton(tr("Number and rate…"), buttons), "canSetup", {});
    m_find = describe(new QPushButton(tr("Without a number…"), buttons), "canFind", {});
    for (QPushButton *button : {m_setup, m_find})
        button->setAutoDefault(false);
    const int row = static_cast<int>(m_commands.size() + 1) / 2;
    rows->addWidget(m_setup, row, 0);
    rows->addWidget(m_find, row, 1);
    connect(m_setup, &QPushButton::clicked, this, [this] {
        if (const auto node = chosenNode())
            Q_EMIT setupWanted(*node);
    });
    connect(m_find, &QPushButton::clicked, this, &CanBusPanel::searchWanted);
    return buttons;
}

void CanBusPanel::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = bus;
    if (bus != nullptr) {
        connect(bus, &CanopenSession::stateChanged, this, &CanBusPanel::showState);
        connect(bus, &CanopenSession::nodesChanged, this, &CanBusPanel::showNodes);
        connect(bus, &CanopenSession::updated, this, &CanBusPanel::showNodes);
        connect(bus, &CanopenSession::updated, this, &CanBusPanel::showFigures);
        connect(bus, &QObject::destroyed, this, [this] { setBus(nullptr); });
    }
    showState();
}

void CanBusPanel::chooseNode(int node)
{
    const int row = m_nodes->rowOf(node);
    if (row >= 0)
        m_table->selectRow(row);
}

std::optional<int> CanBusPanel::chosenNode() const
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    return rows.isEmpty() ? std::nullopt : std::optional(m_nodes->rowAt(rows.front().row()).node);
}

void CanBusPanel::showState()
{
    const bool isOpen = m_bus && m_bus->isOpen();
    if (!isOpen)
        m_state->setState(Role::inactive, tr("Not connected"));
    else if (!m_bus->latest().connected)
        m_state->setState(Role::fault,
                          tr("No link; it is looked for each second. What is below is of before"));
    else if (m_bus->isOperating())
        m_state->setState(Role::running, tr("Open, in Operate"));
    else
        m_state->setState(Role::running, tr("Open, in Watch: nothing is sent"));
    showNodes();
    showFigures();
}

// The chosen node stays chosen.
void CanBusPanel::showNodes()
{
    const auto chosen = chosenNode();
    m_nodes->show(m_bus);
    if (chosen && !chosenNode())
        chooseNode(*chosen);
    showWhatIsPossible();
}

void CanBusPanel::showFigures()
{
    for (const auto &[fact, label] : m_facts) {
        const QString text = m_bus && m_bus->isOpen() ? fact->text(*m_bus) : QString();
        label->setText(text.isEmpty() ? QStringLiteral("\u2013") : text);
        label->setEnabled(m_bus && m_bus->latest().connected);
    }
}

QString CanBusPanel::whyNoCommand() const
{
    if (!m_bus || !m_bus->isOpen() || !m_bus->latest().connected)
        return tr("The CAN bus is not connected");
    if (!m_bus->isOperating())
        return tr("In Watch nothing is sent. Switch to Operate first");
    return chosenNode() ? QString() : tr("Choose a node of the table first");
}

void CanBusPanel::showWhatIsPossible()
{
    const QString whyNot = whyNoCommand();
    for (std::size_t i = 0; i < m_commands.size(); ++i) {
        m_commands[i]->setEnabled(whyNot.isEmpty());
        m_commands[i]->setToolTip(whyNot.isEmpty() ? nmtActions()[i].toolTip() : whyNot);
    }
    m_setup->setEnabled(chosenNode().has_value());
    m_setup->setToolTip(chosenNode() ? tr("Gives the chosen node another number or rate; nothing is written "
                                          "before a question")
                                     : tr("Choose a node of the table first"));
    m_find->setToolTip(tr("Looks for a device without a number by LSS, to give it one"));
}

} // namespace codewheel
