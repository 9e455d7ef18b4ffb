// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc/esc_exchange.h"

#include <QString>

#include <optional>
#include <vector>

namespace codewheel {

// Where encoders are to be looked for.
struct ScanWish
{
    std::vector<int> baudRates{19'200}; // Bd, in this order
    LineAddress first{1};
    LineAddress last{LineAddress::last};
    // Ask at the master address first: any device answers there, so only where one is alone.
    bool throughMaster = false;

    friend bool operator==(const ScanWish &, const ScanWish &) = default;
};

// An encoder that answered, with what it told of itself; nothing: it did not tell.
struct FoundEncoder
{
    LineAddress address; // 0: it answered at the master address only
    int baudRate = 0;
    std::optional<std::uint32_t> serialNumber;
    std::optional<std::uint32_t> deviceCode;
    QString version;

    friend bool operator==(const FoundEncoder &, const FoundEncoder &) = default;
};

// Looks for encoders: each address at each baud rate is asked for its serial number, and who answers is asked
// for its device code and version. Whatever well-formed answer comes, there is somebody; where nothing but
// garbage came, it is asked once more. Only reads. A machine without I/O, like a driver.
class LineScan
{
public:
    struct Step
    {
        int baudRate = 0;
        esc::Request request;
    };

    explicit LineScan(ScanWish wish);

    std::optional<Step> next() const; // nothing: done
    void answered(const esc::ExchangeResult &result);

    const std::vector<FoundEncoder> &found() const { return m_found; }
    int asked() const { return m_asked; } // addresses that were asked, all baud rates together
    int total() const { return m_total; } // to be asked
    int requests() const { return m_requests; }

private:
    enum class Question : std::uint8_t { serialNumber, deviceCode, version };

    LineAddress address() const;
    void answeredWho(const esc::ExchangeResult &result);
    void goOn();

    ScanWish m_wish;
    std::size_t m_rate = 0;
    int m_place = 0; // among the addresses of one rate
    Question m_question = Question::serialNumber;
    bool m_isSecondTry = false;
    std::vector<FoundEncoder> m_found;
    int m_asked = 0;
    int m_total;
    int m_requests = 0;
};

} // namespace codewheel
