// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_table_model.h"

#include "widgets/cams/cam_texts.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

namespace codewheel {

CamTableModel::CamTableModel(CamSheet &sheet, QObject *parent)
    : TableModelBase(parent)
    , m_sheet(sheet)
{
    std::vector<CamRow> rows;
    for (std::size_t cam = 0; cam < CamProgram::cams; ++cam)
        rows.push_back(rowOf(cam));
    setRows(std::move(rows));
    connect(&sheet, &CamSheet::documentChanged, this, &CamTableModel::refresh);
    connect(&sheet, &CamSheet::numberChanged, this, &CamTableModel::refresh);
    connect(&sheet, &CamSheet::largestChanged, this, &CamTableModel::refresh);
    connect(&sheet, &CamSheet::liveChanged, this, &CamTableModel::refresh);
    connect(&sheet, &CamSheet::programChanged, this, [this](unsigned number) {
        if (number == m_sheet.number())
            refresh();
    });
}

CamRow CamTableModel::rowOf(std::size_t cam) const
{
    const auto &known = m_sheet.known(m_sheet.number());
    return {.number = cam,
            .cam = m_sheet.cam(cam),
            .isOn = m_sheet.isOn(cam),
            .mayBeEither = m_sheet.live().position && !m_sheet.isOn(cam),
            .isTold = m_sheet.live().isTold,
            .known = known ? std::optional(known->cam.at(cam)) : std::nullopt,
            .fits = m_sheet.fits(m_sheet.cam(cam))};
}

void CamTableModel::refresh()
{
    for (int row = 0; row < rowCount(); ++row)
        if (const CamRow now = rowOf(rowAt(row).number); now != rowAt(row))
            replace(row, now);
}

Qt::ItemFlags CamTableModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    switch (index.column()) {
    case camColumn:
        return usual | Qt::ItemIsUserCheckable;
    case startColumn:
    case stopColumn:
        return usual | Qt::ItemIsEditable;
    default:
        return usual;
    }
}

bool CamTableModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    const std::size_t number = rowAt(index.row()).number;
    if (role == Qt::CheckStateRole && index.column() == camColumn) {
        m_sheet.setActive(number, value.toInt() == Qt::Checked);
        return true;
    }
    if (role != Qt::EditRole || (flags(index) & Qt::ItemIsEditable) == 0)
        return false;
    Cam changed = m_sheet.cam(number);
    (index.column() == startColumn ? changed.start : changed.stop) = value.toLongLong();
    if (!m_sheet.fits(changed))
        return false;
    const CamGrip grip = index.column() == startColumn ? CamGrip::start : CamGrip::stop;
    m_sheet.setCam(number, changed, cam_texts::movement(number, grip));
    return true;
}

QVariant CamTableModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant((column == startColumn || column == stopColumn ? Qt::AlignRight : Qt::AlignLeft) |
                        Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const bool isTip = role == Qt::ToolTipRole;
    switch (column) {
    case camColumn:
        return isTip ? tr("Ticked: the cam is active. Only active cams come on.") : tr("Cam");
    case startColumn:
        return isTip ? tr("First position on which the cam is on, in steps") : tr("Start");
    case stopColumn:
        return isTip ? tr("Last position on which the cam is on, in steps; smaller than the start: through "
                          "zero")
                     : tr("Stop");
    case stateColumn:
        return isTip ? tr("What the encoder shows now in cam mode; in position mode, what these cams would "
                          "be")
                     : tr("Now");
    default:
        return isTip ? tr("Whether the encoder is known to have the same") : tr("Encoder");
    }
}

QVariant CamTableModel::cell(const CamRow &row, int column, int role) const
{
    const bool isPosition = column == startColumn || column == stopColumn;
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
        return text(row, column);
    case Qt::EditRole:
        if (!isPosition)
            return {};
        return qlonglong{column == startColumn ? row.cam.start : row.cam.stop};
    case Qt::CheckStateRole:
        return column == camColumn ? QVariant(row.cam.active ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::ToolTipRole:
        return cam_texts::description(m_sheet, row.number);
    case Qt::TextAlignmentRole:
        return QVariant((isPosition ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::FontRole:
        return isPosition ? numberFont() : textFont();
    case Qt::DecorationRole:
        return icon(row, column);
    default:
        return {};
    }
}

QString CamTableModel::text(const CamRow &row, int column) const
{
    switch (column) {
    case camColumn:
        return QString::number(row.number);
    case startColumn:
        return cam_texts::position(row.cam.start);
    case stopColumn:
        return cam_texts::position(row.cam.stop);
    case stateColumn:
        if (row.isOn)
            return *row.isOn ? tr("on") : tr("off");
        return row.mayBeEither ? tr("unknown") : QString();
    default:
        break;
    }
    if (!row.known)
        return tr("unknown");
    return *row.known == row.cam ? tr("same") : tr("differs");
}

QVariant CamTableModel::icon(const CamRow &row, int column) const
{
    if (column == stateColumn && row.isOn)
        return *row.isOn ? lineIcon(Icon::setBit, Role::setBit) : lineIcon(Icon::inactive, Role::inactive);
    if (column == encoderColumn && row.known && *row.known != row.cam)
        return lineIcon(Icon::attention, Role::attention);
    const auto isBeyond = [this](std::int64_t position) { return position > m_sheet.largest(); };
    if ((column == startColumn && isBeyond(row.cam.start)) ||
        (column == stopColumn && isBeyond(row.cam.stop)))
        return lineIcon(Icon::fault, Role::fault);
    return {};
}

} // namespace codewheel
