// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_file.h"

namespace codewheel {

// Cam programs on the disk. What went wrong is a sentence.
tl::expected<CamFile, QString> loadCamFile(const QString &path, std::optional<std::int64_t> largestPosition);
tl::expected<void, QString> saveCamFile(const QString &path, const CamFile &file);

} // namespace codewheel
