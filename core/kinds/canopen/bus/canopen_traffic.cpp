// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_traffic.h"

#include "kinds/canopen/protocol/canopen_address.h"
#include "replay/recorded_rows.h"

#include <QtEndian>

#include <algorithm>

namespace codewheel {
namespace {

constexpr qsizetype headSize = 4;
constexpr std::uint32_t extendedFlag = 0x8000'0000;
constexpr std::uint32_t remoteFlag = 0x4000'0000;

// With what its bytes say.
TrafficRow explainedRow(TrafficRow row, const CanFrame &frame, CanFrameMeanings &meanings)
{
    row.head = std::min(headSize, row.bytes.size());
    row.identifier = FrameIdentifier{frame.id, frame.isExtended || frame.isError};
    row.meaning = meanings.next(frame);
    return row;
}

class CanopenRows final : public RecordedRows
{
public:
    std::span<const TrafficColumn> columns() const override { return canTrafficColumns; }
    TrafficRow explained(TrafficRow row, const EncoderAt & /*encoder*/) override
    {
        const auto frame = canFrameOf(row.bytes);
        return frame ? explainedRow(std::move(row), *frame, m_meanings) : row;
    }
    void restart() override { m_meanings = {}; }

private:
    CanFrameMeanings m_meanings;
};

} // namespace

QByteArray frameBytes(const CanFrame &frame)
{
    std::uint32_t head = frame.id;
    head |= frame.isExtended ? extendedFlag : 0;
    head |= frame.isRemote ? remoteFlag : 0;
    head |= frame.isError ? errorFrameFlag : 0;
    const auto data = frame.data();
    QByteArray bytes(headSize + (frame.isRemote ? 1 : std::ssize(data)), static_cast<char>(frame.length));
    qToBigEndian(head, bytes.data());
    std::ranges::copy(data, bytes.begin() + headSize);
    return bytes;
}

std::optional<CanFrame> canFrameOf(const QByteArray &bytes)
{
    const qsizetype size = bytes.size() - headSize;
    if (size < 0 || size > qsizetype{CanFrame::mostBytes})
        return std::nullopt;
    const auto head = qFromBigEndian<std::uint32_t>(bytes.constData());
    CanFrame frame{.isExtended = (head & extendedFlag) != 0,
                   .isRemote = (head & remoteFlag) != 0,
                   .isError = (head & errorFrameFlag) != 0,
                   .length = static_cast<std::uint8_t>(size)};
    frame.id = head & (frame.isExtended || frame.isError ? largestExtendedId : largestStandardId);
    if (frame.isRemote)
        frame.length = size > 0 ? static_cast<std::uint8_t>(bytes.at(headSize)) : std::uint8_t{0};
    else
        std::copy(bytes.begin() + headSize, bytes.end(), frame.bytes.begin());
    return frame;
}

TrafficRow CanopenTraffic::row(const CanopenRow &passed, Instant at)
{
    const CanFrame &frame = passed.frame;
    TrafficRow row{.at = at,
                   .kind = passed.isSent ? TrafficKind::sent : TrafficKind::answer,
                   .bytes = frameBytes(frame),
                   .isAutomatic = passed.isAutomatic,
                   .isTyped = passed.isTyped};
    const auto cob = frame.isExtended || frame.isError ? std::nullopt : canopen::CobId::of(frame.id);
    if (cob && cob->node != 0)
        row.place = Place{firstCanBus, CanopenAddress{cob->node}.place()};
    return explainedRow(std::move(row), frame, m_meanings);
}

std::unique_ptr<RecordedRows> makeCanopenRows()
{
    return std::make_unique<CanopenRows>();
}

} // namespace codewheel
