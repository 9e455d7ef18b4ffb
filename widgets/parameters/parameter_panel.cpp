// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_panel.h"

#include "jobs/plc_words.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "vocabulary/refusal_text.h"
#include "widgets/functions/encoder_functions.h"
#include "widgets/functions/function_questions.h"
#include "widgets/job/job_strip.h"
#include "widgets/job/known_before_bar.h"
#include "widgets/job/outcome_text.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fonts.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/look/role_label.h"
#include "widgets/models/age_text.h"
#include "widgets/models/device_traits.h"
#include "widgets/monitor/copy_menu.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/position_to_set.h"
#include "widgets/parameters/preset_review.h"
#include "widgets/parameters/value_bar.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/parameters/write_review.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int questionLines = 10; // with its buttons
constexpr int tableLines = 5;     // that are worth having beside it: its head and some values

bool isStateSeen(EncoderState state)
{
    return state != EncoderState::unknown && state != EncoderState::notSeen && state != EncoderState::silent;
}

} // namespace

ParameterPanel::ParameterPanel(const Buses &buses, WantedValues &wanted, QWidget *parent)
    : QWidget(parent)
    , m_wanted(wanted)
    , m_model(new ParameterModel(wanted, this))
    , m_functions(new EncoderFunctions(buses, this))
    , m_whose(new QLabel(this))
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::parameters, {}, {}, this))
    , m_review(new WriteReview(this))
    , m_presetReview(new PresetReview(this))
{
    m_tablePage = makeTablePage();
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_tablePage);
    m_pages->addWidget(m_review);
    m_pages->addWidget(m_presetReview);
    m_whose->setTextFormat(Qt::PlainText);
    m_whose->setWordWrap(true);
    m_whose->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // a long name does not widen the panel
    m_whose->setObjectName(QStringLiteral("whose"));
    layOutColumn(this, {m_whose, {m_pages, 1}});
    connectParts();
    setEncoder({});
    onEvent(this, {QEvent::Resize}, [this] { giveWayToQuestion(); });
}

QWidget *ParameterPanel::makeTablePage()
{
    auto *page = new QWidget(this);
    m_values = new QWidget(page);
    m_table = new ParameterTable(*m_model, m_values);
    auto *said = new QWidget(m_values);
    m_differences = new RoleLabel(said);
    m_message = new InlineMessage(said);
    m_message->setObjectName(QStringLiteral("panelMessage"));
    m_before = new KnownBeforeBar(said);
    m_bar = new ValueBar(said);
    m_buttons = makeButtons();
    m_job = new JobStrip(page);
    const auto smallText = [](QWidget *parent) {
        auto *text = new QLabel(parent);
        text->setFont(textFont(TextSize::small));
        text->setWordWrap(true);
        return text;
    };
    m_valueNotes = smallText(said);
    m_note = smallText(page);

    layOutColumn(said, {m_before, m_message, m_bar, m_differences, m_valueNotes}, {.margins = QMargins()});
    m_saidArea = new ContentScrollArea(said, m_values); // in a low panel, what is said is not cut off
    m_saidArea->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    layOutColumn(m_values, {{m_table, 1}, m_saidArea}, {.margins = QMargins()});
    layOutColumn(page, {{m_values, 1}, m_note, m_buttons, m_job}, {.margins = QMargins()});
    return page;
}

QWidget *ParameterPanel::makeButtons()
{
    auto *buttons = new QWidget(this);
    m_read = new QPushButton(lineIcon(Icon::read), tr("&Read from encoder"), buttons);
    m_write = new QPushButton(lineIcon(Icon::write), tr("&Write…"), buttons);
    m_write->setObjectName(QStringLiteral("writeParameters"));
    m_wizard = new QPushButton(lineIcon(Icon::wizard), tr("Wi&zard…"), buttons);
    m_more = describe(new QToolButton(buttons), tr("More for the parameters"),
                      tr("Take over, clear or set values manually; modes, preset and reset"));
    m_more->setText(tr("&More"));
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    makeMenu();

    auto *layout = new QGridLayout(buttons);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_read, 0, 0);
    layout->addWidget(m_write, 0, 1);
    layout->addWidget(m_wizard, 1, 0);
    layout->addWidget(m_more, 1, 1);
    return buttons;
}

