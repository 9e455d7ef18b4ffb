// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_view.h"

#include "bus/encoder_bus.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"
#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_delegate.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_tree.h"
#include "widgets/structure/tree_filter.h"

#include <QHeaderView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int indentation = 3 * grid::unit; // rings are wide and flat, and the panel is narrow

int levelsBelow(const QAbstractItemModel &model, const QModelIndex &parent = {})
{
    int levels = 0;
    for (int row = 0; row < model.rowCount(parent); ++row)
        levels = std::max(levels, 1 + levelsBelow(model, model.index(row, 0, parent)));
    return levels;
}

void listBelow(const StructureModel &model, const QModelIndex &parent, std::vector<ListedDevice> &devices)
{
    const auto bus = model.busAt(parent);
    const QString title = bus ? parent.data().toString() : devices.back().bus;
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, StructureModel::deviceColumn, parent);
        const auto text = [&index](int column) { return index.siblingAtColumn(column).data().toString(); };
        if (const auto place = model.placeAt(index))
            devices.push_back({*place, index.data().toString(), title, text(StructureModel::stateColumn),
                               text(StructureModel::positionColumn), text(StructureModel::profileColumn),
                               text(StructureModel::codeColumn),
                               qvariant_cast<QIcon>(index.data(Qt::DecorationRole))});
        listBelow(model, index, devices);
    }
}

bool asksForAttention(const QModelIndex &index)
{
    return index.data(StructureModel::isAttentionRole).toBool();
}

bool isFault(const QModelIndex &index)
{
    return index.data(StructureModel::isFaultRole).toBool();
}

} // namespace

StructureView::StructureView(QWidget *parent)
    : QWidget(parent)
    , m_model(new StructureModel(this))
    , m_tree(describe(new StructureTree(this), "structure", tr("Bus structure"),
                      tr("Choose a device to see it in the panels. Enter opens its monitors, or says what is "
                         "wrong with one in red; dragged onto the monitors, it is pinned there.")))
    , m_filter(nullptr)
    , m_empty(
          new EmptyState(Icon::ring, tr("No bus is connected"), tr("The project has no devices yet."), this))
    , m_question(new InlineMessage(this))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_tree);
    layout->addWidget(m_empty);
    layout->addWidget(m_question);
    m_question->setObjectName(QStringLiteral("makeQuestion"));

    m_tree->setModel(m_model);
    m_filter = new TreeFilter(*m_tree, this);
    layout->insertWidget(0, m_filter);
    m_tree->setIconSize({grid::smallIcon, grid::smallIcon});
    m_tree->setIndentation(indentation);
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setExpandsOnDoubleClick(false);
    m_tree->setDragDropMode(QAbstractItemView::DragOnly);
    m_tree->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_tree->header()->setSectionResizeMode(StructureModel::deviceColumn, QHeaderView::Stretch);
    m_tree->header()->setStretchLastSection(false);
    m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tree->setItemDelegate(new StructureDelegate(this));
    m_tree->setItemDelegateForColumn(StructureModel::deviceColumn, new NameDelegate(this));
    for (const int column :
         {StructureModel::deviceColumn, StructureModel::stateColumn, StructureModel::positionColumn})
        allowEliding(*m_tree, column);
    // A scroll bar may come or go, too.
    onEventOf(m_tree->viewport(), {QEvent::Resize}, this, [this] { placeColumns(); });
    m_tree->hide();

    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex &index) {
                askForMake();
                if (const auto place = m_model->placeAt(index))
                    Q_EMIT chosen(*place);
                else if (const auto bus = m_model->busAt(index))
                    Q_EMIT busChosen(*bus);
            });
    connect(m_tree, &QTreeView::activated, this, &StructureView::open);
    connect(m_tree, &QTreeView::clicked, this, [this](const QModelIndex &index) {
        if (index.column() == StructureModel::stateColumn && (isFault(index) || asksForAttention(index)))
            Q_EMIT whyRequested(*rowOf(index));
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
    setFocusProxy(m_tree);
    onEvent(this, {QEvent::FontChange, QEvent::StyleChange}, [this] { placeColumns(); });
}

void StructureView::placeColumns()
{
    codewheel::placeColumns(*m_tree, m_levels);
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
    QTimer::singleShot(0, this, [this, id = bus.id()] { scrollTo(id); }); // once it has all its rows
}

// As much of it as there is room for. What is chosen stays so.
void StructureView::scrollTo(BusId bus)
{
    const QModelIndex index = m_model->indexOf(bus);
    if (!row())
        m_tree->setCurrentIndex(m_model->index(0, 0, index));
    m_tree->scrollTo(m_model->index(m_model->rowCount(index) - 1, 0, index));
    m_tree->scrollTo(index);
}

void StructureView::removeBus(BusId bus)
{
    m_model->removeBus(bus);
    askForMake();
}

// Blocks signals, since the user has chosen nothing.
void StructureView::restoreRow()
{
    const QSignalBlocker silent(this);
    if (m_rowBefore && has(*m_rowBefore))
        chooseRow(*m_rowBefore);
}

void StructureView::open(const QModelIndex &index)
{
    const auto row = rowOf(index);
    if (!row)
        return;
    if (isFault(index))
        Q_EMIT whyRequested(*row);
    else if (row->isEmpty())
        Q_EMIT busOpened(row->bus);
    else
        Q_EMIT opened(*row);
}

std::optional<BusId> StructureView::currentBus() const
{
    const QModelIndex index = m_tree->currentIndex();
    return m_model->placeAt(index) ? std::nullopt : m_model->busAt(index);
}

std::optional<Place> StructureView::row() const
{
    return rowOf(m_tree->currentIndex());
}

std::optional<Place> StructureView::rowOf(const QModelIndex &index) const
{
    if (const auto place = m_model->placeAt(index))
        return place;
    const auto bus = m_model->busAt(index);
    return bus ? std::optional(Place{*bus}) : std::nullopt;
}

QString StructureView::nameOf(Place row) const
{
    const QModelIndex index = row.isEmpty() ? m_model->indexOf(row.bus) : m_model->indexOf(row);
    return index.data().toString();
}

bool StructureView::has(Place row) const
{
    return (row.isEmpty() ? m_model->indexOf(row.bus) : m_model->indexOf(row)).isValid();
}

std::vector<ListedDevice> StructureView::devices() const
{
    std::vector<ListedDevice> devices;
    for (int row = 0; row < m_model->rowCount(); ++row)
        listBelow(*m_model, m_model->index(row, 0), devices);
    return devices;
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

void StructureView::reveal(Place row)
{
    const QModelIndex index = row.isEmpty() ? m_model->indexOf(row.bus) : m_model->indexOf(row);
    if (m_tree->isRowHidden(index.row(), index.parent()))
        m_filter->clear();
    chooseRow(row);
    m_tree->scrollTo(index);
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
    placeColumns();
}

// The ID code gives the profile, never the make. The user is asked about an unnamed device if the catalog has
// devices with its code.
void StructureView::askForMake()
{
    const auto place = current();
    if (place && m_model->makeIsOpen(*place))
        m_question->showMessage(Role::attention,
                                tr("The bus does not say which make %1 is.").arg(place->toString()),
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
