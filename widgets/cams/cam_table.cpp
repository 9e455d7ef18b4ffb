// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_table.h"

#include "vocabulary/refusal_text.h"
#include "widgets/cams/cam_rows.h"
#include "widgets/cams/cam_table_model.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/cams/position_input.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"
#include "widgets/look/quiet_table.h"

#include <QKeyEvent>

namespace codewheel {
namespace {

// Over all programs: it may lie beyond the range, which was not known when it was entered.
std::int64_t largestGiven(const CamDocument &document)
{
    std::int64_t largest = 0;
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        for (const Cam &cam : document.program(number).cam)
            largest = std::max({largest, cam.start, cam.stop});
    return largest;
}

} // namespace

CamDelegate::CamDelegate(const CamSheet &sheet, QObject *parent)
    : CheckedDelegate(parent)
    , m_sheet(sheet)
{}

QWidget *CamDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &,
                                   const QModelIndex &index) const
{
    const std::size_t cam = static_cast<const CamTableModel &>(*index.model()).rowAt(index.row()).number;
    const std::int64_t largest = m_sheet.largest();
    const auto complaint = [cam, largest](const RefusalArgument &given) {
        return refusalText({RefusalKind::badInput,
                            RefusalId::camPositionTooLarge,
                            {static_cast<std::int64_t>(cam), given, largest}});
    };
    auto *input = new PositionInput(0, largest, complaint, parent);
    const int column = index.column();
    input->setAccessibleName((column == CamTableModel::startColumn  ? tr("Start of cam %1")
                              : column == CamTableModel::stopColumn ? tr("Stop of cam %1")
                                                                    : tr("Hysteresis of cam %1"))
                                 .arg(cam));
    input->setToolTip(tr("A position from 0 to %1; decimal, or hexadecimal as 0x.. or ..h")
                          .arg(cam_texts::position(largest)));
    connect(input, &PositionInput::inputChecked, this, &CamDelegate::inputChecked);
    return input;
}

// What the user is typing is not overwritten by what comes from the bus.
void CamDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    auto *input = static_cast<PositionInput *>(editor);
    if (!input->isModified())
        input->setText(QString::number(index.data(Qt::EditRole).toLongLong()));
}

void CamDelegate::setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const
{
    if (const auto position = static_cast<PositionInput *>(editor)->value())
        model->setData(index, qlonglong{*position}, Qt::EditRole);
}

CamTable::CamTable(CamSheet &sheet, QWidget *parent)
    : QTableView(parent)
    , m_sheet(sheet)
    , m_model(new CamTableModel(sheet, this))
{
    auto *delegate = new CamDelegate(sheet, this);
    setUpQuietTable(*this, *m_model, tr("Cams of the program"));
    setItemDelegate(delegate);
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    horizontalHeader()->setMinimumSectionSize(1);
    setCurrentIndex(m_model->index(0, CamTableModel::startColumn));
    connect(delegate, &CamDelegate::inputChecked, this, &CamTable::inputChecked);
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex &now) {
        if (now.isValid())
            m_sheet.setCurrent(m_model->rowAt(now.row()).number);
    });
    connect(&sheet, &CamSheet::currentChanged, this, [this](std::size_t cam) {
        const int row = static_cast<int>(cam);
        if (row != currentIndex().row())
            setCurrentIndex(m_model->index(row, CamTableModel::startColumn));
    });
    for (const auto signal : {&CamSheet::documentChanged, &CamSheet::largestChanged})
        connect(&sheet, signal, this, &CamTable::fit);
    connect(&sheet, &CamSheet::programChanged, this, &CamTable::fit);
    fit();
    onEvent(this, {QEvent::StyleChange, QEvent::FontChange}, [this] { fit(); });
}

bool CamTable::finishEditing()
{
    for (PositionInput *input : viewport()->findChildren<PositionInput *>())
        if (input->isVisible() && !input->value()) {
            input->setFocus();
            return false;
        }
    setFocus();
    return true;
}

