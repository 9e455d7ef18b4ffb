// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_view.h"

#include "bus/encoder_bus.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_tree.h"

#include <QHeaderView>
#include <QLocale>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int maxPosition = 33'554'431;     // of 25 bit
constexpr int indentation = 3 * grid::unit; // a ring is wide and flat, and the panel narrow

int levelsBelow(const QAbstractItemModel &model, const QModelIndex &parent = {})
{
    int levels = 0;
    for (int row = 0; row < model.rowCount(parent); ++row)
        levels = std::max(levels, 1 + levelsBelow(model, model.index(row, 0, parent)));
    return levels;
}

} // namespace

StructureView::StructureView(QWidget *parent)
    : QWidget(parent)
    , m_model(new StructureModel(this))
    , m_tree(describe(new StructureTree(this), "structure", tr("Bus structure"),
                      tr("Choose a device to see it in the panels. Enter opens its monitors.")))
    , m_empty(
          new EmptyState(Icon::ring, tr("No bus is connected."), tr("The project has no devices yet."), this))
    , m_question(new InlineMessage(this))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_tree);
    layout->addWidget(m_empty);
    layout->addWidget(m_question);
    m_question->setObjectName(QStringLiteral("makeQuestion"));

    m_tree->setModel(m_model);
    m_tree->setIconSize({grid::smallIcon, grid::smallIcon});
    m_tree->setIndentation(indentation);
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setExpandsOnDoubleClick(false);
    m_tree->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_tree->header()->setSectionResizeMode(StructureModel::deviceColumn, QHeaderView::Interactive);
    m_tree->header()->setStretchLastSection(false);
    m_tree->hide();

    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex &index) {
                askForMake();
                if (const auto place = m_model->placeAt(index))
                    Q_EMIT chosen(*place);
                else if (const auto bus = m_model->busAt(index))
                    Q_EMIT busChosen(*bus);
            });
    connect(m_tree, &QTreeView::activated, this, [this](const QModelIndex &index) {
        if (const auto place = m_model->placeAt(index))
            Q_EMIT opened(*place);
        else if (const auto bus = m_model->busAt(index))
            Q_EMIT busOpened(*bus);
    });
    connect(m_tree, &QTreeView::customContextMenuRequested, this, [this](const QPoint &position) {
        const QModelIndex index = m_tree->indexAt(position);
        const QPoint globalPosition = m_tree->viewport()->mapToGlobal(position);
        if (const auto place = m_model->placeAt(index))
            Q_EMIT menuRequested(*place, globalPosition);
        else if (const auto bus = m_model->busAt(index))
            Q_EMIT busMenuRequested(*bus, globalPosition);
    });
    connect(m_model, &StructureModel::deviceMoved, this, [this](Place from, Place to) {
        if (current() == from)
            choose(to);
    });
    connect(m_question, &InlineMessage::actionTriggered, this, [this] {
        if (const auto number = current())
            Q_EMIT namingRequested(*number);
    });
    connect(m_model, &QAbstractItemModel::modelReset, this, &StructureView::showWhetherEmpty);
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { m_rowBefore = row(); });
    connect(m_model, &QAbstractItemModel::modelReset, this, &StructureView::restoreRow);
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &StructureView::showWhetherEmpty);
    connect(m_model, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex &first) {
        if (first.column() != StructureModel::positionColumn) // it has room for any
            m_measuring.start();
    });
    m_measuring.setSingleShot(true); // several rows that change at once are measured once
    connect(&m_measuring, &QTimer::timeout, this, &StructureView::measureColumns);
    setFocusProxy(m_tree);
}

// So that the columns stay where they are while positions run.
int StructureView::widestPosition() const
{
    return m_tree->fontMetrics().horizontalAdvance(QLocale().toString(maxPosition)) + 2 * grid::margin;
}

int StructureView::roomForNames() const
{
    return narrowestName() + m_tree->fontMetrics().horizontalAdvance(QStringLiteral("FRABA OCD-IB"));
}

// The number of a device has its room.
int StructureView::narrowestName() const
{
    return m_levels * indentation + grid::smallIcon + 2 * grid::margin +
           m_tree->fontMetrics().horizontalAdvance(QStringLiteral("10.10 ..."));
}

