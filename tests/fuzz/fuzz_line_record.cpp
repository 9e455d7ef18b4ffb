// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a session of a serial line, or are refused with a sentence; what was read is saved unchanged,
// and its requests can be described.
#include "kinds/esc/line/esc_line_record.h"
#include "kinds/esc/line/esc_line_replay.h"
#include "tests/fuzz/must.h"

using namespace codewheel;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    const auto record = lineRecordFromJson(bytes, QStringLiteral("a.json"));
    if (!record) {
        must(!record.error().isEmpty(), "there is a sentence");
        return 0;
    }
    const auto again = lineRecordFromJson(lineRecordToJson(*record), QStringLiteral("a.json"));
    must(again && *again == *record, "what was kept is the same");
    const auto reads = replaySteps(*record, {.automatic = true});
    const auto all = replaySteps(*record, {.automatic = true, .writes = true});
    must(reads.size() <= all.size() && all.size() <= record->rows.size(), "a request is sent once at most");
    for (const ReplayStep &step : reads)
        must(!esc::shapeOf(step.request.command).writes, "writes are left out");
    return 0;
}
