// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_target.h"

#include "recording/recording_writer.h"
#include "recording/server_recording.h"

namespace codewheel {

Result<std::unique_ptr<RecordingTarget>> RecordingTarget::begin(const RecordingSettings &settings)
{
    const auto asTarget = [](auto target) { return std::unique_ptr<RecordingTarget>(std::move(target)); };
    return settings.server.isEmpty() ? RecordingWriter::begin(settings).map(asTarget)
                                     : ServerRecording::begin(settings).map(asTarget);
}

} // namespace codewheel
