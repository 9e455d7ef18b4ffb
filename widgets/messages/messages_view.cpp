// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messages_view.h"

#include "journal/message_fields.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icon_cells.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/log_table.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"
#include "widgets/look/save_file.h"
#include "widgets/messages/message_details.h"
#include "widgets/messages/message_filter_bar.h"
#include "widgets/models/go_to_place.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::size_t largestCopy = 100'000; // rows
constexpr qint64 longExport = 20'000;        // messages; half a second and more
constexpr int longestPlace = 24;             // characters; longer ones are elided
constexpr int fewestLetters = 24;
constexpr int roomForDetails = 260; // px of height

} // namespace

MessagesView::MessagesView(MessageModel &messages, QWidget *parent)
    : QWidget(parent)
    , m_messages(messages)
    , m_filters(new MessageFilterBar(this))
    , m_search(new QLabel(this))
    , m_table(new LogTable(tr("List of messages"), this))
    , m_details(new MessageDetails(this))
    , m_note(new InlineMessage(this))
    , m_empty(new EmptyState(Icon::messages, {}, {}, this))
    , m_goTo(new GoToPlace(this))
{
    setAccessibleName(tr("Messages"));
    auto *column = layOut<QVBoxLayout>(this, grid::unit, grid::unit);
    addAction(m_filters->findAction());
    m_search->setFont(textFont(TextSize::small));
    m_search->setAccessibleName(tr("State of the search"));
    m_filters->row().addWidget(m_search);
    auto *commands = new QToolBar(tr("Messages"), this); // tools without room go into its menu
    commands->setIconSize({grid::smallIcon, grid::smallIcon});
    m_filters->row().addWidget(commands);
    makeCommands(*commands);
    makeTable();
    for (QWidget *part : std::initializer_list<QWidget *>{m_filters, m_note})
        column->addWidget(part);
    column->addWidget(m_table, 1);
    column->addWidget(m_empty, 1);
    column->addWidget(m_details);

    connect(m_filters, &MessageFilterBar::changed, this,
            [this] { m_messages.setFilter(m_filters->filter()); });
    connect(m_empty, &EmptyState::actionTriggered, m_filters, &MessageFilterBar::showAll);
    connect(m_note, &InlineMessage::actionTriggered, this, &MessagesView::act);
    connectModel();
    updateContent();
    onEvent(this, {QEvent::FontChange, QEvent::StyleChange}, [this] { setColumnWidths(); });
    onEvent(this, {QEvent::Resize}, [this] { showChosen(); });
}

MessagesView::~MessagesView()
{
    m_messages.disconnect(this);
    m_messages.setFilter({});
}

void MessagesView::connectModel()
{
    connect(&m_messages, &QAbstractItemModel::rowsInserted, this, &MessagesView::updateContent);
    connect(&m_messages, &QAbstractItemModel::rowsRemoved, this, &MessagesView::updateContent);
    connect(&m_messages, &QAbstractItemModel::dataChanged, this, &MessagesView::showChosen);
    connect(&m_messages, &QAbstractItemModel::modelReset, this, &MessagesView::updateContent);
    connect(&m_messages, &MessageModel::searchChanged, this, &MessagesView::updateContent);
    connect(&m_messages, &MessageModel::unseenChanged, this, [this] {
        if (!visibleRegion().isEmpty())
            m_messages.see();
    });
}

QAction *MessagesView::addCommand(QToolBar &bar, const QIcon &icon, const QString &text,
                                  const QString &toolTip)
{
    auto *command = new QAction(icon, text, this);
    command->setToolTip(toolTip);
    bar.addAction(command);
    QWidget *button = bar.widgetForAction(command);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAccessibleName(toolTip);
    return command;
}

