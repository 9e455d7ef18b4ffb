// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/encoder_bits.h"

#include "catalog/device_description.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

struct EncoderBitTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenBit)
};

enum class BitsOf : std::uint8_t { operating, alarms, warnings };

struct EncoderBit
{
    BitsOf object;
    unsigned bit;
    const char *set;
    const char *clear = nullptr; // null: a 0 says nothing
};

// CiA 406.
constexpr std::array encoderBits{
    EncoderBit{BitsOf::operating, 3, QT_TRANSLATE_NOOP("CanopenBit", "measuring direction reversed")},
    EncoderBit{BitsOf::operating, 2, QT_TRANSLATE_NOOP("CanopenBit", "scaling on"),
               QT_TRANSLATE_NOOP("CanopenBit", "scaling off")},
    EncoderBit{BitsOf::operating, 1, QT_TRANSLATE_NOOP("CanopenBit", "commissioning diagnostics on")},
    EncoderBit{BitsOf::operating, 0, QT_TRANSLATE_NOOP("CanopenBit", "CCW"),
               QT_TRANSLATE_NOOP("CanopenBit", "CW")},
    EncoderBit{BitsOf::alarms, 1, QT_TRANSLATE_NOOP("CanopenBit", "commissioning diagnostics")},
    EncoderBit{BitsOf::alarms, 0, QT_TRANSLATE_NOOP("CanopenBit", "position error")},
    EncoderBit{BitsOf::warnings, 5, QT_TRANSLATE_NOOP("CanopenBit", "reference point not reached")},
    EncoderBit{BitsOf::warnings, 4, QT_TRANSLATE_NOOP("CanopenBit", "battery charge low")},
    EncoderBit{BitsOf::warnings, 3, QT_TRANSLATE_NOOP("CanopenBit", "operating time exceeded")},
    EncoderBit{BitsOf::warnings, 2, QT_TRANSLATE_NOOP("CanopenBit", "CPU watchdog")},
    EncoderBit{BitsOf::warnings, 1, QT_TRANSLATE_NOOP("CanopenBit", "light reserve used up")},
    EncoderBit{BitsOf::warnings, 0, QT_TRANSLATE_NOOP("CanopenBit", "frequency exceeded")},
};

constexpr unsigned firstMakersBit = 12;

struct BitObject
{
    std::uint16_t index;
    BitsOf object;
};
constexpr std::array bitObjects{
    BitObject{0x6000, BitsOf::operating}, BitObject{0x6500, BitsOf::operating},
    BitObject{0x6503, BitsOf::alarms},    BitObject{0x6504, BitsOf::alarms},
    BitObject{0x6505, BitsOf::warnings},  BitObject{0x6506, BitsOf::warnings},
};

QString unnamed(unsigned bit)
{
    const QString number = QString::number(bit);
    return bit >= firstMakersBit ? sentence(EncoderBitTexts::tr("bit %1 (of the maker)"), {number})
                                 : sentence(EncoderBitTexts::tr("bit %1 (not described)"), {number});
}

QStringList textsOf(BitsOf object, std::uint32_t bits)
{
    constexpr unsigned highestBit = 31;
    QStringList texts;
    for (unsigned bit = highestBit + 1; bit-- > 0;) {
        const bool isSet = (bits >> bit & 1) != 0;
        const auto row = std::ranges::find_if(
            encoderBits, [&](const EncoderBit &each) { return each.object == object && each.bit == bit; });
        if (row == encoderBits.end()) {
            if (isSet)
                texts << unnamed(bit);
        } else if (const char *text = isSet ? row->set : row->clear) {
            texts << EncoderBitTexts::tr(text);
        }
    }
    return texts;
}

template <BitsOf object>
QString bitsText(std::int64_t value, const KindData & /*options*/)
{
    constexpr int digits = 4;
    const auto bits = static_cast<std::uint32_t>(value);
    const QStringList texts = textsOf(object, bits);
    return QStringLiteral("%1 (%2)").arg(hexNumber(bits, digits), texts.isEmpty()
                                                                      ? EncoderBitTexts::tr("none")
                                                                      : texts.join(QStringLiteral(", ")));
}

constexpr ValueForm operatingForm{.text = bitsText<BitsOf::operating>};
constexpr ValueForm alarmForm{.text = bitsText<BitsOf::alarms>};
constexpr ValueForm warningForm{.text = bitsText<BitsOf::warnings>};
constexpr std::array bitForms{&operatingForm, &alarmForm, &warningForm};

const BitObject *bitObjectOf(std::uint16_t index)
{
    const auto found = std::ranges::find(bitObjects, index, &BitObject::index);
    return found == bitObjects.end() ? nullptr : &*found;
}

} // namespace

QStringList encoderBitTexts(std::uint16_t index, std::uint32_t bits)
{
    const BitObject *its = bitObjectOf(index);
    return its != nullptr ? textsOf(its->object, bits) : QStringList();
}

const ValueForm *encoderBitForm(std::uint16_t index)
{
    const BitObject *its = bitObjectOf(index);
    return its != nullptr ? bitForms.at(static_cast<std::size_t>(its->object)) : nullptr;
}

} // namespace codewheel::canopen
