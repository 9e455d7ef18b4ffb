// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_panel.h"

#include "encoder/refusal_text.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/functions/encoder_functions.h"
#include "widgets/functions/function_questions.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fonts.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"
#include "widgets/models/device_traits.h"
#include "widgets/parameters/job_strip.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/value_bar.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/parameters/write_review.h"
#include "widgets/wizard/known_text.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {

ParameterPanel::ParameterPanel(WantedValues &wanted, QWidget *parent)
    : QWidget(parent)
    , m_wanted(wanted)
    , m_model(new ParameterModel(wanted, this))
    , m_functions(new EncoderFunctions(this))
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::parameters, {}, {}, this))
    , m_review(new WriteReview(this))
{
    m_tablePage = makeTablePage();
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_tablePage);
    m_pages->addWidget(m_review);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_pages);
    connectParts();
    setEncoder(nullptr);
}

QWidget *ParameterPanel::makeTablePage()
{
    auto *page = new QWidget(this);
    m_table = new ParameterTable(*m_model, page);
    m_differences = new RoleLabel(page);
    m_message = new InlineMessage(page);
    m_bar = new ValueBar(page);
    m_buttons = makeButtons();
    m_job = new JobStrip(page);
    m_readingNote = new QLabel(page);
    m_readingNote->setFont(textFont(TextSize::small));
    m_readingNote->setWordWrap(true);

    auto *layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_message);
    layout->addWidget(m_bar);
    layout->addWidget(m_differences);
    layout->addWidget(m_buttons);
    layout->addWidget(m_job);
    layout->addWidget(m_readingNote);
    return page;
}

QWidget *ParameterPanel::makeButtons()
{
    auto *buttons = new QWidget(this);
    m_read = new QPushButton(lineIcon(Icon::read), tr("&Read from encoder"), buttons);
    m_write = new QPushButton(lineIcon(Icon::write), tr("&Write..."), buttons);
    m_wizard = new QPushButton(lineIcon(Icon::wizard), tr("Wi&zard..."), buttons);
    m_more = new QToolButton(buttons);
    m_write->setToolTip(tr("Shows what will be written before anything is sent"));
    m_wizard->setToolTip(tr("Sets the encoder up step by step"));
    m_more->setText(tr("&More"));
    m_more->setToolTip(tr("Take over, clear or tell values; modes, preset and reset"));
    m_more->setAccessibleName(tr("More for the parameters"));
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
    auto *menu = new QMenu(m_more);
    m_tellValue = menu->addAction(tr("&Tell what the encoder has..."));
    menu->addSeparator();
    m_takeKnown = menu->addAction(tr("Take &known values as wanted"));
    m_leaveAll = menu->addAction(tr("&Leave all as they are"));
    menu->addSeparator();
    m_setPosition = menu->addAction(tr("&Set the position..."));
    menu->addActions(m_functions->actions());
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
    connect(m_leaveAll, &QAction::triggered, this, &ParameterPanel::leaveAllAsTheyAre);
    connect(m_tellValue, &QAction::triggered, this, &ParameterPanel::askWhatItHas);
    connect(m_table, &QWidget::customContextMenuRequested, this, &ParameterPanel::showMenu);
    connect(m_table, &ParameterTable::inputChecked, this, &ParameterPanel::showWrongInput);
    connect(m_functions, &EncoderFunctions::refused, this, &ParameterPanel::showRefusal);
    connect(m_message, &InlineMessage::actionTriggered, this, &ParameterPanel::bringBack);
    connect(m_setPosition, &QAction::triggered, this, &ParameterPanel::askWherePositionIs);
    connect(m_review, &WriteReview::cancelled, this, [this] {
        m_pages->setCurrentWidget(m_tablePage);
        m_write->setFocus();
    });
    connect(m_review, &WriteReview::confirmed, this, [this](const WriteParameters &job) {
        m_pages->setCurrentWidget(m_tablePage);
        start(job);
    });
    connect(&m_wanted, &WantedValues::changed, this, [this] { withdraw(Cause::refusal); });
    connect(m_model, &QAbstractItemModel::modelReset, this, &ParameterPanel::showDifferences);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &ParameterPanel::showDifferences);
}

void ParameterPanel::setEncoder(EncoderSession *encoder)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    m_message->withdraw();
    m_bar->hide();
    m_model->setEncoder(encoder);
    m_job->setEncoder(encoder);
    m_functions->setEncoder(encoder);
    const bool hasParameters = encoder != nullptr && !encoder->device().parameters.empty();
    m_pages->setCurrentWidget(hasParameters ? m_tablePage : m_empty);
    if (encoder != nullptr)
        connectEncoder();
    if (!hasParameters) {
        showWhyEmpty();
        return;
    }
    m_table->setCurrentIndex(m_model->index(0, ParameterModel::wantedColumn));
    showReadingNote();
    showRunningJob();
}

