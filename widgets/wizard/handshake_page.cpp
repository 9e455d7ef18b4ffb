// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/handshake_page.h"

#include "catalog/explain_word.h"
#include "jobs/job_report.h"
#include "jobs/value_notes.h"
#include "jobs/write_plan.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/functions/function_questions.h"
#include "widgets/job/job_cancel.h"
#include "widgets/job/known_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/role_label.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/models/device_traits.h"
#include "widgets/wizard/wanted_scale.h"
#include "widgets/wizard/wizard_report.h"

#include <QCheckBox>
#include <QPushButton>

#include <algorithm>

namespace codewheel {
namespace {

// The previous values of everything taken; empty if one of them is not known.
ParameterValues valuesToRestore(const HandshakeRecord &record)
{
    ParameterValues values;
    for (const ParameterValue &taken : record.taken()) {
        auto before = record.outcome ? findValue(record.outcome->read, taken.parameter) : std::nullopt;
        if (!before)
            before = findValue(valuesOf(record.before), taken.parameter);
        if (!before)
            return {};
        values.push_back({taken.parameter, *before});
    }
    return values;
}

// Planned along with the first job, which may give the encoder another address.
std::vector<Step> stepsBehindFirst(const EncoderSession &encoder, const std::vector<Job> &jobs)
{
    auto all = encoder.planned(jobs);
    const auto first = encoder.planned({jobs.front()});
    if (!all || !first)
        return {};
    all->erase(all->begin(), all->begin() + std::min(std::ssize(*first), std::ssize(*all)));
    return *std::move(all);
}

} // namespace

HandshakePage::HandshakePage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Handshake"), parent)
    , m_view(named(new QTableView(this), "steps"))
    , m_state(new RoleLabel(this))
    , m_out(wrappedLabel(this))
    , m_in(wrappedLabel(this))
    , m_next(describe(new QPushButton(lineIcon(Icon::step), tr("Next &step"), this), "nextStep",
                      tr("Sends the next step.")))
    , m_byItself(describe(new QCheckBox(tr("Run b&y itself"), this), "runByItself",
                          tr("The remaining steps follow each other as the encoder confirms them.")))
    , m_problem(named(new InlineMessage(this), "handshakeProblem"))
    , m_leftIn(wrappedLabel(this, "leftIn"))
    , m_restore(describe(new QPushButton(tr("Rest&ore earlier values"), this), "recoverRestore",
                         tr("Writes the earlier values again.")))
    , m_run(named(new QPushButton(tr("R&un with what it has"), this), "recoverRun"))
    , m_cancel(new JobCancel(this, nullptr, [this](const EncoderSession &encoder, const Progress &progress) {
        return situation(encoder, progress);
    }))
{
    setUpQuietTable(*m_view, m_steps, tr("Steps of the handshake"));
    FittedColumns::useIn(*m_view, StepTable::what);
    m_run->hide(); // until it is known what it does
    for (QLabel *word : {m_out, m_in}) {
        word->setFont(numberFont());
        word->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }

    layOutColumn(this,
                 {{m_view, 1},
                  m_out,
                  m_in,
                  layOutRow({m_next, m_byItself, Stretch{1}, m_state}),
                  m_problem,
                  m_leftIn,
                  layOutRow({Stretch{1}, m_restore, m_run})},
                 {.spacing = grid::margin});

    setFocusProxy(m_next);
    connect(m_next, &QPushButton::clicked, this, &HandshakePage::nextStep);
    connect(m_byItself, &QCheckBox::clicked, this, &HandshakePage::setByItself);
    connect(m_problem, &InlineMessage::actionTriggered, this, &HandshakePage::start);
    connect(m_cancel, &JobCancel::leaves, this, &HandshakePage::leaveEncoder);
    connect(m_cancel, &JobCancel::goesOn, this, &HandshakePage::goOn);
    connect(m_restore, &QPushButton::clicked, this, [this] { bringBack(true); });
    connect(m_run, &QPushButton::clicked, this, [this] { bringBack(false); });
}

void HandshakePage::enter()
{
    m_byItself->setChecked(!m_setup.byHand);
    showEnd();
    showWords();
}

void HandshakePage::resume(const UnderWay &before)
{
    const DeviceDescription &device = m_setup.encoder->device();
    const Progress &progress = m_setup.record.progress;
    m_work = before.work;
    m_cancel->begin(m_setup.encoder);
    m_cancel->follow(progress);
    m_steps.goOnFrom(device, before.steps, before.current);
    tellWhatItFollows();
    showEnd();
    if (isBusy())
        showWhereItIs(progress);
    showWords();
    Q_EMIT changed();
}

void HandshakePage::start()
{
    EncoderSession &encoder = *m_setup.encoder;
    HandshakeRecord &record = m_setup.record;
    record = {};
    record.place = encoder.place().shown();
    record.device = encoder.device().fullName();
    record.serialNumber = m_setup.valueNow(Parameter::serialNumber);
    record.job = jobForWish(encoder, m_setup.wish);
    m_work.jobs = jobsForWish(encoder, m_setup.wish);
    m_work.done = {};
    record.setsPosition = m_setup.wish.initialisePreset || m_setup.wish.setPositionTo;
    record.setsByPreset = !m_setup.wish.setPositionTo && encoder.device().find(Parameter::offset) != nullptr;
    record.setPositionTo =
        m_setup.wish.setPositionTo ? m_setup.wish.setPositionTo : m_setup.valueAfter(Parameter::preset);
    record.leftOut = leftOutNote(encoder.device(), m_setup.wish);
    record.before = allKnown(encoder);
    record.positionBefore = encoder.latest().position;
    record.begun = encoder.dateTime(encoder.latest().at);
    m_work.isRecovery = m_work.isCancelled = false;
    m_cancel->begin(&encoder);
    m_steps.begin();
    m_problem->withdraw();
    m_state->setState(Role::inactive, tr("Begins"));
    m_work.job.reset();
    if (const auto started = startJob(); !started)
        m_problem->showMessage(Role::attention, refusalText(started.error()), tr("Try again"));
    showEnd();
    Q_EMIT changed();
}

// Starts the first of the remaining jobs.
Result<void> HandshakePage::startJob()
{
    std::vector<Step> toCome = stepsBehindFirst(*m_setup.encoder, m_work.jobs);
    const auto job =
        m_setup.encoder->start(m_work.jobs.front(), m_setup.byHand ? Pace::byHand : Pace::byItself);
    if (!job)
        return tl::unexpected(job.error());
    m_work.job = *job;
    m_work.jobs.erase(m_work.jobs.begin());
    m_work.toCome = std::move(toCome);
    tellWhatItFollows();
    return {};
}

void HandshakePage::tellWhatItFollows()
{
    if (m_work.job && !m_work.isRecovery && !m_work.done.areNone())
        Q_EMIT goesOn({m_setup.encoder, *m_work.job, m_work.done});
}

void HandshakePage::nextStep()
{
    m_next->setEnabled(false);
    m_setup.encoder->proceed();
}

void HandshakePage::setByItself(bool on)
{
    m_setup.byHand = !on;
    if (on && m_next->isEnabled())
        nextStep();
}

void HandshakePage::showProgress()
{
    Progress &progress = m_setup.record.progress;
    if (m_work.job != progress.job)
        return;
    if (!m_work.isRecovery)
        progress = m_work.done.followedBy(progress);
    m_steps.showSteps(m_setup.encoder->device(), stepsWithThoseToCome(progress));
    m_steps.setCurrent(progress.index, progress.waitsForUser);
    showWhereItIs(progress);
    m_cancel->follow(progress);
    noteBefore();
}

// What it reads before it writes, and where the shaft stands by then.
void HandshakePage::noteBefore()
{
    HandshakeRecord &record = m_setup.record;
    const EncoderSession &encoder = *m_setup.encoder;
    const Progress &progress = record.progress;
    if (!isBusy() || m_work.isRecovery || progress.setsPosition || !record.taken().empty())
        return;
    record.before = allKnown(encoder);
    const bool waits = m_next->isEnabled(); // otherwise what it shows may be of a later step
    if (waits && !progress.hasTaken && encoder.showsPosition())
        record.positionBefore = encoder.latest().position;
}

// A cancelled job is not followed by others.
std::vector<Step> HandshakePage::stepsWithThoseToCome(const Progress &progress) const
{
    std::vector<Step> steps = progress.steps;
    if (!m_work.isRecovery && !m_work.isCancelled)
        steps.insert(steps.end(), m_work.toCome.begin(), m_work.toCome.end());
    return steps;
}

void HandshakePage::showWhereItIs(const Progress &progress)
{
    m_view->scrollTo(m_steps.index(progress.index, 0));
    m_state->setState(Role::running, tr("Step %1 of %2").arg(progress.index + 1).arg(m_steps.rowCount()));
    const bool waits = progress.waitsForUser && m_setup.byHand;
    m_next->setEnabled(waits);
    if (waits)
        m_next->setFocus();
    else if (progress.waitsForUser)
        m_setup.encoder->proceed();
}

void HandshakePage::showRow(const Exchange &row)
{
    m_work.outNow = row.out;
    if (!m_work.job)
        return;
    m_steps.answer(row);
    showWords();
}

void HandshakePage::showLatest()
{
    showWords();
    noteBefore();
    const std::optional<Outcome> &last = m_setup.record.last();
    if (last && !isBusy() && m_setup.stateNow() != m_shownState)
        showEnd();
}

void HandshakePage::showWords()
{
    const Reading &reading = m_setup.encoder->latest();
    const DeviceDescription &device = m_setup.encoder->device();
    m_out->setVisible(device.hasWords() && isBusy()); // afterwards others decide what is there
    m_in->setVisible(device.hasWords());
    if (!device.hasWords())
        return;
    const auto meaning = [&](Word word, Word other, WordDirection direction) {
        return explanationText(device, explainWord(device, word,
                                                   {.direction = direction,
                                                    .mode = reading.mode,
                                                    .coding = reading.coding,
                                                    .counterpart = other}));
    };
    m_out->setText(
        tr("OUT %1  %2").arg(hexWord(m_work.outNow), meaning(m_work.outNow, reading.in, WordDirection::out)));
    m_in->setText(
        tr("IN  %1  %2").arg(hexWord(reading.in), meaning(reading.in, m_work.outNow, WordDirection::in)));
}

void HandshakePage::showOutcome(const Outcome &ended)
{
    if (m_work.job != ended.job)
        return;
    m_work.job.reset();
    HandshakeRecord &record = m_setup.record;
    Outcome outcome = m_work.isRecovery ? ended : m_work.done.followedBy(ended);
    if (!m_work.isRecovery && outcome.result && !m_work.jobs.empty()) {
        m_work.done.add(record.progress, ended);
        const auto started = m_work.isCancelled
                                 ? Result<void>(refuse(RefusalKind::stopped, RefusalId::cancelled))
                                 : startJob();
        if (started)
            return;
        outcome.result = tl::unexpected(started.error());
        outcome.isPositionSet = m_work.done.haveSetPosition();
    }
    (m_work.isRecovery ? record.recovery : record.outcome) = outcome;
    record.endedAt = m_setup.encoder->latest().at;
    record.after = allKnown(*m_setup.encoder);
    record.positionAfter = outcome.result || m_setup.encoder->showsPosition()
                               ? m_setup.encoder->latest().position
                               : std::nullopt;
    if (!m_setup.encoder->device().hasWords())
        record.takePositions(outcome);
    record.ended = m_setup.encoder->dateTime(m_setup.encoder->latest().at);
    record.eepromWritesInAll = m_setup.encoder->eepromCount().writes;
    m_setup.byHand = true;  // the next one
    if (!m_work.isRecovery) // those to come will not be sent
        m_steps.showSteps(m_setup.encoder->device(), record.progress.steps);
    const bool isBroughtBack = isCancelled(outcome);
    m_steps.finish(outcome.result || isBroughtBack);
    showEnd();
    showWords();
    Q_EMIT changed();
}

// The buttons and the sentence for the stage the handshake has reached.
void HandshakePage::showEnd()
{
    const HandshakeRecord &record = m_setup.record;
    std::optional<Outcome> last = record.last();
    if (last)
        m_shownState = last->leftIn = m_setup.stateNow();
    m_next->setVisible(!last || isBusy());
    m_byItself->setVisible(!last || isBusy());
    m_next->setEnabled(false);
    const WayBack way = last && !isBusy() ? wayBack(m_setup.encoder->device(), last->leftIn) : WayBack::none;
    m_restore->setVisible(way != WayBack::none && record.hasTaken());
    m_restore->setEnabled(!valuesToRestore(record).empty());
    m_run->setVisible(way != WayBack::none);
    m_run->setText(way == WayBack::endService ? tr("&End the service") : tr("R&un with what it has"));
    m_run->setToolTip(way == WayBack::endService
                          ? tr("Takes the service bit back: the encoder shows its position again.")
                          : tr("Sends run: what the encoder has taken becomes valid, if it accepts it."));
    m_leftIn->setText(last && !isBusy() ? (validTexts(*last) << endText(*last)).join(u' ') : QString());
    if (!last || isBusy())
        return;
    if (last->result) {
        m_problem->withdraw();
        if (last->onlyZeroSinceRun)
            m_problem->showMessage(Role::attention, messageText({.id = MessageId::onlyZeroSinceRun}));
        m_state->setState(Role::running, m_work.isRecovery ? tr("Brought back") : tr("Verified"));
        if (!m_work.isRecovery)
            m_leftIn->setText(verifiedText(*last));
        return;
    }
    const Refusal &why = last->result.error();
    const bool byUser = why.kind == RefusalKind::stopped;
    m_state->setState(byUser ? Role::attention : Role::fault,
                      byUser ? tr("Ended") : tr("Stopped by an error"));
    m_problem->showMessage(byUser ? Role::attention : Role::fault, refusalText(why));
}

// What acts in an encoder that was cancelled and not restored.
QStringList HandshakePage::validTexts(const Outcome &last) const
{
    const HandshakeRecord &record = m_setup.record;
    const bool isBroughtBack = record.recovery && last.result;
    if (!isBroughtBack && !isCancelled(last))
        return {};
    Outcome outcome = last;
    if (isBroughtBack)
        outcome.written = record.taken();
    outcome.positionBefore = record.positionBefore;
    outcome.positionAfter = record.positionAfter;
    return validNowTexts(*m_setup.encoder, outcome);
}

// How, how the encoder was left, and what does not act yet.
QString HandshakePage::verifiedText(const Outcome &last) const
{
    const DeviceDescription &device = m_setup.encoder->device();
    const QString verified =
        tr("Verified: %1. %2").arg(verificationText(m_setup.record, device), endText(last));
    const auto unscaled = unscaledNote(m_setup.record, device);
    return unscaled ? verified + u' ' + noteText(*unscaled) : verified;
}

bool HandshakePage::waitsForFirstStep() const
{
    const Progress &progress = m_setup.record.progress;
    return isBusy() && progress.waitsForUser && progress.index == 0;
}

bool HandshakePage::cancel()
{
    if (!m_work.job)
        return true;
    m_work.isCancelled = true;
    m_cancel->cancel();
    return m_work.isCancelled || !m_work.job;
}

CancelSituation HandshakePage::situation(const EncoderSession &encoder, const Progress &progress) const
{
    CancelSituation situation = situationOf(encoder, progress);
    situation.taken = m_setup.record.taken();
    if (situation.setsPosition)
        return situation;
    if (situation.isActive)
        situation.positionNote = [&encoder] { return positionNowTexts(encoder).join(u' '); };
    else
        situation.positionNote = [this] { return positionThenText(); };
    return situation;
}

// While it takes values it shows no position: the last one seen is what is known.
QString HandshakePage::positionThenText() const
{
    const auto position = positionWithTaken(m_setup);
    if (!position)
        return tr("What the position will then read is not known.");
    return tr("If the shaft has not moved since the encoder last showed its position, it will then read "
              "%1%2.",
              "'about ' or nothing, position")
        .arg(position->exact ? QString() : tr("about "), numberText(position->position));
}

// As long as the encoder has taken no more than by this handshake.
QString HandshakePage::positionAfterRun() const
{
    const EncoderSession &encoder = *m_setup.encoder;
    const QString taken = doubtText({.values = m_setup.record.taken()}, encoder.device());
    const bool isAsLeft =
        m_shownState == EncoderState::parameterization && encoder.takenWithoutRun() == taken;
    return isAsLeft ? positionThenText() : QString();
}

void HandshakePage::leaveEncoder(OnCancel how)
{
    if (m_work.job)
        m_setup.encoder->cancel(how);
}

void HandshakePage::goOn()
{
    m_work.isCancelled = false;
}

void HandshakePage::bringBack(bool restore)
{
    EndParameterization job;
    if (restore)
        job.restore = valuesToRestore(m_setup.record);
    const bool runs = !restore && wayBack(m_setup.encoder->device(), m_shownState) == WayBack::run;
    if (runs && !askToSendRun(window(), *m_setup.encoder, positionAfterRun()))
        return;
    if (restore && !askToRestore(window(), *m_setup.encoder, job.restore))
        return;
    if (!askForEeprom(window(), *m_setup.encoder, job))
        return;
    const auto started = m_setup.encoder->start(job);
    if (!started) {
        m_problem->showMessage(Role::attention, refusalText(started.error()));
        return;
    }
    m_work.isRecovery = true;
    m_work.isCancelled = false;
    m_cancel->begin(m_setup.encoder);
    m_work.job = *started;
    m_steps.begin();
    m_problem->withdraw();
    showEnd();
    m_state->setState(Role::inactive, tr("Brings the encoder back"));
    Q_EMIT changed();
}

} // namespace codewheel
