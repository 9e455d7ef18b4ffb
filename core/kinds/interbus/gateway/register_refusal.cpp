// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/register_refusal.h"

#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/register_texts.h"

namespace codewheel {
namespace {

constexpr int firstFunctionThatWrites = 16; // of those that are used: 3, 4, 16, 23
constexpr int exceptionOfFailure = 4;
constexpr int exceptionOfAcknowledge = 5; // in progress
constexpr int exceptionOfBusy = 6;
constexpr int exceptionOfNoPath = 10;
constexpr int exceptionOfSilentTarget = 11;
constexpr int firstExceptionOfMap = 1; // illegal function, address, or value
constexpr int lastExceptionOfMap = 3;

// With the others the unit goes on with it, or is one behind the gateway that may have heard it.
constexpr bool isRefusal(std::int64_t exception)
{
    return exception != exceptionOfAcknowledge && exception != exceptionOfSilentTarget;
}

constexpr bool isExceptionOfMap(std::int64_t exception)
{
    return exception >= firstExceptionOfMap && exception <= lastExceptionOfMap;
}

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

bool isNotCarriedOut(const RegisterError &error)
{
    return error.kind == RegisterError::Kind::exception && isRefusal(error.exception);
}

bool isNotCarriedOut(const Refusal &refusal)
{
    return refusal.id == GatewayRefusalId::outputsBlocked ||
           (refusal.id == GatewayRefusalId::registersRefused &&
            isRefusal(std::get<std::int64_t>(refusal.arguments[2])));
}

QString registersText(int function, const RegisterBlock &block)
{
    return registersText(registersKey(function, block.first, block.count));
}

Refusal registerRefusal(const RegisterError &error, const QString &port, int function,
                        const RegisterBlock &block, int tries)
{
    const QString registers = registersKey(function, block.first, block.count);
    switch (error.kind) {
    case RegisterError::Kind::noAnswer:
        return {RefusalKind::link,
                error.isLate ? GatewayRefusalId::registersLate : GatewayRefusalId::registersUnanswered,
                {port, registers, std::int64_t{tries}}};
    case RegisterError::Kind::exception:
        if (error.exception == exceptionOfFailure && function >= firstFunctionThatWrites)
            return {RefusalKind::link, GatewayRefusalId::outputsBlocked, {port, registers}};
        return {RefusalKind::link,
                GatewayRefusalId::registersRefused,
                {port, registers, std::int64_t{error.exception}}};
    case RegisterError::Kind::wrongAnswer:
        return {RefusalKind::link, GatewayRefusalId::registersGarbled, {port, registers, error.text}};
    case RegisterError::Kind::closed:
        if (error.isAtOnce)
            return {RefusalKind::link, GatewayRefusalId::closedUnanswered, {port}};
        return {RefusalKind::link, RefusalId::connectionClosed, {port}};
    case RegisterError::Kind::unplugged:
        return {RefusalKind::link, RefusalId::portLost, {port}};
    case RegisterError::Kind::stopped:
        return {RefusalKind::stopped, RefusalId::cancelled, {}};
    }
    return {RefusalKind::link, RefusalId::linkFailed, {error.text}};
}

bool isOfMap(const RegisterError &error)
{
    return error.kind == RegisterError::Kind::exception && isExceptionOfMap(error.exception);
}

bool isOfMap(const Refusal &refusal)
{
    return refusal.id == GatewayRefusalId::registersRefused &&
           isExceptionOfMap(std::get<std::int64_t>(refusal.arguments[2]));
}

} // namespace codewheel
