// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_file_io.h"

#include "encoder/refusal_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>

namespace codewheel {
namespace {

// The context of these texts.
struct CamFiles
{
    Q_DECLARE_TR_FUNCTIONS(CamFiles)
};

constexpr qint64 largestFile = 1'000'000; // bytes; eight programs take 8 000

} // namespace

tl::expected<CamFile, QString> loadCamFile(const QString &path, std::optional<std::int64_t> largestPosition)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(CamFiles::tr("%1 cannot be read: %2").arg(path, file.errorString()));
    if (file.size() > largestFile)
        return tl::unexpected(CamFiles::tr("%1 is too large for a file of cam programs.").arg(path));
    return camFileFromJson(file.readAll(), QFileInfo(path).fileName(), largestPosition)
        .map_error([](const Refusal &refusal) { return refusalText(refusal); });
}

tl::expected<void, QString> saveCamFile(const QString &path, const CamFile &file)
{
    QSaveFile target(path);
    const QByteArray json = camFileToJson(file);
    if (!target.open(QIODevice::WriteOnly) || target.write(json) != json.size() || !target.commit())
        return tl::unexpected(
            CamFiles::tr("%1 was not saved: %2", "file, reason").arg(path, target.errorString()));
    return {};
}

} // namespace codewheel
