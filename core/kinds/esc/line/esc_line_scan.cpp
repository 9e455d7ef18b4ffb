// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_scan.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr int pairsOfReads = 3; // of one value, until two agree
constexpr int vainReads = 3;    // of one value, if something has come before

} // namespace

EscLineScan::EscLineScan(ScanWish wish)
    : m_wish(std::move(wish))
    , m_reads(pairsOfReads)
{
    for (std::size_t rate = 0; rate < m_wish.baudRates.size(); ++rate) {
        if (m_wish.throughMaster)
            m_places.push_back({rate, EscLineAddress::master()});
        for (int address = m_wish.first.value; address <= m_wish.last.value; ++address)
            m_places.push_back({rate, {static_cast<std::uint8_t>(address)}});
    }
}

std::optional<EscLineScan::Step> EscLineScan::next() const
{
    if (m_asked == m_places.size())
        return std::nullopt;
    using esc::Command;
    const Command command = m_question == Question::serialNumber ? Command::serialNumber
                            : m_question == Question::deviceCode ? Command::deviceCode
                                                                 : Command::version;
    return Step{m_wish.baudRates[place().rate], {.to = place().address, .command = command}};
}

void EscLineScan::answered(const esc::ExchangeResult &result)
{
    m_requests += result.sent;
    if (result.garbageBytes + result.lateBytes > 0)
        noteDamage();
    if (result.answer) {
        m_hasCome = true;
        readAnswered(*result.answer);
    } else if (!m_hasCome) {
        m_silent.push_back(place());
        goOn();
    } else {
        noteDamage();
        if (++m_vain == vainReads)
            told(std::nullopt);
    }
}

void EscLineScan::readAnswered(const esc::Answer &answer)
{
    switch (m_reads.add(answer)) {
    case EscAgreement::State::wantsMore:
        break;
    case EscAgreement::State::agreed:
        told(answer);
        break;
    case EscAgreement::State::disagreed:
        noteDamage();
        told(std::nullopt);
        break;
    }
}

// What it answered, including an error; empty: no two reads agreed.
void EscLineScan::told(const std::optional<esc::Answer> &answer)
{
    const bool isValue = answer && answer->kind == esc::Answer::Kind::value;
    const auto value = isValue ? std::optional(answer->value) : std::nullopt;
    switch (m_question) {
    case Question::serialNumber:
        if (!answer) {
            goOn();
            break;
        }
        m_encoder = {.address = place().address,
                     .baudRate = m_wish.baudRates[place().rate],
                     .serialNumber = value,
                     .deviceCode = {},
                     .version = {}};
        ask(Question::deviceCode);
        break;
    case Question::deviceCode:
        m_encoder.deviceCode = value;
        ask(Question::version);
        break;
    case Question::version:
        if (answer && answer->kind == esc::Answer::Kind::text)
            m_encoder.version = QString::fromLatin1(answer->text).trimmed();
        keepEncoder();
        goOn();
        break;
    }
}

void EscLineScan::ask(Question question)
{
    m_question = question;
    m_reads = EscAgreement(pairsOfReads);
    m_vain = 0;
}

// At the master address several may answer at once; that says nothing about the line.
void EscLineScan::noteDamage()
{
    m_hasCome = true;
    if (!place().address.isMaster())
        m_damaged.insert(place().rate);
}

// In the order of the search, even if some were asked a second time.
void EscLineScan::keepEncoder()
{
    const Place here = place();
    const auto before = std::ranges::upper_bound(m_foundAt, here);
    m_found.insert(m_found.begin() + (before - m_foundAt.begin()), m_encoder);
    m_foundAt.insert(before, here);
}

void EscLineScan::goOn()
{
    ask(Question::serialNumber);
    m_hasCome = false;
    ++m_asked;
    if (m_asked == m_places.size() && !std::exchange(m_isSecondRound, true))
        appendSecondRound();
}

// A request or an answer may be lost entirely.
void EscLineScan::appendSecondRound()
{
    std::ranges::copy_if(m_silent, std::back_inserter(m_places), [this](const Place &place) {
        return m_found.empty() || m_damaged.contains(place.rate);
    });
}

} // namespace codewheel
