// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_checks.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct CanopenPdoText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenChecks)
};

// Why no position comes by itself, by what the node told of its PDO.
struct NoPdo
{
    QString came;
    QString remedy;
};

NoPdo notMapped()
{
    return {CanopenPdoText::tr("none with the position"),
            CanopenPdoText::tr("No PDO of the node has the position (6004h) in it. Map it, in 1A00h, "
                               "while the node is pre-operational.")};
}

NoPdo switchedOff(const canopen::PdoTerms &pdo)
{
    const QString number = QString::number(pdo.number);
    const QString object = canopen::SdoObject{static_cast<std::uint16_t>(0x17FF + pdo.number), 1}.text();
    return {sentence(CanopenPdoText::tr("TPDO%1 is switched off"), {number}),
            sentence(CanopenPdoText::tr("The node sends no TPDO%1: bit 31 of %2 is set. Clear it, and "
                                        "store the parameters."),
                     {number, object})};
}

NoPdo waitsForSync(const canopen::PdoTerms &pdo)
{
    const QString number = QString::number(pdo.number);
    const QString object = canopen::SdoObject{static_cast<std::uint16_t>(0x17FF + pdo.number), 2}.text();
    return {sentence(CanopenPdoText::tr("TPDO%1 waits for SYNC"), {number}),
            sentence(CanopenPdoText::tr("TPDO%1 is sent with SYNC, and none is heard. Let the master send "
                                        "SYNC, or set %2 to 254, and the event timer."),
                     {number, object})};
}

NoPdo waitsToBeAskedFor(const canopen::PdoTerms &pdo)
{
    const QString number = QString::number(pdo.number);
    const QString object = canopen::SdoObject{static_cast<std::uint16_t>(0x17FF + pdo.number), 2}.text();
    return {sentence(CanopenPdoText::tr("TPDO%1 waits to be asked for"), {number}),
            sentence(CanopenPdoText::tr("TPDO%1 is sent only when a remote frame asks for it. Set %2 to "
                                        "254, and the event timer."),
                     {number, object})};
}

NoPdo onlyOnChange(const canopen::PdoTerms &pdo)
{
    const QString number = QString::number(pdo.number);
    const QString object = canopen::SdoObject{static_cast<std::uint16_t>(0x17FF + pdo.number), 5}.text();
    return {CanopenPdoText::tr("none: the shaft is at rest"),
            sentence(CanopenPdoText::tr("TPDO%1 is sent only when the position changes. Turn the shaft, or "
                                        "set the event timer %2, in milliseconds."),
                     {number, object})};
}

NoPdo notStarted()
{
    return {CanopenPdoText::tr("none: the node is pre-operational"),
            CanopenPdoText::tr("PDOs come once the node is started (NMT).")};
}

NoPdo noneSinceBootUp()
{
    return {CanopenPdoText::tr("none since the boot-up"),
            CanopenPdoText::tr("PDOs come once the node is started (NMT), unless it starts by itself.")};
}

// Empty: it is not known when the next one should come, or it is not due yet.
std::optional<NoPdo> noMore(const CanopenSnapshot::Node &node, Instant now)
{
    constexpr int timesMissed = 3;
    constexpr Instant atLeast = std::chrono::seconds(1);
    const Instant timer = node.position ? node.position->eventTimer.value_or(Instant()) : Instant();
    const Instant since = now - node.pdoAt.value_or(now);
    if (timer == Instant() || node.position->isSynchronous() || node.position->isAskedFor() ||
        since <= std::max(timer * timesMissed, atLeast))
        return std::nullopt;
    const auto text = [](auto duration) { return QLocale().toString(qlonglong{duration.count()}); };
    return NoPdo{sentence(CanopenPdoText::tr("none for %1 s"),
                          {text(std::chrono::duration_cast<std::chrono::seconds>(since))}),
                 sentence(CanopenPdoText::tr("TPDO%1 should come each %2 ms at least. Check whether the node "
                                             "still runs: Start it (NMT), and see to its supply."),
                          {QString::number(node.position->number),
                           text(std::chrono::duration_cast<std::chrono::milliseconds>(timer))})};
}

