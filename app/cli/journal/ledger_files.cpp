// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/journal/ledger_files.h"

#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "journal/ledger_json.h"
#include "journal_files.h"
#include "project/file_access.h"
#include "project/folder_lock.h"
#include "vocabulary/sentence.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QRegularExpression>

namespace codewheel {
namespace {

constexpr qint64 largestExport = 256'000'000; // bytes
constexpr QLatin1String sharedName("eeprom-writes");

Result<std::vector<Ledger::Record>> recordsIn(const QString &file)
{
    return readWholeFile(file, largestExport)
        .and_then([&](const QByteArray &bytes) -> Result<std::vector<Ledger::Record>> {
            auto records = recordsFromJson(bytes);
            if (!records)
                return refuse(RefusalKind::badInput, RefusalId::fileNotReadable, {file, records.error()});
            return std::move(*records);
        });
}

int countedIn(const std::vector<Ledger::Record> &records)
{
    return static_cast<int>(std::ranges::count_if(
        records, [](const Ledger::Record &record) { return !record.entry.isWithoutWrite(); }));
}

QString savedText(const QString &file, int entries)
{
    return sentence(CommandLine::tr("Saved in %1: entries of the ledger: %2."),
                    {file, QString::number(entries)}) +
           u'\n';
}

Checked<Ledger> opened(const QString &file)
{
    return Ledger::open(DatabasePlace::file(file)).map_error([&](const DatabaseError &why) {
        return aboutLedger(file, why);
    });
}

void append(std::vector<Ledger::Record> &all, const std::vector<Ledger::Record> &more)
{
    all.insert(all.end(), more.begin(), more.end());
}

// In a shared folder: named after this computer, so that each writes only its own.
QString ownFileIn(const QDir &folder)
{
    static const QRegularExpression unusual(QStringLiteral("[^A-Za-z0-9._-]+"));
    const QString computer = ledgerWriter().computer.trimmed().replace(unusual, QStringLiteral("-"));
    const QString name =
        computer.isEmpty() ? QString(sharedName) : QStringLiteral("%1-%2").arg(sharedName, computer);
    return folder.filePath(name + QStringLiteral(".json"));
}

// What the folder held before this call changed it.
struct SharedFiles
{
    QStringList read;
    std::vector<Ledger::Record> records; // of these
    QStringList notRead;
    QStringList reasons;
};

SharedFiles sharedFilesIn(const QDir &folder)
{
    SharedFiles files;
    for (const QString &name :
         folder.entryList({QStringLiteral("%1*.json").arg(sharedName)}, QDir::Files, QDir::Name)) {
        const QString file = folder.filePath(name);
        if (const auto records = recordsIn(file)) {
            files.read << file;
            append(files.records, *records);
        } else {
            files.notRead << file;
            files.reasons << complaintAbout(records.error()).text;
        }
    }
    return files;
}

std::optional<Complaint> complaintAboutFiles(const SharedFiles &files)
{
    if (files.notRead.isEmpty())
        return std::nullopt;
    const QString reasons = files.reasons.join(u' ');
    return notDone("ledgerFilesNotRead",
                   sentence(CommandLine::tr("Not taken in, and left as they are: %1"), {reasons}), {reasons});
}

// Not written again if nothing is new, so that what keeps the folder alike on several computers has nothing
// to do.
Checked<void> leave(const std::vector<Ledger::Record> &records, const QString &file)
{
    const QByteArray json = recordsToJson(records, false);
    if (readWholeFile(file, largestExport) == json)
        return {};
    return replaceFile(file, json, OldFile::goes).map_error([](const Refusal &why) {
        return complaintAbout(why);
    });
}

} // namespace

QString ledgerMeant(const Call &call)
{
    return call.arguments.value("--ledger").value_or(ledgerFile(userJournalFolder()));
}

Complaint aboutLedger(const QString &file, const DatabaseError &error)
{
    return complaintAbout({RefusalKind::link, RefusalId::databaseFailed, {file, error.reason}});
}

Checked<std::optional<Ledger>> existingLedger(const QString &file)
{
    if (!QFileInfo::exists(file))
        return std::nullopt;
    return opened(file).map([](Ledger &&ledger) { return std::optional(std::move(ledger)); });
}

Checked<Answer> exportLedger(const Call &call, const QString &target)
{
    const QString file = ledgerMeant(call);
    if (const auto free = checkTargetFile(call.arguments, target); !free)
        return tl::unexpected(free.error());
    const auto ledger = existingLedger(file);
    if (!ledger)
        return tl::unexpected(ledger.error());
    const auto records = *ledger ? (*ledger)->records() : std::vector<Ledger::Record>();
    if (!records)
        return tl::unexpected(aboutLedger(file, records.error()));
    if (const auto saved = replaceFile(target, recordsToJson(*records, false), OldFile::goes); !saved)
        return tl::unexpected(complaintAbout(saved.error()));
    const int entries = countedIn(*records);
    return Answer{.text = savedText(target, entries),
                  .json = {{QStringLiteral("saved"), target}, {QStringLiteral("entries"), entries}}};
}

Checked<Answer> importLedgers(const Call &call, const QStringList &sources)
{
    std::vector<Ledger::Record> records;
    for (const QString &source : sources) {
        const auto read = recordsIn(source);
        if (!read)
            return tl::unexpected(complaintAbout(read.error()));
        append(records, *read);
    }
    const QString file = ledgerMeant(call);
    auto ledger = opened(file);
    if (!ledger)
        return tl::unexpected(ledger.error());
    const auto merged = ledger->merge(records);
    if (!merged)
        return tl::unexpected(aboutLedger(file, merged.error()));
    return Answer{
        .text = sentence(CommandLine::tr("Imported into %1: new entries: %2; known already: %3."),
                         {file, QString::number(merged->added), QString::number(merged->known)}) +
                u'\n',
        .json = {{QStringLiteral("added"), merged->added}, {QStringLiteral("known"), merged->known}}};
}

Checked<Answer> mergeLedgerFolder(const Call &call, const QString &path)
{
    const QDir folder(path);
    if (!folder.exists())
        return badInput("noFolder", CommandLine::tr("There is no folder %1."), {path});
    const QString own = ownFileIn(folder);
    const FolderLock lock(own);
    if (lock.isRefused())
        return tl::unexpected(
            complaintAbout({RefusalKind::busy,
                            RefusalId::fileNotWritten,
                            {own, CommandLine::tr("Another program has locked its folder.")}}));
    const SharedFiles files = sharedFilesIn(folder);
    const QString file = ledgerMeant(call);
    auto ledger = opened(file);
    if (!ledger)
        return tl::unexpected(ledger.error());
    const auto merged = ledger->merge(files.records);
    if (!merged)
        return tl::unexpected(aboutLedger(file, merged.error()));

    Answer answer{.text =
                      sentence(CommandLine::tr("Imported from %1 into %2: files: %3; new entries: %4; known "
                                               "already: %5."),
                               {path, file, QString::number(files.read.size()),
                                QString::number(merged->added), QString::number(merged->known)}) +
                      u'\n',
                  .json = {{QStringLiteral("read"), QJsonArray::fromStringList(files.read)},
                           {QStringLiteral("notRead"), QJsonArray::fromStringList(files.notRead)},
                           {QStringLiteral("added"), merged->added},
                           {QStringLiteral("known"), merged->known}},
                  .complaint = complaintAboutFiles(files)};
    if (files.notRead.contains(own)) // it may hold what nobody else has
        return answer;
    const auto records = ledger->records();
    if (!records)
        return tl::unexpected(aboutLedger(file, records.error()));
    if (const auto left = leave(*records, own); !left) {
        answer.complaint = left.error();
        return answer;
    }
    const int entries = countedIn(*records);
    answer.text += savedText(own, entries);
    answer.json.insert(QStringLiteral("saved"), own);
    answer.json.insert(QStringLiteral("entries"), entries);
    return answer;
}

} // namespace codewheel
