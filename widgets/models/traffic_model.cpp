// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/traffic_model.h"

#include "vocabulary/csv_text.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "widgets/look/fonts.h"
#include "widgets/look/roles.h"

#include <QFontMetrics>
#include <QLocale>

namespace codewheel {
namespace {

constexpr char16_t escapePicture = 0x241B;
constexpr char16_t escapeSign = 0x238B;
constexpr int partDropped = 40; // one in so many rows is dropped at once

struct ColumnShape
{
    const char *title;
    const char *key; // in exports
    bool isRightAligned = false;
    bool hasNumberFont = false;
    bool hasToolTip = false; // the text, if the column is too narrow for it
};

// Indexed by TrafficColumn.
constexpr ColumnShape columnShapes[] = {
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Time"), "time", false, true, false},
    {"\u0394 ms", "since_last_ms", true, true, false},
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Cycle"), "cycle", true, true, false},
    {"\u2195", "direction", false, false, true},
    {"OUT", "out", false, true, false},
    {"IN", "in", false, true, false},
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Text"), "text", false, true, true},
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Meaning"), "meaning", false, false, true},
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Hex"), "bytes", false, true, true},
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Remark"), "remark", false, false, true},
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Identifier"), "identifier", false, true, false},
    {QT_TRANSLATE_NOOP("codewheel::TrafficModel", "Node"), "node", false, true, false},
};

const ColumnShape &shapeOf(TrafficColumn column)
{
    return columnShapes[static_cast<std::size_t>(column)];
}

// Which rows go first.
enum class Keeping : std::uint8_t { automatic, seldom, typed };

Keeping keepingOf(const TrafficRow &row)
{
    if (row.isTyped)
        return Keeping::typed;
    return row.isAutomatic ? Keeping::automatic : Keeping::seldom;
}

double inMilliseconds(Instant duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

// A typed request and its answer stand out as a pair; so does where another connection begins.
QVariant fontOf(const ShownTraffic &row, const ColumnShape &shape)
{
    if (!shape.hasNumberFont && !row.what.isTyped && !row.beginsConnection)
        return {};
    QFont font = shape.hasNumberFont ? numberFont() : textFont();
    font.setBold(row.what.isTyped || row.beginsConnection);
    return font;
}

QIcon kindIcon(std::optional<TrafficKind> kind)
{
    if (!kind)
        return {};
    switch (*kind) {
    case TrafficKind::sent:
        return lineIcon(Icon::next);
    case TrafficKind::answer:
        return lineIcon(Icon::back);
    case TrafficKind::echo:
        return lineIcon(Icon::refresh, Role::inactive);
    case TrafficKind::garbage:
        return lineIcon(Icon::fault, Role::fault);
    case TrafficKind::late:
        break;
    }
    return lineIcon(Icon::attention, Role::attention);
}

} // namespace

ControlCharacters shownControls()
{
    static const ControlCharacters shown = [] {
        const QFontMetrics font(numberFont());
        if (font.inFont(QChar(escapePicture)))
            return ControlCharacters::pictures;
        return font.inFont(QChar(escapeSign)) ? ControlCharacters::signs : ControlCharacters::numbers;
    }();
    return shown;
}

TrafficModel::TrafficModel(std::span<const TrafficColumn> columns, int most, QObject *parent)
    : TableModelBase(parent)
    , m_columns(columns)
{
    setMost(most);
}

void TrafficModel::setMost(int most)
{
    m_most = most;
    m_droppedAtOnce = std::max(1, most / partDropped);
}

int TrafficModel::columnOf(TrafficColumn column) const
{
    return static_cast<int>(std::ranges::find(m_columns, column) - m_columns.begin());
}

void TrafficModel::setHeld(bool held)
{
    m_held = held;
    showWaiting();
}

// The clock of the bus may have stood still between them, or another one begun: then their dates tell.
std::optional<Instant> TrafficModel::between(const Moment &last, const Moment &now)
{
    using std::chrono::milliseconds;
    const Instant byClock = now.at - last.at;
    const Instant byDate = milliseconds(last.time.msecsTo(now.time));
    const bool isOneClock = !now.time.isValid() || std::chrono::abs(byClock - byDate) <= milliseconds(1);
    const Instant passed = isOneClock ? byClock : byDate;
    return passed >= Instant{} ? std::optional(passed) : std::nullopt;
}

void TrafficModel::add(TrafficRow row)
{
    const auto last = std::exchange(m_last, Moment{row.at, row.time});
    const auto sinceLast = last ? between(*last, *m_last) : std::nullopt;
    m_waiting.push_back({std::move(row), sinceLast});
    if (waiting() <= m_most)
        return;
    std::vector<ShownTraffic> kept;
    const std::vector<bool> goes = chooseSurplus(m_waiting);
    for (std::size_t i = 0; i < goes.size(); ++i)
        if (!goes[i])
            kept.push_back(std::move(m_waiting[i]));
    m_dropped += m_waiting.size() - kept.size();
    m_waiting = std::move(kept);
}

void TrafficModel::showWaiting()
{
    if (!m_held) {
        append(std::exchange(m_waiting, {}));
        dropOldest();
    }
    Q_EMIT countsChanged();
}

void TrafficModel::dropOldest()
{
    if (rowCount() <= m_most)
        return;
    const int before = rowCount();
    removeChosen(chooseSurplus(rows()));
    m_dropped += static_cast<quint64>(before - rowCount());
}

// What polls a bus by itself must not push out what the user sent. Among rows of one kind the oldest go.
std::vector<bool> TrafficModel::chooseSurplus(const std::vector<ShownTraffic> &rows) const
{
    auto surplus = std::max(std::ssize(rows) - m_most, std::ptrdiff_t{m_droppedAtOnce});
    std::vector<bool> goes(rows.size());
    for (const Keeping keeping : {Keeping::automatic, Keeping::seldom, Keeping::typed})
        for (std::size_t i = 0; i < rows.size() && surplus > 0; ++i)
            if (keepingOf(rows[i].what) == keeping) {
                goes[i] = true;
                --surplus;
            }
    return goes;
}

void TrafficModel::beginConnection(const QDateTime &time)
{
    m_last.reset();
    if (isEmpty() && !hasCleared())
        return;
    TrafficRow row{.time = time};
    row.meaning = [] { return tr("Another connection begins here."); };
    m_waiting.push_back({.what = std::move(row), .beginsConnection = true});
    showWaiting();
}

// Everything from the last time it was sent belongs to the answer.
void TrafficModel::markTyped(const QByteArray &sent)
{
    const auto begins = [&sent](const TrafficRow &row) {
        return row.kind == TrafficKind::sent && row.bytes == sent;
    };
    for (auto row = m_waiting.rbegin(); row != m_waiting.rend(); ++row) {
        row->what.isTyped = true;
        if (begins(row->what))
            return;
    }
    for (int row = rowCount() - 1; row >= 0; --row) {
        ShownTraffic marked = rowAt(row);
        marked.what.isTyped = true;
        const bool isFirst = begins(marked.what);
        replace(row, std::move(marked));
        if (isFirst)
            return;
    }
}

void TrafficModel::tellMeaningsChanged()
{
    const int meaning = columnOf(TrafficColumn::meaning);
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, meaning), index(rowCount() - 1, meaning));
}