void MessagesView::makeCommands(QToolBar &bar)
{
    m_follow =
        addCommand(bar, lineIcon(Icon::down), tr("Follow"), tr("Keep the newest message in view (Ctrl+End)"));
    m_follow->setCheckable(true);
    m_follow->setChecked(true);
    m_table->setFollow(*m_follow);

    QAction *copyRows = addCommand(bar, lineIcon(Icon::copy), tr("Copy"),
                                   tr("Copy the messages chosen, or all that are shown (Ctrl+C)"));
    copyRows->setShortcut(QKeySequence::Copy);
    copyRows->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copyRows, &QAction::triggered, this, &MessagesView::copy);

    QAction *exportAll = addCommand(bar, lineIcon(Icon::exportData), tr("Export…"),
                                    tr("Write the messages shown to a file (CSV or HTML)"));
    connect(exportAll, &QAction::triggered, this, &MessagesView::exportRows);

    QAction *clearAll = addCommand(bar, lineIcon(Icon::remove), tr("Clear"),
                                   tr("Hide all messages up to now; they are kept on disk"));
    connect(clearAll, &QAction::triggered, this, &MessagesView::clear);

    m_bringBack = new QAction(tr("Bring back what was cleared"), this);
    m_bringBack->setToolTip(tr("Show the messages again that were hidden by Clear"));
    connect(m_bringBack, &QAction::triggered, this, &MessagesView::bringBack);

    m_showDetails = new QAction(tr("Details"), this);
    m_showDetails->setToolTip(tr("Show all of the chosen message below the list (Enter)"));
    m_showDetails->setCheckable(true);
    m_showDetails->setShortcuts({Qt::Key_Return, Qt::Key_Enter});
    m_showDetails->setShortcutContext(Qt::WidgetShortcut);
    connect(m_showDetails, &QAction::triggered, this, [this](bool on) {
        m_detailsWanted = on;
        showChosen();
        layout()->activate();
        m_table->scrollTo(m_table->currentIndex()); // the list has become smaller
    });
    connect(m_goTo, &GoToPlace::wanted, this, &MessagesView::goToWanted);

    auto *separator = new QAction(m_table);
    separator->setSeparator(true);
    m_table->addActions({m_goTo, m_showDetails, copyRows, separator, exportAll, clearAll, m_bringBack});
}

void MessagesView::makeTable()
{
    m_table->setModel(&m_messages);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->horizontalHeader()->hide(); // the columns are self-explanatory, and messages need the room
    m_table->setItemDelegateForColumn(MessageModel::severityColumn, new IconCells(m_table));
    allowEliding(*m_table, MessageModel::placeColumn);
    m_table->setHeadings([this](int row) { return m_messages.isDay(row); });
    connect(m_table, &LogTable::chosenChanged, this, &MessagesView::showChosen);
    setColumnWidths();
}

void MessagesView::setColumnWidths()
{
    const QFontMetrics numbers(numberFont());
    m_table->setColumnWidth(MessageModel::timeColumn,
                            numbers.horizontalAdvance(QStringLiteral("22:58:58")) + 2 * grid::margin);
    m_table->setColumnWidth(MessageModel::severityColumn, grid::smallIcon + 2 * grid::unit);
    showPlaces();
    m_table->setTextColumn(MessageModel::textColumn, fewestLetters);
}

// The column fits the place names, so that they can be told apart.
void MessagesView::showPlaces()
{
    const std::vector<Place> places = m_messages.places();
    const QFontMetrics numbers(numberFont());
    int widest = numbers.horizontalAdvance(QStringLiteral("10.10"));
    for (const Place place : places)
        widest = std::max(widest, numbers.horizontalAdvance(placeName(place)));
    const int most = numbers.horizontalAdvance(QString(longestPlace, u'0'));
    const int width = std::min(widest, most) + 2 * grid::margin;
    if (m_table->columnWidth(MessageModel::placeColumn) != width) {
        m_table->setColumnWidth(MessageModel::placeColumn, width);
        m_table->setTextColumn(MessageModel::textColumn, fewestLetters);
    }
    m_filters->setPlaces(places);
    m_table->viewport()->update();
}

void MessagesView::updateContent()
{
    showPlaces();
    const bool none = m_messages.isEmpty();
    const bool noneShown = m_messages.rowCount() == 0;
    m_table->setVisible(!noneShown);
    m_empty->setVisible(noneShown);
    m_bringBack->setEnabled(m_messages.isCleared());
    if (noneShown) {
        if (none)
            m_empty->setTexts(tr("No messages yet"),
                              tr("What happens to the bus and its devices is listed here."));
        else if (m_messages.searched())
            m_empty->setTexts(tr("No message found so far"), tr("The search goes on."));
        else
            m_empty->setTexts(tr("No message matches the filter"), tr("Change it, or show all messages."));
        m_empty->setAction(none ? QString() : tr("Show all"));
    }
    showSearch();
    showChosen();
}

void MessagesView::showSearch()
{
    const auto part = m_messages.searched();
    const bool isSought = !m_messages.filter().isEmpty();
    m_search->setVisible(isSought);
    if (isSought)
        m_search->setText(part ? tr("searching: %1 %").arg(static_cast<int>(*part * 100))
                               : tr("%n found", nullptr, static_cast<int>(m_messages.foundCount())));
}