void ParameterPanel::makeMenu()
{
    auto *menu = named(new QMenu(m_more), "moreMenu");
    m_tellValue = menu->addAction(tr("Set &manually what the encoder has…"));
    menu->addSeparator();
    m_takeKnown = menu->addAction(tr("Take &known values as wanted"));
    m_leaveAll = menu->addAction(tr("&Leave all unchanged"));
    menu->addSeparator();
    m_setPosition = menu->addAction(tr("&Set the position…"));
    foundBy(m_setPosition, tr("preset, zero, zero point"));
    menu->addActions(m_functions->actions());
    menu->addSeparator();
    m_copyAs = new CopyMenu(m_table);
    m_table->addAction(m_copyAs->plcWords()); // for its key
    menu->addActions({m_copyAs->plcWords(), m_copyAs->menuAction()});
    menu->setToolTipsVisible(true);
    m_more->setMenu(menu);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
}

void ParameterPanel::connectParts()
{
    connect(m_read, &QPushButton::clicked, this, &ParameterPanel::read);
    connect(m_write, &QPushButton::clicked, this, &ParameterPanel::review);
    connect(m_wizard, &QPushButton::clicked, this, &ParameterPanel::wizardRequested);
    connect(m_takeKnown, &QAction::triggered, this, &ParameterPanel::takeKnownAsWanted);
    connect(m_leaveAll, &QAction::triggered, this, [this] { m_wanted.clear(m_encoder.place()); });
    connect(m_tellValue, &QAction::triggered, this, &ParameterPanel::askWhatItHas);
    connect(m_table, &QWidget::customContextMenuRequested, this, &ParameterPanel::showMenu);
    connect(m_copyAs, &CopyMenu::chosen, this, &ParameterPanel::copyWords);
    connect(m_table, &ParameterTable::inputChecked, this, &ParameterPanel::showWrongInput);
    connect(m_functions, &EncoderFunctions::refused, this, &ParameterPanel::showRefusal);
    connect(m_message, &InlineMessage::actionTriggered, this, &ParameterPanel::bringBack);
    connect(m_setPosition, &QAction::triggered, this, &ParameterPanel::askWherePositionIs);
    onEventOf(m_before, {QEvent::ShowToParent, QEvent::HideToParent}, this, [this] { giveWayToQuestion(); });
    connect(m_job, &JobStrip::asks, this, [this](bool isAsking) {
        m_values->setVisible(!isAsking);
        m_note->setVisible(!isAsking && !m_note->text().isEmpty());
    });
    for (JobReview *review : {static_cast<JobReview *>(m_review), static_cast<JobReview *>(m_presetReview)}) {
        connect(review, &JobReview::cancelled, this, [this] {
            m_pages->setCurrentWidget(m_tablePage);
            m_write->setFocus();
        });
        connect(review, &JobReview::confirmed, this, [this](const Job &job) {
            m_pages->setCurrentWidget(m_tablePage);
            start(job);
        });
    }
    connect(&m_wanted, &WantedValues::changed, this, [this] { withdraw(Cause::refusal); });
    for (const auto show : {&ParameterPanel::showDifferences, &ParameterPanel::showValueNotes}) {
        connect(m_model, &QAbstractItemModel::modelReset, this, show);
        connect(m_model, &QAbstractItemModel::dataChanged, this, show);
    }
}

// In a low panel, all else that is said gives way to the question whether it is the same encoder.
void ParameterPanel::giveWayToQuestion()
{
    const bool isAsked = !m_before->isHidden();
    const int question = questionLines * fontMetrics().lineSpacing();
    const int table = std::max(tableLines * fontMetrics().lineSpacing(), m_table->minimumSizeHint().height());
    const int beside = m_whose->sizeHint().height() + m_buttons->sizeHint().height() + table + question;
    m_table->setVisible(!isAsked || height() >= beside);
    m_note->setVisible(!isAsked && !m_note->text().isEmpty());
    m_saidArea->setMinimumHeight(isAsked ? question : 0);
}

