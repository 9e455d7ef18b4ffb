// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of the tree.
#include "widgets/dial/state_note.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"
#include "widgets/models/age_text.h"
#include "widgets/structure/structure_model.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>

namespace codewheel {
namespace {

QString positionText(const NodeState &state)
{
    if (state.velocity)
        return StructureModel::tr("%1 rpm").arg(QLocale().toString(qlonglong{*state.velocity}));
    return state.position ? QLocale().toString(qlonglong{*state.position}) : QString();
}

// Grey, and put into words for those who cannot see it.
QVariant oldPositionLook(const NodeState &state, int role)
{
    if (role == Qt::ForegroundRole)
        return QGuiApplication::palette().brush(QPalette::PlaceholderText);
    if (role == Qt::AccessibleTextRole && (state.position || state.velocity))
        return StructureModel::tr("%1, not up to date", "a position").arg(positionText(state));
    return {};
}

QString placeAndName(const BusNode &node)
{
    return QStringLiteral("%1  %2").arg(node.node.toString(), node.name);
}

QString nameText(const BusBranch::Row &row)
{
    const QString device = placeAndName(row.node);
    return row.station.isEmpty() ? device : QStringLiteral("%1  %2").arg(row.station, device);
}

// For those who cannot see where the tree is broken.
QVariant spokenName(const BusBranch::Row &row)
{
    return row.state.isBehindBreak
               ? StructureModel::tr("%1, the bus is interrupted before it").arg(nameText(row))
               : QVariant();
}

QVariant stateIcon(const StateWord &state)
{
    return lineIcon(roleIcon(state.role), state.role);
}

// How to ask about a fault.
QString withWhy(const QString &toolTip, const StateWord &state)
{
    if (state.role == Role::fault)
        return toolTip + u'\n' + StructureModel::tr("Double click or Enter: why there is no data");
    if (state.role == Role::attention)
        return toolTip + u'\n' + StructureModel::tr("Click on the state: why it is so");
    return toolTip;
}

} // namespace

// An encoder without a known position shows a dash, and the tooltip says why.
QString StructureModel::shownPosition(const BusBranch &branch, const Row &row)
{
    const QString known = positionText(row.state);
    const bool isOfEncoder = branch.connected && branch.connected->encoder(row.node.node) != nullptr;
    return known.isEmpty() && isOfEncoder ? QString(QChar(0x2013)) : known;
}

QVariant StructureModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    static constexpr const char *titles[] = {QT_TR_NOOP("Device"),   QT_TR_NOOP("State"),
                                             QT_TR_NOOP("Position"), QT_TR_NOOP("Profile"),
                                             QT_TR_NOOP("ID code"),  QT_TR_NOOP("Words IN / OUT")};
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section == positionColumn)
        return int{Qt::AlignRight | Qt::AlignVCenter};
    const bool isTitle = orientation == Qt::Horizontal &&
                         (role == Qt::DisplayRole || role == Qt::ToolTipRole) && section >= 0 &&
                         section < columnCount();
    return isTitle ? tr(titles[section]) : QVariant();
}

QVariant StructureModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return index.column() == positionColumn ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    const Where *where = whereIs(index);
    if (where == nullptr)
        return {};
    const BusBranch &branch = m_branches[where->branch];
    return where->row ? deviceCell(branch, branch.rows[*where->row], index.column(), role)
                      : busCell(branch, index.column(), role);
}

QVariant StructureModel::busCell(const BusBranch &branch, int column, int role)
{
    if (role == Qt::ToolTipRole)
        return withWhy(branch.outline().toolTip(), branch.state);
    if (role == isFaultRole)
        return branch.state.role == codewheel::Role::fault;
    if (role == isAttentionRole)
        return branch.state.role == codewheel::Role::attention;
    if (column == deviceColumn && role == Qt::DisplayRole)
        return branch.title;
    if (column == deviceColumn && role == Qt::DecorationRole)
        return lineIcon(Icon::master);
    if (column == stateColumn && role == Qt::DisplayRole)
        return branch.state.word;
    if (column == stateColumn && role == Qt::DecorationRole)
        return stateIcon(branch.state);
    if (column == positionColumn && role == Qt::DisplayRole)
        return branch.mode;
    return {};
}

QVariant StructureModel::deviceCell(const BusBranch &branch, const Row &row, int column, int role)
{
    if (role == Qt::ToolTipRole)
        return withWhy(toolTip(branch, row), row.state.shown);
    if (column == positionColumn && row.state.isOld)
        if (QVariant look = oldPositionLook(row.state, role); look.isValid())
            return look;
    if (role == Qt::ForegroundRole && row.state.isCutOff)
        return QGuiApplication::palette().brush(QPalette::PlaceholderText);
    if (role == isBehindBreakRole)
        return row.state.isBehindBreak;
    if (role == isFaultRole)
        return row.state.shown.role == codewheel::Role::fault;
    if (role == isAttentionRole)
        return row.state.shown.role == codewheel::Role::attention;
    if (role == nameRole)
        return row.station.isEmpty() ? placeAndName(row.node) : row.station;
    if (role == detailRole)
        return row.station.isEmpty() ? QString() : placeAndName(row.node);
    if (role == Qt::AccessibleTextRole && column == deviceColumn)
        return spokenName(row);
    if (role == Qt::DecorationRole && column == deviceColumn)
        return lineIcon(row.node.isCoupler ? Icon::ring : Icon::encoder);
    if (role == Qt::DecorationRole && column == stateColumn)
        return stateIcon(row.state.shown);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case deviceColumn:
        return nameText(row);
    case stateColumn:
        return row.state.shown.word;
    case positionColumn:
        return shownPosition(branch, row);
    case profileColumn:
        return row.node.profile;
    case codeColumn:
        return row.node.code;
    case wordsColumn:
        return row.node.words;
    default:
        return {};
    }
}

QString StructureModel::toolTip(const BusBranch &branch, const Row &row)
{
    const auto place = static_cast<std::size_t>(&row - branch.rows.data());
    QString text = branch.outline().toolTip(place, calledText(row.station, row.node.name));
    const EncoderSession *encoder = branch.connected ? branch.connected->encoder(row.node.node) : nullptr;
    if (encoder == nullptr)
        return text;
    for (const QString &why : {ageSentence(*encoder), unchangedSentence(*encoder), whyNoPosition(*encoder)})
        if (!why.isEmpty())
            text += u'\n' + why;
    return text;
}

} // namespace codewheel
