// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_account.h"

#include "cli/call/json.h"
#include "cli/call/keys.h"
#include "cli/call/texts.h"
#include "kinds/esc/driver/esc_fate.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "vocabulary/sentence.h"

namespace codewheel {
EscLineAccount::EscLineAccount(const EncoderSession &encoder, const ParameterValues &wanted,
                               const FinishedJob &job)
    : WriteAccount(encoder, wanted, job)
{}

EscLineAccount::Fate EscLineAccount::fate(const ParameterValue &value) const
{
    const Outcome &outcome = this->outcome();
    if (valueOf(outcome.alreadyThere, value.parameter))
        return Fate::alreadyThere;
    const auto known = encoder().known(value.parameter);
    const bool isRead = known && known->evidence == Evidence::read && known->value == value.value;
    if (valueOf(outcome.written, value.parameter))
        return isRead ? Fate::readBack : Fate::accepted;
    if (!wasSentOnEsc(lastStep(), value.parameter))
        return Fate::notSent;
    return isFateUnknownOnEsc(encoder(), value.parameter, outcome, lastStep()) ? Fate::unknown
                                                                               : Fate::refused;
}

QString EscLineAccount::fateOf(const ParameterValue &value) const
{
    switch (fate(value)) {
    case Fate::readBack:
        return CommandLine::tr("written, and read back");
    case Fate::accepted:
        return CommandLine::tr("accepted by the encoder, not read back");
    case Fate::alreadyThere:
        return CommandLine::tr("already there");
    case Fate::unknown:
        return CommandLine::tr("sent: it is not known whether the encoder has it");
    case Fate::refused:
        return CommandLine::tr("not taken: the encoder has another value");
    case Fate::notSent:
        break;
    }
    return CommandLine::tr("not sent");
}

QJsonObject EscLineAccount::toJson() const
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

QString EscLineAccount::whereItWasLeft() const
{
    const Outcome &outcome = this->outcome();
    const auto endedBy = [&](RefusalCode id) { return !outcome.result && outcome.result.error().id == id; };
    if (endedBy(RefusalId::portLost) || endedBy(RefusalId::stoppedInWrite))
        return CommandLine::tr(
            "What the encoder has is known as far as it is told above: connect again and read "
            "it.");
    if (endedBy(EscRefusalId::notFoundAgain))
        return {};
    if (outcome.leftIn == EncoderState::silent)
        return CommandLine::tr("The encoder does not answer any more.");
    if (outcome.leftIn != EncoderState::operation)
        return {};
    return sentence(CommandLine::tr("The encoder answers at %1."),
                    {EscLineAddress::of(encoder().place().node).shown()});
}

} // namespace codewheel
