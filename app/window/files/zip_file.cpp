// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/zip_file.h"

#include "project/file_replacement.h"

#include <archive.h>
#include <archive_entry.h>
#include <memory>

namespace codewheel {
namespace {

struct FreeArchive
{
    void operator()(archive *zip) const { archive_write_free(zip); }
    void operator()(archive_entry *entry) const { archive_entry_free(entry); }
};
using ZipArchive = std::unique_ptr<archive, FreeArchive>;
using ZipArchiveEntry = std::unique_ptr<archive_entry, FreeArchive>;

la_ssize_t passToFile(archive *, void *file, const void *bytes, std::size_t count)
{
    return static_cast<FileReplacement *>(file)->write(static_cast<const char *>(bytes),
                                                       static_cast<qint64>(count));
}

bool addToZip(archive &zip, const ZipEntry &file, const QDateTime &time)
{
    const ZipArchiveEntry entry(archive_entry_new());
    archive_entry_set_pathname(entry.get(), file.name.toLatin1().constData());
    archive_entry_set_size(entry.get(), file.bytes.size());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), time.toSecsSinceEpoch(), 0);
    return archive_write_header(&zip, entry.get()) == ARCHIVE_OK &&
           archive_write_data(&zip, file.bytes.constData(), static_cast<std::size_t>(file.bytes.size())) ==
               file.bytes.size();
}

bool writeZip(FileReplacement &replacement, const std::vector<ZipEntry> &files, const QDateTime &time)
{
    const ZipArchive zip(archive_write_new());
    if (archive_write_set_format_zip(zip.get()) != ARCHIVE_OK ||
        archive_write_set_bytes_in_last_block(zip.get(), 1) != ARCHIVE_OK ||
        archive_write_open(zip.get(), &replacement, nullptr, passToFile, nullptr) != ARCHIVE_OK)
        return false;
    for (const ZipEntry &file : files)
        if (!addToZip(*zip, file, time))
            return false;
    return archive_write_close(zip.get()) == ARCHIVE_OK;
}

} // namespace

Result<void> saveZip(const QString &path, const std::vector<ZipEntry> &files, const QDateTime &time)
{
    FileReplacement replacement(path);
    if (auto begun = replacement.begin(); !begun)
        return begun;
    const bool isWhole = writeZip(replacement, files, time);
    if (auto isThere = replacement.bringToDisk(); !isThere) // says why
        return isThere;
    if (!isWhole)
        return refuse(RefusalKind::link, RefusalId::fileNotWritten, {path, qt_error_string(ENOMEM)});
    return replacement.replace();
}

} // namespace codewheel
