// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trace/trace_view.h"

#include "project/file_access.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/save_file.h"
#include "widgets/look/tool.h"
#include "widgets/models/device_traits.h"
#include "widgets/trace/trace_model.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QStackedWidget>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

namespace codewheel {

namespace {

constexpr int traceMeaningLetters = 60; // about as long as the sentences of a handshake
constexpr int fewestLetters = 20;
constexpr int remarkWidth = 25 * grid::unit;

} // namespace

TraceView::TraceView(Buses &buses, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::trace, {}, {}, this))
    , m_tools(new QToolBar(this))
    , m_table(new QTableView(this))
    , m_counts(new QLabel(this))
    , m_message(new InlineMessage(this))
{
    makeTable();
    makeTools();
    auto *page = new QWidget;
    auto *rows = new QVBoxLayout(page);
    rows->setContentsMargins(grid::unit, 0, grid::unit, grid::unit);
    rows->setSpacing(grid::unit);
    auto *bar = new QHBoxLayout;
    bar->addWidget(m_tools);
    bar->addWidget(m_counts, 1);
    rows->addLayout(bar);
    rows->addWidget(m_message);
    rows->addWidget(m_table, 1);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(page);
    connect(m_empty, &EmptyState::actionTriggered, this, &TraceView::terminalRequested);
    showWhyEmpty(nullptr);
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

void TraceView::makeTable()
{
    m_table->setAccessibleName(tr("Handshake trace"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + grid::unit);
}

void TraceView::makeTools()
{
    setUpToolBar(*m_tools);
    const auto makeTool = [this](const Tool &tool) { return addTool(*this, *m_tools, tool); };
    m_follow = makeTool(
        {Icon::next, tr("Follow"), QKeySequence(Qt::CTRL | Qt::Key_End), tr("Keep the newest row in view")});
    m_follow->setCheckable(true);
    m_follow->setChecked(true);
    m_hold = makeTool({Icon::stop, tr("Pause"), QKeySequence(Qt::CTRL | Qt::Key_P),
                       tr("Hold the table; rows that come are kept and shown afterwards")});
    m_hold->setCheckable(true);
    const QAction *copying = makeTool({Icon::copy, tr("Copy"), QKeySequence::Copy,
                                       tr("Copy the selected rows, or all, with tabs between the columns")});
    const QAction *exporting = makeTool({Icon::exportData, tr("Export"), QKeySequence(Qt::CTRL | Qt::Key_E),
                                         tr("Save all rows as a CSV file")});
    const QAction *clearing = makeTool({Icon::remove, tr("Clear"), QKeySequence(Qt::CTRL | Qt::Key_Delete),
                                        tr("Remove all rows of this encoder")});
    m_bringBack = makeTool({Icon::back, tr("Bring back"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Delete),
                            tr("Show the rows again that Clear removed")});
    m_bringBack->setEnabled(false);
    connect(m_follow, &QAction::toggled, this, &TraceView::follow);
    connect(m_hold, &QAction::toggled, this, [this](bool held) {
        for (const auto &[number, model] : m_models)
            model->setHeld(held);
        follow();
    });
    connect(copying, &QAction::triggered, this, &TraceView::copy);
    connect(exporting, &QAction::triggered, this, &TraceView::exportRows);
    connect(clearing, &QAction::triggered, this, [this] {
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
    std::erase(m_watched, nullptr);
    const auto isWatched = [this](const EncoderSession *encoder) {
        return std::ranges::any_of(m_watched, [encoder](const auto &watched) { return watched == encoder; });
    };
    for (const Place place : m_buses.places())
        if (EncoderSession *encoder = m_buses.encoder(place); encoder && !isWatched(encoder))
            watch(*encoder);
}

void TraceView::watch(EncoderSession &encoder)
{
    m_watched.emplace_back(&encoder);
    std::unique_ptr<TraceModel> &model = m_models[encoder.place()];
    if (!model || model->device() != encoder.device()) {
        const bool isShown = model && model.get() == m_shown;
        auto fresh = std::make_unique<TraceModel>(encoder.device());
        if (isShown) {
            m_shown = fresh.get();
            showModel();
        }
        model = std::move(fresh);
        model->setHeld(m_hold->isChecked());
        connect(model.get(), &TraceModel::countsChanged, this, [this, changed = model.get()] {
            if (changed == m_shown)
                showCounts();
        });
        connect(model.get(), &QAbstractItemModel::rowsInserted, this,
                [this, changed = model.get()](const QModelIndex &, int first, int last) {
                    if (changed == m_shown)
                        makeRoom(first, last);
                });
    }
    connect(&encoder, &EncoderSession::exchanged, model.get(),
            [into = model.get(), bus = m_buses.open(encoder.place().bus)](const Exchange &row) {
                into->add(row, bus->dateTime(row.at));
            });
}

void TraceView::setEncoder(EncoderSession *encoder)
{
    watchEncoders();
    m_shown = encoder ? model(encoder->place()) : nullptr;
    m_message->withdraw();
    showModel();
    showWhyEmpty(encoder);
    if (encoder && isOnLine(encoder->device()))
        m_pages->setCurrentWidget(m_empty);
}

void TraceView::showWhyEmpty(const EncoderSession *encoder)
{
    const bool onLine = encoder && isOnLine(encoder->device());
    if (onLine)
        m_empty->setTexts(tr("%1 is on a serial line").arg(encoder->place().shown()),
                          tr("It has no words. What passes on its line stands in the terminal."));
    else
        m_empty->setTexts(
            tr("No encoder is selected"),
            tr("The handshake trace has a row for each change of the words of an encoder. Select "
               "an encoder in the bus structure."));
    m_empty->setAction(onLine ? tr("Open the terminal") : QString());
}

TraceModel *TraceView::model(Place number) const
{
    const auto found = m_models.find(number);
    return found == m_models.end() ? nullptr : found->second.get();
}

void TraceView::showModel()
{
    m_pages->setCurrentIndex(m_shown ? 1 : 0);
    const QItemSelectionModel *before = m_table->selectionModel();
    m_table->setModel(m_shown);
    delete before;
    if (!m_shown)
        return;
    for (int column = 0; column < TraceModel::meaning; ++column)
        m_table->setColumnWidth(column, m_table->horizontalHeader()->sectionSizeHint(column));
    makeRoom(0, m_shown->rowCount() - 1);
    showCounts();
}

// Columns of numbers become wider with their numbers and never narrower: nothing is cut off, nothing jumps.
void TraceView::makeRoom(int first, int last)
{
    const QFontMetrics metrics{numberFont()};
    for (int column = 0; column < TraceModel::meaning; ++column) {
        int width = m_table->columnWidth(column);
        for (int row = first; row <= last; ++row)
            width = std::max(width, metrics.horizontalAdvance(m_shown->index(row, column).data().toString()) +
                                        2 * grid::unit);
        m_table->setColumnWidth(column, width);
    }
    fitMeaning();
}

// The meaning has what the numbers leave it, the remark what is left then; in a narrow dock it is scrolled
// to.
void TraceView::fitMeaning()
{
    const int letter = m_table->fontMetrics().averageCharWidth();
    int left = m_table->viewport()->width();
    for (int column = 0; column < TraceModel::meaning; ++column)
        left -= m_table->columnWidth(column);
    if (left - remarkWidth > fewestLetters * letter)
        left = std::min(left - remarkWidth, traceMeaningLetters * letter);
    m_table->setColumnWidth(TraceModel::meaning, std::max(left, fewestLetters * letter));
}

void TraceView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitMeaning();
}

void TraceView::showCounts()
{
    QStringList texts{tr("%n rows", nullptr, m_shown->rowCount())};
    if (m_shown->isHeld())
        texts << tr("paused, %n new", nullptr, m_shown->waiting());
    if (m_shown->dropped() > 0)
        texts << tr("%1 oldest dropped").arg(QLocale().toString(m_shown->dropped()));
    m_counts->setText(texts.join(QStringLiteral("; ")));
    m_bringBack->setEnabled(m_shown->hasCleared());
    follow();
}

void TraceView::follow()
{
    if (m_follow->isChecked() && m_shown && !m_shown->isHeld())
        m_table->scrollToBottom();
}

void TraceView::copy()
{
    if (!m_shown)
        return;
    std::vector<TraceRow> rows;
    for (int row = 0; row < m_shown->rowCount(); ++row)
        if (m_table->selectionModel()->isRowSelected(row))
            rows.push_back(m_shown->rowAt(row));
    QApplication::clipboard()->setText(traceText(m_shown->device(), rows.empty() ? m_shown->rows() : rows));
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
    const auto shown = std::ranges::find(m_models, m_shown, [](const auto &one) { return one.second.get(); });
    const auto saved =
        replaceFile(path, traceCsv(shown->first, m_shown->device(), m_shown->rows()), OldFile::goes);
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