int StructureView::narrowestState() const
{
    return grid::smallIcon + 2 * grid::margin +
           m_tree->fontMetrics().horizontalAdvance(QStringLiteral("m..."));
}

void StructureView::measureColumns()
{
    for (int column = 0; column < StructureModel::columns; ++column)
        m_tree->resizeColumnToContents(column);
    m_tree->setColumnWidth(StructureModel::positionColumn, widestPosition());
    m_widestName = m_tree->columnWidth(StructureModel::deviceColumn);
    m_widestState = m_tree->columnWidth(StructureModel::stateColumn);
    placeColumns();
}

// The state is seen before the whole name is, and the number before a long state; the tooltip has all of it.
void StructureView::placeColumns()
{
    const int all = m_tree->viewport()->width();
    int left = all - m_widestState;
    const int beside = left - m_tree->columnWidth(StructureModel::positionColumn);
    if (beside >= std::min(m_widestName, roomForNames())) // the position is seen too where there is room
        left = beside;
    const int name = std::min(m_widestName, std::max(left, narrowestName()));
    m_tree->setColumnWidth(StructureModel::deviceColumn, name);
    m_tree->setColumnWidth(StructureModel::stateColumn,
                           std::min(m_widestState, std::max(all - name, narrowestState()))); // elided
}

void StructureView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placeColumns();
}

void StructureView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        m_measuring.start();
}

void StructureView::showTitles()
{
    m_model->showTitles();
}

void StructureView::addBus(EncoderBus &bus)
{
    const auto before = row();
    m_model->addBus(bus);
    bus.disconnect(this);
    connect(&bus, &EncoderBus::nodesChanged, this, &StructureView::askForMake);
    const std::vector<Place> places = bus.places();
    if (!places.empty() && !(before && has(*before)))
        choose(places.front());
    askForMake();
}

void StructureView::removeBus(BusId bus)
{
    m_model->removeBus(bus);
    askForMake();
}

// Nobody has chosen anything.
void StructureView::restoreRow()
{
    const QSignalBlocker silent(this);
    if (m_rowBefore && has(*m_rowBefore))
        chooseRow(*m_rowBefore);
}

std::optional<BusId> StructureView::currentBus() const
{
    const QModelIndex index = m_tree->currentIndex();
    return m_model->placeAt(index) ? std::nullopt : m_model->busAt(index);
}

std::optional<Place> StructureView::row() const
{
    const auto bus = currentBus();
    return bus ? std::optional(Place{*bus}) : current();
}

bool StructureView::has(Place row) const
{
    return (row.isEmpty() ? m_model->indexOf(row.bus) : m_model->indexOf(row)).isValid();
}

void StructureView::choose(BusId bus)
{
    m_tree->setCurrentIndex(m_model->indexOf(bus));
}

void StructureView::chooseRow(Place row)
{
    if (row.isEmpty())
        choose(row.bus);
    else
        choose(row);
}

void StructureView::setProject(const ProjectDocument &project, const Catalog &catalog)
{
    m_model->setProject(project, catalog);
}

void StructureView::showWhetherEmpty()
{
    const bool isEmpty = m_model->rowCount() == 0;
    m_levels = levelsBelow(*m_model);
    m_tree->expandAll();
    m_tree->setVisible(!isEmpty);
    m_empty->setVisible(isEmpty);
    measureColumns();
}

// The ID code tells the profile, never the make. A device that nobody named is asked for where the catalog
// has devices of its code.
void StructureView::askForMake()
{
    const auto place = current();
    if (place && m_model->makeIsOpen(*place))
        m_question->showMessage(Role::attention,
                                tr("The bus does not tell which make %1 is.").arg(place->toString()),
                                tr("Name it"));
    else
        m_question->withdraw();
}

std::optional<Place> StructureView::current() const
{
    return m_model->placeAt(m_tree->currentIndex());
}

void StructureView::choose(Place place)
{
    m_tree->setCurrentIndex(m_model->indexOf(place));
}

} // namespace codewheel