int MessagesView::chosenRow() const
{
    const QModelIndex current = m_table->currentIndex();
    return current.isValid() && !m_messages.isDay(current.row()) ? current.row() : -1;
}

void MessagesView::showChosen()
{
    const int row = chosenRow();
    const bool wanted = m_detailsWanted.value_or(height() >= roomForDetails);
    m_showDetails->setChecked(wanted);
    m_goTo->setPlace(row < 0 ? std::nullopt : m_messages.message(row).place);
    m_details->setVisible(wanted && row >= 0);
    if (wanted && row >= 0)
        m_details->show(m_messages, row);
}

// Not called in a dock behind another one.
void MessagesView::paintEvent(QPaintEvent *event)
{
    QWidget::paintEvent(event);
    m_messages.see();
}

std::vector<qint64> MessagesView::chosenIds() const
{
    std::vector<qint64> chosen;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        for (const qint64 id : m_messages.idsOf(index.row()))
            chosen.push_back(id);
    std::ranges::sort(chosen);
    if (!chosen.empty())
        return chosen;
    const IdRuns ids = m_messages.ids();
    for (qint64 each = std::max<qint64>(0, ids.size() - static_cast<qint64>(largestCopy)); each < ids.size();
         ++each)
        chosen.push_back(ids.at(each));
    return chosen;
}

void MessagesView::copy()
{
    QString text;
    for (const StoredMessage &message : m_messages.read(chosenIds())) {
        QStringList cells;
        for (int column = 0; column < MessageModel::columnTotal; ++column)
            cells.append(m_messages.text(message, column));
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text);
}

void MessagesView::clear()
{
    if (m_messages.isEmpty())
        return;
    m_messages.clear();
    note(NoteAction::bringBack, Role::attention,
         tr("The messages up to now are hidden. They are kept on disk."), tr("Bring back"));
}

void MessagesView::showMessage(qint64 id)
{
    const int row = m_messages.rowOf(id);
    if (row < 0)
        return;
    m_table->setFocus();
    m_table->setCurrentIndex(m_messages.index(row, MessageModel::textColumn));
    m_table->scrollTo(m_table->currentIndex());
}

void MessagesView::bringBack()
{
    m_messages.bringBack();
    if (m_noteAction == NoteAction::bringBack)
        m_note->withdraw();
}

void MessagesView::note(NoteAction action, Role role, const QString &sentence, const QString &actionText)
{
    m_noteAction = action;
    m_note->showMessage(role, sentence, actionText);
}

void MessagesView::act()
{
    if (m_noteAction == NoteAction::bringBack)
        bringBack();
    if (m_noteAction == NoteAction::cancelExport && m_export) {
        delete m_export; // discards what was written so far
        m_note->withdraw();
    }
}

void MessagesView::exportRows()
{
    auto *dialog = new QFileDialog(this, tr("Export messages"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    setSaveFilters(*dialog, {tr("Table (*.csv)"), tr("Page (*.html)")});
    dialog->selectFile(tr("messages.csv", "name of a file"));
    connect(dialog, &QFileDialog::fileSelected, this, &MessagesView::writeFile);
    dialog->open();
}

void MessagesView::writeFile(const QString &fileName)
{
    delete m_export;
    m_exportPercent = -1;
    m_export = new MessageExport(
        m_messages, fileName, MessageWriter::formatOf(fileName).value_or(MessageWriter::Format::csv), this);
    connect(m_export, &MessageExport::progressed, this, &MessagesView::showExport);
    connect(m_export, &MessageExport::ended, this, &MessagesView::endExport);
}

void MessagesView::showExport(double part)
{
    const int percent = static_cast<int>(part * 20) * 5; // not for each piece: notes are read aloud
    if (m_export->total() < longExport || percent == m_exportPercent)
        return;
    m_exportPercent = percent;
    note(NoteAction::cancelExport, Role::running,
         tr("Writing %1: %2 %").arg(m_export->fileName()).arg(percent), tr("Cancel"));
}

void MessagesView::endExport(const QString &failure)
{
    if (failure.isEmpty())
        note(NoteAction::none, Role::running,
             tr("Messages written to %1: %2.")
                 .arg(m_export->fileName(), locale().toString(static_cast<qlonglong>(m_export->total()))));
    else
        note(NoteAction::none, Role::fault,
             tr("%1 could not be written: %2. Choose another folder or name.")
                 .arg(m_export->fileName(), failure));
    m_export->deleteLater();
}

} // namespace codewheel
