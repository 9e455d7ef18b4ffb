// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/setup.h"

#include "widgets/models/device_traits.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct SetupTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Setup)
};

} // namespace

EncoderState Setup::stateNow() const
{
    const std::optional<Outcome> &last = record.last();
    if (encoder && last && isSeenSince(*encoder, record.endedAt))
        return encoder->latest().state;
    return last ? last->leftIn : EncoderState::notSeen;
}

void Setup::want(const Wishes &wishes)
{
    ParameterValues values = wish.wanted;
    for (const auto &[parameter, value] : wishes) {
        const auto before = findValue(wish.wanted, parameter);
        if (before == value)
            continue;
        putWanted(values, parameter, value);
        given.try_emplace(parameter, Given{before, value}).first->second.now = value;
    }
    wanted.replace(encoder->place(), std::move(values),
                   SetupTexts::tr("Values wanted for %1").arg(encoder->place().shown()));
    takeWanted();
}

QStringList Setup::changed() const
{
    QStringList names;
    for (const auto &[parameter, change] : given)
        if (change.now != change.before && findValue(wish.wanted, parameter) == change.now)
            names << parameterName(encoder != nullptr ? &encoder->device() : nullptr, parameter);
    return names;
}

void Setup::takeBack()
{
    if (!encoder)
        return;
    takeWanted();
    ParameterValues values = wish.wanted;
    for (const auto &[parameter, change] : given)
        if (findValue(wish.wanted, parameter) == change.now)
            putWanted(values, parameter, change.before);
    wanted.replace(encoder->place(), std::move(values),
                   SetupTexts::tr("Wizard for %1 cancelled").arg(encoder->place().shown()));
    keep();
    takeWanted();
}

} // namespace codewheel
