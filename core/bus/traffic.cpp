// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/traffic.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The translation context of these texts.
struct Traffic
{
    Q_DECLARE_TR_FUNCTIONS(Traffic)
};

constexpr uchar firstPrintable = 0x20;
constexpr uchar deleteCharacter = 0x7F;
constexpr char16_t controlPictures = 0x2400; // the one for 00h; the others follow
constexpr char16_t deletePicture = 0x2421;
constexpr uchar escape = 0x1B;
constexpr uchar carriageReturn = 0x0D;
constexpr uchar lineFeed = 0x0A;

bool isControl(uchar code)
{
    return code < firstPrintable || code == deleteCharacter;
}

QChar picture(uchar code)
{
    return code == deleteCharacter ? deletePicture : static_cast<char16_t>(controlPictures + code);
}

QChar sign(uchar code)
{
    switch (code) {
    case escape:
        return u'\u238B';
    case carriageReturn:
        return u'\u21B5';
    case lineFeed:
        return u'\u2193';
    default:
        return u'\u25AF'; // its number is shown beside it
    }
}

} // namespace

QString FrameIdentifier::text() const
{
    return QStringLiteral("%1").arg(number, isLong ? 8 : 3, 16, QLatin1Char('0')).toUpper();
}

QString rowKindWord(TrafficKind kind)
{
    switch (kind) {
    case TrafficKind::sent:
        return Traffic::tr("sent");
    case TrafficKind::answer:
        return Traffic::tr("answer");
    case TrafficKind::echo:
        return Traffic::tr("echo");
    case TrafficKind::garbage:
        return Traffic::tr("garbage");
    case TrafficKind::late:
        break;
    }
    return Traffic::tr("late");
}

QString controlText(const QByteArray &bytes, ControlCharacters controls)
{
    QString text;
    for (const char byte : bytes) {
        const auto code = static_cast<uchar>(byte);
        if (isControl(code) && controls != ControlCharacters::numbers)
            text += controls == ControlCharacters::pictures ? picture(code) : sign(code);
        else if (code < firstPrintable || code >= deleteCharacter)
            text += QStringLiteral("<%1>").arg(byteText(QByteArray(1, byte)));
        else
            text += QLatin1Char(byte);
    }
    return text;
}

QString byteText(const QByteArray &bytes)
{
    return QString::fromLatin1(bytes.toHex(' ').toUpper());
}

} // namespace codewheel
