// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a log of CAN frames or lines with a reason, the same in whatever pieces they come; what was
// read can be told, and is written and read again unchanged.
#include "can/can_log_reader.h"
#include "can/can_log_writer.h"
#include "can/frame_meaning.h"
#include "tests/fuzz/must.h"

#include <algorithm>

using namespace codewheel;

namespace {

constexpr Instant latest = std::chrono::hours(24 * 366 * 8'000); // with twelve digits of seconds

struct Read
{
    std::vector<CanFrame> frames;
    std::int64_t faults = 0;
};

Read readInPieces(std::string_view text, std::size_t size, std::optional<CanLogTimes> meant = {})
{
    Read read;
    CanLogReader reader([&](const CanFrame &frame) { read.frames.push_back(frame); },
                        [&](std::int64_t line, CanLogFault fault) {
                            ++read.faults;
                            must(line >= 1, "lines are counted from 1 on");
                            must(!canLogFaultText(fault).isEmpty(), "there is a sentence");
                        },
                        meant);
    for (; !text.empty(); text.remove_prefix(std::min(size, text.size())))
        reader.read(text.substr(0, size));
    reader.finish();
    return read;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const Read whole = readInPieces(text, size);
    const Read pieces = readInPieces(text, 7);
    must(whole.frames == pieces.frames && whole.faults == pieces.faults, "pieces make no difference");
    readInPieces(text, size, CanLogTimes::differences);
    std::vector<CanFrame> told;
    std::string written;
    CanFrameMeanings meanings;
    for (CanFrame frame : whole.frames) {
        must(frame.length <= CanFrame::mostBytes, "a frame has eight bytes at most");
        must(frame.id <= largestExtendedId, "an identifier has 29 bits at most");
        meanings.next(frame)();
        if (frame.isError) // it is written with all its bytes
            frame.length = CanFrame::mostBytes;
        frame.time = std::clamp(frame.time.value_or(Instant()), Instant(), latest);
        written += canLogLine(frame);
        told.push_back(frame);
    }
    const Read again = readInPieces(written, size, CanLogTimes::absolute);
    must(again.faults == 0 && again.frames == told, "what is written is read");
    return 0;
}