// As wide as the widest text that can appear, so that nothing jumps while the encoder turns.
void CamTable::fit()
{
    const int lengthBefore = horizontalHeader()->length();
    setColumnHidden(CamTableModel::hysteresisColumn, !m_sheet.abilities().hasHysteresis);
    setColumnHidden(CamTableModel::polarityColumn, !m_sheet.abilities().hasPolarity);
    const int height = camRowHeight(*this);
    verticalHeader()->setMinimumSectionSize(height);
    verticalHeader()->setDefaultSectionSize(height);
    horizontalHeader()->setFixedHeight(camAxisHeight(*this));
    const int check = style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, this) + grid::margin;
    const int icon = grid::smallIcon + grid::margin;
    const std::int64_t largest = std::max(m_sheet.largest(), largestGiven(m_sheet.document()));
    const int positions = QFontMetrics(numberFont()).horizontalAdvance(cam_texts::position(largest)) +
                          (largest > m_sheet.largest() ? icon : 0);
    const auto words = [this](const QStringList &texts) {
        int width = 0;
        for (const QString &text : texts)
            width = std::max(width, fontMetrics().horizontalAdvance(text));
        return width;
    };
    const std::array contents{check + fontMetrics().horizontalAdvance(QStringLiteral("0")),
                              positions,
                              positions,
                              positions,
                              check,
                              icon + words({tr("on"), tr("off")}),
                              icon + words({tr("same"), tr("differs"), tr("unknown")})};
    for (int column = 0; column < m_model->columnCount(); ++column) {
        const QString header = m_model->headerData(column, Qt::Horizontal).toString();
        const int content = contents.at(static_cast<std::size_t>(column));
        setColumnWidth(column, std::max(content, words({header})) + 2 * grid::margin);
    }
    if (horizontalHeader()->length() != lengthBefore)
        updateGeometry();
}

QSize CamTable::sizeHint() const
{
    const int rows = m_model->rowCount() * camRowHeight(*this);
    return {horizontalHeader()->length() + 2 * frameWidth(), rows + camAxisHeight(*this) + 2 * frameWidth()};
}

// Tab and Shift+Tab in a field: stop of the cam, its hysteresis, start of the next one.
QModelIndex CamTable::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers)
{
    if (action != MoveNext && action != MovePrevious)
        return QTableView::moveCursor(action, modifiers);
    const QModelIndex at = currentIndex();
    const int first = CamTableModel::startColumn;
    const int last =
        m_sheet.abilities().hasHysteresis ? CamTableModel::hysteresisColumn : CamTableModel::stopColumn;
    if (action == MoveNext && at.column() < last)
        return at.siblingAtColumn(std::max<int>(at.column() + 1, CamTableModel::stopColumn));
    if (action == MovePrevious && at.column() > first)
        return at.siblingAtColumn(at.column() > last ? first : at.column() - 1);
    return action == MoveNext ? m_model->index(at.row() + 1, first) : m_model->index(at.row() - 1, last);
}

QList<KeyHelp> CamTable::keys()
{
    return {{keyNames({Qt::Key_Return, Qt::Key_F2}), tr("Edits a position; so does typing")},
            {keyNames({Qt::Key_Space}), tr("Switches the cam on or off")},
            {keyNames({Qt::Key_Delete}), tr("Clears the cam")}};
}

void CamTable::keyPressEvent(QKeyEvent *event)
{
    if (state() == EditingState || !currentIndex().isValid()) {
        QTableView::keyPressEvent(event);
        return;
    }
    const std::size_t cam = m_model->rowAt(currentIndex().row()).number;
    const QModelIndex position = CamTableModel::isPosition(currentIndex().column())
                                     ? currentIndex()
                                     : currentIndex().siblingAtColumn(CamTableModel::startColumn);
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_F2:
        setCurrentIndex(position);
        edit(position);
        return;
    case Qt::Key_Delete:
        m_sheet.clear(cam);
        return;
    case Qt::Key_Space:
        m_sheet.setActive(cam, !m_sheet.cam(cam).active);
        return;
    default:
        break;
    }
    if (!event->text().isEmpty() && event->text().front().isPrint())
        setCurrentIndex(position); // so that typing begins there
    QTableView::keyPressEvent(event);
}

} // namespace codewheel
