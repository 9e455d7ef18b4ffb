// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/interbus/ring/comparison.h"
#include "kinds/interbus/ring/id_code.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct ComparisonTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Comparison)
};

// "K3 37h", "bus terminal 0Ch", "BEh"
QString shortName(const RingDevice &participant, const Catalog &catalog)
{
    const QString code = hexCode(participant.idCode(), 2);
    if (participant.idCode() == busTerminalIdCode)
        return nameOrTerminal(participant, nullptr) + u' ' + code;
    const DeviceDescription *device = catalog.findFitting(participant.deviceKey, participant.deviceCode);
    return device ? profileName(device->profile) + u' ' + code : code;
}

QString wordsText(const RingDevice &participant)
{
    return sentence(ComparisonTexts::tr("device code %1, words: %2 IN, %3 OUT"),
                    {hexCode(participant.deviceCode, 4), QString::number(participant.inWords),
                     QString::number(participant.outWords)});
}

QString differenceText(const RingDevice &configured, const RingDevice &connected, const Catalog &catalog)
{
    QString wanted = shortName(configured, catalog);
    QString found = shortName(connected, catalog);
    if (wanted == found) {
        wanted += QStringLiteral(" (%1)").arg(wordsText(configured));
        found += QStringLiteral(" (%1)").arg(wordsText(connected));
    }
    return sentence(ComparisonTexts::tr("%1: configured %2, found %3"),
                    {configured.number.toString(), wanted, found});
}

QString sameText(const RingDevice &configured, const RingDevice &connected, const QString &name)
{
    if (configured.number == connected.number)
        return sentence(ComparisonTexts::tr("%1: %2, as configured"), {configured.number.toString(), name});
    return sentence(ComparisonTexts::tr("%1: %2, as configured; its number is %3 now"),
                    {configured.number.toString(), name, connected.number.toString()});
}

QString movedText(const RingDevice &configured, const RingDevice &connected, const QString &name)
{
    if (configured.number == connected.number && configured.level == connected.level)
        return sentence(ComparisonTexts::tr("%1: %2 moved among its neighbours, its number stayed the same"),
                        {configured.number.toString(), name});
    if (configured.number == connected.number)
        return sentence(ComparisonTexts::tr("%1: %2 moved, configured on level %3, found on level %4"),
                        {configured.number.toString(), name, QString::number(configured.level),
                         QString::number(connected.level)});
    return sentence(ComparisonTexts::tr("%1: %2 moved, found at %3"),
                    {configured.number.toString(), name, connected.number.toString()});
}

} // namespace

QString comparisonText(const ComparisonLine &line, const RingStructure &configured,
                       const RingStructure &connected, const Catalog &catalog)
{
    const auto found = [&]() -> const RingDevice & { return connected.at(*line.connected); };
    if (!line.configured)
        return sentence(ComparisonTexts::tr("%1: %2 is additional: it is not configured"),
                        {found().number.toString(), shortName(found(), catalog)});
    const RingDevice &wanted = configured.at(*line.configured);
    const QString name = shortName(wanted, catalog);
    switch (line.kind) {
    case ComparisonKind::differs:
        return differenceText(wanted, found(), catalog);
    case ComparisonKind::moved:
        return movedText(wanted, found(), name);
    case ComparisonKind::missing:
    case ComparisonKind::additional:
        return sentence(ComparisonTexts::tr("%1: configured %2 is missing"),
                        {wanted.number.toString(), name});
    case ComparisonKind::same:
        break;
    }
    return sameText(wanted, found(), name);
}

} // namespace codewheel
