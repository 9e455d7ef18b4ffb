// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trace/trace_view.h"

#include "catalog/device_description.h"
#include "project/file_access.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/heading_width.h"
#include "widgets/look/icon_cells.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/log_table.h"
#include "widgets/look/save_file.h"
#include "widgets/models/go_to_place.h"
#include "widgets/models/traffic_model.h"
#include "widgets/monitor/copy_menu.h"
#include "widgets/trace/traffic_tools.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QStackedWidget>
#include <QToolBar>
#include <QVBoxLayout>

namespace codewheel {

namespace {

constexpr int fewestLetters = 20; // of the meaning
constexpr int wantedLetters = 40;
constexpr int remarkWidth = 25 * grid::unit;
constexpr int mostMeasured = 1'000; // rows, the newest of an encoder that is chosen

} // namespace

TraceView::TraceView(Buses &buses, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::trace, {}, {}, this))
    , m_tools(new QToolBar(this))
    , m_goTo(new GoToPlace(this))
    , m_table(new LogTable(tr("Handshake trace"), this))
    , m_icons(new IconCells(m_table))
    , m_counts(new QLabel(this))
    , m_message(new InlineMessage(this))
{
    makeTools();
    auto *page = new QWidget;
    auto *rows = layOut<QVBoxLayout>(page, grid::unit, QMargins(grid::unit, 0, grid::unit, grid::unit));
    auto *bar = new QHBoxLayout;
    bar->addWidget(m_tools, 1);
    bar->addWidget(m_counts);
    rows->addLayout(bar);
    rows->addWidget(m_message);
    rows->addWidget(m_table, 1);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(page);
    connect(m_empty, &EmptyState::actionTriggered, this, &TraceView::terminalRequested);
    showWhyEmpty(nullptr, {});
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_pages);

    connect(&buses, &Buses::changed, this, &TraceView::watchEncoders);
    watchEncoders();
}

TraceView::~TraceView()
{
    m_table->setModel(nullptr);
}

void TraceView::makeTools()
{
    const TrafficTools tools(*this, *m_tools, *m_table);
    m_hold = tools.hold;
    m_bringBack = tools.bringBack;
    connect(m_goTo, &GoToPlace::wanted, this, &TraceView::goToWanted);
    auto *copyAs = new CopyMenu(m_table);
    connect(copyAs, &CopyMenu::chosen, this, &TraceView::copyWords);
    m_table->addActions({tools.copy, copyAs->plcWords(), copyAs->menuAction(), m_goTo, tools.exportRows,
                         tools.clear, m_bringBack});
    connect(m_hold, &QAction::toggled, this, [this](bool held) {
        for (const auto &[place, collected] : m_collected)
            collected.rows->setHeld(held);
    });
    connect(tools.copy, &QAction::triggered, this, &TraceView::copy);
    connect(tools.exportRows, &QAction::triggered, this, &TraceView::exportRows);
    connect(tools.clear, &QAction::triggered, this, [this] {
        if (m_shown)
            m_shown->clear();
    });
    connect(m_bringBack, &QAction::triggered, this, [this] {
        if (m_shown)
            m_shown->bringBack();
    });
}

void TraceView::watchEncoders()
{
    for (EncoderBus *bus : m_buses.open()) {
        connect(bus, &EncoderBus::trafficPassed, this, &TraceView::add, Qt::UniqueConnection);
        connect(bus, &EncoderBus::trafficRestarted, this, &TraceView::beginAnew, Qt::UniqueConnection);
        for (const Place place : bus->places())
            if (const EncoderSession *encoder = bus->encoder(place); encoder && !bus->hasTerminal())
                collect(*encoder);
    }
}

void TraceView::setMostRows(int rows)
{
    m_mostRows = rows;
    for (const auto &[place, collected] : m_collected)
        if (collected.rows)
            collected.rows->setMost(rows);
}

void TraceView::collect(const EncoderSession &encoder)
{
    Collected &collected = m_collected[encoder.place()];
    EncoderBus *bus = m_buses.open(encoder.place().bus);
    if (!collected.rows || collected.device != encoder.device()) {
        auto rows = std::make_unique<TrafficModel>(bus->trafficColumns(), m_mostRows);
        keep(encoder.place(), {encoder.device(), std::move(rows), bus});
    } else if (collected.bus != bus) {
        collected.bus = bus;
        collected.rows->beginConnection(bus->dateTime(bus->now()));
    }
}