// Whether it runs or not.
std::optional<NoPdo> whyNever(const canopen::PdoTerms &pdo, bool isSyncHeard)
{
    if (!pdo.holdsIt)
        return notMapped();
    if (pdo.isOff)
        return switchedOff(pdo);
    if (pdo.isSynchronous() && !isSyncHeard)
        return waitsForSync(pdo);
    if (pdo.isAskedFor())
        return waitsToBeAskedFor(pdo);
    return std::nullopt;
}

// Before its settings were read.
NoPdo notReadYet(bool isSyncHeard)
{
    return {CanopenPdoText::tr("none"),
            isSyncHeard
                ? CanopenPdoText::tr("The PDOs of the node may be switched off, have another identifier, or "
                                     "be sent only when the shaft turns. In Operate its settings are read.")
                : CanopenPdoText::tr("The PDOs of the node may be switched off, wait for a SYNC, of which "
                                     "none was heard, have another identifier, or be sent only when the "
                                     "shaft turns. In Operate its settings are read.")};
}

// PDOs come: under which terms is worth knowing where they are not the usual ones.
DataCheck termsCheck(DataCheck passed, const canopen::PdoTerms &pdo, int number)
{
    constexpr std::chrono::milliseconds longInhibit(100);
    if (pdo.identifier != canopen::CobId{canopen::CobId::Service::tpdo, number, pdo.number}.identifier())
        return remarkOf(std::move(passed),
                        sentence(CanopenPdoText::tr("A PDO of the node has the identifier %1, which is not "
                                                    "the predefined one."),
                                 {hexNumber(pdo.identifier, 3)}));
    if (pdo.inhibitTime.value_or(Instant()) < longInhibit)
        return passed;
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(*pdo.inhibitTime);
    return remarkOf(std::move(passed),
                    sentence(CanopenPdoText::tr("Positions come each %1 ms at the most: the inhibit time "
                                                "(1800h:3) holds them back."),
                             {QLocale().toString(qlonglong{milliseconds.count()})}));
}

} // namespace

DataCheck canopenPdoCheck(const CanopenSession &bus, int number)
{
    const QString what = CanopenPdoText::tr("Positions by PDO");
    const QString expected = CanopenPdoText::tr("they come");
    const CanopenSnapshot &latest = bus.latest();
    const CanopenSnapshot::Node *node = latest.heard(number);
    const auto terms = node != nullptr ? node->position : std::nullopt;
    const bool isPreOperational =
        node != nullptr && node->stateOrCommanded() == canopen::NmtState::preOperational;
    const bool hasBooted = node != nullptr && node->hasBooted;
    const auto stopped = node != nullptr ? noMore(*node, latest.at) : std::nullopt;
    if (node != nullptr && node->sendsPdos && !stopped) {
        DataCheck passed = passedCheck(DataCheck::Id::answer, what, expected, expected);
        return terms ? termsCheck(std::move(passed), *terms, number) : passed;
    }
    const bool isSyncHeard = latest.sync.goesOn(latest.at);
    const auto bySettings = terms ? whyNever(*terms, isSyncHeard) : std::nullopt;
    const NoPdo why = stopped                        ? *stopped
                      : bySettings                   ? *bySettings
                      : isPreOperational             ? notStarted()
                      : hasBooted                    ? noneSinceBootUp()
                      : terms && terms->isOnChange() ? onlyOnChange(*terms)
                                                     : notReadYet(isSyncHeard);
    if (bus.isOperating()) // they are asked for
        return remarkOf(
            passedCheck(DataCheck::Id::answer, what, expected, why.came),
            terms || isPreOperational || hasBooted
                ? sentence(CanopenPdoText::tr("The position is asked for (SDO). %1"), {why.remedy})
                : CanopenPdoText::tr("The position is asked for (SDO)."));
    return failedCheck(DataCheck::Id::answer, what, expected, why.came, why.remedy,
                       DataCheck::Action::operate);
}

} // namespace codewheel
