// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequence/sequence_view.h"

#include "catalog/device_description.h"
#include "project/file_access.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/input/checked_delegate.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/save_file.h"
#include "widgets/look/tool.h"
#include "widgets/models/dragged_place.h"
#include "widgets/monitor/copy_menu.h"
#include "widgets/monitor/word_format.h"
#include "widgets/sequence/sequence_model.h"

#include <QApplication>
#include <QClipboard>
#include <QDropEvent>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTableView>
#include <QToolBar>

namespace codewheel {
namespace {

constexpr int wordsInSight = 3; // however low the panel

} // namespace

SequenceView::SequenceView(QWidget *parent)
    : QWidget(parent)
    , m_model(new SequenceModel(this))
    , m_job(new SequenceJob(this))
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::sequence, {}, {}, this))
    , m_tools(new QToolBar(this))
    , m_table(new QTableView(this))
    , m_hold(describe(
          new IntegerField(this), tr("Cycles for words that nothing acknowledges"),
          tr("How long a word stays that nothing acknowledges; others stay until they are acknowledged")))
    , m_summary(new QLabel(this))
    , m_send(new QPushButton(lineIcon(Icon::start), tr("&Send"), this))
    , m_stop(describe(new QPushButton(lineIcon(Icon::stop), tr("S&top"), this), tr("Stop the sequence"),
                      tr("End the sequence, and choose in which state the encoder is left")))
    , m_message(new InlineMessage(this))
{
    makeTable();
    makeTools();
    makeSending();

    auto *page = new QWidget;
    m_summary->setWordWrap(true);
    m_summary->setToolTip(tr("Add or paste words to send."));
    auto *holdLabel = new QLabel(tr("&Unacknowledged words for"), page);
    holdLabel->setBuddy(m_hold);
    layOutColumn(
        page,
        {m_tools,
         {m_table, 1},
         m_message,
         layOutRow({holdLabel, m_hold, {m_summary, 1}, m_send, m_stop}, {.spacing = grid::groupGap})},
        {.spacing = grid::unit, .margins = QMargins(grid::unit, 0, grid::unit, grid::unit)});
    m_pages->addWidget(m_empty);
    m_pages->addWidget(page);
    connect(m_empty, &EmptyState::actionTriggered, this, &SequenceView::terminalRequested);
    layOutColumn(this, {m_pages}, {.margins = QMargins()});
    setAcceptDrops(true);
    setEncoder(nullptr);
}

// The focus lost in the destructor must not count as leaving a field.
SequenceView::~SequenceView()
{
    m_hold->disconnect(this);
}

void SequenceView::makeTable()
{
    m_table->setModel(m_model);
    auto *words = new CheckedDelegate(
        [](const QModelIndex &, const QString &text) {
            return parseHexWord(text) ? QString() : hexProblem(text);
        },
        this);
    m_table->setItemDelegate(words);
    connect(words, &CheckedDelegate::inputChecked, this, [this](const QString &wrong) {
        if (!wrong.isEmpty())
            say(Role::attention, wrong);
        else if (!m_job->isRunning())
            m_message->withdraw();
    });
    m_table->setAccessibleName(tr("Words to send"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 2 * grid::unit);
    m_table->horizontalHeader()->setSectionResizeMode(SequenceModel::meaning, QHeaderView::Stretch);
    m_table->setTabKeyNavigation(false);
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() +
                              wordsInSight * m_table->verticalHeader()->defaultSectionSize() +
                              2 * m_table->frameWidth());
    connect(m_model, &SequenceModel::badInput, this,
            [this](const QString &sentence) { say(Role::attention, sentence); });
    connect(m_model, &QAbstractItemModel::dataChanged, this, [this] {
        if (!m_job->isRunning())
            m_message->withdraw();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &SequenceView::showWhatIsPossible);
    connect(this, &SequenceView::listChanged, this, &SequenceView::showWhatIsPossible);
    connect(m_model, &QAbstractItemModel::modelReset, this, &SequenceView::listChanged);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &SequenceView::listChanged);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(m_model, signal, this, &SequenceView::listChanged);
}

