// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/register_texts.h"

#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/gateway_texts.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr int firstFunctionThatWrites = 16; // of those that are used: 3, 4, 16, 23
constexpr int exceptionOfValue = 3;
constexpr int registersOfWord = 2;
constexpr QChar betweenNumbers = u'/';

struct RegistersOfKey
{
    int function = 0;
    int first = 0;
    int count = 0;
};

std::optional<RegistersOfKey> registersOf(const QString &key)
{
    constexpr qsizetype numbers = 3;
    std::array<int, numbers> all{};
    const QStringList parts = key.split(betweenNumbers);
    bool isKey = parts.size() == numbers;
    for (std::size_t i = 0; isKey && i < all.size(); ++i)
        all[i] = parts[static_cast<qsizetype>(i)].toInt(&isKey);
    return isKey ? std::optional(RegistersOfKey{all[0], all[1], all[2]}) : std::nullopt;
}

struct WrongAnswerRows
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::GatewayTexts)

public:
    static constexpr auto all = std::to_array<KeyedText<WrongAnswer>>({
        {WrongAnswer::incomplete, "incomplete",
         QT_TR_NOOP("it is incomplete. Look for newer firmware of the gateway.")},
        {WrongAnswer::damaged, "damaged",
         QT_TR_NOOP("it is damaged or incomplete. Check cable, shield, terminating resistors, baud rate, and "
                    "format.")},
        {WrongAnswer::notModbus, "notModbus",
         QT_TR_NOOP("it is not Modbus. Check the port: something else listens there.")},
        {WrongAnswer::unit, "unit",
         QT_TR_NOOP("it is of unit %1. Check the unit number, and on a serial line whether two devices have "
                    "the same.")},
        {WrongAnswer::transaction, "transaction",
         QT_TR_NOOP("it is for transaction %1, not %2. Look for newer firmware of the gateway.")},
        {WrongAnswer::oneTransaction, "oneTransaction",
         QT_TR_NOOP("each is for transaction %1: the gateway does not repeat the number of the request, as "
                    "Modbus/TCP wants it. Use Modbus RTU, if it has that, or look for newer firmware.")},
        {WrongAnswer::function, "function",
         QT_TR_NOOP("it is for function %1. Look for newer firmware of the gateway.")},
        {WrongAnswer::length, "length",
         QT_TR_NOOP("it has %1 bytes instead of %2. Compare the number of registers with the manual of the "
                    "gateway, or look for newer firmware.")},
        {WrongAnswer::otherRegisters, "otherRegisters",
         QT_TR_NOOP(
             "it names other registers than those to be written. Look for newer firmware of the gateway.")},
        {WrongAnswer::count, "count",
         QT_TR_NOOP("it counts its own bytes wrong. Look for newer firmware of the gateway.")},
        {WrongAnswer::lengthOfException, "lengthOfException",
         QT_TR_NOOP("it is an exception of the wrong length. Look for newer firmware of the gateway.")},
        {WrongAnswer::another, "another",
         QT_TR_NOOP(
             "another one follows it. Check whether two devices on the line have the same unit number.")},
        {WrongAnswer::noPause, "noPause",
         QT_TR_NOOP(
             "something on the line does not stop sending. Look for another master, or a faulty device.")},
    });
};

constexpr auto exceptionRows = std::to_array<TextOf<int>>({
    {0, QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "0 is no exception code: its answer is faulty.")},
    {1, QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "it does not have this function.")},
    {2, QT_TRANSLATE_NOOP("codewheel::GatewayTexts",
                          "it does not have these registers. Its image is shorter, or begins elsewhere.")},
    {3, QT_TRANSLATE_NOOP("codewheel::GatewayTexts",
                          "it does not accept this value or this number of registers.")},
    {4, QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "it failed while carrying this out.")},
    {5, QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "it has accepted the request and needs longer for it.")},
    {6, QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "it is busy.")},
    {8, QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "its memory is damaged.")},
    {10, QT_TRANSLATE_NOOP("codewheel::GatewayTexts",
                           "the gateway has no path to the unit. Check the unit number.")},
    {11, QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "the unit behind the gateway does not answer.")},
});

// A limit of the gateway shows nowhere else: the test of the connection writes nothing.
QString whyRefused(int code, const std::optional<RegistersOfKey> &registers)
{
    const bool writesMore =
        registers && registers->function >= firstFunctionThatWrites && registers->count > registersOfWord;
    return code == exceptionOfValue && writesMore
               ? GatewayTexts::tr(
                     "it does not accept so many registers at once, or not these values. Set fewer "
                     "registers in a write, in the connection.")
               : exceptionText(code);
}

} // namespace

QString registersKey(int function, int first, int count)
{
    return QStringLiteral("%1/%2/%3").arg(function).arg(first).arg(count);
}

QString registersText(const QString &key)
{
    const auto its = registersOf(key);
    if (!its)
        return key;
    const QString function = QString::number(its->function);
    const QString first = QString::number(its->first);
    if (its->count == 1)
        return sentence(GatewayTexts::tr("function %1, register %2"), {function, first});
    return sentence(GatewayTexts::tr("function %1, registers %2 to %3"),
                    {function, first, QString::number(its->first + its->count - 1)});
}

QString exceptionText(int code)
{
    return GatewayTexts::tr(
        textFor(exceptionRows, code,
                QT_TRANSLATE_NOOP("codewheel::GatewayTexts", "this code is not in the standard.")));
}

QString wrongAnswerKey(WrongAnswer what, std::initializer_list<int> numbers)
{
    QStringList parts{
        QString::fromLatin1(std::ranges::find(WrongAnswerRows::all, what, &KeyedText<WrongAnswer>::id)->key)};
    for (const int number : numbers)
        parts << QString::number(number);
    return parts.join(betweenNumbers);
}

QString wrongAnswerText(const QString &key)
{
    const QStringList parts = key.split(betweenNumbers);
    const auto *row = rowByKey(WrongAnswerRows::all, parts.front());
    return row == nullptr ? key : sentence(GatewayTexts::tr(row->text), parts.sliced(1));
}

QStringList registerRefusalTexts(const Refusal &refusal)
{
    constexpr qsizetype registersAt = 1;
    constexpr qsizetype detailAt = 2; // what was wrong, or the code of the exception
    QStringList parts = argumentTexts(refusal.arguments);
    if (parts.size() <= registersAt)
        return parts;
    const auto registers = registersOf(parts[registersAt]);
    parts[registersAt] = registersText(parts[registersAt]);
    if (parts.size() != detailAt + 1)
        return parts;
    if (refusal.id == GatewayRefusalId::registersGarbled)
        parts[detailAt] = wrongAnswerText(parts[detailAt]);
    if (const auto *code = std::get_if<std::int64_t>(&refusal.arguments[detailAt]);
        code != nullptr && refusal.id == GatewayRefusalId::registersRefused)
        parts << whyRefused(static_cast<int>(*code), registers);
    return parts;
}

} // namespace codewheel
