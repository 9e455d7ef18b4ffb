// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/register_refusal.h"

#include "kinds/interbus/gateway/gateway_texts.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

constexpr int firstFunctionThatWrites = 16; // of those that are used: 3, 4, 16, 23
constexpr int exceptionOfFailure = 4;
constexpr int exceptionOfAcknowledge = 5; // in progress
constexpr int exceptionOfBusy = 6;
constexpr int exceptionOfNoPath = 10;
constexpr int exceptionOfSilentTarget = 11;
constexpr int exceptionOfValue = 3;
constexpr int firstExceptionOfMap = 1; // illegal function, address, or value
constexpr int lastExceptionOfMap = exceptionOfValue;
constexpr int registersOfWord = 2;

} // namespace

int readFunction(RegisterArea area)
{
    return area == RegisterArea::input ? 4 : 3;
}

bool isBusy(const RegisterError &error)
{
    return error.kind == RegisterError::Kind::exception &&
           (error.exception == exceptionOfAcknowledge || error.exception == exceptionOfBusy ||
            error.exception == exceptionOfNoPath || error.exception == exceptionOfSilentTarget);
}

bool isWorthRepeating(const RegisterError &error)
{
    using Kind = RegisterError::Kind;
    return error.kind == Kind::noAnswer || error.kind == Kind::wrongAnswer || isBusy(error);
}

QString registersText(int function, const RegisterBlock &block)
{
    const QString of = QString::number(function);
    if (block.count == 1)
        return sentence(GatewayTexts::tr("function %1, register %2"), {of, QString::number(block.first)});
    return sentence(GatewayTexts::tr("function %1, registers %2 to %3"),
                    {of, QString::number(block.first), QString::number(block.end() - 1)});
}

QString exceptionText(int code)
{
    switch (code) {
    case 0:
        return GatewayTexts::tr("0 is no exception code: its answer is faulty.");
    case 1:
        return GatewayTexts::tr("it does not have this function.");
    case 2:
        return GatewayTexts::tr(
            "it does not have these registers. Its image is shorter, or begins elsewhere.");
    case 3:
        return GatewayTexts::tr("it does not accept this value or this number of registers.");
    case 4:
        return GatewayTexts::tr("it failed while carrying this out.");
    case 5:
        return GatewayTexts::tr("it has accepted the request and needs longer for it.");
    case 6:
        return GatewayTexts::tr("it is busy.");
    case 8:
        return GatewayTexts::tr("its memory is damaged.");
    case 10:
        return GatewayTexts::tr("the gateway has no path to the unit. Check the unit number.");
    case 11:
        return GatewayTexts::tr("the unit behind the gateway does not answer.");
    default:
        return GatewayTexts::tr("this code is not in the standard.");
    }
}

namespace {

// A limit of the gateway shows nowhere else: the test of the connection writes nothing.
QString whyRefused(int code, int function, const RegisterBlock &block)
{
    return code == exceptionOfValue && function >= firstFunctionThatWrites && block.count > registersOfWord
               ? GatewayTexts::tr(
                     "it does not accept so many registers at once, or not these values. Set fewer "
                     "registers in a write, in the connection.")
               : exceptionText(code);
}

} // namespace

Refusal registerRefusal(const RegisterError &error, const QString &port, int function,
                        const RegisterBlock &block, int tries)
{
    const QString registers = registersText(function, block);
    switch (error.kind) {
    case RegisterError::Kind::noAnswer:
        return {RefusalKind::link,
                error.isLate ? RefusalId::registersLate : RefusalId::registersUnanswered,
                {port, registers, std::int64_t{tries}}};
    case RegisterError::Kind::exception:
        if (error.exception == exceptionOfFailure && function >= firstFunctionThatWrites)
            return {RefusalKind::link, RefusalId::outputsBlocked, {port, registers}};
        return {
            RefusalKind::link,
            RefusalId::registersRefused,
            {port, registers, std::int64_t{error.exception}, whyRefused(error.exception, function, block)}};
    case RegisterError::Kind::wrongAnswer:
        return {RefusalKind::link, RefusalId::registersGarbled, {port, registers, error.text}};
    case RegisterError::Kind::closed:
        return {RefusalKind::link, RefusalId::connectionClosed, {port}};
    case RegisterError::Kind::unplugged:
        return {RefusalKind::link, RefusalId::portLost, {port}};
    case RegisterError::Kind::stopped:
        return {RefusalKind::stopped, RefusalId::cancelled, {}};
    }
    return {RefusalKind::link, RefusalId::linkFailed, {error.text}};
}

bool isOfMap(const Refusal &refusal)
{
    if (refusal.id != RefusalId::registersRefused)
        return false;
    const auto code = std::get<std::int64_t>(refusal.arguments[2]);
    return code >= firstExceptionOfMap && code <= lastExceptionOfMap;
}

} // namespace codewheel