void SequenceView::makeTools()
{
    makeCopying();
    setUpToolBar(*m_tools);
    const auto makeTool = [this](const Tool &tool, void (SequenceView::*slot)()) {
        QAction *action = addTool(*this, *m_tools, tool);
        connect(action, &QAction::triggered, this, slot);
        return action;
    };
    makeTool({Icon::add, tr("Add"), QKeySequence(Qt::Key_Insert), tr("Insert a word below")},
             &SequenceView::add);
    m_rowActions = {
        makeTool({Icon::remove, tr("Remove"), QKeySequence(Qt::Key_Delete), tr("Remove the selected words")},
                 &SequenceView::removeSelected),
        makeTool({Icon::up, tr("Up"), QKeySequence(Qt::ALT | Qt::Key_Up), tr("Move the word up")},
                 &SequenceView::moveUp),
        makeTool({Icon::down, tr("Down"), QKeySequence(Qt::ALT | Qt::Key_Down), tr("Move the word down")},
                 &SequenceView::moveDown),
    };
    makeTool(
        {Icon::paste, tr("Paste"), QKeySequence::Paste, tr("Insert the column of words that was copied")},
        &SequenceView::paste);
    makeTool({Icon::read, tr("Open"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
              tr("Read a sequence from a file")},
             &SequenceView::askLoad);
    makeTool({Icon::exportData, tr("Save"), QKeySequence(Qt::CTRL | Qt::Key_E),
              tr("Save this sequence in a file")},
             &SequenceView::askSave);
}

void SequenceView::makeSending()
{
    m_hold->setRange(1, WordList::longestHold);
    m_hold->setValue(WordList().holdCycles);
    connect(m_hold, &QSpinBox::editingFinished, this, &SequenceView::holdTaken);
    m_hold->setSuffix(tr(" cycles", "unit of a number of bus cycles"));
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_send->setAccessibleName(tr("Send the sequence"));
    auto *menu = new QMenu(m_stop);
    menu->addAction(tr("&Run: end the parameterization with what the encoder has taken"), this,
                    [this] { stop(OnCancel::runWithWhatItHas); });
    menu->addAction(tr("&Leave the encoder unchanged, OUT back to 0"), this,
                    [this] { stop(OnCancel::leaveAsIs); });
    m_stop->setMenu(menu);
    connect(m_hold, &QSpinBox::valueChanged, this, &SequenceView::listChanged);
    connect(m_send, &QPushButton::clicked, this, &SequenceView::send);
    connect(m_job, &SequenceJob::reached, this, [this](int row) {
        m_model->setSendingRow(row);
        m_table->scrollTo(m_model->index(row, SequenceModel::word));
    });
    connect(m_job, &SequenceJob::ended, this, &SequenceView::showEnd);
}

void SequenceView::setEncoder(EncoderSession *encoder, std::optional<Place> offline)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    showWhyEmpty(encoder, offline);
    const bool takesWords = encoder && encoder->device().hasWords();
    m_pages->setCurrentIndex(takesWords || m_job->isRunning() ? 1 : 0);
    if (!m_job->isRunning())
        m_message->withdraw();
    if (encoder) {
        connect(encoder, &EncoderSession::latestChanged, this, &SequenceView::explainWords);
        connect(encoder, &EncoderSession::permissionChanged, this, [this] {
            if (m_isRefused)
                m_message->withdraw();
        });
        connect(encoder, &QObject::destroyed, this, [this] { setEncoder(nullptr); });
    }
    explainWords();
    showWhatIsPossible();
}

void SequenceView::showWhyEmpty(const EncoderSession *encoder, std::optional<Place> offline)
{
    const bool onLine = encoder && !encoder->device().hasWords();
    if (onLine)
        m_empty->setTexts(tr("%1 is on a serial line").arg(encoder->place().shown()),
                          tr("It takes requests instead of words. Type them in the terminal."));
    else if (offline)
        m_empty->setTexts(tr("%1 is not connected").arg(offline->shown()),
                          tr("Words can be sent to it once it is."));
    else
        m_empty->setTexts(tr("No encoder is selected"),
                          tr("A sequence is a list of words that are sent to an encoder one after the other. "
                             "Select an encoder in the bus structure."));
    m_empty->setAction(onLine ? tr("Open the terminal") : QString());
}

