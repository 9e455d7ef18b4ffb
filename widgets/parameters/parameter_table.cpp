// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_table.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"
#include "widgets/look/quiet_table.h"
#include "widgets/parameters/parameter_delegate.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/value_input.h"

#include <QApplication>
#include <QKeyEvent>

#include <algorithm>

namespace codewheel {

namespace {

constexpr double nameShare = 0.36; // of the width
constexpr double largestNameShare = 0.5;
constexpr int smallestColumn = 40;

} // namespace

ParameterTable::ParameterTable(ParameterModel &model, QWidget *parent)
    : QTableView(parent)
    , m_model(model)
{
    auto *delegate = new ParameterDelegate(this);
    setUpQuietTable(*this, model, tr("Parameters of the encoder"));
    setItemDelegate(delegate);
    setSelectionMode(ExtendedSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    allowEliding(*this, ParameterModel::nameColumn);
    horizontalHeader()->setMinimumSectionSize(smallestColumn);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(ParameterModel::wantedColumn, QHeaderView::Stretch);
    connect(delegate, &ParameterDelegate::inputChecked, this, &ParameterTable::inputChecked);
    connect(this, &QTableView::clicked, this, &ParameterTable::activateCell);
    for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(&model, changed, this, &ParameterTable::fitColumns);
    connect(&model, &QAbstractItemModel::modelReset, this, &ParameterTable::fitColumns);
    connect(&model, &QAbstractItemModel::dataChanged, this, &ParameterTable::fitColumns);
    onEvent(this, {QEvent::StyleChange, QEvent::FontChange}, [this] { fitColumns(); });
}

bool ParameterTable::finishEditing()
{
    for (ValueInput *input : viewport()->findChildren<ValueInput *>())
        if (input->isVisible() && !input->value()) {
            input->setFocus();
            return false;
        }
    setFocus();
    return true;
}

std::optional<ParameterTable::Typed> ParameterTable::typed() const
{
    for (const ValueInput *input : viewport()->findChildren<ValueInput *>())
        if (input->isVisible() && input->isModified())
            return Typed{input->parameter(), input->text()};
    return {};
}

void ParameterTable::goOn(const Typed &typed)
{
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (m_model.rowAt(row).isHead() || m_model.rowAt(row).parameter.parameter != typed.parameter)
            continue;
        edit(m_model.index(row, ParameterModel::wantedColumn));
        for (ValueInput *input : viewport()->findChildren<ValueInput *>()) {
            input->setText(typed.text);
            input->setModified(true);
        }
    }
}

bool ParameterTable::hasWantedValue(int row) const
{
    return !m_model.rowAt(row).isReadOnly() || m_model.rowAt(row).isTold();
}

// A known value that is too long for its column takes up both where nothing is wanted.
void ParameterTable::spanColumns()
{
    clearSpans();
    for (int row = 0; row < m_model.rowCount(); ++row)
        if (m_model.rowAt(row).isHead())
            setSpan(row, 0, 1, m_model.columnCount());
        else if (!hasWantedValue(row) &&
                 ParameterDelegate::lineWidth(m_model.index(row, ParameterModel::knownColumn)) >
                     columnWidth(ParameterModel::knownColumn))
            setSpan(row, ParameterModel::knownColumn, 1, 2);
}

void ParameterTable::activateCell(const QModelIndex &index)
{
    if (QApplication::keyboardModifiers() & (Qt::ControlModifier | Qt::ShiftModifier))
        return; // selects several
    if (m_model.isFoldable(index)) {
        m_model.toggleRegisters();
        if (m_model.showsRegisters())
            scrollTo(index, PositionAtTop);
    } else if (index.isValid() && index.flags().testFlag(Qt::ItemIsEditable) && state() != EditingState) {
        edit(index);
    }
}

// Tab and Shift+Tab in a field: the next and the previous wanted value.
QModelIndex ParameterTable::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers)
{
    if (action != MoveNext && action != MovePrevious)
        return QTableView::moveCursor(action, modifiers);
    const int step = action == MoveNext ? 1 : -1;
    for (int row = currentIndex().row() + step; row >= 0 && row < model()->rowCount(); row += step) {
        const QModelIndex wanted = model()->index(row, ParameterModel::wantedColumn);
        if (wanted.flags().testFlag(Qt::ItemIsEditable))
            return wanted;
    }
    return {};
}