void TrafficModel::clear()
{
    clearRows(std::exchange(m_waiting, {}), m_most);
    m_droppedBefore += std::exchange(m_dropped, 0);
    m_last.reset();
    Q_EMIT countsChanged();
}

void TrafficModel::goOnFrom(const TrafficModel &before)
{
    setRows(before.rows());
    m_waiting = before.m_waiting;
    m_last = before.m_last;
    m_dropped = before.m_dropped;
    Q_EMIT countsChanged();
}

void TrafficModel::bringBack()
{
    bringRowsBack();
    m_dropped += std::exchange(m_droppedBefore, 0);
    dropOldest();
    Q_EMIT countsChanged();
}

QString TrafficModel::cellText(const ShownTraffic &row, TrafficColumn column,
                               ControlCharacters controls) const
{
    const TrafficRow &what = row.what;
    const bool isText =
        column == TrafficColumn::time || column == TrafficColumn::meaning || column == TrafficColumn::remark;
    if (row.beginsConnection && !isText)
        return {};
    switch (column) {
    case TrafficColumn::time:
        return what.time.time().toString(QStringLiteral("HH:mm:ss.zzz"));
    case TrafficColumn::sinceLast:
        return row.sinceLast ? QLocale().toString(inMilliseconds(*row.sinceLast), 'f', 1) : QString();
    case TrafficColumn::cycle:
        return QLocale().toString(static_cast<qulonglong>(what.cycle));
    case TrafficColumn::direction:
        if (!what.kind)
            return {};
        return what.isTyped ? tr("%1, typed", "sent, answer ...").arg(rowKindWord(*what.kind))
                            : rowKindWord(*what.kind);
    case TrafficColumn::out:
        return hexWord(what.out);
    case TrafficColumn::in:
        return what.isAnswered ? hexWord(what.in) : QString(QChar(0x2013));
    case TrafficColumn::text:
        return controlText(what.bytes, controls);
    case TrafficColumn::meaning:
        return what.meaning ? what.meaning() : QString();
    case TrafficColumn::bytes:
        return byteText(what.bytes.sliced(what.head));
    case TrafficColumn::identifier:
        return what.identifier ? what.identifier->text() : QString();
    case TrafficColumn::who:
        return what.place ? what.place->toString() : QString();
    case TrafficColumn::remark:
        break;
    }
    return row.remark;
}

