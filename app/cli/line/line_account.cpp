// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/line/line_account.h"

#include "cli/json.h"
#include "cli/keys.h"
#include "cli/parameter_text.h"
#include "cli/texts.h"
#include "drivers/esc_plan.h"
#include "drivers/values_to_write.h"
#include "encoder/sentence.h"

#include <algorithm>
#include <span>

namespace codewheel {
namespace {

// Whether it says of a write that was sent last that its outcome is not known.
bool leavesItOpen(const Refusal &why)
{
    return why.kind == RefusalKind::link || why.kind == RefusalKind::stopped || // ended where it stood
           why.id == RefusalId::escWriteUnknown || why.id == RefusalId::escNoAnswer ||
           why.id == RefusalId::escReadsDisagree;
}

} // namespace

LineAccount::LineAccount(const EncoderSession &encoder, const ParameterValues &wanted, const FinishedJob &job)
    : WriteAccount(encoder, wanted, job.outcome)
    , m_lastStep(job.lastStep)
{}

bool LineAccount::wasSent(Parameter parameter) const
{
    const auto begun =
        std::span(m_lastStep.steps)
            .first(std::min(m_lastStep.steps.size(), static_cast<std::size_t>(m_lastStep.index) + 1));
    return std::ranges::any_of(
        begun, [&](const Step &step) { return writesValue(step) && step.parameter == parameter; });
}

LineAccount::Fate LineAccount::fate(const ParameterValue &value) const
{
    const Outcome &outcome = this->outcome();
    if (valueOf(outcome.alreadyThere, value.parameter))
        return Fate::alreadyThere;
    const auto known = encoder().known(value.parameter);
    const bool isRead = known && known->evidence == Evidence::read && known->value == value.value;
    if (valueOf(outcome.written, value.parameter))
        return isRead ? Fate::readBack : Fate::accepted;
    if (!wasSent(value.parameter))
        return Fate::notSent;
    const bool isOpen = !outcome.result && leavesItOpen(outcome.result.error());
    // Steps and range that are read do not tell whether new ones wait for their factor.
    const bool isUntold = isOpen && outcome.result.error().id == RefusalId::escWriteUnknown &&
                          isBoundToEscFactor(value.parameter);
    return isUntold || (isOpen && !known) ? Fate::unknown : Fate::refused;
}

QString LineAccount::fateOf(const ParameterValue &value) const
{
    switch (fate(value)) {
    case Fate::readBack:
        return CommandLine::tr("written, and read back");
    case Fate::accepted:
        return CommandLine::tr("accepted by the encoder, not read back");
    case Fate::alreadyThere:
        return CommandLine::tr("was there already");
    case Fate::unknown:
        return CommandLine::tr("sent: it is not known whether the encoder has it");
    case Fate::refused:
        return CommandLine::tr("not taken: the encoder has another value");
    case Fate::notSent:
        break;
    }
    return CommandLine::tr("not sent");
}

QJsonObject LineAccount::toJson() const
{
    static constexpr NamedValue<Fate> fates[] = {
        {"notSent", Fate::notSent},           {"readBack", Fate::readBack}, {"accepted", Fate::accepted},
        {"alreadyThere", Fate::alreadyThere}, {"unknown", Fate::unknown},   {"refused", Fate::refused},
    };
    QJsonArray json;
    const auto add = [&](const ParameterValue &value, const QString &fate) {
        QJsonObject object = valueJson(*encoder().device().find(value.parameter), value.value);
        object.insert(QStringLiteral("fate"), fate);
        json.append(object);
    };
    for (const ParameterValue &value : wanted())
        add(value, keyOf(fates, fate(value)));
    for (const ParameterValue &value : outcome().setAlong)
        add(value, QStringLiteral("setAlong"));
    return {{QStringLiteral("values"), json}, {QStringLiteral("placeNow"), encoder().place().toString()}};
}

QString LineAccount::whereItWasLeft() const
{
    const Outcome &outcome = this->outcome();
    const auto endedBy = [&](RefusalId id) { return !outcome.result && outcome.result.error().id == id; };
    if (endedBy(RefusalId::portLost) || endedBy(RefusalId::stoppedInWrite))
        return CommandLine::tr(
            "What the encoder has is known as far as it is told above: connect again and read "
            "it.");
    if (endedBy(RefusalId::escNotFoundAgain))
        return {};
    if (outcome.leftIn == EncoderState::silent)
        return CommandLine::tr("The encoder does not answer any more.");
    if (outcome.leftIn != EncoderState::operation)
        return {};
    return sentence(CommandLine::tr("The encoder answers at %1."),
                    {LineAddress::of(encoder().place().node).shown()});
}

} // namespace codewheel
