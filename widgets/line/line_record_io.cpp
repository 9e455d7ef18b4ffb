// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_record_io.h"

#include "encoder/sentence.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>

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
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(
            sentence(LineRecordFiles::tr("%1 cannot be read: %2"), {path, file.errorString()}));
    if (file.size() > largestFile)
        return tl::unexpected(
            sentence(LineRecordFiles::tr("%1 is too large for a session of a serial line."), {path}));
    return lineRecordFromJson(file.readAll(), QFileInfo(path).fileName());
}

tl::expected<void, QString> saveLineRecord(const QString &path, const LineRecord &record)
{
    return writeWholeFile(path, lineRecordToJson(record));
}

tl::expected<void, QString> writeWholeFile(const QString &path, const QByteArray &content)
{
    QSaveFile target(path);
    if (!target.open(QIODevice::WriteOnly) || target.write(content) != content.size() || !target.commit())
        return tl::unexpected(sentence(LineRecordFiles::tr("%1 was not saved: %2", "file, reason"),
                                       {path, target.errorString()}));
    return {};
}

} // namespace codewheel