QString TrafficModel::dateTimeText(const ShownTraffic &row) const
{
    return QLocale().toString(row.what.time.date(), QLocale::ShortFormat) + QLatin1Char(' ') +
           cellText(row, TrafficColumn::time);
}

QString TrafficModel::countsText(int shown) const
{
    QStringList texts{shown == rowCount()
                          ? tr("%Ln rows", nullptr, rowCount())
                          : sentence(tr("%1 of %2 rows shown"),
                                     {QLocale().toString(shown), QLocale().toString(rowCount())})};
    if (isHeld())
        texts << tr("paused, %Ln new", nullptr, waiting());
    if (dropped() > 0)
        texts << sentence(tr("%1 older ones not kept"), {QLocale().toString(dropped())});
    return texts.join(QStringLiteral("; "));
}

QByteArray TrafficModel::csv(Place place) const
{
    const auto field = [this](const ShownTraffic &row, TrafficColumn column) {
        switch (column) {
        case TrafficColumn::time:
            return row.what.time.toString(Qt::ISODateWithMs);
        case TrafficColumn::sinceLast:
            return row.sinceLast ? QString::number(inMilliseconds(*row.sinceLast), 'f', 1) : QString();
        case TrafficColumn::cycle:
            return row.beginsConnection ? QString() : QString::number(row.what.cycle);
        case TrafficColumn::out:
        case TrafficColumn::in:
        case TrafficColumn::bytes:
            return cellText(row, column);
        default:
            return csvText(cellText(row, column, ControlCharacters::pictures));
        }
    };
    QString csv;
    for (const TrafficColumn column : m_columns)
        csv += QLatin1String(shapeOf(column).key) + QLatin1Char(',');
    csv += QLatin1String("bus,place\r\n");
    for (const ShownTraffic &row : rows()) {
        for (const TrafficColumn column : m_columns)
            csv += field(row, column) + QLatin1Char(',');
        csv +=
            QString::number(place.bus.number) + QLatin1Char(',') + place.toString() + QLatin1String("\r\n");
    }
    return csv.toUtf8();
}

Qt::ItemFlags TrafficModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    const bool isRemark = index.isValid() && columnAt(index.column()) == TrafficColumn::remark;
    return isRemark ? usual | Qt::ItemIsEditable : usual;
}

bool TrafficModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || role != Qt::EditRole || columnAt(index.column()) != TrafficColumn::remark)
        return false;
    ShownTraffic row = rowAt(index.row());
    row.remark = value.toString().simplified();
    replace(index.row(), std::move(row));
    return true;
}

QVariant TrafficModel::headerCell(int column, int role) const
{
    const ColumnShape &shape = shapeOf(columnAt(column));
    if (role == Qt::TextAlignmentRole)
        return QVariant((shape.isRightAligned ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        if (columnAt(column) == TrafficColumn::sinceLast)
            return tr("Since last, ms");
        if (columnAt(column) == TrafficColumn::direction)
            return tr("Direction");
    }
    return role == Qt::DisplayRole ? tr(shape.title) : QVariant();
}

QVariant TrafficModel::cell(const ShownTraffic &row, int column, int role) const
{
    const TrafficColumn shown = columnAt(column);
    const ColumnShape &shape = shapeOf(shown);
    switch (role) {
    case Qt::DisplayRole:
        return cellText(row, shown);
    case Qt::EditRole:
        return shown == TrafficColumn::remark ? QVariant(row.remark) : QVariant();
    case Qt::DecorationRole:
        return shown == TrafficColumn::direction ? QVariant(kindIcon(row.what.kind)) : QVariant();
    case Qt::ToolTipRole:
        if (shown == TrafficColumn::time)
            return dateTimeText(row);
        return shape.hasToolTip ? QVariant(cellText(row, shown, ControlCharacters::numbers)) : QVariant();
    case Qt::FontRole:
        return fontOf(row, shape);
    case Qt::TextAlignmentRole:
        return headerCell(column, role);
    default:
        return {};
    }
}

} // namespace codewheel
