// SPDX-License-Identifier: GPL-3.0-or-later
// What the structure editor is made of, and how its parts are connected.
#include "widgets/input/checked_delegate.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/heading_width.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/tool.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/structure_editor/insert_panel.h"
#include "widgets/structure_editor/plan_model.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int widestColumn = 44 * grid::unit;
constexpr int narrowestStation = 28 * grid::unit;
constexpr int rowsMeasured = 100; // for the width of columns, even before the page is shown
constexpr int lowestRows = 4;     // however low the window; one is hidden by the scroll bar

} // namespace

StructureEditor::StructureEditor(ProjectDocument &document, const Catalog &catalog, QWidget *parent)
    : Page(parent)
    , m_document(document)
    , m_edits(document, catalog)
    , m_model(new PlanModel(m_edits, this))
    , m_busLabel(new QLabel(tr("Planned b&us"), this))
    , m_bus(describe(new QComboBox(this), "plannedBus", tr("Planned bus"),
                     tr("The bus that is planned here; choosing a device elsewhere chooses its bus, too")))
    , m_tools(new QToolBar(this))
    , m_search(describe(new QLineEdit(this), "structureSearch", tr("Search the structure"),
                        tr("Goes to the devices with this text; Enter and Shift+Enter to the next and the "
                           "previous one (Ctrl+F)")))
    , m_found(new QLabel(this))
    , m_tree(new QTreeView(this))
    , m_empty(new EmptyState(Icon::ring, tr("No devices are planned"),
                             tr("Insert the first one, or connect the bus and take it over."), this))
    , m_insert(new InsertPanel(m_edits, this))
    , m_message(new InlineMessage(this))
    , m_findings(
          describe(new QToolButton(this), "findings", tr("Goes to the next device with a finding (F3)")))
    , m_finding(wrappedLabel(this, "findingsOfDevice"))
{
    makeTools();
    makeSearch();
    makeTree();
    arrange();
    connectParts();
    m_insert->hide();
    showKind();
    showProject();
    showCurrent();
}

QAction *StructureEditor::addTool(const Tool &tool, Slot slot)
{
    QAction *action = codewheel::addTool(*this, *m_tools, tool);
    static_cast<QToolButton *>(m_tools->widgetForAction(action))->setFocusPolicy(Qt::TabFocus);
    connect(action, &QAction::triggered, this, slot);
    return action;
}

template <PlanStep step>
void StructureEditor::move()
{
    if (const auto id = current())
        say(m_edits.move(*id, step));
}

void StructureEditor::makeTools()
{
    setUpToolBar(*m_tools);
    addTool({Icon::add, tr("Insert…"), Qt::Key_Insert, tr("Insert a device from the catalog or by ID code")},
            &StructureEditor::openInsertPanel);
    auto *insert = static_cast<QToolButton *>(m_tools->widgetForAction(m_tools->actions().first()));
    connect(m_tools, &QToolBar::toolButtonStyleChanged, insert, // it keeps its word, however narrow the bar
            [insert] { insert->setToolButtonStyle(Qt::ToolButtonTextBesideIcon); });
    m_deviceActions = {addTool({Icon::remove, tr("Remove"), Qt::CTRL | Qt::Key_Delete,
                                tr("Remove the chosen devices with all that hangs below")},
                               &StructureEditor::remove)};
    m_orderActions = {
        addTool({Icon::up, tr("Up"), Qt::ALT | Qt::Key_Up, tr("Move before its neighbour")},
                &StructureEditor::move<PlanStep::up>),
        addTool({Icon::down, tr("Down"), Qt::ALT | Qt::Key_Down, tr("Move behind its neighbour")},
                &StructureEditor::move<PlanStep::down>),
        addTool(
            {Icon::next, tr("In"), Qt::ALT | Qt::Key_Right, tr("Hang it below the bus terminal before it")},
            &StructureEditor::move<PlanStep::in>),
        addTool({Icon::back, tr("Out"), Qt::ALT | Qt::Key_Left, tr("Take it out, behind its bus terminal")},
                &StructureEditor::move<PlanStep::out>),
        addTool({Icon::refresh, tr("Local bus or branch"), Qt::CTRL | Qt::Key_B,
                 tr("From the local bus of its bus terminal into the branch, and back")},
                &StructureEditor::move<PlanStep::changeBus>),
    };
    m_deviceActions << m_orderActions;
    m_tools->addSeparator();
}

void StructureEditor::makeSearch()
{
    m_search->setClearButtonEnabled(true);
    m_found->setObjectName(QStringLiteral("structureFound"));
    m_tools->addWidget(m_search);
    m_tools->addWidget(m_found);
    auto *find = new QShortcut(QKeySequence::Find, this);
    find->setContext(Qt::WidgetWithChildrenShortcut);
    connect(find, &QShortcut::activated, this, [this] {
        m_search->setFocus();
        m_search->selectAll();
    });
    auto *previous = new QShortcut(Qt::SHIFT | Qt::Key_Return, m_search);
    previous->setContext(Qt::WidgetShortcut);
    connect(previous, &QShortcut::activated, this, &StructureEditor::findPrevious);
}

