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

// `sub`: of the settings of the PDO, what to change. %1 is the number of the PDO, %2 the object.
NoPdo byTerms(const canopen::PdoTerms &pdo, int sub, const QString &came, const QString &remedy)
{
    const QString number = QString::number(pdo.number);
    const canopen::SdoObject object{static_cast<std::uint16_t>(0x17FF + pdo.number),
                                    static_cast<std::uint8_t>(sub)};
    return {sentence(came, {number}), sentence(remedy, {number, object.text()})};
}

NoPdo onlyOnChange(const canopen::PdoTerms &pdo)
{
    return byTerms(pdo, 5, CanopenPdoText::tr("none: the shaft is at rest"),
                   CanopenPdoText::tr("TPDO%1 is sent only when the position changes. Turn the shaft, or "
                                      "set the event timer %2, in milliseconds."));
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
        return byTerms(pdo, 1, CanopenPdoText::tr("TPDO%1 is switched off"),
                       CanopenPdoText::tr("The node sends no TPDO%1: bit 31 of %2 is set. Clear it, and "
                                          "store the parameters."));
    if (pdo.isSynchronous() && !isSyncHeard)
        return byTerms(pdo, 2, CanopenPdoText::tr("TPDO%1 waits for SYNC"),
                       CanopenPdoText::tr("TPDO%1 is sent with SYNC, and none is heard. Let the master send "
                                          "SYNC, or set %2 to 254, and the event timer."));
    if (pdo.isAskedFor())
        return byTerms(pdo, 2, CanopenPdoText::tr("TPDO%1 waits to be asked for"),
                       CanopenPdoText::tr("TPDO%1 is sent only when a remote frame asks for it. Set %2 to "
                                          "254, and the event timer."));
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
DataCheck termsCheck(const DataStep &step, const canopen::PdoTerms &pdo, int number)
{
    constexpr std::chrono::milliseconds longInhibit(100);
    if (pdo.identifier != canopen::CobId{canopen::CobId::Service::tpdo, number, pdo.number}.identifier())
        return step.remark(
            step.expected,
            sentence(CanopenPdoText::tr("A PDO of the node has the identifier %1, which is not "
                                        "the predefined one."),
                     {hexNumber(pdo.identifier, 3)}));
    if (pdo.inhibitTime.value_or(Instant()) < longInhibit)
        return step.passed();
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(*pdo.inhibitTime);
    return step.remark(step.expected,
                       sentence(CanopenPdoText::tr("Positions come each %1 ms at the most: the inhibit time "
                                                   "(1800h:3) holds them back."),
                                {QLocale().toString(qlonglong{milliseconds.count()})}));
}

} // namespace

DataCheck canopenPdoCheck(const CanopenSession &bus, int number)
{
    const DataStep step{DataCheck::Id::answer, CanopenPdoText::tr("Positions by PDO"),
                        CanopenPdoText::tr("they come")};
    const CanopenSnapshot &latest = bus.latest();
    const CanopenSnapshot::Node *node = latest.heard(number);
    const auto terms = node != nullptr ? node->position : std::nullopt;
    const bool isPreOperational =
        node != nullptr && node->stateOrCommanded() == canopen::NmtState::preOperational;
    const bool hasBooted = node != nullptr && node->hasBooted;
    const auto stopped = node != nullptr ? noMore(*node, latest.at) : std::nullopt;
    if (node != nullptr && node->sendsPdos && !stopped)
        return terms ? termsCheck(step, *terms, number) : step.passed();
    const bool isSyncHeard = latest.sync.goesOn(latest.at);
    const auto bySettings = terms ? whyNever(*terms, isSyncHeard) : std::nullopt;
    const NoPdo why = stopped                        ? *stopped
                      : bySettings                   ? *bySettings
                      : isPreOperational             ? notStarted()
                      : hasBooted                    ? noneSinceBootUp()
                      : terms && terms->isOnChange() ? onlyOnChange(*terms)
                                                     : notReadYet(isSyncHeard);
    if (bus.isOperating()) // they are asked for
        return step.remark(
            why.came, terms || isPreOperational || hasBooted
                          ? sentence(CanopenPdoText::tr("The position is asked for (SDO). %1"), {why.remedy})
                          : CanopenPdoText::tr("The position is asked for (SDO)."));
    return step.failed(why.came, why.remedy, DataCheck::Action::operate);
}

} // namespace codewheel