void ParameterPanel::setEncoder(const ShownEncoder &encoder)
{
    if (session() != nullptr)
        session()->disconnect(this);
    const auto typed = m_table->typed();
    const QString before = m_encoder.isThere() ? m_encoder.place().shown() : QString();
    m_encoder = encoder;
    m_message->withdraw();
    m_bar->hide();
    m_model->setEncoder(encoder);
    m_before->setEncoder(session());
    m_job->setEncoder(session());
    m_functions->setEncoder(session());
    const bool hasParameters = encoder.isThere() && !encoder.device().parameters.empty();
    m_pages->setCurrentWidget(hasParameters ? m_tablePage : m_empty);
    showWhose();
    if (session() != nullptr)
        connectSession(*session());
    if (!hasParameters) {
        showWhyEmpty();
        return;
    }
    m_table->setCurrentIndex(m_model->index(0, ParameterModel::wantedColumn));
    showWhatIsPossible();
    showRunningJob();
    if (typed)
        m_message->showMessage(Role::attention,
                               tr("What was being typed for encoder %1 was not taken: %2 %3.")
                                   .arg(before, parameterName(typed->parameter), typed->text));
}

QAction &ParameterPanel::isInPositionMode() const
{
    return m_functions->isInPositionMode();
}

QList<QAction *> ParameterPanel::functionActions() const
{
    return m_functions->actions();
}

void ParameterPanel::showWhose()
{
    const bool hasParameters = m_encoder.isThere() && !m_encoder.device().parameters.empty();
    m_whose->setVisible(hasParameters); // otherwise the sentence on the page names it
    if (!hasParameters)
        return;
    m_whose->setText(QStringLiteral("%1  %2").arg(m_encoder.place().shown(), m_encoder.device().fullName()));
    m_whose->setToolTip(m_whose->text());
}

void ParameterPanel::showWhyEmpty()
{
    if (!m_encoder.isThere()) {
        m_empty->setTexts(tr("No encoder is chosen"),
                          tr("Choose an encoder in the bus structure. Its parameters are shown here: what "
                             "it has, and what you want it to have."));
        return;
    }
    const DeviceDescription &device = m_encoder.device();
    const QString what = tr("%1 has no parameters here").arg(m_encoder.place().shown());
    m_empty->setTexts(
        what, device.outWords == 0
                  ? tr("The %1 has no OUT word. It only sends its position: nothing can be read from it or "
                       "written to it.")
                        .arg(device.fullName())
                  : tr("No source says which words set up a %1, so none are sent. Its position is shown.")
                        .arg(device.fullName()));
}

void ParameterPanel::connectSession(EncoderSession &session)
{
    connect(&session, &EncoderSession::jobStarted, this, [this] {
        m_message->withdraw();
        showRunningJob();
    });
    connect(&session, &EncoderSession::finished, this, &ParameterPanel::finished);
    connect(&session, &EncoderSession::latestChanged, this, &ParameterPanel::followState);
    connect(&session, &EncoderSession::freshnessChanged, this, &ParameterPanel::followSight);
    connect(&session, &EncoderSession::knownBeforeChanged, this, [this, &session] {
        if (session.knownBefore()) // whoever is there now need not be the one that this was said of
            withdraw(Cause::outcome);
    });
    connect(&session, &EncoderSession::wordAboutToBeSent, this, [this] { withdraw(Cause::outcome); });
    connect(&session, &EncoderSession::eepromCountChanged, this, &ParameterPanel::followCount);
    connect(&session, &EncoderSession::permissionChanged, this, [this] { withdraw(Cause::refusal); });
    connect(&session, &QObject::destroyed, this, [this] { setEncoder({}); });
}

