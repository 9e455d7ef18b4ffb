// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/driver/esc_agreement.h"
#include "kinds/esc/protocol/esc_exchange.h"

#include <QString>

#include <optional>
#include <set>
#include <vector>

namespace codewheel {

// Where to look for encoders.
struct ScanWish
{
    std::vector<int> baudRates{19'200}; // Bd, in this order
    EscLineAddress first{1};
    EscLineAddress last{EscLineAddress::last};
    // Ask at the master address first: any device answers there, so it only works for a device that is alone.
    bool throughMaster = false;

    friend bool operator==(const ScanWish &, const ScanWish &) = default;
};

// An encoder that answered, with what it reported of itself; empty: not reported.
struct FoundEncoder
{
    EscLineAddress address; // 0: it answered at the master address only
    int baudRate = 0;
    std::optional<std::uint32_t> serialNumber;
    std::optional<std::uint32_t> deviceCode;
    QString version;

    friend bool operator==(const FoundEncoder &, const FoundEncoder &) = default;
};

// Searches for encoders: each address at each baud rate is asked for its serial number, and whoever answers
// is asked for its device code and version. The protocol has no checksum, so an encoder and its values are
// accepted when two reads agree, errors (03, 05) included; if anything came in, a read is repeated like any
// other. Addresses that stayed silent are asked once more at the end, but only at baud rates at which
// something corrupted was seen, and if no encoder was found at all: each costs a time-out. Only reads. A
// state machine without I/O, like a driver.
class EscLineScan
{
public:
    struct Step
    {
        int baudRate = 0;
        esc::Request request;
    };

    explicit EscLineScan(ScanWish wish);

    std::optional<Step> next() const; // empty: done
    void answered(const esc::ExchangeResult &result);

    const std::vector<FoundEncoder> &found() const { return m_found; }
    // Addresses asked so far, over all baud rates, and to be asked: more once some are to be asked a second
    // time.
    int asked() const { return static_cast<int>(m_asked); }
    int total() const { return static_cast<int>(m_places.size()); }
    int requests() const { return m_requests; }

private:
    enum class Question : std::uint8_t { serialNumber, deviceCode, version };
    struct Place
    {
        std::size_t rate = 0; // its index among the baud rates
        EscLineAddress address;

        // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
        // NOLINTNEXTLINE(modernize-use-nullptr)
        friend auto operator<=>(const Place &, const Place &) = default;
    };

    const Place &place() const { return m_places[m_asked]; }
    void readAnswered(const esc::Answer &answer);
    void told(const std::optional<esc::Answer> &answer);
    void ask(Question question);
    void noteDamage();
    void keepEncoder();
    void goOn();
    void appendSecondRound();

    ScanWish m_wish;
    std::vector<Place> m_places;
    std::size_t m_asked = 0;
    Question m_question = Question::serialNumber;
    EscAgreement m_reads;
    int m_vain = 0;         // reads without an answer
    bool m_hasCome = false; // anything, from this place
    FoundEncoder m_encoder; // the one being asked
    std::vector<FoundEncoder> m_found;
    std::vector<Place> m_foundAt;
    std::vector<Place> m_silent;
    std::set<std::size_t> m_damaged; // indices of baud rates
    bool m_isSecondRound = false;
    int m_requests = 0;
};

} // namespace codewheel
