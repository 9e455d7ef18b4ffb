// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/serve_can_plan.h"

#include "can/can_link_argument.h"
#include "can/slcan_codec.h"
#include "cli/bus/serve_options.h"
#include "cli/call/texts.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using canopen::CanopenEncoderPlan;
using canopen::NodeQuirks;

constexpr Instant silenceOfStore = std::chrono::milliseconds(400); // as Gotting's

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
    Option{"--quirk", "QUIRK",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "canopen: what makers do otherwise, on all encoders; several as "
                             "autostart,fixed-mapping")},
};

struct Quirk
{
    const char *name;
    void (*put)(NodeQuirks &quirks);
};
constexpr std::array servedQuirks{
    Quirk{"autostart", [](NodeQuirks &its) { its.startsItself = true; }},
    Quirk{"fixed-mapping", [](NodeQuirks &its) { its.hasFixedMapping = true; }},
    Quirk{"highest-range", [](NodeQuirks &its) { its.rangeIsHighest = true; }},
    Quirk{"keeps-identifiers", [](NodeQuirks &its) { its.keepsIdentifiers = true; }},
    Quirk{"keeps-preset", [](NodeQuirks &its) { its.keepsPreset = true; }},
    Quirk{"lss-forgets", [](NodeQuirks &its) { its.lssForgets = true; }},
    Quirk{"lss-stopped", [](NodeQuirks &its) { its.lssOnlyWhenStopped = true; }},
    Quirk{"restore-at-once", [](NodeQuirks &its) { its.restore = NodeQuirks::Restore::atOnce; }},
    Quirk{"silent-store", [](NodeQuirks &its) { its.silenceWhileStoring = silenceOfStore; }},
    Quirk{"speed-off", [](NodeQuirks &its) { its.speedIsOff = true; }},
    Quirk{"switches", [](NodeQuirks &its) { its.hasSwitches = true; }},
    Quirk{"writes-pre-operational", [](NodeQuirks &its) { its.writesOnlyPreOperational = true; }},
};

tl::unexpected<Complaint> valueNotAllowed(const char *option, const QString &typed, const QString &allowed)
{
    return badInput(QStringLiteral("optionNotAllowed"),
                    CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
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
    };
    if (const auto taken = takeNumbers(arguments, rows); !taken)
        return taken;
    plan.faults.delay = std::chrono::milliseconds(delay);
    plan.seed = static_cast<std::uint32_t>(seed);
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
    for (const QString &typed : given.split(u',', Qt::SkipEmptyParts)) {
        const auto quirk = std::ranges::find_if(
            servedQuirks, [&](const Quirk &one) { return typed == QLatin1String(one.name); });
        if (quirk == servedQuirks.end())
            return valueNotAllowed("--quirk", typed, quirkNames());
        for (CanopenEncoderPlan &encoder : plan.encoders)
            quirk->put(encoder.quirks);
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
    return listed(servedQuirks, [](const Quirk &one) { return QString::fromLatin1(one.name); });
}

Checked<ServeCanPlan> serveCanPlan(const Arguments &arguments)
{
    ServeCanPlan plan{.interface = arguments.value("--interface"), .encoders = canopen::trainingEncoders()};
    if (plan.interface && arguments.has("--slcan"))
        return badInput(QStringLiteral("slcanOrInterface"),
                        CommandLine::tr("Give --slcan or --interface, not both: the bus is in one place."));
    for (const auto take : {takeFaults, takeRate, takeQuirks, takeSilent})
        if (const auto taken = take(arguments, plan); !taken)
            return tl::unexpected(taken.error());
    return plan;
}

} // namespace codewheel