// Commands that send, or enter what the encoder has, need a connected one; the tooltips and a note say so.
void ParameterPanel::showWhatIsPossible()
{
    const Capabilities &can = m_encoder.can();
    const bool isRecorded = session() != nullptr && session()->freshness().isOfRecording();
    const bool isConnected = session() != nullptr && !isRecorded;
    const QString offline =
        isRecorded ? tr("This is a recording: nothing is read or written.")
                   : tr("Not connected: nothing can be read or written. What is wanted is kept in the "
                        "project.");
    const QString note =
        !isConnected ? offline
        : !can.reads
            ? tr("The %1 has no read-out. Only what was written from here, or set manually, is known.")
                  .arg(m_encoder.device().fullName())
        : can.readingHidesPosition ? tr("Reading hides the position for some cycles.")
                                   : QString();
    m_note->setText(note);
    giveWayToQuestion();
    m_read->setAccessibleDescription(note);
    m_write->setVisible(can.writes);
    m_setPosition->setVisible(can.presetNeedsValue);
    m_copyAs->setOffered(m_encoder.device().hasWords()); // a serial line takes requests
    m_read->setEnabled(isConnected && can.reads);
    m_read->setToolTip(note);
    const auto allow = [&](auto *control, const QString &what) {
        control->setEnabled(isConnected);
        control->setToolTip(isConnected ? what : offline);
    };
    allow(m_write, tr("Shows what will be written before anything is sent"));
    allow(m_wizard, tr("Sets the encoder up step by step"));
    allow(m_tellValue, tr("From its papers or its label; nothing is sent"));
    allow(m_takeKnown, tr("What the encoder is known to have is wanted from now on"));
    allow(m_setPosition, tr("The place where it stands becomes the position you type"));
}

void ParameterPanel::showDifferences()
{
    const int count = m_model->differing();
    m_differences->setVisible(count > 0);
    m_differences->setState(Role::attention,
                            count == 1 ? tr("1 value differs") : tr("%1 values differ").arg(count));
}

// Side effects of the wanted values: shown as soon as they are wanted, for a planned encoder too.
void ParameterPanel::showValueNotes()
{
    ParameterValues written;
    ParameterValues known;
    for (const ParameterRow &row : m_model->rows()) {
        if (row.known)
            known.push_back({row.parameter.parameter, row.known->value});
        if (row.wanted && (!row.known || row.differs()))
            written.push_back({row.parameter.parameter, *row.wanted});
    }
    QStringList sentences;
    if (!written.empty())
        for (const ValueNote &note : valueNotes(m_encoder.device(), written, known))
            sentences << noteText(note);
    for (const ParameterValue &value : written)
        sentences << m_model->whyTaken(value);
    sentences.removeAll(QString());
    m_valueNotes->setText(sentences.join(u'\n'));
    m_valueNotes->setVisible(!sentences.isEmpty());
}

void ParameterPanel::read()
{
    if (!m_table->finishEditing())
        return;
    ReadParameters job{m_encoder.device().readableValues()};
    if (m_model->showsRegisters())
        for (const ParameterRow &row : m_model->rows())
            if (!row.isHead() && row.parameter.isDetail)
                job.parameters.push_back(row.parameter.parameter);
    start(job);
}

void ParameterPanel::review()
{
    if (!session() || !m_table->finishEditing())
        return;
    const ParameterValues wanted = m_wanted.values(m_encoder.place());
    if (wanted.empty()) {
        showMessage(Cause::refusal, Role::attention,
                    tr("No value is wanted. Enter what you want in the column \"Wanted\" first."));
        m_table->setFocus();
        return;
    }
    m_message->withdraw();
    m_review->review(*session(), wanted);
    m_pages->setCurrentWidget(m_review);
}

void ParameterPanel::start(const Job &job)
{
    if (!session())
        return;
    m_message->withdraw();
    const auto taken = session()->start(job);
    if (!taken)
        showMessage(Cause::refusal, Role::attention, refusalText(taken.error()));
}

