// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/k3_explain.h"

#include <algorithm>
#include <array>

namespace codewheel::k3 {
namespace {

constexpr std::array frabaErrors{0U, 1U, 2U, 3U};
constexpr std::array baumerErrors{0U, 1U, 2U, 3U, 13U, 14U, 15U};
constexpr unsigned manufacturerErrors = 12; // 980000xx, FRABA
constexpr unsigned unknownReadOut = 2;      // A40000nn
constexpr Word largestCode = 0xFF;

bool isErrorSent(Word in, Dialect dialect)
{
    const bool isFraba = dialect != Dialect::baumer && std::ranges::count(frabaErrors, number(in)) > 0;
    const bool isBaumer = dialect != Dialect::fraba && std::ranges::count(baumerErrors, number(in)) > 0;
    if (dialect != Dialect::baumer && number(in) == manufacturerErrors)
        return data(in) <= largestCode;
    return data(in) == 0 && (isFraba || isBaumer);
}

bool isReadOutSent(Word in)
{
    return number(in) == 0 || (number(in) == unknownReadOut && data(in) <= largestCode);
}

// A Baumer confirms any number; in cam mode a FRABA confirms the words of its cams, with D29 = 1 those of
// their ends.
bool isConfirmationSent(Word in, Dialect dialect)
{
    if ((in & manufacturerBit) != 0)
        return dialect != Dialect::baumer && number(in) < camCount;
    return dialect != Dialect::fraba || number(in) == 0 || isKnownNumber(number(in));
}

} // namespace

bool canSend(Word in, Dialect dialect) noexcept
{
    if (isOperation(in))
        return (in & (manufacturerBit | numberMask)) == 0;
    if (isConfirmation(in))
        return isConfirmationSent(in, dialect);
    if (!isErrorOrReadOut(in))
        return false;
    if (isReadOutAnswer(in))
        return dialect != Dialect::baumer && isReadOutSent(in);
    return isErrorSent(in, dialect);
}

} // namespace codewheel::k3