QList<QAction *> ParameterPanel::functionActions() const
{
    return m_functions->actions();
}

void ParameterPanel::showWhyEmpty()
{
    if (!m_encoder) {
        m_empty->setTexts(tr("No encoder is chosen"),
                          tr("Choose an encoder in the bus structure. Its parameters are shown here: what "
                             "it has, and what you want it to have."));
        return;
    }
    const DeviceDescription &device = m_encoder->device();
    const QString what = tr("%1 has no parameters here").arg(m_encoder->number().toString());
    m_empty->setTexts(what, device.outWords == 0
                                ? tr("The %1 has no OUT word. It only tells its position: nothing can be "
                                     "read from it or written to it.")
                                      .arg(device.fullName())
                                : tr("What words set up a %1 is in no source, so none are sent. Its position "
                                     "is shown.")
                                      .arg(device.fullName()));
}

void ParameterPanel::connectEncoder()
{
    connect(m_encoder, &EncoderSession::jobStarted, this, &ParameterPanel::jobStarted);
    connect(m_encoder, &EncoderSession::finished, this, &ParameterPanel::finished);
    connect(m_encoder, &EncoderSession::permissionChanged, this, [this] { withdraw(Cause::refusal); });
    connect(m_encoder, &QObject::destroyed, this, [this] { setEncoder(nullptr); });
}

void ParameterPanel::showReadingNote()
{
    const Capabilities &can = m_encoder->can();
    m_read->setEnabled(can.reads);
    const QString note = !can.reads
                             ? tr("The %1 has no read-out. Known is what was written from here or told.")
                                   .arg(m_encoder->device().fullName())
                         : can.readingHidesPosition ? tr("Reading takes the position away for some cycles.")
                                                    : QString();
    m_readingNote->setText(note);
    m_readingNote->setVisible(!note.isEmpty());
    m_read->setToolTip(note);
    m_read->setAccessibleDescription(note);
    m_write->setVisible(can.writes);
    m_setPosition->setVisible(can.presetNeedsValue);
}

void ParameterPanel::showDifferences()
{
    const int count = m_model->differing();
    m_differences->setVisible(count > 0);
    m_differences->setState(Role::attention,
                            count == 1 ? tr("1 value differs") : tr("%1 values differ").arg(count));
}

void ParameterPanel::read()
{
    if (!m_table->finishEditing())
        return;
    ReadParameters job{m_encoder->device().readableValues()};
    if (m_model->showsRegisters())
        for (const ParameterRow &row : m_model->rows())
            if (!row.isHead() && isOpcRegister(row.parameter.parameter))
                job.parameters.push_back(row.parameter.parameter);
    start(job);
}

void ParameterPanel::review()
{
    if (!m_table->finishEditing())
        return;
    const ParameterValues wanted = m_wanted.values(m_encoder->number());
    if (wanted.empty()) {
        showMessage(Cause::refusal, Role::attention,
                    tr("No value is wanted. Enter what you want in the column \"Wanted\" first."));
        m_table->setFocus();
        return;
    }
    m_message->withdraw();
    m_review->review(*m_encoder, wanted);
    m_pages->setCurrentWidget(m_review);
}

void ParameterPanel::start(const Job &job)
{
    m_message->withdraw();
    const auto taken = m_encoder->start(job);
    if (!taken)
        showMessage(Cause::refusal, Role::attention, refusalText(taken.error()));
}

void ParameterPanel::showRefusal(const Refusal &why)
{
    showMessage(Cause::refusal, Role::attention, refusalText(why));
    Q_EMIT refusalShown();
}

void ParameterPanel::bringBack()
{
    if (m_encoder)
        start(EndParameterization{});
}

void ParameterPanel::takeKnownAsWanted()
{
    for (const ParameterRow &row : std::vector(m_model->rows()))
        if (row.known && !row.isReadOnly())
            m_wanted.set(m_encoder->number(), row.parameter.parameter, row.known->value);
}

void ParameterPanel::leaveAllAsTheyAre()
{
    m_wanted.clear(m_encoder->number());
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
    const auto known = m_encoder->known(parameter);
    m_bar->ask({.parameter = *m_encoder->device().find(parameter),
                .label = tr("%1: the encoder has", "parameter name").arg(parameterName(parameter)),
                .ifEmpty = tr("unknown"),
                .button = tr("&Tell"),
                .toolTip = tr("Takes the value as known by telling; nothing is sent. An empty field takes it "
                              "back."),
                .mayBeEmpty = true,
                .answered =
                    [this, parameter](std::optional<std::int64_t> value) {
                        if (m_encoder)
                            m_encoder->tell(parameter, value);
                        m_table->setFocus();
                    }},
               known ? std::optional(known->value) : std::nullopt);
}

