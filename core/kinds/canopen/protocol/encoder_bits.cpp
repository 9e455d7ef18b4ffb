// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/encoder_bits.h"

#include "catalog/device_description.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/find_by.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <functional>

namespace codewheel::canopen {
namespace {

struct EncoderBitTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenBit)
};

enum class BitsOf : std::uint8_t { operating, alarms, warnings, area };

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
    EncoderBit{BitsOf::area, 2, QT_TRANSLATE_NOOP("CanopenBit", "below the work area")},
    EncoderBit{BitsOf::area, 1, QT_TRANSLATE_NOOP("CanopenBit", "above the work area")},
    EncoderBit{BitsOf::area, 0, QT_TRANSLATE_NOOP("CanopenBit", "outside the work area")},
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
    BitObject{0x6400, BitsOf::area},
};

QString unnamed(BitsOf object, unsigned bit)
{
    const QString number = QString::number(bit);
    return object != BitsOf::area && bit >= firstMakersBit
               ? sentence(EncoderBitTexts::tr("bit %1 (of the maker)"), {number})
               : sentence(EncoderBitTexts::tr("bit %1 (not described)"), {number});
}

// As the description names this bit of an object; empty: it does not.
QString describedName(const DeviceDescription &device, std::uint16_t index, unsigned bit)
{
    const auto its = std::ranges::find_if(device.parameters, [&](const ParameterDescription &each) {
        const CanopenReach *reach = canopenReach(each);
        return reach != nullptr && reach->object.index == index && reach->bit == bit;
    });
    return its != device.parameters.end() ? parameterNameInText(device, its->parameter) : QString();
}

using BitName = std::function<QString(unsigned)>;

QStringList textsOf(BitsOf object, std::uint32_t bits, const BitName &described = {})
{
    constexpr unsigned highestBit = 31;
    QStringList texts;
    for (unsigned bit = highestBit + 1; bit-- > 0;) {
        const bool isSet = (bits >> bit & 1) != 0;
        if (const QString name = isSet && described ? described(bit) : QString(); !name.isEmpty()) {
            texts << name;
            continue;
        }
        const auto row = std::ranges::find_if(
            encoderBits, [&](const EncoderBit &each) { return each.object == object && each.bit == bit; });
        if (row == encoderBits.end()) {
            if (isSet)
                texts << unnamed(object, bit);
        } else if (const char *text = isSet ? row->set : row->clear) {
            texts << EncoderBitTexts::tr(text);
        }
    }
    return texts;
}

template <BitsOf object>
QString bitsText(std::int64_t value, const KindData & /*options*/)
{
    constexpr int digits = object == BitsOf::area ? 2 : 4;
    const auto bits = static_cast<std::uint32_t>(value);
    const QStringList texts = textsOf(object, bits);
    return QStringLiteral("%1 (%2)").arg(hexNumber(bits, digits), texts.isEmpty()
                                                                      ? EncoderBitTexts::tr("none")
                                                                      : texts.join(QStringLiteral(", ")));
}

constexpr ValueForm operatingForm{.text = bitsText<BitsOf::operating>};
constexpr ValueForm alarmForm{.text = bitsText<BitsOf::alarms>};
constexpr ValueForm warningForm{.text = bitsText<BitsOf::warnings>};
constexpr ValueForm areaForm{.text = bitsText<BitsOf::area>};
constexpr std::array bitForms{&operatingForm, &alarmForm, &warningForm, &areaForm};

// Two octets each: that of the profile, that of the software.
QString versionsText(std::int64_t value, const KindData & /*options*/)
{
    constexpr int digits = 8;
    const auto octet = [value](unsigned shift) { return QString::number(value >> shift & 0xFF); };
    return QStringLiteral("%1 (%2)").arg(hexNumber(static_cast<std::uint32_t>(value), digits),
                                         sentence(EncoderBitTexts::tr("profile %1.%2, software %3.%4"),
                                                  {octet(8), octet(0), octet(24), octet(16)}));
}

bool isNotSupported(std::int64_t operatingTime)
{
    return operatingTime == 0xFFFF'FFFF;
}

// In tenths of an hour.
QString operatingTimeText(std::int64_t value, const KindData & /*options*/)
{
    constexpr double tenths = 10;
    return isNotSupported(value) ? EncoderBitTexts::tr("not supported")
                                 : QLocale().toString(static_cast<double>(value) / tenths, 'f', 1);
}

constexpr ValueForm versionsForm{.text = versionsText};
constexpr ValueForm operatingTimeForm{.text = operatingTimeText, .isInWords = isNotSupported};

} // namespace

QStringList encoderBitTexts(std::uint16_t index, std::uint32_t bits)
{
    const BitObject *its = findBy(bitObjects, index, &BitObject::index);
    return its != nullptr ? textsOf(its->object, bits) : QStringList();
}

QStringList encoderBitTexts(const DeviceDescription &device, std::uint16_t index, std::uint32_t bits)
{
    const BitObject *its = findBy(bitObjects, index, &BitObject::index);
    if (its == nullptr)
        return {};
    return textsOf(its->object, bits,
                   [&device, index](unsigned bit) { return describedName(device, index, bit); });
}

const ValueForm *encoderValueForm(std::uint16_t index)
{
    if (index == object::versions.index)
        return &versionsForm;
    if (index == object::operatingTime.index)
        return &operatingTimeForm;
    const BitObject *its = findBy(bitObjects, index, &BitObject::index);
    return its != nullptr ? bitForms.at(static_cast<std::size_t>(its->object)) : nullptr;
}

} // namespace codewheel::canopen
