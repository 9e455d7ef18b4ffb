// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_editor.h"

#include "bus/buses.h"
#include "cams/check_cams.h"
#include "catalog/device_description.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/refusal_text.h"
#include "widgets/cams/cam_board.h"
#include "widgets/cams/cam_mode_bar.h"
#include "widgets/cams/cam_range.h"
#include "widgets/cams/cam_range_bar.h"
#include "widgets/cams/cam_review.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/functions/function_questions.h"
#include "widgets/job/job_strip.h"
#include "widgets/job/known_text.h"
#include "widgets/job/outcome_text.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/models/age_text.h"
#include "widgets/models/age_timer.h"

#include <QScrollArea>
#include <QStackedWidget>

#include <numeric>

namespace codewheel {
namespace {

QString howCamsAreKnown(const EncoderSession &encoder, const KnownCams &cams)
{
    const Known known{.evidence = cams.evidence, .at = cams.at};
    return howKnown(known, encoder);
}

} // namespace

CamEditor::Work &CamEditor::workOf(Place number)
{
    auto &work = m_works[number];
    if (!work)
        work = std::make_unique<Work>(m_project, number);
    return *work;
}

void CamEditor::setEncoder(const ShownEncoder &encoder)
{
    if (session() != nullptr)
        session()->disconnect(this);
    const bool hasCams = encoder.isThere() && encoder.can().cams;
    m_encoder = hasCams ? encoder : ShownEncoder();
    Q_EMIT headChanged();
    m_message->withdraw();
    m_mode->hide();
    m_range->hide();
    m_job->setEncoder(session());
    showRunningJob();
    for (QAction *action : m_fileActions)
        action->setEnabled(hasCams);
    if (!hasCams) {
        m_empty->setTexts(
            encoder.isThere()
                ? refusalText(
                      {RefusalKind::notSupported, RefusalId::camsNotSupported, {encoder.device().fullName()}})
                : tr("No encoder is chosen"),
            tr("Choose an encoder with cams, such as the FRABA OCD-IB K3, in the bus structure. Its "
               "eight programs of eight cams are edited here."));
        m_pages->setCurrentWidget(m_empty);
        return;
    }
    Work &work = workOf(encoder.place());
    m_sheet->setDocument(work.document, *encoder.can().cams);
    for (QAction *action : m_modeActions)
        action->setVisible(m_sheet->abilities().hasMode);
    m_sheet->setNumber(work.program);
    m_range->begin(work.toldLargest);
    m_pages->setCurrentWidget(m_scroll);
    if (session() != nullptr)
        connectSession(*session());
    showKnown();
    showLive();
}

QString CamEditor::about() const
{
    return m_encoder.isThere() ? calledInFull(m_encoder.place(), m_project.device(m_encoder.place()).station,
                                              m_encoder.device())
                               : QString();
}

QString CamEditor::effect() const
{
    return session() != nullptr ? tr("Edits cam programs of the project; only Read, Write and Compare send.")
                                : tr("Edits cam programs of the project. Nothing is sent here.");
}

std::optional<PrintedView> CamEditor::printedView() const
{
    if (m_pages->currentWidget() != m_scroll)
        return {};
    PrintedView printed{
        .title = title(), .place = m_encoder.place(), .device = m_encoder.device().fullName()};
    m_board->addTo(printed);
    return printed;
}

void CamEditor::connectSession(EncoderSession &session)
{
    connect(&session, &EncoderSession::latestChanged, this, &CamEditor::showLive);
    connect(&session, &EncoderSession::freshnessChanged, this, &CamEditor::showLive);
    connect(&session, &EncoderSession::knownChanged, this, &CamEditor::showKnown);
    connect(&session, &EncoderSession::jobStarted, this, [this] {
        m_message->withdraw();
        showRunningJob();
    });
    connect(&session, &EncoderSession::finished, this, &CamEditor::showRunningJob);
    connect(&session, &EncoderSession::permissionChanged, this, [this] { withdraw(Cause::refusal); });
    connect(&session, &QObject::destroyed, this, [this] { setEncoder({}); });
}

void CamEditor::chooseProgram(unsigned number)
{
    if (const auto checked = checkCamProgramNumber(number, m_sheet->abilities()); !checked) {
        say(Cause::input, Role::fault, refusalText(checked.error()));
        return;
    }
    if (!m_board->finishEditing())
        return;
    withdraw(Cause::input);
    if (m_encoder.isThere())
        workOf(m_encoder.place()).program = number;
    m_sheet->setNumber(number);
    showLive();
}

void CamEditor::showKnown()
{
    CamSheet::KnownPrograms known;
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        if (const auto there = session() ? session()->cams(number) : std::nullopt)
            known.at(number - 1) = {there->program, howCamsAreKnown(*session(), *there)};
    m_sheet->setKnown(known);
    showRange();
}

void CamEditor::showRange()
{
    const Place number = m_encoder.place();
    const auto largest = largestPosition(m_encoder, m_project.device(number));
    const auto told = workOf(number).toldLargest;
    m_sheet->setLargest(largest ? largest : told);
    if (largest)
        m_range->hide();
    else
        m_range->ask(session() && m_encoder.can().reads, told);
}

void CamEditor::tellLargest(std::int64_t largest)
{
    const auto position = session() ? session()->latest().position : std::nullopt;
    if (position && *position > largest) {
        say(Cause::input, Role::fault,
            tr("The largest position cannot be %1: the encoder shows %2.")
                .arg(cam_texts::position(largest), cam_texts::position(*position)));
        return;
    }
    workOf(m_encoder.place()).toldLargest = largest;
    showRange();
    showLive();
}

void CamEditor::showLive()
{
    if (!m_encoder.isThere() || !isVisible() || m_pages->currentWidget() == m_empty)
        return;
    if (session())
        m_age->follow(*session());
    m_sheet->setLive(session() ? camLive(*session(), m_sheet->program(), m_sheet->largest()) : CamLive());
    m_board->setNote(session() ? note(session()->latest())
                               : tr("Not connected: what the encoder has and shows is not known. The cams "
                                    "are kept in the project."));
}

QString CamEditor::note(const Reading &reading) const
{
    const CamLive &live = m_sheet->live();
    if (live.isOld)
        return tr("Not up to date: %1", "a sentence").arg(ageSentence(*session()));
    if (reading.cams && live.isTold)
        return tr("Program %1 runs in the encoder. \"Now\" is what it shows.").arg(m_sheet->number());
    QString would = live.knowsAny()
                        ? tr("\"Now\" is what the cams of program %1 would be.").arg(m_sheet->number())
                        : tr("What its cams would be is not known.");
    if (!m_sheet->abilities().hasMode)
        return would;
    if (reading.cams && reading.camProgram)
        return tr("Program %1 runs in the encoder.").arg(*reading.camProgram) + QLatin1Char(' ') + would;
    if (reading.cams)
        return tr("The encoder is in cam mode; which program runs is not known.");
    if (reading.state != EncoderState::operation && reading.state != EncoderState::notSeen)
        return tr("The encoder shows no cams now.");
    if (!reading.mode)
        return tr("The mode of the encoder is not known, and so are its cams.");
    if (*reading.mode == Mode::velocity)
        return tr("The encoder is in velocity mode and shows no cams.");
    return tr("The encoder is in position mode.") + QLatin1Char(' ') + would;
}

void CamEditor::showRunningJob()
{
    const bool isRunning = session() && session()->runningJob();
    if (isRunning)
        m_job->begin();
    m_job->setVisible(isRunning);
    const bool isPlanned = m_encoder.isThere() && !session();
    for (QAction *action : m_jobActions) {
        action->setEnabled(session() && !isRunning);
        action->setToolTip(isPlanned ? tr("Not connected: nothing can be read or written.")
                                     : action->statusTip());
    }
}

void CamEditor::withModeAfterwards(std::function<void(const SwitchMode &)> then)
{
    if (!session() || !m_board->finishEditing())
        return;
    m_message->withdraw();
    const auto now = m_sheet->abilities().hasMode ? modeNow(*session()) : SwitchMode();
    if (now) {
        then(*now);
        return;
    }
    if (isRefusedInWatch())
        return;
    m_whenAnswered = std::move(then);
    m_mode->ask(m_sheet->number());
}

void CamEditor::readPrograms(CamJobs::Purpose purpose, const std::vector<unsigned> &programs)
{
    withModeAfterwards([this, purpose, programs](const SwitchMode &afterwards) {
        start(purpose, ReadCams{.programs = programs, .afterwards = afterwards});
    });
}

void CamEditor::readAll()
{
    std::vector<unsigned> all(m_sheet->abilities().programs);
    std::iota(all.begin(), all.end(), 1U);
    readPrograms(CamJobs::Purpose::read, all);
}

void CamEditor::write()
{
    if (!m_board->finishEditing())
        return;
    reviewPrograms({m_sheet->program()});
}

// The programs set here that the encoder is not known to have.
void CamEditor::writeAll()
{
    if (!m_board->finishEditing())
        return;
    std::vector<CamProgram> programs;
    for (unsigned number = 1; number <= m_sheet->abilities().programs; ++number) {
        const CamProgram &program = m_sheet->document().program(number);
        const auto differs = m_sheet->differs(number);
        if (differs.value_or(program != CamProgram{.number = number}))
            programs.push_back(program);
    }
    if (programs.empty())
        say(Cause::outcome, Role::running,
            tr("No program has to be written: none is set that the encoder does not have."));
    else
        reviewPrograms(programs);
}

void CamEditor::reviewPrograms(const std::vector<CamProgram> &programs)
{
    for (const CamProgram &program : programs)
        if (const auto checked = check(program, m_sheet->abilities(), m_sheet->largest()); !checked) {
            say(Cause::input, Role::fault,
                tr("Program %1: %2").arg(program.number).arg(refusalText(checked.error())));
            return;
        }
    withModeAfterwards([this, programs](const SwitchMode &afterwards) {
        m_review->review(*session(), programs, afterwards);
        m_pages->setCurrentWidget(m_review);
    });
}

void CamEditor::readRange()
{
    ReadParameters job;
    for (const Parameter parameter : {Parameter::steps, Parameter::revolutions, Parameter::measuringRange})
        if (const auto *described = m_encoder.device().find(parameter); described && described->canBeRead)
            job.parameters.push_back(parameter);
    start(CamJobs::Purpose::findRange, job);
}

void CamEditor::bringBack()
{
    if (m_cause == Cause::outcome && session() && askToSendRun(window(), *session()))
        start(CamJobs::Purpose::switchMode, EndParameterization{});
}

bool CamEditor::isRefusedInWatch()
{
    const Place place = m_encoder.place();
    const EncoderBus *bus = m_buses.busOf(place);
    if (bus == nullptr || bus->isOperating())
        return false;
    say(Cause::refusal, Role::attention,
        refusalText({RefusalKind::busy, RefusalId::watchOnly, {place.shown()}}));
    return true;
}

void CamEditor::start(CamJobs::Purpose purpose, const Job &job)
{
    const bool wasAsked = purpose == CamJobs::Purpose::write; // in the review
    if (session() && mostEepromWrites(*session(), job) > 0 && isRefusedInWatch())
        return;
    if (!session() || (!wasAsked && !askForEeprom(window(), *session(), job)) || !session())
        return;
    m_message->withdraw();
    if (const auto taken = m_jobs->start(*session(), purpose, job); !taken)
        say(Cause::refusal, Role::attention, refusalText(taken.error()));
}

void CamEditor::finished(Place number, CamJobs::Purpose purpose, const Outcome &outcome)
{
    CamDocument &document = workOf(number).document;
    if (outcome.result && purpose == CamJobs::Purpose::read)
        document.setPrograms(outcome.camsRead, tr("Read from the encoder"));
    if (!session() || session()->place() != number)
        return; // reported in the messages
    const JobEnd end = endOf(*session(), outcome);
    if (!outcome.result)
        say(Cause::outcome, end.role, end.text, end.wayBack);
    else if (purpose == CamJobs::Purpose::compare)
        for (const CamProgram &there : outcome.camsRead)
            sayWhatDiffers(document.program(there.number), there);
    else if (purpose == CamJobs::Purpose::write && outcome.camsWritten.empty())
        say(Cause::outcome, Role::running,
            tr("The encoder has all of it already. Nothing was written.") + u' ' + end.text);
    else if (purpose == CamJobs::Purpose::read || purpose == CamJobs::Purpose::write)
        say(Cause::outcome, end.role, end.text);
}

void CamEditor::sayWhatDiffers(const CamProgram &wanted, const CamProgram &there)
{
    QStringList parts;
    for (std::size_t cam = 0; cam < CamProgram::cams; ++cam)
        if (wanted.cam.at(cam) != there.cam.at(cam))
            parts << tr("cam %1").arg(cam);
    if (wanted.shift != there.shift)
        parts << tr("the shift (the encoder has %1)").arg(there.shift);
    if (parts.isEmpty())
        say(Cause::outcome, Role::running, tr("The encoder has the same program %1.").arg(there.number));
    else
        say(Cause::outcome, Role::attention,
            tr("Program %1 differs in: %2.").arg(wanted.number).arg(parts.join(QStringLiteral(", "))) + u' ' +
                tr("The lines in the ruler show what the encoder has. Nothing was changed."));
}

void CamEditor::say(Cause cause, Role role, const QString &sentence, const QString &action)
{
    m_cause = cause;
    m_message->showMessage(role, sentence, action);
}

void CamEditor::withdraw(Cause cause)
{
    if (m_cause == cause)
        m_message->withdraw();
}

} // namespace codewheel