QList<KeyHelp> ParameterTable::keys()
{
    return {{keyNames({Qt::Key_Return, Qt::Key_F2}), tr("Edits the wanted value; so does typing")},
            {keyNames({Qt::Key_Tab, Qt::SHIFT | Qt::Key_Tab}),
             tr("While editing: the next wanted value, or the one before")},
            {keyNames({Qt::Key_Delete}), tr("Leaves the selected parameters unchanged")},
            {keyNames({Qt::Key_Return, Qt::Key_Space}), tr("Opens or closes a heading")}};
}

void ParameterTable::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const QModelIndex wanted = currentIndex().siblingAtColumn(ParameterModel::wantedColumn);
    if ((isEnter || event->key() == Qt::Key_Space) && m_model.isFoldable(wanted)) {
        activateCell(wanted.siblingAtColumn(ParameterModel::nameColumn));
        return;
    }
    if (state() != EditingState && wanted.isValid() && wanted.flags().testFlag(Qt::ItemIsEditable)) {
        if (isEnter || event->key() == Qt::Key_F2) {
            edit(wanted);
            return;
        }
        if (event->key() == Qt::Key_Delete) {
            leaveSelectedAlone();
            return;
        }
        if (!event->text().isEmpty() && event->text().front().isPrint())
            setCurrentIndex(wanted); // so that typing begins there
    }
    QTableView::keyPressEvent(event);
}

void ParameterTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

void ParameterTable::leaveSelectedAlone()
{
    for (const QModelIndex &row : selectionModel()->selectedRows(ParameterModel::wantedColumn))
        if (row.flags().testFlag(Qt::ItemIsEditable))
            model()->setData(row, {}, Qt::EditRole);
}

// Of those that have to fit: others take up two columns.
int ParameterTable::widest(int column, int (*widthOf)(const QModelIndex &)) const
{
    int width = horizontalHeader()->sectionSizeHint(column);
    for (int row = 0; row < m_model.rowCount(); ++row)
        if (!m_model.rowAt(row).isHead() && hasWantedValue(row))
            width = std::max(width, widthOf(m_model.index(row, column)));
    return width;
}

int ParameterTable::longestName(const QFont &font) const
{
    const QFontMetrics metrics(font);
    int longest = 0;
    for (int row = 0; row < m_model.rowCount(); ++row)
        if (!m_model.rowAt(row).isHead())
            for (const QString &word : m_model.index(row, ParameterModel::nameColumn)
                                           .data()
                                           .toString()
                                           .replace(u'-', u' ')
                                           .split(u' '))
                longest = std::max(longest, metrics.horizontalAdvance(word) + 2 * grid::unit);
    return longest;
}

// The names so wide that their longest word stands on one line, where the values leave room for it: in the
// usual size if no number has to be small for it.
void ParameterTable::fitColumns()
{
    const int width = viewport()->width();
    int known = widest(ParameterModel::knownColumn, ParameterDelegate::leastWidth);
    int wanted = widest(ParameterModel::wantedColumn, ParameterDelegate::leastWidth);
    const int wholeKnown = std::max(known, widest(ParameterModel::knownColumn, ParameterDelegate::wordWidth));
    const int wholeWanted =
        std::max(wanted, widest(ParameterModel::wantedColumn, ParameterDelegate::wordWidth));
    int longest = longestName(textFont());
    if (longest + wholeKnown + wholeWanted <= width) {
        known = wholeKnown;
        wanted = wholeWanted;
    } else {
        longest = longestName(textFont(TextSize::small));
    }
    const int name = std::clamp(longest, qRound(width * nameShare), qRound(width * largestNameShare));
    const int values = std::max(width - name, known + wanted);
    setColumnWidth(ParameterModel::nameColumn, width - values);
    setColumnWidth(ParameterModel::knownColumn, std::clamp(values / 2, known, values - wanted));
    spanColumns();
    scheduleDelayedItemsLayout(); // values take more lines in a narrower column
}

} // namespace codewheel
