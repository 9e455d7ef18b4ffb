// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/plain_run.h"

#include "catalog/kept_values.h"
#include "tests/kinds/plain/plain_refusals.h"
#include "tests/kinds/plain/telegram_protocol.h"

namespace codewheel::test {

void PlainKnowledge::flush()
{
    if (auto changes = values.takeChanges())
        events.emplace_back(*std::move(changes));
}

PlainRun::PlainRun(JobId id, const Job &job, Pace pace, PlainKnowledge &encoder)
    : JobRun(id, job, pace, encoder.values, encoder.reading, encoder.events)
    , m_encoder(encoder)
{
    m_steps.all = encoder.device.profile == telegramProfile
                      ? telegramSteps(encoder.device, job, encoder.values.values())
                      : plainSteps(encoder.device, job);
}

std::optional<QByteArray> PlainRun::next()
{
    settle();
    if (isDone())
        return std::nullopt;
    const bool waits = m_steps.current().effect != Effect::reads && !goesByItself();
    if (!m_steps.begun && waits) {
        ask();
        return std::nullopt;
    }
    if (!m_steps.begun) {
        beginStep();
        if (m_steps.current().task == PlainStep::Task::to)
            m_account.outcome.positionBefore = m_reading.position;
        reportProgress(false);
    }
    return m_steps.current().line;
}

void PlainRun::settle()
{
    const bool hasCompared = m_steps.atEnd() || m_steps.current().task != PlainStep::Task::get;
    if (hasCompared && !std::exchange(m_isCompared, true))
        leaveOutWhatIsThere();
    if (hasLeftOffNow() && givesBack()) {
        m_restores = true;
        m_steps.append(plainWrites(m_encoder.device, m_account.valuesBefore(m_account.outcome.written)));
    }
    if (m_steps.atEnd() && !isDone())
        finish(result());
}

void PlainRun::leaveOutWhatIsThere()
{
    const auto *write = job<WriteParameters>();
    if (write == nullptr || !write->onlyWhatDiffers || m_failure || m_cancelled)
        return;
    ParameterValues left;
    for (const ParameterValue &value : write->values)
        (findValue(m_account.outcome.read, value.parameter) != value.value ? left
         : mayBeLost(value)                                                ? m_toStore
                                                                           : m_account.outcome.alreadyThere)
            .push_back(value);
    m_steps.dropRest();
    m_steps.append(left.empty() && !m_toStore.empty() ? std::vector{plainStore()}
                                                      : plainWrites(m_encoder.device, left));
}

bool PlainRun::mayBeLost(const ParameterValue &value) const
{
    const auto known = m_encoder.values.known(value.parameter);
    return !known || hasToBeStored(m_encoder.device, *known);
}

bool PlainRun::isUnderWay(PlainStep::Task task) const
{
    return !m_steps.atEnd() && m_steps.begun && m_steps.current().task == task;
}

void PlainRun::answered(const QByteArray &answer)
{
    if (answer.startsWith("no "))
        fail({RefusalKind::device,
              m_encoder.device.profile == telegramProfile ? RefusalCode(RefusalId::wrongParameterData)
                                                          : PlainRefusalId::noSuchKey,
              {*parameterFromKey(QString::fromLatin1(answer.mid(3)))}});
    else
        done(answer);
    settle();
    m_encoder.flush();
}

void PlainRun::done(const QByteArray &answer)
{
    const PlainStep step = m_steps.current();
    m_steps.goOn();
    switch (step.task) {
    case PlainStep::Task::get:
    case PlainStep::Task::check:
        read(answer);
        if (step.task == PlainStep::Task::check)
            check(answer);
        break;
    case PlainStep::Task::set:
        for (const ParameterValue &value : step.values)
            replaceValue(m_given, value);
        break;
    case PlainStep::Task::all:
        m_given = step.values;
        goesInForce();
        break;
    case PlainStep::Task::at:
        takeTelegramPosition(answer, m_encoder);
        break;
    case PlainStep::Task::go:
        goesInForce();
        break;
    case PlainStep::Task::keep:
        m_encoder.values.countEepromWrite();
        m_encoder.values.haveBeenStored();
        m_account.outcome.stored = std::exchange(m_toStore, {});
        break;
    case PlainStep::Task::to:
        m_encoder.reading.position = step.line.mid(3).toLongLong();
        m_account.outcome.positionAfter = m_encoder.reading.position;
        break;
    }
}

void PlainRun::read(const QByteArray &answer)
{
    const QByteArray key = answer.left(answer.indexOf('='));
    const ParameterDescription *its = m_encoder.device.find(*parameterFromKey(QString::fromLatin1(key)));
    const Value value = plainValue(*its, answer.mid(key.size() + 1));
    if (!valueOf(m_account.outcome.written, its->parameter))
        m_account.read({its->parameter, value});
    m_encoder.values.learn({its->parameter, value, Evidence::read, m_encoder.reading.at});
}

void PlainRun::check(const QByteArray &answer)
{
    const ParameterValue wanted = m_steps.done().back().values.front();
    const Value has =
        plainValue(*m_encoder.device.find(wanted.parameter), answer.mid(answer.indexOf('=') + 1));
    if (has == wanted.value)
        return;
    m_account.notWritten(wanted.parameter);
    fail({RefusalKind::device,
          RefusalId::verificationFailed,
          {wanted.parameter, argumentOf(wanted.value), argumentOf(has)}});
}

void PlainRun::goesInForce()
{
    for (const ParameterValue &value : std::exchange(m_given, {})) {
        m_account.written(value);
        m_encoder.values.learn(
            {value.parameter, value.value, Evidence::echoed, m_encoder.reading.at, Kept::untilPowerOff});
    }
}

void PlainRun::fail(Refusal why)
{
    noteFailure(std::move(why));
}

void PlainRun::stop(const Refusal &why)
{
    if (isUnderWay(PlainStep::Task::go))
        m_account.outcome.inDoubt.values = m_given;
    if (isUnderWay(PlainStep::Task::keep)) {
        m_account.outcome.inDoubt.eepromWrites = 1;
        m_encoder.values.mayHaveBeenStored();
    }
    leaveOutOfSight();
    noteFailure(why);
    finish(result());
    m_encoder.flush();
}

bool PlainRun::hasTaken() const
{
    return !m_given.empty() || !m_account.outcome.written.empty();
}

void PlainRun::leaveOffAt(Instant /*now*/)
{
    m_steps.dropRest();
    if (m_cancelled == OnCancel::runWithWhatItHas && !m_given.empty()) {
        auto rest = plainWrites(m_encoder.device, m_given);
        std::erase_if(rest, [](const PlainStep &step) { return step.task == PlainStep::Task::set; });
        m_steps.append(rest);
    }
}

void PlainRun::complete(Outcome &outcome)
{
    outcome.confirmed = m_given;
    std::ranges::copy(m_toStore, std::back_inserter(outcome.alreadyThere)); // they were not stored
    if (hasRestored())
        outcome.restored = Evidence::read;
    m_encoder.flush();
}

} // namespace codewheel::test
