// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_rules.h"

#include "catalog/hex_code.h"
#include "catalog/rule_texts.h"
#include "kinds/interbus/words/word_reach.h"

namespace codewheel {

void RingRules::readPlaceOnBus(const JsonObject &json, DeviceDescription &device) const
{
    constexpr std::int64_t mostWords = 32;
    device.idCode = json.hexNumber("idCode");
    device.deviceCode = json.hexNumber("deviceCode");
    if ((device.deviceCode & 0xFF) != device.idCode)
        json.report("deviceCode", DescriptionRules::tr("The last two digits must be those of idCode."));
    device.inWords = static_cast<int>(json.number("inWords", 0, mostWords));
    device.outWords = static_cast<int>(json.number("outWords", 0, mostWords));
    checkCodes(json, device);
    checkWordCounts(json, device);
}

void RingRules::checkCodes(const JsonObject &json, const DeviceDescription &device) const
{
    QStringList idCodes;
    QStringList deviceCodes;
    for (const unsigned code : m_place.deviceCodes) {
        idCodes << hexCode(code & 0xFF, 2);
        deviceCodes << hexCode(code, 4);
    }
    const QString profile = profileName(device.profile);
    const QString either = DescriptionRules::tr(" or ");
    if (!idCodes.contains(hexCode(device.idCode, 2)))
        json.report(
            "idCode",
            DescriptionRules::tr("The ID code of the profile %1 is %2.").arg(profile, idCodes.join(either)));
    if (!deviceCodes.contains(hexCode(device.deviceCode, 4)))
        json.report("deviceCode", DescriptionRules::tr("The device code of the profile %1 is %2.")
                                      .arg(profile, deviceCodes.join(either)));
}

void RingRules::checkWordCounts(const JsonObject &json, const DeviceDescription &device) const
{
    const QString reason = DescriptionRules::tr("The words of the profile %1 are: IN %2, OUT %3.")
                               .arg(profileName(device.profile))
                               .arg(m_place.inWords)
                               .arg(m_place.outWords);
    if (device.inWords != m_place.inWords)
        json.report("inWords", reason);
    if (device.outWords != m_place.outWords)
        json.report("outWords", reason);
}

void WordRules::readReach(const JsonObject &row, ParameterDescription &parameter,
                          const DeviceDescription &before) const
{
    constexpr std::int64_t highestNumber = 15; // D28..D25
    constexpr std::int64_t highestReadOut = 0xFF;
    const auto code = [&row](const char *key, std::int64_t least, std::int64_t most) {
        const auto number = row.optionalNumber(key, least, most);
        return number ? std::optional(static_cast<unsigned>(*number)) : std::nullopt;
    };
    const WordReach reach{.number = code("number", 1, highestNumber),
                          .readOut = code("readOut", 0, highestReadOut)};
    if (reach.number && findNumber(before, *reach.number) != nullptr)
        row.report("number", DescriptionRules::tr("This number is here twice."));
    if (reach.readOut && findReadOut(before, *reach.readOut) != nullptr)
        row.report("readOut", DescriptionRules::tr("This readOut code is here twice."));
    parameter.reach = KindData(reach);
    parameter.canBeWritten = reach.number.has_value();
    parameter.canBeRead = reach.readOut.has_value();
}

ProtocolRules::ReachText WordRules::reachText(const ParameterDescription &parameter) const
{
    const auto text = [](std::optional<unsigned> code) { return code ? QString::number(*code) : QString(); };
    const WordReach reach = wordReach(parameter);
    return {.write = text(reach.number), .read = text(reach.readOut)};
}

void WordRules::checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                               const DeviceDescription &device) const
{
    refuseCommands(row);
    checkRange(row, parameter);
    checkWords(row, parameter, device);
}

void WordRules::checkRange(const JsonObject &row, const ParameterDescription &parameter) const
{
    if (!parameter.canBeWritten)
        return;
    const QString reason =
        DescriptionRules::tr(
            "A value that is written must be between 0 and %1: the word has no room for others.")
            .arg(largestData());
    if (parameter.minimum < 0)
        row.report("minimum", reason);
    if (parameter.maximum > largestData())
        row.report("maximum", reason);
}

} // namespace codewheel