// In place of what was collected there.
void TraceView::keep(Place place, Collected fresh)
{
    TrafficModel *rows = fresh.rows.get();
    rows->setHeld(m_hold->isChecked());
    connect(rows, &TrafficModel::countsChanged, this, [this, rows] {
        if (rows == m_shown)
            showCounts();
    });
    connect(rows, &QAbstractItemModel::rowsInserted, this,
            [this, rows](const QModelIndex &, int first, int last) {
                if (rows == m_shown)
                    makeRoom(first, last);
            });
    Collected &collected = m_collected[place];
    if (collected.rows && collected.rows.get() == m_shown) {
        m_shown = rows;
        showModel();
    }
    collected = std::move(fresh);
}

TraceView::Traces TraceView::takeTraces()
{
    m_shown = nullptr;
    showModel();
    return std::exchange(m_collected, {});
}

void TraceView::goOn(Traces traces)
{
    for (auto &[place, collected] : traces)
        if (collected.rows)
            keep(place, std::move(collected));
}

void TraceView::add(const TrafficRow &row)
{
    if (TrafficModel *rows = row.place ? model(*row.place) : nullptr) {
        rows->add(row);
        rows->showWaiting();
    }
}

void TraceView::beginAnew()
{
    const auto *bus = qobject_cast<EncoderBus *>(sender());
    for (const auto &[place, collected] : m_collected)
        if (bus != nullptr && place.bus == bus->id() && collected.rows)
            collected.rows->clear();
}

void TraceView::setEncoder(EncoderSession *encoder, std::optional<Place> offline)
{
    watchEncoders();
    m_shown = encoder && !hasTerminal(*encoder) ? model(encoder->place()) : nullptr;
    m_message->withdraw();
    m_goTo->setPlace(m_shown ? std::optional(encoder->place()) : std::nullopt);
    showModel();
    showWhyEmpty(encoder, offline);
}

bool TraceView::hasTerminal(const EncoderSession &encoder) const
{
    const EncoderBus *bus = m_buses.busOf(encoder.place());
    return bus != nullptr && bus->hasTerminal();
}

void TraceView::showWhyEmpty(const EncoderSession *encoder, std::optional<Place> offline)
{
    const bool onLine = encoder && hasTerminal(*encoder);
    if (onLine)
        m_empty->setTexts(tr("%1 is on a serial line").arg(encoder->place().shown()),
                          tr("It has no words. The traffic of its line is in the terminal."));
    else if (offline)
        m_empty->setTexts(tr("%1 is not connected").arg(offline->shown()),
                          tr("What passes is shown once it is."));
    else
        m_empty->setTexts(
            tr("No encoder is selected"),
            tr("The handshake trace has a row for each change of the words of an encoder. Select "
               "an encoder in the bus structure."));
    m_empty->setAction(onLine ? tr("Open the terminal") : QString());
}

std::vector<Place> TraceView::places() const
{
    std::vector<Place> places;
    for (const auto &[place, collected] : m_collected)
        places.push_back(place);
    return places;
}

TrafficModel *TraceView::model(Place number) const
{
    const auto found = m_collected.find(number);
    return found == m_collected.end() ? nullptr : found->second.rows.get();
}

std::vector<Word> TraceView::outWords(Place place) const
{
    std::vector<Word> words;
    const TrafficModel *rows = model(place);
    if (rows == nullptr)
        return words;
    std::optional<Word> before; // empty: what stands there at first
    for (int row = 0; row < rows->rowCount(); ++row) {
        const ShownTraffic &shown = rows->rowAt(row);
        const Word out = shown.what.out;
        if (!shown.beginsConnection && before && out != *before)
            words.push_back(out);
        before = shown.beginsConnection ? std::nullopt : std::optional(out);
    }
    return words;
}

int TraceView::meaningColumn() const
{
    return m_shown->columnOf(TrafficColumn::meaning);
}

