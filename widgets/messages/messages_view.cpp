// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messages_view.h"

#include "widgets/look/empty_state.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/messages/message_csv.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSaveFile>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

namespace codewheel {

MessagesView::MessagesView(MessageModel &messages, QWidget *parent)
    : QWidget(parent)
    , m_messages(messages)
    , m_filter(new MessageFilter(messages, this))
    , m_search(new QLineEdit(this))
    , m_severity(new QComboBox(this))
    , m_place(new QComboBox(this))
    , m_table(new QTableView(this))
    , m_note(new InlineMessage(this))
    , m_empty(new EmptyState(Icon::messages, {}, {}, this))
{
    setAccessibleName(tr("Messages"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(grid::unit, grid::unit, grid::unit, grid::unit);
    column->setSpacing(grid::unit);
    QBoxLayout *row = makeFilters();
    makeCommands(row);
    makeTable();
    column->addLayout(row);
    column->addWidget(m_note);
    column->addWidget(m_table, 1);
    column->addWidget(m_empty, 1);

    connect(m_empty, &EmptyState::actionTriggered, this, &MessagesView::showAll);
    connect(m_note, &InlineMessage::actionTriggered, this, &MessagesView::bringBack);
    connect(m_note, &InlineMessage::closed, this, [this] { m_cleared.clear(); });
    connect(&messages, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex &, int first) { listPlaces(first); });
    connect(&messages, &QAbstractItemModel::modelReset, this, [this] { listPlaces(0); });
    for (const auto change : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(m_filter, change, this, &MessagesView::updateContent);
    connect(m_filter, &QAbstractItemModel::modelReset, this, &MessagesView::updateContent);
    listPlaces(0);
    updateContent();
}

QBoxLayout *MessagesView::makeFilters()
{
    m_search->setPlaceholderText(tr("Search"));
    m_search->setAccessibleName(tr("Search in messages"));
    m_search->setToolTip(tr("Show only messages with this text (Ctrl+F)"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(lineIcon(Icon::search, Role::inactive), QLineEdit::LeadingPosition);
    auto *find = new QAction(tr("Search"), this);
    find->setShortcut(QKeySequence::Find);
    find->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(find);
    connect(find, &QAction::triggered, this, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    connect(m_search, &QLineEdit::textChanged, m_filter, &MessageFilter::setText);

    m_severity->addItem(tr("All messages"), QVariant::fromValue(Severity::information));
    m_severity->addItem(tr("Attention and faults"), QVariant::fromValue(Severity::attention));
    m_severity->addItem(tr("Faults only"), QVariant::fromValue(Severity::fault));
    m_severity->setAccessibleName(tr("Severity of messages"));
    m_severity->setToolTip(tr("Show only messages of this severity or worse"));
    connect(m_severity, &QComboBox::currentIndexChanged, this,
            [this] { m_filter->setSeverity(m_severity->currentData().value<Severity>()); });

    m_place->addItem(tr("All places"), QVariant::fromValue(MessageFilter::Place{}));
    m_place->addItem(tr("Bus"), QVariant::fromValue(MessageFilter::Place{.all = false}));
    m_place->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_place->setAccessibleName(tr("Place of messages"));
    m_place->setToolTip(tr("Show only messages of this device, or of the bus itself"));
    connect(m_place, &QComboBox::currentIndexChanged, this,
            [this] { m_filter->setPlace(m_place->currentData().value<MessageFilter::Place>()); });

    auto *row = new QHBoxLayout;
    row->setSpacing(grid::unit);
    row->addWidget(m_search, 1);
    row->addWidget(m_severity);
    row->addWidget(m_place);
    row->addSpacing(grid::unit);
    return row;
}

QAction *MessagesView::addCommand(QBoxLayout *row, const QIcon &icon, const QString &text,
                                  const QString &toolTip)
{
    auto *command = new QAction(icon, text, this);
    command->setToolTip(toolTip);
    auto *button = new QToolButton(this);
    button->setDefaultAction(command);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAccessibleName(toolTip);
    row->addWidget(button);
    return command;
}

void MessagesView::makeCommands(QBoxLayout *row)
{
    m_follow = addCommand(row, {}, tr("Follow"), tr("Keep the newest message in sight (Ctrl+End)"));
    m_follow->setCheckable(true);
    m_follow->setChecked(true);
    connect(m_follow, &QAction::toggled, this, &MessagesView::followNewest);

    QAction *copyRows = addCommand(row, lineIcon(Icon::copy), tr("Copy"),
                                   tr("Copy the messages chosen, or all that are shown (Ctrl+C)"));
    copyRows->setShortcut(QKeySequence::Copy);
    copyRows->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copyRows, &QAction::triggered, this, &MessagesView::copy);

    QAction *exportAll = addCommand(row, lineIcon(Icon::exportData), tr("Export…"),
                                    tr("Write the messages shown to a file (CSV)"));
    connect(exportAll, &QAction::triggered, this, &MessagesView::exportRows);

    QAction *clearAll =
        addCommand(row, lineIcon(Icon::remove), tr("Clear"), tr("Remove all messages from this list"));
    connect(clearAll, &QAction::triggered, this, &MessagesView::clear);

    m_table->addActions({copyRows, exportAll, clearAll});
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void MessagesView::makeTable()
{
    m_table->setModel(m_filter);
    m_table->setAccessibleName(tr("List of messages"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setIconSize({grid::smallIcon, grid::smallIcon});
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setMinimumHeight(2 * grid::largeIcon);
    setColumnWidths();

    // Whoever scrolls up wants to read; at the end one follows again.
    QScrollBar *bar = m_table->verticalScrollBar();
    connect(bar, &QScrollBar::actionTriggered, this,
            [this, bar] { m_follow->setChecked(bar->sliderPosition() >= bar->maximum()); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex &current) {
                if (current.isValid())
                    m_follow->setChecked(current.row() == m_filter->rowCount() - 1);
            });
}

void MessagesView::setColumnWidths()
{
    const QFontMetrics numbers(numberFont());
    const QFontMetrics texts(m_table->font());
    const int gap = 2 * grid::margin;
    const QString widestTime =
        MessageModel::text({QDateTime(QDate(2026, 12, 28), QTime(22, 58)), {}}, MessageModel::timeColumn);
    int severity = 0;
    for (const Severity each : {Severity::information, Severity::attention, Severity::fault})
        severity = std::max(severity, texts.horizontalAdvance(severityName(each)));
    m_table->setColumnWidth(MessageModel::timeColumn, numbers.horizontalAdvance(widestTime) + gap);
    m_table->setColumnWidth(MessageModel::severityColumn, severity + grid::smallIcon + gap);
    m_table->setColumnWidth(MessageModel::placeColumn,
                            numbers.horizontalAdvance(QStringLiteral("10.10")) + gap);
    m_table->verticalHeader()->setDefaultSectionSize(std::max(grid::smallIcon, numbers.height()) +
                                                     grid::unit);
}

// A place can be chosen once something happened there.
void MessagesView::listPlaces(int firstNew)
{
    for (int row = firstNew; row < m_messages.rowCount(); ++row) {
        const auto &number = m_messages.rowAt(row).message.place;
        if (!number || m_place->findText(number->toString()) >= 0)
            continue;
        const auto before = [this](int index, DeviceNumber added) {
            return *m_place->itemData(index).value<MessageFilter::Place>().number < added;
        };
        int index = 2; // after "all places" and "bus"
        while (index < m_place->count() && before(index, *number))
            ++index;
        m_place->insertItem(index, number->toString(),
                            QVariant::fromValue(MessageFilter::Place{.all = false, .number = number}));
    }
}

void MessagesView::showAll()
{
    m_search->clear();
    m_severity->setCurrentIndex(0);
    m_place->setCurrentIndex(0);
}

void MessagesView::updateContent()
{
    const bool none = m_messages.rowCount() == 0;
    const bool noneShown = m_filter->rowCount() == 0;
    m_table->setVisible(!noneShown);
    m_empty->setVisible(noneShown);
    if (noneShown) {
        if (none)
            m_empty->setTexts(tr("No messages yet"),
                              tr("What happens to the bus and its devices is told here."));
        else
            m_empty->setTexts(tr("No message fits the filter"), tr("Change it, or show all messages."));
        m_empty->setAction(none ? QString() : tr("Show all"));
    }
    followNewest();
}

void MessagesView::followNewest()
{
    if (m_follow->isChecked())
        m_table->scrollToBottom();
}

void MessagesView::add(const Message &message)
{
    m_messages.addNow(message);
}

const MessageRow &MessagesView::shownRow(int row) const
{
    return m_messages.rowAt(m_filter->mapToSource(m_filter->index(row, 0)).row());
}

std::vector<int> MessagesView::chosenRows() const
{
    std::vector<int> rows;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        rows.push_back(index.row());
    if (rows.empty())
        for (int row = 0; row < m_filter->rowCount(); ++row)
            rows.push_back(row);
    std::sort(rows.begin(), rows.end());
    return rows;
}

void MessagesView::copy()
{
    QString text;
    for (const int row : chosenRows()) {
        QStringList cells;
        for (int column = 0; column < MessageModel::columnTotal; ++column)
            cells.append(MessageModel::text(shownRow(row), column));
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    QApplication::clipboard()->setText(text);
}

void MessagesView::clear()
{
    if (m_messages.rowCount() == 0)
        return;
    m_cleared = m_messages.rows();
    m_messages.setRows({});
    m_note->showMessage(Role::attention, tr("The list of messages was cleared."), tr("Bring back"));
}

void MessagesView::bringBack()
{
    std::vector<MessageRow> rows = std::move(m_cleared);
    m_cleared.clear();
    rows.insert(rows.end(), m_messages.rows().begin(), m_messages.rows().end());
    if (rows.size() > MessageModel::capacity)
        rows.erase(rows.begin(), rows.end() - MessageModel::capacity);
    m_messages.setRows(std::move(rows));
    m_note->withdraw();
}

void MessagesView::exportRows()
{
    auto *dialog = new QFileDialog(this, tr("Export messages"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->setNameFilter(tr("Table (*.csv)"));
    dialog->selectFile(tr("messages.csv", "name of a file"));
    connect(dialog, &QFileDialog::fileSelected, this, &MessagesView::writeFile);
    dialog->open();
}

void MessagesView::writeFile(const QString &fileName)
{
    std::vector<MessageRow> rows;
    for (int row = 0; row < m_filter->rowCount(); ++row)
        rows.push_back(shownRow(row));
    const QByteArray csv = messagesAsCsv(rows);
    QSaveFile file(fileName);
    m_cleared.clear(); // the note is about the file now
    if (file.open(QIODevice::WriteOnly) && file.write(csv) == csv.size() && file.commit())
        m_note->showMessage(
            Role::running,
            tr("Messages written to %1: %2.").arg(fileName, locale().toString(m_filter->rowCount())));
    else
        m_note->showMessage(Role::fault, tr("%1 could not be written: %2. Choose another folder or name.")
                                             .arg(fileName, file.errorString()));
}

void MessagesView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        setColumnWidths();
}

} // namespace codewheel