void SequenceView::explainWords()
{
    m_model->setDevice(m_encoder ? &m_encoder->device() : nullptr,
                       m_encoder ? m_encoder->latest().mode : std::nullopt);
}

WordList SequenceView::list() const
{
    return {.words = m_model->words(), .holdCycles = m_hold->value()};
}

void SequenceView::setList(const WordList &list)
{
    m_model->setWords(list.words);
    m_hold->setValue(list.holdCycles);
}

int SequenceView::selectedRow() const
{
    const QModelIndexList selected = m_table->selectionModel()->selectedRows();
    return selected.isEmpty() ? -1 : selected.last().row();
}

void SequenceView::add()
{
    const int row = selectedRow() < 0 ? m_model->rowCount() : selectedRow() + 1;
    m_model->insertAt(row, {});
    const QModelIndex added = m_model->index(row, SequenceModel::word);
    m_table->setCurrentIndex(added);
    m_table->edit(added);
}

void SequenceView::removeSelected()
{
    QList<int> selected;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        selected << index.row();
    std::ranges::sort(selected, std::greater());
    for (const int row : selected)
        m_model->removeAt(row);
}

void SequenceView::moveSelected(int by)
{
    const int row = selectedRow();
    if (row < 0 || row + by < 0 || row + by >= m_model->rowCount())
        return;
    m_model->moveRowTo(row, row + by);
    m_table->selectRow(row + by);
}

// Words for pasting into a PLC program, a table or a sequence: one per line.
void SequenceView::makeCopying()
{
    auto *action = new QAction(lineIcon(Icon::copy), tr("&Copy"), m_table);
    action->setShortcut(QKeySequence::Copy);
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setToolTip(tr("Copies the selected words, or all, one a line"));
    connect(action, &QAction::triggered, this, [this] { copy(WordNotation::hexadecimal); });
    auto *menu = new CopyMenu(m_table);
    connect(menu, &CopyMenu::chosen, this, &SequenceView::copy);
    m_table->addActions({action, menu->plcWords(), menu->menuAction()});
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void SequenceView::copy(WordNotation notation)
{
    const std::vector<Word> words = m_model->words();
    const QItemSelectionModel &selection = *m_table->selectionModel();
    QStringList lines;
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (!selection.hasSelection() || selection.isRowSelected(row))
            lines << copiedText(words[static_cast<std::size_t>(row)], 32, notation);
    if (!lines.isEmpty())
        QApplication::clipboard()->setText(lines.join(u'\n') + u'\n');
}

void SequenceView::paste()
{
    const auto words = parseColumn(QApplication::clipboard()->text());
    if (!words) {
        say(Role::attention, words.error());
        return;
    }
    m_message->withdraw();
    insert(*words);
}

void SequenceView::insert(const std::vector<Word> &words)
{
    int row = selectedRow() < 0 ? m_model->rowCount() : selectedRow() + 1;
    for (const Word word : words)
        m_model->insertAt(row++, {.word = word});
    m_table->selectRow(row - 1);
}

void SequenceView::dragEnterEvent(QDragEnterEvent *event)
{
    if (m_wordsOf && !m_job->isRunning() && placeDragged(*event->mimeData()))
        event->acceptProposedAction();
}

// Appends to the list: words can be removed again, and another encoder may have been meant.
void SequenceView::dropEvent(QDropEvent *event)
{
    const auto place = placeDragged(*event->mimeData());
    if (!place || !m_wordsOf || m_job->isRunning())
        return;
    event->acceptProposedAction();
    std::vector<Word> words = m_wordsOf(*place);
    const std::size_t room = WordList::mostWords - std::min(WordList::mostWords, m_model->words().size());
    if (words.size() > room)
        words.erase(words.begin(), words.end() - static_cast<std::ptrdiff_t>(room));
    if (words.empty()) {
        say(Role::attention,
            tr("There are no words of %1 to take: nothing was sent to it, or the list is full.")
                .arg(place->shown()));
        return;
    }
    m_message->withdraw();
    insert(words);
}

void SequenceView::askLoad()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open a sequence"), {}, tr("Sequences (*.json)"));
    if (!path.isEmpty())
        load(path);
}

