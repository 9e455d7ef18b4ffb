// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/transfer_account.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "jobs/protocol.h"

#include <algorithm>

namespace codewheel {
namespace {

// Over the jobs of one encoder; later ones have the last word.
Became becameOf(const WriteRow &row, const std::vector<Outcome> &outcomes)
{
    Became became = row.isThere ? Became::alreadyThere : Became::notDone;
    for (const Outcome &outcome : outcomes) {
        if (const auto written = findValue(outcome.written, row.wanted.parameter)) {
            if (*written == row.wanted.value)
                became = Became::written;
            else if (!outcome.result)
                became = Became::restored;
        } else if (findValue(outcome.confirmed, row.wanted.parameter) == row.wanted.value) {
            became = Became::confirmed;
        } else if (findValue(outcome.notActive, row.wanted.parameter) == row.wanted.value) {
            became = Became::notActive;
        } else if (findValue(outcome.stored, row.wanted.parameter) == row.wanted.value) {
            became = Became::stored;
        } else if (findValue(outcome.alreadyThere, row.wanted.parameter) == row.wanted.value) {
            became = Became::alreadyThere;
        }
    }
    return became;
}

bool mayHaveSent(const Outcome &outcome, Parameter parameter)
{
    return findValue(outcome.written, parameter) || findValue(outcome.confirmed, parameter) ||
           findValue(outcome.notActive, parameter) || findValue(outcome.inDoubt.values, parameter);
}

// What a job read before anything was sent, otherwise what was known when the plan was made.
std::optional<Known> valueBefore(const WriteRow &row, const std::vector<Outcome> &outcomes)
{
    const Parameter parameter = row.wanted.parameter;
    for (const Outcome &outcome : outcomes) {
        if (const auto read = findValue(outcome.read, parameter))
            return Known{.parameter = parameter, .value = *read, .evidence = Evidence::read};
        if (mayHaveSent(outcome, parameter))
            break;
    }
    return row.known;
}

// A job that was done has found, or written, all its programs.
Became becameOf(const TransferCamRow &row, const std::vector<Outcome> &outcomes)
{
    if (row.isThere)
        return Became::alreadyThere;
    Became became = Became::notDone;
    for (const Outcome &outcome : outcomes) {
        if (std::ranges::find(outcome.camsWritten, row.wanted) != outcome.camsWritten.end())
            became = Became::written;
        else if (std::ranges::find(outcome.camsRead, row.wanted) != outcome.camsRead.end())
            became = Became::alreadyThere;
    }
    return became;
}

bool setsPosition(const Job &job)
{
    return std::holds_alternative<SetPreset>(job);
}

bool wasPositionSet(const EncoderPlan &plan, const std::vector<Outcome> &outcomes)
{
    const auto job = std::ranges::find_if(plan.jobs, setsPosition);
    const auto index = job - plan.jobs.begin();
    return job != plan.jobs.end() && index < std::ssize(outcomes) &&
           outcomes[static_cast<std::size_t>(index)].result.has_value();
}

// For what the last job that ended has sent.
bool isUnknown(const EncoderSession *encoder, std::optional<Parameter> parameter, const EncoderResult *result)
{
    return encoder != nullptr && result != nullptr && !result->outcomes.empty() &&
           protocolOf(encoder->device())
               .isFateUnknown(*encoder, parameter, result->outcomes.back(), result->lastJob);
}

// By a job that was cancelled afterwards.
bool wasPositionSetBefore(const std::vector<Outcome> &outcomes)
{
    return std::ranges::any_of(outcomes, &Outcome::isPositionSet);
}

// A job that was cancelled has read back what its preset did.
bool wasPositionReadBack(const EncoderPlan &plan, const EncoderSession *encoder, const EncoderResult *result)
{
    if (encoder == nullptr || result == nullptr || !result->why || result->why->id != RefusalId::cancelled ||
        !protocolOf(encoder->device()).wasSent(result->lastJob, std::nullopt))
        return false;
    const auto known = encoder->known(Parameter::preset);
    return known && known->evidence == Evidence::read && known->value == plan.position;
}

void addResult(EncoderAccount &account, const EncoderResult &result)
{
    account.isBegun = !result.outcomes.empty();
    account.why = result.why;
    account.leftIn = result.leftIn;
    if (!result.outcomes.empty())
        account.leftInMode = result.outcomes.back().leftInMode;
    account.positionBefore = result.positionBefore;
    account.positionAfter = result.positionAfter;
    account.begun = result.begun;
    account.ended = result.ended;
    for (const Outcome &outcome : result.outcomes) {
        account.eepromWrites += outcome.eepromWrites;
        account.eepromWritesPerhaps += outcome.inDoubt.eepromWrites;
        account.outLeft.insert(account.outLeft.end(), outcome.inDoubt.out.begin(), outcome.inDoubt.out.end());
        account.onlyZeroSinceRun = account.onlyZeroSinceRun || outcome.onlyZeroSinceRun;
    }
}

// The preset that was to set the position was written, and is left, unless another one was written after it.
void addPresetThatIsLeft(EncoderAccount &account, const EncoderPlan &plan, const EncoderSession *encoder,
                         const std::vector<Outcome> &outcomes)
{
    const ParameterValue preset{Parameter::preset, plan.position.value_or(0)};
    const bool isShown = std::ranges::find(account.rows, preset, &AccountRow::wanted) != account.rows.end();
    const bool isReplaced = std::ranges::any_of(plan.write.rows, [&](const WriteRow &row) {
        return row.wanted.parameter == preset.parameter && !row.goesAlong;
    });
    const bool wasWritten = std::ranges::any_of(outcomes, [&](const Outcome &outcome) {
        return findValue(outcome.written, preset.parameter) == preset.value;
    });
    const bool isLeft = !isReplaced || !account.positionSet || account.why;
    if (plan.position && isLeft && wasWritten && !isShown)
        account.rows.push_back({.wanted = preset,
                                .before = valueBefore({.wanted = preset}, outcomes),
                                .after = encoder ? encoder->known(preset.parameter) : std::nullopt,
                                .became = Became::written});
}

std::optional<ValueNote> whatIsNotInForce(const EncoderSession &encoder, const std::vector<AccountRow> &rows)
{
    ParameterValues there;
    for (const AccountRow &row : rows)
        if (isThere(row.became))
            there.push_back(row.wanted);
    return scalingNote(encoder, there);
}

EncoderAccount accountOfEncoder(const Buses &buses, const EncoderPlan &plan, const EncoderResult *result)
{
    const EncoderSession *encoder = buses.encoder(plan.place);
    EncoderAccount account{.place = plan.place,
                           .station = plan.station,
                           .device = plan.device,
                           .deviceKey = encoder ? encoder->device().key : QString(),
                           .positionWanted = plan.position,
                           .why = plan.hindrance,
                           .leftIn = encoder ? encoder->latest().state : EncoderState::notSeen};
    if (result)
        addResult(account, *result);
    const std::vector<Outcome> outcomes = result ? result->outcomes : std::vector<Outcome>();
    for (const WriteRow &row : plan.write.rows) {
        if (row.goesAlong)
            continue;
        const Parameter parameter = row.wanted.parameter;
        const Became became = becameOf(row, outcomes);
        const bool isOpen = became == Became::notDone && isUnknown(encoder, parameter, result);
        account.rows.push_back({.wanted = row.wanted,
                                .before = valueBefore(row, outcomes),
                                .after = encoder ? encoder->known(parameter) : std::nullopt,
                                .became = isOpen ? Became::unknown : became});
    }
    if (encoder)
        account.notInForce = whatIsNotInForce(*encoder, account.rows);
    for (const TransferCamRow &row : plan.cams)
        account.cams.push_back({row.wanted.number, becameOf(row, outcomes)});
    account.positionSet = wasPositionSet(plan, outcomes) || wasPositionSetBefore(outcomes) ||
                          wasPositionReadBack(plan, encoder, result);
    addPresetThatIsLeft(account, plan, encoder, outcomes);
    account.positionUnknown =
        plan.position && !account.positionSet && isUnknown(encoder, std::nullopt, result);
    return account;
}

bool wasCancelled(const EncoderAccount &account)
{
    return account.why && account.why->id == RefusalId::cancelled;
}

} // namespace

bool isThere(Became became)
{
    return became == Became::written || became == Became::alreadyThere || became == Became::stored;
}

bool EncoderAccount::isDone() const
{
    const auto done = [](const auto &row) { return isThere(row.became); };
    const bool isInOrder = leftIn == EncoderState::operation || leftIn == EncoderState::waiting ||
                           leftIn == EncoderState::notSeen;
    return !why && isInOrder && std::ranges::all_of(rows, done) && std::ranges::all_of(cams, done) &&
           (!positionWanted || positionSet);
}

int TransferAccount::count(Became became) const
{
    std::ptrdiff_t sum = 0;
    for (const EncoderAccount &encoder : encoders)
        sum += std::ranges::count(encoder.rows, became, &AccountRow::became) +
               std::ranges::count(encoder.cams, became, &AccountCamRow::became);
    return static_cast<int>(sum);
}

int TransferAccount::eepromWrites() const
{
    int sum = 0;
    for (const EncoderAccount &encoder : encoders)
        sum += encoder.eepromWrites;
    return sum;
}

int TransferAccount::eepromWritesPerhaps() const
{
    int sum = 0;
    for (const EncoderAccount &encoder : encoders)
        sum += encoder.eepromWritesPerhaps;
    return sum;
}

bool TransferAccount::isCancelled() const
{
    return std::ranges::any_of(encoders, wasCancelled);
}

bool TransferAccount::isDone() const
{
    return std::ranges::all_of(encoders, &EncoderAccount::isDone);
}

TransferAccount accountOf(const Buses &buses, TransferKind kind, const TransferPlan &plan,
                          const std::vector<EncoderResult> &results)
{
    TransferAccount account{.kind = kind, .at = buses.now(plan.empty() ? Place() : plan.front().place)};
    for (const EncoderPlan &one : plan) {
        const auto result = std::ranges::find(results, one.place, &EncoderResult::place);
        account.encoders.push_back(
            accountOfEncoder(buses, one, result == results.end() ? nullptr : &*result));
    }
    return account;
}

Message messageOf(const TransferAccount &account)
{
    const auto done = std::ranges::count_if(account.encoders, &EncoderAccount::isDone);
    Message message{
        .severity = account.isDone() ? Severity::information : Severity::attention,
        .id = account.isCancelled() ? MessageId::transferCancelled : MessageId::transferDone,
        .arguments = {
            std::int64_t{done}, std::int64_t{account.count(Became::written) + account.count(Became::stored)},
            std::int64_t{account.count(Became::alreadyThere)}, std::int64_t{account.eepromWrites()}}};
    if (account.encoders.size() == 1)
        message.place = account.encoders.front().place;
    const auto set = std::ranges::find_if(account.encoders, [](const EncoderAccount &encoder) {
        return wasCancelled(encoder) && encoder.positionSet && encoder.positionWanted;
    });
    if (set != account.encoders.end()) {
        message.id = MessageId::transferCancelledSet;
        message.arguments.emplace_back(*set->positionWanted);
    }
    return message;
}

std::vector<EncoderJobs> jobsOf(const TransferPlan &plan)
{
    std::vector<EncoderJobs> jobs;
    for (const EncoderPlan &encoder : plan)
        if (encoder.isWritten())
            jobs.push_back({encoder.place, encoder.jobs});
    return jobs;
}

} // namespace codewheel