void TraceView::showModel()
{
    m_pages->setCurrentIndex(m_shown ? 1 : 0);
    m_table->setModel(m_shown);
    if (!m_shown)
        return;
    for (int column = 0; column < m_shown->columnCount(); ++column) // all rows are of one encoder
        m_table->setColumnHidden(column, m_shown->columnAt(column) == TrafficColumn::who);
    for (int column = 0; column < meaningColumn(); ++column)
        setUpColumn(column);
    m_table->setTextColumn(meaningColumn(), fewestLetters);
    const int remark = m_shown->columnOf(TrafficColumn::remark);
    const bool hasRemarks = remark < m_shown->columnCount();
    m_table->setElasticColumn(
        hasRemarks ? LogTable::Elastic{.column = remark,
                                       .least = headingWidth(*m_table->horizontalHeader(), remark),
                                       .most = remarkWidth,
                                       .wantedLetters = wantedLetters}
                   : LogTable::Elastic());
    makeRoom(0, m_shown->rowCount() - 1);
    showCounts();
}

void TraceView::setUpColumn(int column)
{
    const bool isIcon = m_shown->columnAt(column) == TrafficColumn::direction;
    m_table->setItemDelegateForColumn(column, isIcon ? m_icons : nullptr);
    m_table->setColumnWidth(column, isIcon ? grid::smallIcon + 2 * grid::margin
                                           : headingWidth(*m_table->horizontalHeader(), column));
}

// Columns of numbers grow with their numbers and never shrink: nothing is cut off, nothing jumps.
void TraceView::makeRoom(int first, int last)
{
    const QFontMetrics metrics{numberFont()};
    first = std::max(first, last + 1 - mostMeasured);
    for (int column = 0; column < meaningColumn(); ++column) {
        if (m_table->isColumnHidden(column) || m_shown->columnAt(column) == TrafficColumn::direction)
            continue;
        int width = m_table->columnWidth(column);
        for (int row = first; row <= last; ++row)
            width = std::max(width, metrics.horizontalAdvance(m_shown->index(row, column).data().toString()) +
                                        2 * grid::unit);
        if (width != m_table->columnWidth(column))
            m_table->setColumnWidth(column, width);
    }
}

void TraceView::showCounts()
{
    m_counts->setText(m_shown->countsText(m_shown->rowCount()));
    m_bringBack->setEnabled(m_shown->hasCleared());
}

const std::pair<const Place, TraceView::Collected> &TraceView::shown() const
{
    return *std::ranges::find(m_collected, m_shown, [](const auto &one) { return one.second.rows.get(); });
}

std::vector<int> TraceView::chosenRows() const
{
    const QItemSelectionModel &selection = *m_table->selectionModel();
    std::vector<int> rows;
    for (int row = 0; row < m_shown->rowCount(); ++row)
        if (!selection.hasSelection() || selection.isRowSelected(row))
            rows.push_back(row);
    return rows;
}

void TraceView::copy()
{
    if (!m_shown)
        return;
    QString text;
    for (const int row : chosenRows()) {
        QStringList cells{m_shown->dateTimeText(m_shown->rowAt(row))};
        for (int column = 1; column < m_shown->columnCount(); ++column)
            cells << m_shown->index(row, column).data().toString();
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text);
}

// To be pasted into a PLC program or a table. An encoder without OUT has its IN alone.
void TraceView::copyWords(WordNotation notation)
{
    if (!m_shown)
        return;
    const DeviceDescription &device = shown().second.device;
    const int bits = device.inWords > 1 ? 32 : 16;
    QString text;
    for (const int row : chosenRows()) {
        if (m_shown->rowAt(row).beginsConnection)
            continue;
        const TrafficRow &words = m_shown->rowAt(row).what;
        if (device.outWords > 0)
            text += copiedText(words.out, bits, notation) + u'\t';
        text += copiedText(words.in, bits, notation) + u'\n';
    }
    if (!text.isEmpty())
        QApplication::clipboard()->setText(text);
}

void TraceView::exportRows()
{
    const QString path = askSaveFile(this, tr("Export the trace"), tr("trace.csv"), {tr("Tables (*.csv)")});
    if (!path.isEmpty())
        exportTo(path);
}

bool TraceView::exportTo(const QString &path)
{
    if (!m_shown)
        return false;
    const auto saved = replaceFile(path, m_shown->csv(shown().first), OldFile::goes);
    if (!saved) {
        m_message->showMessage(
            Role::attention,
            tr("%1 was not written: %2", "file, reason").arg(path, whyNotWritten(saved.error())));
        return false;
    }
    m_message->withdraw();
    return true;
}

} // namespace codewheel