// Where the service ends, nothing becomes valid.
void ParameterPanel::bringBack()
{
    if (session() &&
        (session()->latest().state == EncoderState::service || askToSendRun(window(), *session())))
        start(EndParameterization{});
}

void ParameterPanel::showRefusal(const Refusal &why)
{
    showMessage(Cause::refusal, Role::attention, refusalText(why));
    Q_EMIT refusalShown();
}

void ParameterPanel::takeKnownAsWanted()
{
    ParameterValues values = m_wanted.values(m_encoder.place());
    for (const ParameterRow &row : m_model->rows())
        if (row.known && !row.isReadOnly())
            replaceValue(values, {row.parameter.parameter, row.known->value});
    m_wanted.replace(m_encoder.place(), std::move(values),
                     tr("Known values wanted for %1").arg(m_encoder.place().shown()));
}

void ParameterPanel::showParameter(Parameter parameter)
{
    const ParameterDescription *its = m_encoder.device().find(parameter);
    if (its != nullptr && its->isDetail && !m_model->showsRegisters())
        m_model->toggleRegisters();
    const int row = m_model->rowOf(parameter);
    if (row < 0)
        return;
    m_pages->setCurrentWidget(m_tablePage);
    m_table->setFocus();
    m_table->setCurrentIndex(m_model->index(row, ParameterModel::wantedColumn));
    m_table->scrollTo(m_table->currentIndex());
}

Parameter ParameterPanel::currentParameter() const
{
    return m_model->rowAt(std::max(m_table->currentIndex().row(), 0)).parameter.parameter;
}

void ParameterPanel::askWhatItHas()
{
    if (const int row = m_table->currentIndex().row(); row >= 0 && m_model->rowAt(row).isHead())
        return;
    const Parameter parameter = currentParameter();
    const auto known = m_encoder.known(parameter);
    m_bar->ask({.parameter = *m_encoder.device().find(parameter),
                .label = tr("%1: the encoder has", "parameter name").arg(parameterName(parameter)),
                .ifEmpty = tr("unknown"),
                .button = tr("&Set manually"),
                .toolTip = tr("Sets the value manually; nothing is sent. An empty field clears it."),
                .mayBeEmpty = true,
                .answered =
                    [this, parameter](const std::optional<Value> &value) {
                        if (session())
                            session()->tell(parameter, value);
                        m_table->setFocus();
                    }},
               known ? std::optional(known->value) : std::nullopt);
}

// For encoders whose command carries the value with it.
void ParameterPanel::askWherePositionIs()
{
    if (!session() || m_functions->isRefusedInWatch())
        return;
    m_bar->ask({.parameter = positionToSet(*session()),
                .label = tr("The position here is to be"),
                .ifEmpty = tr("position"),
                .button = tr("&Set…"),
                .toolTip = positionToSetText(*session()),
                .answered =
                    [this](const std::optional<Value> &value) {
                        if (!session() || !value)
                            return;
                        m_presetReview->review(*session(), value->number());
                        m_pages->setCurrentWidget(m_presetReview);
                    }},
               std::nullopt);
}

void ParameterPanel::showMenu(const QPoint &position)
{
    const QModelIndex at = m_table->indexAt(position);
    if (at.isValid() && !m_table->selectionModel()->isRowSelected(at.row()))
        m_table->setCurrentIndex(at);
    m_more->menu()->popup(m_table->viewport()->mapToGlobal(position));
}

// What a PLC sends so that the encoder takes the values of the selected rows: what is wanted, else what it
// has.
Result<std::vector<Word>> ParameterPanel::chosenWords() const
{
    ParameterValues values;
    std::vector<Known> known;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const ParameterRow &of = m_model->rowAt(row);
        if (of.isHead())
            continue;
        if (of.known)
            known.push_back(*of.known);
        const auto value = of.wanted ? of.wanted : of.known ? std::optional(of.known->value) : std::nullopt;
        if (value && !of.isReadOnly() && m_table->selectionModel()->isRowSelected(row))
            values.push_back({of.parameter.parameter, *value});
    }
    return plcWords(m_encoder.device(), values, known);
}

