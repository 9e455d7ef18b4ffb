// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/emcy.h"

#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

struct EmcyTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenEmcy)
};

struct EmcyCode
{
    std::uint16_t code;
    std::uint16_t mask; // of its class
    const char *text;
};

// CiA 301, table 26: a code, then its class.
constexpr std::array emcyCodes{
    EmcyCode{0x8110, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "frames lost")},
    EmcyCode{0x8120, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "error passive")},
    EmcyCode{0x8130, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "guarding or heartbeat")},
    EmcyCode{0x8140, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "back from bus off")},
    EmcyCode{0x8150, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "identifier collision")},
    EmcyCode{0x8210, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "PDO too short")},
    EmcyCode{0x8220, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "PDO too long")},
    EmcyCode{0x8240, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "SYNC of unexpected length")},
    EmcyCode{0x8250, 0xFFFF, QT_TRANSLATE_NOOP("CanopenEmcy", "PDO did not come in time")},
    EmcyCode{0x1000, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "error")},
    EmcyCode{0x2000, 0xF000, QT_TRANSLATE_NOOP("CanopenEmcy", "current")},
    EmcyCode{0x3000, 0xF000, QT_TRANSLATE_NOOP("CanopenEmcy", "voltage")},
    EmcyCode{0x4000, 0xF000, QT_TRANSLATE_NOOP("CanopenEmcy", "temperature")},
    EmcyCode{0x5000, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "hardware")},
    EmcyCode{0x6000, 0xF000, QT_TRANSLATE_NOOP("CanopenEmcy", "software")},
    EmcyCode{0x7000, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "additional modules")},
    EmcyCode{0x8100, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "communication")},
    EmcyCode{0x8200, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "protocol")},
    EmcyCode{0x8000, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "monitoring")},
    EmcyCode{0x9000, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "external error")},
    EmcyCode{0xF000, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "additional functions")},
    EmcyCode{0xFF00, 0xFF00, QT_TRANSLATE_NOOP("CanopenEmcy", "of the maker")},
};

// Object 1001h, from bit 0 on.
constexpr std::array registerBits{
    QT_TRANSLATE_NOOP("CanopenEmcy", "error"),
    QT_TRANSLATE_NOOP("CanopenEmcy", "current"),
    QT_TRANSLATE_NOOP("CanopenEmcy", "voltage"),
    QT_TRANSLATE_NOOP("CanopenEmcy", "temperature"),
    QT_TRANSLATE_NOOP("CanopenEmcy", "communication"),
    QT_TRANSLATE_NOOP("CanopenEmcy", "profile"),
    static_cast<const char *>(nullptr),
    QT_TRANSLATE_NOOP("CanopenEmcy", "of the maker"),
};

} // namespace

std::optional<Emcy> Emcy::read(Octets data)
{
    constexpr std::size_t size = 8;
    if (data.size() != size)
        return std::nullopt;
    Emcy emcy{static_cast<std::uint16_t>(numberOf(data.first(2))), data[2]};
    std::ranges::copy(data.subspan(3), emcy.ofMaker.begin());
    return emcy;
}

QString Emcy::text() const
{
    QString digits = hexNumber(code, 4);
    if (isGone())
        return sentence(EmcyTexts::tr("%1, error gone"), {digits});
    for (const EmcyCode &each : emcyCodes)
        if ((code & each.mask) == each.code)
            return QStringLiteral("%1, %2").arg(digits, EmcyTexts::tr(each.text));
    return digits;
}

QStringList Emcy::registerTexts() const
{
    QStringList texts;
    for (std::size_t bit = 0; bit < registerBits.size(); ++bit)
        if ((errorRegister >> bit & 1) != 0 && registerBits[bit] != nullptr)
            texts << EmcyTexts::tr(registerBits[bit]);
    return texts;
}

} // namespace codewheel::canopen