// Where the command brings its value along: any position, stored at once.
void ParameterPanel::askWherePositionIs()
{
    ParameterDescription position;
    position.parameter = Parameter::preset;
    position.maximum = la66::dataMask;
    m_bar->ask({.parameter = position,
                .label = tr("The position here is to be"),
                .ifEmpty = tr("position"),
                .button = tr("&Set"),
                .toolTip = tr("Sends service 6 with this position; it holds at once, and costs an EEPROM "
                              "write."),
                .answered =
                    [this](std::optional<std::int64_t> value) {
                        if (m_encoder)
                            setPosition(value);
                    }},
               std::nullopt);
}

void ParameterPanel::setPosition(std::optional<std::int64_t> value)
{
    const SetPreset job{.value = value};
    if (askForEeprom(window(), *m_encoder, job))
        start(job);
}

void ParameterPanel::showMenu(const QPoint &position)
{
    if (const QModelIndex at = m_table->indexAt(position); at.isValid())
        m_table->setCurrentIndex(at);
    m_more->menu()->popup(m_table->viewport()->mapToGlobal(position));
}

void ParameterPanel::jobStarted()
{
    m_message->withdraw();
    showRunningJob();
}

void ParameterPanel::showRunningJob()
{
    const bool isRunning = m_encoder->runningJob().has_value();
    if (isRunning)
        m_job->begin();
    m_job->setVisible(isRunning);
    m_buttons->setVisible(!isRunning);
}

void ParameterPanel::finished(const Outcome &outcome)
{
    showRunningJob();
    const WayBack way = wayBack(m_encoder->device(), outcome.leftIn);
    const bool isStuck = way != WayBack::none;
    const QString help = way == WayBack::run          ? tr("Send run")
                         : way == WayBack::endService ? tr("End the service")
                                                      : QString();
    const bool resetWaits =
        m_functions->isReset(outcome.job) && outcome.leftIn == EncoderState::parameterization;
    if (resetWaits) // without the help: run would carry it out
        showMessage(Cause::outcome, Role::attention, messageText({.id = MessageId::resetWaitsForRun}));
    else if (outcome.result)
        showMessage(Cause::outcome, isStuck ? Role::attention : Role::running, successText(outcome), help);
    else
        showMessage(Cause::outcome,
                    outcome.result.error().kind == RefusalKind::device ? Role::fault : Role::attention,
                    QStringLiteral("%1 %2").arg(refusalText(outcome.result.error()), endText(outcome)), help);
}

// Short: the table shows the values, the messages keep them.
QString ParameterPanel::successText(const Outcome &outcome) const
{
    QStringList sentences;
    if (!outcome.written.empty()) {
        const auto isReadBack = [this](const ParameterValue &value) {
            const auto known = m_encoder->known(value.parameter);
            return known && known->evidence == Evidence::read;
        };
        const QString verified = std::ranges::all_of(outcome.written, isReadBack)
                                     ? tr("%1 written, active and read back.", "names of parameters")
                                     : tr("%1 written, echoed and active.", "names of parameters");
        QStringList names;
        for (const ParameterValue &value : outcome.written)
            names << parameterName(value.parameter);
        sentences << verified.arg(names.join(QStringLiteral(", ")));
    }
    if (!outcome.written.empty() || outcome.eepromWrites > 0)
        sentences << tr("EEPROM writes: %1.").arg(outcome.eepromWrites);
    if (outcome.positionAfter)
        sentences << tr("Position: %1.").arg(QLocale().toString(qlonglong{*outcome.positionAfter}));
    if (m_encoder->device().mayHaveModes() && m_encoder->latest().mode != Mode::position)
        sentences << tr("Mode: %1.").arg(modeName(m_encoder->latest().mode));
    if (!outcome.alreadyThere.empty())
        sentences << tr("There already: %1.").arg(outcome.alreadyThere.size());
    else if (outcome.written.empty() && !outcome.read.empty())
        sentences << tr("Values read: %1.").arg(outcome.read.size());
    sentences << leftInText(outcome.leftIn);
    if (outcome.onlyZeroSinceRun)
        sentences << messageText({.id = MessageId::onlyZeroSinceRun});
    return sentences.join(QLatin1Char(' '));
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
    m_message->showMessage(role, sentence, action);
}

void ParameterPanel::withdraw(Cause cause)
{
    if (m_cause == cause)
        m_message->withdraw();
}

} // namespace codewheel