void SequenceView::askSave()
{
    const QString path =
        askSaveFile(this, tr("Save the sequence"), tr("sequence.json"), {tr("Sequences (*.json)")});
    if (!path.isEmpty())
        save(path);
}

bool SequenceView::load(const QString &path)
{
    constexpr qint64 largestFile = 10'000'000; // bytes; a word takes 100
    const auto json = readWholeFile(path, largestFile);
    if (!json) {
        say(Role::attention, refusalText(json.error()));
        return false;
    }
    const auto read = sequenceFromJson(*json);
    if (!read) {
        say(Role::attention, tr("%1 was not read. %2", "file, reason").arg(path, read.error()));
        return false;
    }
    m_message->withdraw();
    setList(*read);
    return true;
}

bool SequenceView::save(const QString &path)
{
    if (const auto saved = replaceFile(path, sequenceToJson(list()), OldFile::goes); !saved) {
        say(Role::attention,
            tr("%1 was not saved: %2", "file, reason").arg(path, whyNotWritten(saved.error())));
        return false;
    }
    m_message->withdraw();
    return true;
}

void SequenceView::send()
{
    if (!m_encoder)
        return;
    m_message->withdraw();
    m_model->setSendingRow({});
    if (const QString wrong = takeFields(*this); !wrong.isEmpty()) {
        say(Role::attention, wrong);
        return;
    }
    const SendWords job{.words = m_model->words(), .holdCycles = m_hold->value()};
    if (!askForEeprom(window(), *m_encoder, job) || !m_encoder)
        return;
    const auto started = m_job->start(*m_encoder, job);
    if (!started) {
        say(Role::attention, refusalText(started.error()));
        m_isRefused = true;
    }
    showWhatIsPossible();
}

void SequenceView::stop(OnCancel how)
{
    m_job->cancel(how);
}

void SequenceView::showEnd(const Outcome &outcome, int words)
{
    m_model->setSendingRow(words);
    if (outcome.result)
        say(Role::running, tr("All %n words were sent.", nullptr, words));
    else
        say(outcome.result.error().kind == RefusalKind::stopped ? Role::attention : Role::fault,
            tr("%1 Sent before that: %2 of %3 words.", "reason, counts")
                .arg(refusalText(outcome.result.error()), QLocale().toString(words),
                     QLocale().toString(m_model->rowCount())));
    if (!m_encoder)
        m_pages->setCurrentIndex(0);
    showWhatIsPossible();
    Q_EMIT sendingEnded();
}

void SequenceView::showWhatIsPossible()
{
    const bool runs = m_job->isRunning();
    m_model->setLocked(runs);
    for (QAction *action : actions())
        action->setEnabled(!runs && (selectedRow() >= 0 || !m_rowActions.contains(action)));
    m_hold->setEnabled(!runs);
    m_send->setEnabled(!runs && m_encoder && m_model->rowCount() > 0);
    m_stop->setEnabled(runs);
    const QString place = m_encoder ? m_encoder->place().shown() : QString();
    m_summary->setText(m_model->rowCount() == 0
                           ? tr("No words yet")
                           : tr("%n words to %1", nullptr, m_model->rowCount()).arg(place));
    m_send->setToolTip(
        tr("Send the words to %1 one after the other, each until it is acknowledged").arg(place));
}

void SequenceView::say(Role role, const QString &sentence)
{
    m_isRefused = false;
    m_message->showMessage(role, sentence);
}

} // namespace codewheel
