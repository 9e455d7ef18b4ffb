// SPDX-License-Identifier: GPL-3.0-or-later
// What the trend is made of.
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/folding_row.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/tool.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/trend/curve_bar.h"
#include "widgets/trend/curve_menu.h"
#include "widgets/trend/note_bar.h"
#include "widgets/trend/shift_bar.h"
#include "widgets/trend/trend_chart.h"
#include "widgets/trend/trend_page.h"
#include "widgets/trend/trend_values_model.h"

#include <QAction>
#include <QActionGroup>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto rest = 150ms; // after which cursors rest
constexpr auto oftenEnough = 200ms;
constexpr int wideEnough = 1'000; // for all columns of the table
constexpr int tallEnough = 450;   // for a table of three curves
constexpr int chartShare = 70;    // of the height
constexpr int belowShare = 30;

QToolButton *menuButton(QToolBar &bar, QMenu *menu, Icon icon, const QString &text, const QString &tip)
{
    auto *button = new QToolButton(&bar);
    button->setIcon(lineIcon(icon));
    button->setText(text);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(menu);
    button->setToolTip(tip);
    QObject::connect(&bar, &QToolBar::toolButtonStyleChanged, button, &QToolButton::setToolButtonStyle);
    button->setToolButtonStyle(bar.toolButtonStyle());
    bar.addWidget(button);
    return button;
}

} // namespace

TrendPage::TrendPage(Buses &buses, Histories &histories, std::function<QString(Place)> station,
                     QWidget *parent)
    : Page(parent)
    , m_buses(buses)
    , m_histories(histories)
    , m_station(std::move(station))
    , m_scales(buses, histories, m_tracks)
    , m_pages(new QStackedWidget(this))
    , m_empty(
          new EmptyState(Icon::trend, tr("No curve is shown"),
                         tr("Drag an encoder from the bus structure here, or choose a curve with Add. What "
                            "encoders show is kept whether it is shown or not."),
                         this))
    , m_tools(new QToolBar(this))
    , m_message(new InlineMessage(this))
    , m_view(new TrendView(histories, m_tracks, m_scales, m_station, this))
    , m_note(new NoteBar(this))
    , m_cursors(named(wrappedLabel(this), "trendCursors"))
    , m_parts(new QTabBar(this))
    , m_values(new TrendValuesModel(this))
    , m_table(new QTableView(this))
    , m_curve(new CurveBar(m_tracks, m_scales, this))
    , m_shift(new ShiftBar(this))
    , m_memory(named(wrappedLabel(this), "trendMemory"))
{
    setAcceptDrops(true);
    makeTools();
    makeTable();
    auto *below = new QWidget;
    layOutColumn(below, {m_note, m_cursors, {m_table, 1}, new FoldingRow(m_parts, m_curve), m_shift},
                 {.spacing = grid::unit, .margins = QMargins(0, grid::unit, 0, 0)});
    auto *parts = new QSplitter(Qt::Vertical);
    parts->addWidget(m_view);
    parts->addWidget(below);
    parts->setStretchFactor(0, 1);
    parts->setSizes({chartShare, belowShare});
    parts->setChildrenCollapsible(false);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(parts);
    m_memory->setFont(textFont(TextSize::small));
    m_lastLine = layOutRow({{m_memory, 1}}, {.spacing = grid::unit, .margins = QMargins()});
    layOutColumn(this, {m_tools, m_message, {m_pages, 1}, m_lastLine},
                 {.spacing = grid::unit, .margins = QMargins(grid::margin, 0, grid::margin, grid::unit)});
    makeShortcuts();
    connectParts();
    connectRecordings();
    takeArchives();
    showWhatThereIs();
    showValues();
    showMemory();
    setFocusProxy(m_view->findChild<TrendChart *>());
    onEvent(this, {QEvent::Show}, [this] {
        m_scales.look();
        m_view->showAnew();
        showMemory();
    });
    onEvent(this, {QEvent::Resize}, [this] {
        showColumns();
        giveTableRoom();
    });
}