void ParameterPanel::copyWords(WordNotation notation)
{
    const auto words = chosenWords();
    if (!words) {
        showMessage(Cause::refusal, Role::attention, refusalText(words.error()));
        return;
    }
    if (words->empty()) {
        showMessage(Cause::refusal, Role::attention,
                    tr("There are no words to copy. Select parameters that can be written, and of which a "
                       "value is wanted or known."));
        return;
    }
    withdraw(Cause::refusal);
    QString lines;
    for (const Word word : *words)
        lines += copiedText(word, 32, notation) + u'\n';
    QApplication::clipboard()->setText(lines);
}

void ParameterPanel::showRunningJob()
{
    const bool isRunning = session() && session()->runningJob();
    if (isRunning)
        m_job->begin();
    m_job->setVisible(isRunning);
    m_buttons->setVisible(!isRunning);
}

void ParameterPanel::finished(const Outcome &outcome)
{
    showRunningJob();
    m_end.reset();
    if (outcome.resetWaits) // without the way back: run would carry out the reset
        showMessage(Cause::outcome, Role::attention, messageText({.id = MessageId::resetWaitsForRun}));
    else
        showEnd(outcome);
}

void ParameterPanel::showEnd(const Outcome &outcome)
{
    m_end = outcome;
    m_endedAt = session()->latest().at;
    tellEnd();
}

void ParameterPanel::tellEnd()
{
    const QString why = outOfSightReason(*session());
    Outcome outcome = *m_end;
    const bool isLost = !why.isEmpty() && isStateSeen(outcome.leftIn);
    if (isLost)
        outcome.leftIn = EncoderState::unknown;
    const JobEnd end = endOf(*session(), outcome, doneBefore(outcome.job), m_functions->isReset(outcome.job));
    if (isLost)
        showMessage(Cause::outcome, Role::attention,
                    tr("%1 Done before that: %2", "a sentence, sentences").arg(why, end.text));
    else
        showMessage(Cause::outcome, end.role, end.text, end.wayBack);
}

DoneJobs ParameterPanel::doneBefore(JobId job) const
{
    const bool follows = m_following.encoder == session() && m_following.job == job;
    return follows ? m_following.before : DoneJobs();
}

// It was written to by hand since: the end of the last job no longer says what it has.
void ParameterPanel::followCount()
{
    if (m_end && !session()->runningJob() && isSeenSince(*session(), m_endedAt))
        withdraw(Cause::outcome);
}

bool ParameterPanel::tellsEnd() const
{
    return m_end && m_cause == Cause::outcome && !m_message->isHidden() && !session()->runningJob();
}

// In which state it was left holds only as long as it is seen.
void ParameterPanel::followSight()
{
    if (tellsEnd())
        tellEnd();
}

// Somebody, or a loss of power, has brought an encoder back that was left in another state.
void ParameterPanel::followState()
{
    if (!tellsEnd() || !isSeenSince(*session(), m_endedAt))
        return;
    const bool isBack =
        m_end->leftIn != EncoderState::operation && session()->latest().state == EncoderState::operation;
    const bool hasModeBack = m_end->leftInMode && session()->latest().mode == Mode::position;
    if (!isBack && !hasModeBack)
        return;
    if (isBack)
        m_end->leftIn = EncoderState::operation;
    if (hasModeBack)
        m_end->leftInMode.reset();
    showEnd(*m_end);
}

void ParameterPanel::showWrongInput(const QString &wrong)
{
    if (!wrong.isEmpty())
        showMessage(Cause::input, Role::fault, wrong);
    else
        withdraw(Cause::input);
}

void ParameterPanel::showMessage(Cause cause, Role role, const QString &sentence, const QString &action)
{
    m_cause = cause;
    if (cause != Cause::outcome)
        m_end.reset();
    m_message->showMessage(role, sentence, action);
}

void ParameterPanel::withdraw(Cause cause)
{
    if (m_cause == cause)
        m_message->withdraw();
}

} // namespace codewheel
