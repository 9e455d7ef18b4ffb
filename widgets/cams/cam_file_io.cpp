// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_file_io.h"

#include "encoder/refusal_text.h"
#include "project/file_access.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace codewheel {
namespace {

// The context of these texts.
struct CamFiles
{
    Q_DECLARE_TR_FUNCTIONS(CamFiles)
};

} // namespace

tl::expected<CamFile, QString> loadCamFile(const QString &path, std::optional<std::int64_t> largestPosition)
{
    return readWholeFile(path, largestCamFile)
        .and_then([&](const QByteArray &json) {
            return camFileFromJson(json, QFileInfo(path).fileName(), largestPosition);
        })
        .map_error([](const Refusal &refusal) { return refusalText(refusal); });
}

tl::expected<void, QString> saveCamFile(const QString &path, const CamFile &file)
{
    return replaceFile(path, camFileToJson(file), OldFile::goes).map_error([&](const Refusal &refusal) {
        return CamFiles::tr("%1 was not saved: %2", "file, reason").arg(path, whyNotWritten(refusal));
    });
}

} // namespace codewheel
