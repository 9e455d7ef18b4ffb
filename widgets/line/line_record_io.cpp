// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_record_io.h"

#include "encoder/refusal_text.h"
#include "encoder/sentence.h"
#include "project/file_access.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace codewheel {
namespace {

// The context of these texts.
struct LineRecordFiles
{
    Q_DECLARE_TR_FUNCTIONS(LineRecordFiles)
};

constexpr qint64 largestFile = 64'000'000; // bytes; 100 000 rows take 9 000 000

} // namespace

tl::expected<LineRecord, QString> loadLineRecord(const QString &path)
{
    const auto json = readWholeFile(path, largestFile);
    if (!json)
        return tl::unexpected(refusalText(json.error()));
    return lineRecordFromJson(*json, QFileInfo(path).fileName());
}

tl::expected<void, QString> saveLineRecord(const QString &path, const LineRecord &record)
{
    return writeWholeFile(path, lineRecordToJson(record));
}

tl::expected<void, QString> writeWholeFile(const QString &path, const QByteArray &content)
{
    return replaceFile(path, content, OldFile::goes).map_error([&](const Refusal &refusal) {
        return sentence(LineRecordFiles::tr("%1 was not saved: %2", "file, reason"),
                        {path, whyNotWritten(refusal)});
    });
}

} // namespace codewheel
