// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/serve_can_plan.h"

#include "can/can_link_argument.h"
#include "can/slcan_codec.h"
#include "cli/bus/serve_options.h"
#include "cli/call/texts.h"
#include "kinds/canopen/simulator/node_quirks.h"
#include "vocabulary/enumeration_rows.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using canopen::CanopenEncoderPlan;

constexpr std::array canServiceOptions{
    Option{"--slcan", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "canopen: behind an SLCAN adapter on a pseudo terminal (so it is, unless "
                             "--interface is given)")},
    Option{"--interface", "NAME",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "canopen: on this interface, as can0")},
    Option{"--rate", "BD",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "canopen: of the encoders (that of the interface, otherwise 125000)")},
    lostOption,
    Option{"--damaged", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "of 1000 frames, so many are destroyed by an error frame and sent again")},
    doubledOption,
    delayedOption,
    delayOption,
    silentOption,
    seedOption,
    Option{"--load", "PERCENT",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "canopen: devices that are no encoders take so much of the bus (0)")},
    Option{"--master", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "canopen: a master is at work, with SYNC and SDO requests of its own")},
    Option{"--quirk", "QUIRK",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "canopen: what makers do otherwise, on all encoders; several as "
                             "autostart,fixed-mapping")},
};

tl::unexpected<Complaint> valueNotAllowed(const char *option, const QString &typed, const QString &allowed)
{
    return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                    {QString::fromLatin1(option), typed, allowed});
}

Checked<void> takeFaults(const Arguments &arguments, ServeCanPlan &plan)
{
    int delay = 0;
    int seed = 0;
    const ServedNumber rows[] = {
        {"--lost", 0, 0, mostOfThousand, plan.faults.lost},
        {"--damaged", 0, 0, mostOfThousand - 1, plan.faults.damaged},
        {"--doubled", 0, 0, mostOfThousand - 1, plan.faults.doubled},
        {"--delayed", 0, 0, mostOfThousand, plan.faults.late},
        {"--delay", usualServedDelay, 1, longestServedDelay, delay},
        {"--seed", 1, 0, largestSeed, seed},
        {"--load", 0, 0, canopen::BackgroundPlan::highestLoad, plan.background.load},
    };
    if (const auto taken = takeNumbers(arguments, rows); !taken)
        return taken;
    plan.faults.delay = std::chrono::milliseconds(delay);
    plan.seed = static_cast<std::uint32_t>(seed);
    plan.background.hasMaster = arguments.has("--master");
    return {};
}

Checked<void> takeRate(const Arguments &arguments, ServeCanPlan &plan)
{
    const auto typed = arguments.value("--rate");
    if (!typed)
        return {};
    const auto found = std::ranges::find(slcanRates, typed->toInt());
    if (found == slcanRates.end())
        return valueNotAllowed("--rate", *typed, slcanRatesText());
    plan.rate = *found;
    return {};
}

Checked<void> takeQuirks(const Arguments &arguments, ServeCanPlan &plan)
{
    const QString given = arguments.value("--quirk").value_or(QString());
    const auto quirks = canopen::namedQuirks();
    for (const QString &typed : given.split(u',', Qt::SkipEmptyParts)) {
        const canopen::NamedQuirk *quirk = rowByKey(quirks, typed);
        if (quirk == nullptr)
            return valueNotAllowed("--quirk", typed, quirkNames());
        for (CanopenEncoderPlan &encoder : plan.encoders)
            quirk->put(encoder.quirks, true);
    }
    return {};
}

Checked<void> takeSilent(const Arguments &arguments, ServeCanPlan &plan)
{
    const QString all = QStringLiteral("all");
    const QString given = arguments.value("--silent").value_or(QString());
    QStringList there;
    for (const CanopenEncoderPlan &encoder : plan.encoders)
        there << (encoder.node ? QString::number(*encoder.node) : QString());
    for (const QString &typed : given.split(u',', Qt::SkipEmptyParts)) {
        if (typed != all && !there.contains(typed))
            return valueNotAllowed(
                "--silent", typed,
                (QStringList(there.first(there.size() - 1)) << all).join(QStringLiteral(", ")));
        for (qsizetype which = 0; which < there.size(); ++which)
            if (typed == all || typed == there.at(which))
                plan.silent.push_back(static_cast<std::size_t>(which));
    }
    return {};
}

} // namespace

std::span<const Option> serveCanOptions()
{
    return canServiceOptions;
}

QString quirkNames()
{
    return listed(canopen::namedQuirks(),
                  [](const canopen::NamedQuirk &one) { return QString::fromLatin1(one.key); });
}

Checked<ServeCanPlan> serveCanPlan(const Arguments &arguments)
{
    ServeCanPlan plan{.interface = arguments.value("--interface"), .encoders = canopen::trainingEncoders()};
    if (plan.interface && arguments.has("--slcan"))
        return badInput("slcanOrInterface",
                        CommandLine::tr("Give --slcan or --interface, not both: the bus is in one place."));
    for (const auto take : {takeFaults, takeRate, takeQuirks, takeSilent})
        if (const auto taken = take(arguments, plan); !taken)
            return tl::unexpected(taken.error());
    return plan;
}

} // namespace codewheel
