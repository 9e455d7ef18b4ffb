// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <QByteArray>

#include <vector>

namespace codewheel {

// The rates of the commands S0 to S8, in Bd.
inline constexpr std::array slcanRates{10'000,  20'000,  50'000,  100'000,  125'000,
                                       250'000, 500'000, 800'000, 1'000'000};

// ms at which the time stamps of an adapter begin again.
inline constexpr int slcanStampRange = 60'000;

// One thing that an SLCAN adapter (Lawicel's ASCII protocol) has sent.
struct SlcanItem
{
    enum class Kind : std::uint8_t {
        frame,
        done,    // an empty line
        sent,    // z or Z: done, and a frame was meant
        refused, // 07h
        text,    // any other line: an answer such as "V1013", what it says when it starts, or a torn frame
    };

    Kind kind = Kind::done;
    CanFrame frame{};           // without a time
    std::optional<int> stamp{}; // ms, below slcanStampRange
    QByteArray text{};

    friend bool operator==(const SlcanItem &, const SlcanItem &) = default;
};

// Takes apart what comes from an adapter, in whatever pieces. Lines end with CR, LF or CR LF.
class SlcanReader
{
public:
    std::vector<SlcanItem> read(const QByteArray &bytes);
    // Bytes of lines that cannot be printed or are too long, so far.
    std::uint64_t skipped() const { return m_skipped; }

private:
    void endLine(std::vector<SlcanItem> &items);
    void takeLine(std::vector<SlcanItem> &items);

    QByteArray m_line;
    bool m_isTooLong = false;
    bool m_wasCarriageReturn = false;
    std::uint64_t m_skipped = 0;
};

// "t1232AABB\r": to be sent.
QByteArray slcanCommand(const CanFrame &frame);
// "S5\r"; empty: there is none for this rate.
QByteArray slcanRateCommand(int rate);

// Whether it is what a Lawicel adapter answers to V: "V" and four digits.
bool isLawicelVersion(const QByteArray &text);
// Whether there are words in it: it is no torn frame, but what a board says when it starts.
bool hasWords(const QByteArray &text);
// The bits of "F00"; empty: it is another text.
std::optional<std::uint8_t> slcanStatusBits(const QByteArray &text);

} // namespace codewheel