void TrendPage::makeTools()
{
    setUpToolBar(*m_tools);
    auto *curves = new CurveMenu(m_buses, m_histories, m_station, this);
    connect(curves, &CurveMenu::chosen, this, &TrendPage::showTrack);
    QToolButton *add =
        menuButton(*m_tools, curves, Icon::add, tr("Add"), tr("Shows another curve (Ctrl+Ins)"));
    describe(named(add, "addCurve"), tr("Add a curve"), add->toolTip());
    const auto opens = [this](QToolButton *button, const QKeySequence &key) {
        auto *open = new QAction(button->accessibleName(), this);
        open->setShortcut(key);
        open->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        open->setToolTip(button->toolTip());
        connect(open, &QAction::triggered, button, &QToolButton::showMenu);
        addAction(open);
    };
    opens(add, Qt::CTRL | Qt::Key_Insert);
    const auto tool = [this](Icon icon, const QString &text, const QKeySequence &key, const QString &tip) {
        return addTool(*this, *m_tools, {icon, text, key, tip});
    };
    m_follow = tool(Icon::next, tr("Follow"), Qt::CTRL | Qt::Key_End, tr("Keeps the newest values in sight"));
    m_follow->setCheckable(true);
    m_follow->setChecked(true);
    m_pause = tool(Icon::stop, tr("Pause"), Qt::CTRL | Qt::Key_H,
                   tr("Holds the picture; all that comes is kept and shown afterwards"));
    m_pause->setCheckable(true);
    QAction *all = tool(Icon::search, tr("All"), Qt::CTRL | Qt::Key_Home,
                        tr("Shows all the time there is, with axes that fit"));
    m_together =
        tool(Icon::compare, tr("Together"), Qt::CTRL | Qt::SHIFT | Qt::Key_B,
             tr("Lays the open recordings on each other: all begin together, with the same curves of each"));
    QAction *note =
        tool(Icon::write, tr("Note"), Qt::CTRL | Qt::Key_M, tr("Marks the moment at the cursor with a text"));
    QAction *picture = tool(Icon::save, tr("Picture"), Qt::CTRL | Qt::SHIFT | Qt::Key_I,
                            tr("Saves what is seen as a PNG or SVG file"));
    QToolButton *exporting = menuButton(*m_tools, makeExportMenu(), Icon::exportData, tr("Export"),
                                        tr("Saves the curves that are shown as a table (Ctrl+E)"));
    describe(named(exporting, "exportTrend"), tr("Export"), exporting->toolTip());
    opens(exporting, Qt::CTRL | Qt::Key_E);
    connect(m_follow, &QAction::triggered, this,
            [this](bool follow) { follow ? m_view->follow() : m_view->stopFollowing(); });
    connect(all, &QAction::triggered, m_view, &TrendView::showAll);
    connect(m_together, &QAction::triggered, this, &TrendPage::layTogether);
    connect(note, &QAction::triggered, this, &TrendPage::askNote);
    connect(picture, &QAction::triggered, this, &TrendPage::askPicture);
}

QMenu *TrendPage::makeExportMenu()
{
    auto *menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    const auto add = [&](const QString &text, Extract what) {
        QAction *action = menu->addAction(text);
        connect(action, &QAction::triggered, this, [this, what] { askExport(what); });
        connect(menu, &QMenu::aboutToShow, action,
                [this, action, what] { action->setEnabled(!m_tracks.shown().empty() && spanOf(what)); });
    };
    add(tr("What is &seen…"), Extract::seen);
    add(tr("What is &between the cursors…"), Extract::betweenCursors);
    add(tr("&All that is kept…"), Extract::all);
    menu->addSeparator();
    m_forSpreadsheets = menu->addAction(tr("For s&preadsheets of this country"));
    m_withDates = menu->addAction(tr("With a column of &dates"));
    m_withDates->setToolTip(tr("Beside the seconds: date and time of day, with the offset from UTC"));
    auto *styles = new QActionGroup(menu);
    styles->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (QAction *style : {m_forSpreadsheets, m_withDates}) {
        style->setCheckable(true);
        styles->addAction(style);
    }
    m_forSpreadsheets->setToolTip(tr("With its decimal sign, and with dates and times of day; otherwise with "
                                     "commas, points and seconds, as programs take it"));
    return menu;
}

// What needs no button.
void TrendPage::makeShortcuts()
{
    const auto add = [this](const QString &text, const QKeySequence &key, auto what) {
        auto *action = new QAction(text, this);
        action->setShortcut(key);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        connect(action, &QAction::triggered, this, what);
        addAction(action);
    };
    add(tr("Cursor to the next mark"), Qt::CTRL | Qt::Key_Down, [this] { showMark(true); });
    add(tr("Cursor to the mark before"), Qt::CTRL | Qt::Key_Up, [this] { showMark(false); });
    add(tr("Move the curve up"), Qt::ALT | Qt::Key_Up, [this] { m_curve->move(-1); });
    add(tr("Move the curve down"), Qt::ALT | Qt::Key_Down, [this] { m_curve->move(1); });
    add(tr("Remove the cursors"), Qt::CTRL | Qt::Key_Delete, [this] { m_view->removeCursors(); });
}

