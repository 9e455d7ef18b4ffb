// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/object_texts.h"

#include "catalog/device_description.h"
#include "kinds/canopen/protocol/encoder_bits.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct ObjectTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ObjectTexts)

public:
    // As many digits as the type has; of an unknown one as few as show it.
    static QString hexadecimal(std::int64_t number, std::optional<canopen::DataType> type)
    {
        constexpr int widest = 64;
        const int bits = type ? canopen::factsOf(*type).bits : 0;
        auto shown = static_cast<quint64>(number);
        if (bits > 0 && bits < widest)
            shown &= (quint64{1} << bits) - 1;
        return QStringLiteral("%1h")
            .arg(shown, (bits + 3) / 4, 16, QLatin1Char('0'))
            .toUpper()
            .replace(u'H', u'h');
    }

    // "6004h:0, 32 bits"
    static QString mapping(std::uint32_t entry)
    {
        const canopen::SdoObject object{static_cast<std::uint16_t>(entry >> 16),
                                        static_cast<std::uint8_t>(entry >> 8)};
        return sentence(tr("%1, %2 bits"), {object.text(), QString::number(entry & 0xFF)});
    }

    // Bit 31 says that it is not used.
    static QString identifier(std::uint32_t word)
    {
        constexpr std::uint32_t off = 0x8000'0000;
        constexpr std::uint32_t identifierBits = 0x1FFF'FFFF;
        const QString shown = QStringLiteral("%1h").arg(word & identifierBits, 3, 16, QLatin1Char('0'));
        return (word & off) != 0 ? sentence(tr("off, %1"), {shown}) : QString();
    }

    static bool isMappingEntry(canopen::SdoObject object)
    {
        return object.sub != 0 && object.index >= 0x1600 && object.index < 0x1C00 &&
               (object.index < 0x1800 || object.index >= 0x1A00);
    }
    static bool isIdentifier(canopen::SdoObject object)
    {
        return object.sub == 1 && ((object.index >= 0x1400 && object.index < 0x1600) ||
                                   (object.index >= 0x1800 && object.index < 0x1A00));
    }
};

} // namespace

QString objectValueText(const canopen::FileValue &value, std::optional<canopen::DataType> type)
{
    const std::int64_t *number = value.number();
    if (number == nullptr || value.addsNode)
        return value.text(type);
    return QStringLiteral("%1 = %2").arg(ObjectTexts::hexadecimal(*number, type), value.text(type));
}

QString wantedObjectText(const canopen::WantedObject &wanted, std::optional<canopen::DataType> type)
{
    if (wanted.bits == 0)
        return objectValueText(wanted.value, type);
    const auto word = static_cast<std::uint32_t>(*wanted.value.number());
    QStringList bits;
    for (int bit = 0; bit < 32; ++bit)
        if ((wanted.bits >> bit & 1) != 0)
            bits << sentence(ObjectTexts::tr("bit %1 = %2"),
                             {QString::number(bit), QString::number(word >> bit & 1)});
    return bits.join(QStringLiteral(", "));
}

QString objectMeaningText(canopen::SdoObject object, const canopen::FileValue &value)
{
    const std::int64_t *number = value.number();
    if (number == nullptr || value.addsNode)
        return {};
    const auto word = static_cast<std::uint32_t>(*number);
    if (ObjectTexts::isMappingEntry(object))
        return word == 0 ? QString() : ObjectTexts::mapping(word);
    if (ObjectTexts::isIdentifier(object))
        return ObjectTexts::identifier(word);
    constexpr std::uint16_t areaState = 0x6400; // of each area
    if (object == canopen::object::versions || object == canopen::object::operatingTime)
        return canopen::encoderValueForm(object.index)->text(word, {});
    return (object.sub == 0) != (object.index == areaState)
               ? canopen::encoderBitTexts(object.index, word).join(QStringLiteral(", "))
               : QString();
}

QString objectAccessText(std::optional<canopen::FileAccess> access)
{
    if (!access)
        return QStringLiteral("\u2013");
    switch (*access) {
    case canopen::FileAccess::readOnly:
        return ObjectTexts::tr("read");
    case canopen::FileAccess::writeOnly:
        return ObjectTexts::tr("write");
    case canopen::FileAccess::readAndWrite:
        return ObjectTexts::tr("read, write");
    case canopen::FileAccess::constant:
        break;
    }
    return ObjectTexts::tr("constant");
}

} // namespace codewheel
