// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_explain.h"

#include "kinds/esc/protocol/esc_bits.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel::esc {
namespace {

class Explain
{
    Q_DECLARE_TR_FUNCTIONS(EscExplain)

public:
    static QString bitDigits(std::uint16_t asSent, bool isSwapped);
    static QString address(EscLineAddress to);
    static QString value(Command command, std::uint32_t value, const ExplainOptions &options);
    static QString request(const Request &request, const ExplainOptions &options);
    static QString answer(const Request &request, const Answer &answer, const ExplainOptions &options);

private:
    static QString bits(Command command, std::uint32_t value, const ExplainOptions &options);
    static QString choice(Command command, std::uint32_t value);
    static QString number(Command command, std::uint32_t value, const ExplainOptions &options);
    static QString outside(const QString &text, Command command, ValueRange range);
};

QString hex(std::uint32_t value, int digits)
{
    return QStringLiteral("%1h").arg(value, digits, 16, QLatin1Char('0')).toUpper().replace(u'H', u'h');
}

QString decimal(std::uint32_t value)
{
    return QLocale().toString(qulonglong{value});
}

QString fractionText(std::uint32_t raw, const ExplainOptions &options)
{
    constexpr int significant = 10;
    return QLocale().toString(esc::scalingFactor(raw, options.fractionBits), 'g', significant);
}

QString Explain::address(EscLineAddress to)
{
    return to.isMaster() ? tr("00 (any encoder)") : to.onWire();
}

QString Explain::bitDigits(std::uint16_t asSent, bool isSwapped)
{
    const QString digits = hex(asSent, 4);
    return isSwapped ? sentence(tr("%1, bytes swapped %2"), {digits, hex(swappedBytes(asSent), 4)}) : digits;
}

QString Explain::bits(Command command, std::uint32_t value, const ExplainOptions &options)
{
    const auto asSent = static_cast<std::uint16_t>(value);
    const bool isSwapped = command == Command::warnings && options.swapWarningBytes;
    const QStringList said = bitTexts(command, isSwapped ? swappedBytes(asSent) : asSent);
    return sentence(tr("%1: %2"), {bitDigits(asSent, isSwapped),
                                   said.isEmpty() ? tr("none") : said.join(QStringLiteral(", "))});
}

// What the single digit of a write stands for; empty where it has another meaning or none.
QString Explain::choice(Command command, std::uint32_t value)
{
    constexpr int baudRates[] = {19'200, 9'600, 4'800};
    if (command == Command::writeDirection && value <= 1)
        return value == 1 ? tr("CCW") : tr("CW");
    if (command == Command::writeScaling && value <= 1)
        return value == 1 ? tr("on") : tr("off");
    if (command == Command::writeBaudRate && value <= 2)
        return sentence(tr("%1 Bd"), {QString::number(baudRates[value])});
    return {};
}

// `text` of a value, followed by the range it lies outside of.
QString Explain::outside(const QString &text, Command command, ValueRange range)
{
    QStringList parts{text, decimal(range.smallest), decimal(range.largest)};
    if (command == Command::deviceCode)
        parts = {text, hex(range.smallest, 4), hex(range.largest, 4)};
    else if (command == Command::scalingFactor || command == Command::writeScalingFactor)
        parts = {text, QLocale().toString(smallestFactor, 'f', 5), QLocale().toString(largestFactor, 'f', 1)};
    return sentence(tr("%1, outside %2 to %3"), parts);
}

QString Explain::value(Command command, std::uint32_t value, const ExplainOptions &options)
{
    if (!bitsOf(command).empty())
        return bits(command, value, options);
    if (const QString name = choice(command, value); !name.isEmpty())
        return sentence(QStringLiteral("%1 (%2)"), {decimal(value), name});
    const QString text = number(command, value, options);
    const ValueRange range = valueRange(command, options.fractionBits);
    return range.holds(value) ? text : outside(text, command, range);
}

QString Explain::number(Command command, std::uint32_t value, const ExplainOptions &options)
{
    switch (command) {
    case Command::serialNumber:
        return hex(value, 8);
    case Command::deviceCode:
        return hex(value, 4);
    case Command::operatingTime:
        return sentence(tr("%1 = %2 h"), {hex(value, 0), QLocale().toString(value / 10.0, 'f', 1)});
    case Command::scalingFactor:
    case Command::writeScalingFactor:
        return sentence(QStringLiteral("%1 = %2"), {hex(value, 8), fractionText(value, options)});
    default:
        return sentence(QStringLiteral("%1 = %2"), {hex(value, 0), decimal(value)});
    }
}

QString Explain::request(const Request &request, const ExplainOptions &options)
{
    const QString to = address(request.to);
    const QString name = commandName(request.command);
    if (!shapeOf(request.command).writes)
        return sentence(tr("%1: %2?"), {to, name});
    return sentence(tr("%1: set %2 to %3"), {to, name, value(request.command, request.data, options)});
}

QString Explain::answer(const Request &request, const Answer &answer, const ExplainOptions &options)
{
    switch (answer.kind) {
    case Answer::Kind::value:
        return value(request.command, answer.value,
                     {.swapWarningBytes = options.swaps(request.to), .fractionBits = options.fractionBits});
    case Answer::Kind::text:
        return QString::fromLatin1(answer.text);
    case Answer::Kind::accepted:
        return tr("accepted");
    case Answer::Kind::unknownCommand:
        return tr("command unknown (03)");
    case Answer::Kind::outOfRange:
        return tr("incomplete or out of range (05)");
    }
    return {};
}

} // namespace

QString bitDigits(std::uint16_t asSent, bool isSwapped)
{
    return Explain::bitDigits(asSent, isSwapped);
}

QString requestText(const Request &request, const ExplainOptions &options)
{
    return Explain::request(request, options);
}

std::vector<RefusalArgument> typedArguments(const Request &request, const ExplainOptions &options)
{
    return {QString::fromLatin1(request.text()), std::int64_t{options.fractionBits}};
}

QString typedText(const std::vector<RefusalArgument> &arguments)
{
    QString typed = argumentTexts(arguments).value(0);
    const auto request = parseRequest(typed.toLatin1());
    const auto *bits = arguments.size() > 1 ? std::get_if<std::int64_t>(&arguments[1]) : nullptr;
    if (!request || bits == nullptr)
        return typed;
    return sentence(QStringLiteral("%1 (%2)"),
                    {requestText(*request, {.fractionBits = static_cast<int>(*bits)}), typed});
}

QString answerText(const Request &request, const Answer &answer, const ExplainOptions &options)
{
    return Explain::answer(request, answer, options);
}

QString exchangeText(const Request &request, const Answer &answer, const ExplainOptions &options)
{
    return sentence(QStringLiteral("%1 -> %2"),
                    {requestText(request, options), answerText(request, answer, options)});
}

} // namespace codewheel::esc
