// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc_line/line_record.h"

namespace codewheel {

// A kept session from and to the disk; what goes wrong is told in a sentence.
tl::expected<LineRecord, QString> loadLineRecord(const QString &path);
tl::expected<void, QString> saveLineRecord(const QString &path, const LineRecord &record);
// A file of any kind, whole or not at all.
tl::expected<void, QString> writeWholeFile(const QString &path, const QByteArray &content);

} // namespace codewheel
