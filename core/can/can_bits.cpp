// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_bits.h"

namespace codewheel {
namespace {

constexpr int extensionBits = 18; // of an extended identifier
constexpr std::uint32_t extensionMask = (1U << extensionBits) - 1;
constexpr int unstuffed = 1 + 2 + 7; // CRC delimiter, acknowledge with its delimiter, end of frame

// Counts the bits it is given, computes their CRC, and adds the stuff bits: one of the other level after
// five alike, which counts as the first of the next five.
class StuffedBits
{
public:
    void put(std::uint32_t bits, int count)
    {
        while (count > 0)
            put((bits >> --count & 1) != 0);
    }
    std::uint16_t crc() const { return m_crc; }
    int count() const { return m_count; }
    int stuffed() const { return m_stuffed; }

private:
    static constexpr std::uint16_t polynomial = 0x4599;
    static constexpr std::uint16_t crcMask = 0x7FFF;
    static constexpr int crcTop = 14;

    void put(bool bit)
    {
        ++m_count;
        const bool isOdd = bit != ((m_crc >> crcTop & 1) != 0);
        m_crc = (m_crc << 1 & crcMask) ^ (isOdd ? polynomial : 0);
        m_alike = bit == m_last ? m_alike + 1 : 1;
        m_last = bit;
        if (m_alike == 5) {
            ++m_stuffed;
            m_alike = 1;
            m_last = !bit;
        }
    }

    std::uint16_t m_crc = 0;
    int m_count = 0;
    int m_stuffed = 0;
    int m_alike = 0;
    bool m_last = true; // the bus is recessive before
};

// From the start of frame to the end of the data.
StuffedBits upToData(const CanFrame &frame)
{
    StuffedBits bits;
    bits.put(0, 1);
    if (frame.isExtended) {
        bits.put(frame.id >> extensionBits, 11);
        bits.put(0b11, 2); // SRR, IDE
        bits.put(frame.id & extensionMask, extensionBits);
        bits.put(frame.isRemote ? 1 : 0, 1);
        bits.put(0, 2); // reserved
    } else {
        bits.put(frame.id, 11);
        bits.put(frame.isRemote ? 1 : 0, 1);
        bits.put(0, 2); // IDE, reserved
    }
    bits.put(frame.length, 4);
    for (const std::uint8_t byte : frame.data())
        bits.put(byte, 8);
    return bits;
}

StuffedBits upToCrc(const CanFrame &frame)
{
    StuffedBits bits = upToData(frame);
    bits.put(bits.crc(), 15);
    return bits;
}

} // namespace

int canBits(const CanFrame &frame)
{
    const StuffedBits bits = upToCrc(frame);
    return bits.count() + bits.stuffed() + unstuffed;
}

std::uint16_t canCrc(const CanFrame &frame)
{
    return upToData(frame).crc();
}

std::uint32_t canPrecedence(const CanFrame &frame)
{
    const std::uint32_t remote = frame.isRemote ? 1 : 0;
    if (!frame.isExtended)
        return frame.id << 21 | remote << 20;
    const std::uint32_t base = frame.id >> extensionBits;
    return base << 21 | 0b11U << 19 | (frame.id & extensionMask) << 1 | remote;
}

} // namespace codewheel