void TrendPage::makeTable()
{
    setUpQuietTable(*m_table, *m_values, tr("Curves"));
    m_table->setObjectName(QStringLiteral("trendTable"));
    m_table->setToolTip(tr("The curves, and what they are at the cursors"));
    allowEliding(*m_table, TrendValuesModel::name);
    FittedColumns::useIn(*m_table, TrendValuesModel::name);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // it fits
    m_parts->addTab(tr("Values"));
    m_parts->addTab(tr("Statistics"));
    m_parts->setShape(QTabBar::RoundedSouth);
    m_parts->setDrawBase(false);
    m_parts->setExpanding(false);
    m_parts->setUsesScrollButtons(false);
    describe(m_parts, "trendParts", tr("Columns of the table"),
             tr("Values at the cursors, or statistics between them"));
    auto *remove = new QAction(tr("Remove curve"), m_table);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    connect(remove, &QAction::triggered, this, [this] {
        if (const auto curve = currentCurve())
            m_tracks.remove(*curve);
    });
    m_table->addAction(remove);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

// Both parts beside each other where there is room.
void TrendPage::showColumns()
{
    const bool isWide = width() >= wideEnough;
    m_parts->setVisible(!isWide);
    const bool hasStatistics = isWide || m_parts->currentIndex() == 1;
    const bool hasValues = isWide || m_parts->currentIndex() == 0;
    for (int column = TrendValuesModel::now; column < TrendValuesModel::count; ++column)
        m_table->setColumnHidden(column, column >= TrendValuesModel::least ? !hasStatistics : !hasValues);
}

void TrendPage::giveTableRoom()
{
    const int row = m_table->fontMetrics().height() + 2 * grid::unit;
    const int curves = height() >= tallEnough ? 3 : 2;
    m_table->setMinimumHeight((1 + curves) * row); // with the headings
}

void TrendPage::connectParts()
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(rest);
    connect(&m_soon, &QTimer::timeout, this, &TrendPage::showStatistics);
    m_seldom.setInterval(oftenEnough);
    m_seldom.start();
    connect(&m_seldom, &QTimer::timeout, this, [this] {
        if (!isVisible())
            return;
        m_values->showNow(m_view->scene());
        showMemory();
    });
    connect(m_parts, &QTabBar::currentChanged, this, &TrendPage::showColumns);
    connect(m_view, &TrendView::cursorsMoved, this, &TrendPage::showValues);
    connect(m_view, &TrendView::scalesChanged, this, [this] {
        showValues();
        m_curve->showAnew();
    });
    connect(m_view, &TrendView::followChanged, m_follow, &QAction::setChecked);
    connect(m_view, &TrendView::followChanged, this, [this](bool follows) {
        if (follows)
            m_pause->setChecked(false);
    });
    connect(&m_tracks, &TrendTracks::changed, this, [this] {
        showValues();
        showWhatThereIs();
    });
    connect(&m_histories, &Histories::moved, &m_tracks, &TrendTracks::encoderMoved);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &TrendPage::showCurve);
    connect(m_curve, &CurveBar::moved, this,
            [this](std::size_t to) { m_table->selectRow(static_cast<int>(to)); });
    connect(m_message, &InlineMessage::actionTriggered, this, &TrendPage::cancelExport);
    connect(m_note, &NoteBar::noted, &m_histories, &Histories::note);
    connect(m_note, &NoteBar::closed, m_view->findChild<TrendChart *>(), qOverload<>(&QWidget::setFocus));
    connect(&m_histories, &Histories::marksChanged, this, &TrendPage::showCursors);
}

void TrendPage::connectRecordings()
{
    connect(&m_histories, &Histories::archivesChanged, this, &TrendPage::takeArchives);
    connect(&m_histories, &Histories::statisticsReady, &m_soon, qOverload<>(&QTimer::start));
    connect(&m_histories, &Histories::archiveTroubled, this,
            [this](const Refusal &why) { say(Role::attention, refusalText(why)); });
    connect(m_shift, &ShiftBar::beginWanted, this, &TrendPage::beginTogether);
    connect(m_shift, &ShiftBar::cursorWanted, this, &TrendPage::putCursorAOnB);
    connect(m_shift, &ShiftBar::momentWanted, this, [this] {
        const TrendScene &scene = m_view->scene();
        if (const auto at = scene.cursors.at(scene.chosenCursor); at && m_shift->archive() != nullptr)
            m_shift->archive()->askFor(*at);
    });
}

} // namespace codewheel
