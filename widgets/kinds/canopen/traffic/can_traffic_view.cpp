// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/traffic/can_traffic_view.h"

#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/bus/canopen_traffic.h"
#include "project/file_access.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/traffic/can_traffic_filter.h"
#include "widgets/kinds/canopen/traffic/send_frame_bar.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/save_file.h"
#include "widgets/models/go_to_place.h"
#include "widgets/models/traffic_model.h"
#include "widgets/trace/traffic_table.h"
#include "widgets/trace/traffic_tools.h"

#include <QAction>
#include <QLabel>
#include <QStackedWidget>
#include <QToolBar>

namespace codewheel {
namespace {

constexpr int mostRows = 100'000;

} // namespace

CanTrafficView::CanTrafficView(QWidget *parent)
    : QWidget(parent)
    , m_rows(new TrafficModel(canTrafficColumns, mostRows, this))
    , m_table(new TrafficTable(*m_rows, tr("Frames on the bus"), this))
    , m_content(new QStackedWidget(this))
    , m_counts(new QLabel(this))
    , m_goTo(new GoToPlace(this))
    , m_message(new InlineMessage(this))
    , m_sending(new SendFrameBar(this))
{
    setAccessibleName(tr("CAN traffic"));
    auto *tools = new QToolBar(tr("CAN traffic"), this);
    makeTools(*tools);
    auto *filter = new CanTrafficFilter(*m_table, this);
    auto *filterRow = new QHBoxLayout;
    filterRow->setSpacing(grid::groupGap);
    filterRow->addWidget(filter, 1);
    filterRow->addWidget(m_counts);
    m_content->addWidget(m_table);
    m_content->addWidget(new EmptyState(Icon::trace, tr("Nothing has passed on the bus yet"),
                                        tr("Connect a CAN bus to watch it."), this));
    m_content->setMinimumHeight(2 * grid::largeIcon);
    auto *rows = layOut<QVBoxLayout>(this, grid::unit / 2, QMargins(grid::unit, 0, grid::unit, 0));
    rows->addWidget(tools);
    rows->addLayout(filterRow);
    rows->addWidget(m_content, 1);
    rows->addWidget(m_message);
    rows->addWidget(m_sending);
    setFocusProxy(m_table);
    connect(m_rows, &TrafficModel::countsChanged, this, &CanTrafficView::showCounts);
    connect(filter, &CanTrafficFilter::changed, this, &CanTrafficView::showCounts);
    connect(m_sending, &SendFrameBar::sent, m_follow, [this] { m_follow->setChecked(true); });
    showCounts();
}

CanTrafficView::~CanTrafficView() = default;

void CanTrafficView::makeTools(QToolBar &bar)
{
    const TrafficTools tools(*this, bar, *m_table);
    m_follow = tools.follow;
    m_bringBack = tools.bringBack;
    m_table->addActions({tools.copy, m_goTo, tools.exportRows, tools.clear, m_bringBack});
    connect(m_table, &LogTable::chosenChanged, this, [this] { m_goTo->setPlace(m_table->chosenPlace()); });
    connect(m_goTo, &GoToPlace::wanted, this, &CanTrafficView::goToWanted);
    connect(tools.hold, &QAction::toggled, m_rows, &TrafficModel::setHeld);
    connect(tools.copy, &QAction::triggered, m_table, &TrafficTable::copy);
    connect(tools.exportRows, &QAction::triggered, this, &CanTrafficView::askExport);
    connect(tools.clear, &QAction::triggered, m_rows, &TrafficModel::clear);
    connect(m_bringBack, &QAction::triggered, m_rows, &TrafficModel::bringBack);
}

void CanTrafficView::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_rows->showWaiting();
    const bool isOther = m_bus != bus;
    m_bus = bus;
    m_sending->setBus(bus);
    if (bus == nullptr)
        return;
    if (isOther) {
        m_whole = {};
        if (!m_rows->isEmpty())
            m_rows->beginConnection(bus->dateTime(bus->now()));
    }
    connect(bus, &CanopenSession::trafficPassed, this, &CanTrafficView::add);
    connect(bus, &CanopenSession::updated, this, &CanTrafficView::takeOverdue);
    connect(bus, &QObject::destroyed, this, [this] { setBus(nullptr); });
}

void CanTrafficView::setRecordingChosen(bool isChosen)
{
    m_sending->setRecordingChosen(isChosen);
}

void CanTrafficView::setMostRows(int rows)
{
    m_rows->setMost(rows);
}

std::shared_ptr<const TrafficModel> CanTrafficView::takeRows()
{
    m_rows->setParent(nullptr);
    return std::shared_ptr<const TrafficModel>(m_rows);
}

void CanTrafficView::goOn(const TrafficModel &before)
{
    m_rows->goOnFrom(before);
}

void CanTrafficView::add(const TrafficRow &row)
{
    for (TrafficRow &each : m_whole.next(row))
        m_rows->add(std::move(each));
}

void CanTrafficView::takeOverdue()
{
    for (TrafficRow &each : m_whole.overdue(m_bus->now()))
        m_rows->add(std::move(each));
    if (!visibleRegion().isEmpty())
        m_rows->showWaiting();
}

// Shows what came while nobody looked. Not in showEvent(), which also comes behind another tab.
void CanTrafficView::paintEvent(QPaintEvent *event)
{
    QWidget::paintEvent(event);
    if (m_rows->waiting() > 0 && !m_rows->isHeld())
        QMetaObject::invokeMethod(m_rows, &TrafficModel::showWaiting, Qt::QueuedConnection);
}

void CanTrafficView::showCounts()
{
    m_counts->setText(m_rows->countsText(m_table->model()->rowCount()));
    m_content->setCurrentIndex(m_rows->isEmpty() ? 1 : 0);
    m_bringBack->setEnabled(m_rows->hasCleared());
}

bool CanTrafficView::exportTo(const QString &path)
{
    m_rows->showWaiting();
    const auto written = replaceFile(path, m_table->exportText().toUtf8(), OldFile::goes);
    if (written)
        m_message->withdraw();
    else
        m_message->showMessage(Role::attention, sentence(tr("%1 was not saved: %2", "file, reason"),
                                                         {path, whyNotWritten(written.error())}));
    return written.has_value();
}

void CanTrafficView::askExport()
{
    const QString path =
        askSaveFile(this, tr("Export the rows"), tr("can.txt", "name of a file"), {tr("Text files (*.txt)")});
    if (!path.isEmpty())
        exportTo(path);
}

} // namespace codewheel
