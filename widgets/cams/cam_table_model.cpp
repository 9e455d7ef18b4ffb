// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_table_model.h"

#include "widgets/cams/cam_texts.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QGuiApplication>
#include <QPalette>

namespace codewheel {
namespace {

std::int64_t positionIn(const Cam &cam, int column)
{
    return column == CamTableModel::startColumn  ? cam.start
           : column == CamTableModel::stopColumn ? cam.stop
                                                 : cam.hysteresis;
}

} // namespace

CamTableModel::CamTableModel(CamSheet &sheet, QObject *parent)
    : TableModelBase(parent)
    , m_sheet(sheet)
{
    refresh();
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
    const auto known = m_sheet.known(m_sheet.number());
    return {.number = cam,
            .cam = m_sheet.cam(cam),
            .isOn = m_sheet.isOn(cam),
            .mayBeEither = m_sheet.live().position && !m_sheet.isOn(cam),
            .isTold = m_sheet.live().isTold,
            .known = known ? std::optional(known->cam.at(cam)) : std::nullopt,
            .isOld = known && m_sheet.isOld()};
}

void CamTableModel::refresh()
{
    while (rowCount() > static_cast<int>(m_sheet.abilities().cams))
        removeAt(rowCount() - 1);
    while (rowCount() < static_cast<int>(m_sheet.abilities().cams))
        append({rowOf(static_cast<std::size_t>(rowCount()))});
    for (int row = 0; row < rowCount(); ++row)
        if (const CamRow now = rowOf(rowAt(row).number); now != rowAt(row))
            replace(row, now);
}

Qt::ItemFlags CamTableModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    switch (index.column()) {
    case camColumn:
    case polarityColumn:
        return usual | Qt::ItemIsUserCheckable;
    default:
        return isPosition(index.column()) ? usual | Qt::ItemIsEditable : usual;
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
    Cam changed = m_sheet.cam(number);
    if (role == Qt::CheckStateRole && index.column() == polarityColumn) {
        changed.isInverted = value.toInt() == Qt::Checked;
        m_sheet.setCam(number, changed, tr("Polarity of cam %1").arg(number));
        return true;
    }
    if (role != Qt::EditRole || !isPosition(index.column()))
        return false;
    setPosition(changed, index.column(), value.toLongLong());
    if (!m_sheet.check(number, changed))
        return false;
    m_sheet.setCam(number, changed,
                   index.column() == startColumn  ? cam_texts::movement(number, CamGrip::start)
                   : index.column() == stopColumn ? cam_texts::movement(number, CamGrip::stop)
                                                  : tr("Hysteresis of cam %1").arg(number));
    return true;
}

void CamTableModel::setPosition(Cam &cam, int column, std::int64_t position) const
{
    const bool isCyclic = m_sheet.abilities().isCyclic;
    if (column == hysteresisColumn) {
        cam.hysteresis = position;
    } else if (column == startColumn) {
        cam.start = position;
        cam.stop = isCyclic ? cam.stop : std::max(cam.stop, position);
    } else {
        cam.stop = position;
        cam.start = isCyclic ? cam.start : std::min(cam.start, position);
    }
}

std::span<const ColumnHead> CamTableModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Cam"), Qt::AlignLeft,
         QT_TR_NOOP("Ticked: the cam is active. Only active cams come on.")},
        {QT_TR_NOOP("Start"), Qt::AlignRight, QT_TR_NOOP("First position on which the cam is on, in steps")},
        {QT_TR_NOOP("Stop"), Qt::AlignRight,
         QT_TR_NOOP("Last position on which the cam is on, in steps; smaller than the start: through zero")},
        {QT_TR_NOOP("Hysteresis"), Qt::AlignRight,
         QT_TR_NOOP("Steps behind an edge until the cam goes back")},
        {QT_TR_NOOP("Inverted"), Qt::AlignLeft, QT_TR_NOOP("Ticked: the cam is on outside of its positions")},
        {QT_TR_NOOP("Now"), Qt::AlignLeft,
         QT_TR_NOOP("What the encoder shows now in cam mode; in position mode, what these cams would be")},
        {QT_TR_NOOP("Encoder"), Qt::AlignLeft, QT_TR_NOOP("Whether the encoder is known to have the same")},
    };
    return all;
}

QVariant CamTableModel::cell(const CamRow &row, int column, int role) const
{
    switch (role) {
    case Qt::AccessibleTextRole:
        return isOld(row, column) ? tr("%1, not up to date").arg(text(row, column)) : text(row, column);
    case Qt::ForegroundRole:
        return isOld(row, column) ? QVariant(QGuiApplication::palette().placeholderText()) : QVariant();
    case Qt::EditRole:
        return isPosition(column) ? QVariant(qlonglong{positionIn(row.cam, column)}) : QVariant();
    case Qt::CheckStateRole:
        if (column != camColumn && column != polarityColumn)
            return {};
        return (column == camColumn ? row.cam.active : row.cam.isInverted) ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole:
        return cam_texts::description(m_sheet, row.number);
    case Qt::FontRole:
        return isPosition(column) ? numberFont() : textFont();
    case Qt::DecorationRole:
        return icon(row, column);
    default:
        return TableModelBase::cell(row, column, role);
    }
}

bool CamTableModel::isOld(const CamRow &row, int column)
{
    return row.isOld && column == encoderColumn;
}

QString CamTableModel::text(const CamRow &row, int column) const
{
    switch (column) {
    case camColumn:
        return QString::number(row.number);
    case startColumn:
    case stopColumn:
    case hysteresisColumn:
        return cam_texts::position(positionIn(row.cam, column));
    case polarityColumn:
        return {};
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
        return lineIcon(Icon::attention, row.isOld ? Role::inactive : Role::attention);
    if (isPosition(column) && positionIn(row.cam, column) > m_sheet.largest())
        return lineIcon(Icon::fault, Role::fault);
    return {};
}

} // namespace codewheel