void StructureEditor::makeTree()
{
    m_tree->setObjectName(QStringLiteral("plan"));
    m_tree->setAccessibleName(tr("Planned bus structure"));
    m_tree->setModel(m_model);
    auto *cells = new CheckedDelegate(
        [this](const QModelIndex &cell, const QString &text) { return m_model->complaint(cell, text); },
        this);
    m_tree->setItemDelegate(cells);
    connect(cells, &CheckedDelegate::inputChecked, this,
            [this](const QString &wrong) { m_message->showMessage(Role::attention, wrong); });
    m_tree->setIconSize({grid::smallIcon, grid::smallIcon});
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_tree->setExpandsOnDoubleClick(false);
    m_tree->setDragDropMode(QAbstractItemView::DragDrop);
    m_tree->setDefaultDropAction(Qt::MoveAction);
    m_tree->setAutoExpandDelay(500);
    m_tree->setMinimumHeight(m_tree->header()->sizeHint().height() +
                             lowestRows * (m_tree->fontMetrics().height() + grid::unit));
    m_tree->header()->setResizeContentsPrecision(rowsMeasured);
    m_tree->header()->setStretchLastSection(true);
    m_tree->expandAll();
}

// As wide as their content, with a minimum to type in; nothing jumps while editing.
void StructureEditor::fitColumns()
{
    m_tree->expandAll();
    const QAbstractItemView &cells = *m_tree;
    for (int column = 0; column < m_model->columnCount() - 1; ++column) {
        const int content =
            std::max(cells.sizeHintForColumn(column), headingWidth(*m_tree->header(), column));
        const PlanField field = m_model->columnAt(column).field;
        const int least = field == PlanField::station ? narrowestStation : 0;
        const int most = field == PlanField::device ? QWIDGETSIZE_MAX : widestColumn;
        m_tree->setColumnWidth(column, std::clamp(content + grid::unit, least, most));
    }
}

// No place is cut, whatever else was typed into the columns.
void StructureEditor::widenPlaces()
{
    const int content = static_cast<const QAbstractItemView &>(*m_tree).sizeHintForColumn(0) + grid::unit;
    m_tree->setColumnWidth(0, std::max(m_tree->columnWidth(0), content));
}

void StructureEditor::arrange()
{
    m_findings->setAutoRaise(true);
    m_finding->setTextFormat(Qt::PlainText); // names stand in it
    m_findings->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_findings->setShortcut(Qt::Key_F3);
    auto *below = new QWidget; // below the tree
    m_below = layOut<QVBoxLayout>(below, grid::unit);
    m_below->addWidget(m_insert);
    m_below->addLayout(layOutRow({{m_findings, 0, Qt::AlignTop}, {m_finding, 1}}, {.spacing = grid::margin}));
    auto *column = new QVBoxLayout;
    column->setContentsMargins(grid::margin, 0, grid::margin, grid::margin);
    column->setSpacing(grid::unit);
    column->addWidget(m_message);
    column->addWidget(m_empty, 1);
    column->addWidget(m_tree, 1);
    column->addWidget(new ContentScrollArea(below, this));
    auto *layout = layOut<QVBoxLayout>(this, grid::unit);
    m_busLabel->setBuddy(m_bus);
    auto *bus = new QHBoxLayout;
    bus->setContentsMargins(grid::margin, grid::unit, grid::margin, 0);
    bus->setSpacing(grid::groupGap);
    bus->addWidget(m_busLabel);
    bus->addWidget(m_bus);
    bus->addStretch();
    layout->addLayout(bus);
    layout->addWidget(m_tools);
    layout->addLayout(column);
}

void StructureEditor::connectParts()
{
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &StructureEditor::showCurrent);
    connect(m_search, &QLineEdit::textChanged, this, &StructureEditor::search);
    connect(m_search, &QLineEdit::returnPressed, this, &StructureEditor::findNext);
    connect(m_insert, &InsertPanel::insertRequested, this, &StructureEditor::insert);
    connect(m_insert, &InsertPanel::changeRequested, this, &StructureEditor::changeTo);
    connect(m_insert, &InsertPanel::closeRequested, this, [this] {
        m_insert->hide();
        m_tree->setFocus();
    });
    connect(m_model, &PlanModel::refused, this, [this](const Refusal &why) { say(tl::unexpected(why)); });
    connect(m_model, &PlanModel::badInput, this,
            [this](const QString &sentence) { m_message->showMessage(Role::attention, sentence); });
    connect(m_model, &QAbstractItemModel::rowsInserted, m_tree, &QTreeView::expand);
    connect(m_bus, &QComboBox::activated, this, [this](int index) {
        const BusId bus = m_buses.at(static_cast<std::size_t>(index));
        setBus(bus);
        Q_EMIT busChosen(bus);
    });
    connect(m_empty, &EmptyState::actionTriggered, this, &StructureEditor::openInsertPanel);
    connect(&m_document, &ProjectDocument::changed, this, &StructureEditor::showProject);
    connect(m_findings, &QToolButton::clicked, this, &StructureEditor::goToFinding);
    connect(&m_document, &ProjectDocument::replaced, this, &StructureEditor::fitColumns,
            Qt::QueuedConnection);
    fitColumns();
}

} // namespace codewheel
