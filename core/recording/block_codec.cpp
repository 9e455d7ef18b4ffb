// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/block_codec.h"

#include "recording/number_series.h"

namespace codewheel {
namespace {

constexpr std::uint8_t blockFormat = 1;
constexpr qsizetype checksumSize = 2;

void packGaps(QByteArray &bytes, const RecordedBlock &block)
{
    packNumber(bytes, block.gaps.size());
    std::size_t before = 0;
    for (const RecordedBlock::GapBefore &gap : block.gaps) {
        packNumber(bytes, gap.index - before);
        packNumber(bytes, static_cast<std::uint64_t>((block.samples[gap.index].at - gap.from).count()));
        before = gap.index;
    }
}

struct PackedGap
{
    std::size_t index;
    std::uint64_t length; // microseconds
};

std::optional<std::vector<PackedGap>> unpackGaps(PackedBytes &bytes, std::size_t samples)
{
    const auto count = bytes.number();
    if (!count || *count > samples)
        return std::nullopt;
    std::vector<PackedGap> gaps;
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto distance = bytes.number();
        const auto length = bytes.number();
        if (!distance || !length || *distance >= samples || (i > 0 && *distance == 0))
            return std::nullopt;
        const std::size_t index = (i > 0 ? gaps.back().index : 0) + *distance;
        if (index >= samples)
            return std::nullopt;
        gaps.push_back({index, *length});
    }
    return gaps;
}

// Each lies between two samples; before the first one there is room back to the beginning of time.
bool takeGaps(RecordedBlock &block, const std::vector<PackedGap> &gaps)
{
    for (const PackedGap &gap : gaps) {
        const Instant at = block.samples[gap.index].at;
        const Instant earliest = gap.index > 0 ? block.samples[gap.index - 1].at : Instant(0);
        if (at < earliest || gap.length > static_cast<std::uint64_t>((at - earliest).count()))
            return false;
        block.gaps.push_back({gap.index, at - Instant(static_cast<std::int64_t>(gap.length))});
    }
    return true;
}

} // namespace

Summary RecordedBlock::summary() const
{
    const auto of = [](const Sample &sample) {
        const auto word = static_cast<std::uint32_t>(sample.value);
        return Summary{{sample.value, sample.value}, word, word};
    };
    Summary all = of(samples.front());
    for (const Sample &sample : samples)
        all.include(of(sample));
    return all;
}

QByteArray packBlock(const RecordedBlock &block)
{
    std::vector<std::int64_t> times;
    std::vector<std::int64_t> values;
    times.reserve(block.samples.size());
    values.reserve(block.samples.size());
    for (const Sample &sample : block.samples) {
        times.push_back(sample.at.count());
        values.push_back(sample.value);
    }
    QByteArray bytes;
    bytes.reserve(qsizetype{4} * std::ssize(block.samples));
    bytes.append(static_cast<char>(blockFormat));
    packNumber(bytes, block.samples.size());
    packGaps(bytes, block);
    packSeries(bytes, times);
    packSeries(bytes, values);
    const quint16 checksum = qChecksum(bytes);
    bytes.append(static_cast<char>(checksum & 0xFFU));
    bytes.append(static_cast<char>(checksum >> 8U));
    return bytes;
}

std::optional<RecordedBlock> unpackBlock(QByteArrayView bytes)
{
    if (bytes.size() <= checksumSize)
        return std::nullopt;
    const QByteArrayView content = bytes.chopped(checksumSize);
    const auto checksumByte = [&](qsizetype index) {
        return static_cast<std::uint8_t>(bytes[content.size() + index]);
    };
    if (qChecksum(content) != (checksumByte(0) | checksumByte(1) << 8U))
        return std::nullopt;
    PackedBytes packed(content);
    const auto format = packed.byte();
    const auto count = packed.number();
    if (format != blockFormat || !count || *count == 0 || *count > RecordedBlock::most)
        return std::nullopt;
    const auto gaps = unpackGaps(packed, *count);
    const auto times = gaps ? unpackSeries(packed, *count) : std::nullopt;
    const auto values = times ? unpackSeries(packed, *count) : std::nullopt;
    if (!values || !packed.isAtEnd() || !std::ranges::is_sorted(*times) || times->front() < 0)
        return std::nullopt;
    RecordedBlock block;
    block.samples.reserve(*count);
    for (std::size_t i = 0; i < *count; ++i)
        block.samples.push_back({Instant((*times)[i]), (*values)[i]});
    return takeGaps(block, *gaps) ? std::optional(std::move(block)) : std::nullopt;
}

} // namespace codewheel
