// SPDX-License-Identifier: GPL-3.0-or-later
#include "line/line_scan.h"

namespace codewheel {
namespace {

int addressesPerRate(const ScanWish &wish)
{
    return wish.last.value - wish.first.value + 1 + (wish.throughMaster ? 1 : 0);
}

std::optional<std::uint32_t> valueIn(const esc::ExchangeResult &result)
{
    const bool isValue = result.answer && result.answer->kind == esc::Answer::Kind::value;
    return isValue ? std::optional(result.answer->value) : std::nullopt;
}

} // namespace

LineScan::LineScan(ScanWish wish)
    : m_wish(std::move(wish))
    , m_total(addressesPerRate(m_wish) * static_cast<int>(m_wish.baudRates.size()))
{}

LineAddress LineScan::address() const
{
    if (m_wish.throughMaster && m_place == 0)
        return LineAddress::master();
    const int index = m_place - (m_wish.throughMaster ? 1 : 0);
    return {static_cast<std::uint8_t>(m_wish.first.value + index)};
}

std::optional<LineScan::Step> LineScan::next() const
{
    if (m_asked == m_total)
        return std::nullopt;
    using esc::Command;
    const Command command = m_question == Question::serialNumber ? Command::serialNumber
                            : m_question == Question::deviceCode ? Command::deviceCode
                                                                 : Command::version;
    return Step{m_wish.baudRates[m_rate], {.to = address(), .command = command}};
}

void LineScan::answered(const esc::ExchangeResult &result)
{
    m_requests += result.sent;
    switch (m_question) {
    case Question::serialNumber:
        answeredWho(result);
        return;
    case Question::deviceCode:
        m_found.back().deviceCode = valueIn(result);
        m_question = Question::version;
        return;
    case Question::version:
        if (result.answer && result.answer->kind == esc::Answer::Kind::text)
            m_found.back().version = QString::fromLatin1(result.answer->text).trimmed();
        goOn();
        return;
    }
}

void LineScan::answeredWho(const esc::ExchangeResult &result)
{
    const bool isDisturbed = !result.answer && result.garbageBytes + result.lateBytes > 0;
    if (isDisturbed && !m_isSecondTry) {
        m_isSecondTry = true;
        return;
    }
    if (!result.answer) {
        goOn();
        return;
    }
    m_found.push_back({.address = address(),
                       .baudRate = m_wish.baudRates[m_rate],
                       .serialNumber = valueIn(result),
                       .deviceCode = {},
                       .version = {}});
    m_question = Question::deviceCode;
}

void LineScan::goOn()
{
    m_question = Question::serialNumber;
    m_isSecondTry = false;
    ++m_asked;
    if (++m_place < addressesPerRate(m_wish))
        return;
    m_place = 0;
    ++m_rate;
}

} // namespace codewheel
