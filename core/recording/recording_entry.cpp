// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_entry.h"

namespace codewheel {
namespace {

struct EntryBytes
{
    std::size_t operator()(const RecordedBus &) const { return 0; }
    std::size_t operator()(const RecordedDescription &entry) const { return size(entry.json.size()); }
    std::size_t operator()(const RecordedValues &entry) const
    {
        return entry.values.size() * sizeof(ShownValues);
    }
    std::size_t operator()(const RecordedPast &entry) const
    {
        return entry.samples.size() * sizeof(Sample) + entry.gaps.size() * sizeof(History::Gap);
    }
    std::size_t operator()(const RecordedInterruption &) const { return 0; }
    std::size_t operator()(const RecordedMessage &entry) const
    {
        return entry.message.arguments.size() * sizeof(RefusalArgument);
    }
    std::size_t operator()(const RecordedTraffic &entry) const { return size(entry.row.bytes.size()); }
    std::size_t operator()(const RecordedNote &entry) const { return size(2 * entry.text.size()); }
    std::size_t operator()(const RecordedLoss &) const { return 0; }
    std::size_t operator()(const RecordedClock &) const { return 0; }

    static std::size_t size(qsizetype bytes) { return static_cast<std::size_t>(bytes); }
};

} // namespace

std::size_t bytesOf(const RecordingEntry &entry)
{
    return sizeof entry + std::visit(EntryBytes(), entry);
}

std::uint64_t valuesOf(const RecordingEntry &entry)
{
    if (const auto *values = std::get_if<RecordedValues>(&entry))
        return values->values.size();
    if (const auto *past = std::get_if<RecordedPast>(&entry))
        return past->samples.size();
    return 1;
}

} // namespace codewheel
