// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/frame_meaning.h"

#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

struct FrameMeanings
{
    Q_DECLARE_TR_FUNCTIONS(FrameMeanings)
};

struct ErrorClass
{
    std::uint32_t bit;
    const char *text;
};

// linux/can/error.h
constexpr std::array errorClasses{
    ErrorClass{0x001, QT_TRANSLATE_NOOP("FrameMeanings", "not sent in time")},
    ErrorClass{0x002, QT_TRANSLATE_NOOP("FrameMeanings", "arbitration lost")},
    ErrorClass{0x004, QT_TRANSLATE_NOOP("FrameMeanings", "controller has a problem")},
    ErrorClass{0x008, QT_TRANSLATE_NOOP("FrameMeanings", "protocol violated")},
    ErrorClass{0x010, QT_TRANSLATE_NOOP("FrameMeanings", "transceiver has a problem")},
    ErrorClass{0x020, QT_TRANSLATE_NOOP("FrameMeanings", "nobody acknowledges")},
    ErrorClass{0x040, QT_TRANSLATE_NOOP("FrameMeanings", "bus off")},
    ErrorClass{0x080, QT_TRANSLATE_NOOP("FrameMeanings", "bus error")},
    ErrorClass{0x100, QT_TRANSLATE_NOOP("FrameMeanings", "controller restarted")},
    ErrorClass{0x200, QT_TRANSLATE_NOOP("FrameMeanings", "error counters")},
};

QString errorText(const CanFrame &frame)
{
    QStringList texts;
    for (const ErrorClass &each : errorClasses)
        if ((frame.id & each.bit) != 0)
            texts << FrameMeanings::tr(each.text);
    return texts.isEmpty()
               ? FrameMeanings::tr("Error frame")
               : sentence(FrameMeanings::tr("Error frame: %1"), {texts.join(QStringLiteral(", "))});
}

// The low octet of the number of its parameter group is who it is for, if the next octet is below F0h.
QString j1939Text(const CanFrame &frame)
{
    constexpr std::uint32_t firstForAll = 0xF0;
    const std::uint32_t priority = frame.id >> 26;
    const std::uint32_t group = (frame.id >> 8) & 0x3FFFF;
    const std::uint32_t source = frame.id & 0xFF;
    const QString head = QString::number(priority);
    if (((group >> 8) & 0xFF) >= firstForAll)
        return sentence(FrameMeanings::tr("J1939: priority %1, PGN %2, from %3"),
                        {head, hexNumber(group, 4), hexNumber(source, 2)});
    return sentence(FrameMeanings::tr("J1939: priority %1, PGN %2, from %3 to %4"),
                    {head, hexNumber(group & 0x3FF00, 4), hexNumber(source, 2), hexNumber(group & 0xFF, 2)});
}

} // namespace

FrameText CanFrameMeanings::next(const CanFrame &frame)
{
    if (frame.isError)
        return [frame] { return errorText(frame); };
    for (const FrameMeaning &meaning : m_ofKinds)
        if (FrameText text = meaning(frame))
            return text;
    return [frame] { return frame.isExtended ? j1939Text(frame) : QString(); };
}

} // namespace codewheel
