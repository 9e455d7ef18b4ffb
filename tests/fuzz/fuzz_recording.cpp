// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a recording, or are refused with a sentence; whatever is in it can be asked for. The first
// byte chooses: B, a block of samples; else a file.
#include "recording/recorded_device.h"
#include "recording/recording_reader.h"
#include "tests/fuzz/must.h"
#include "vocabulary/refusal_text.h"

#include <QFile>
#include <QTemporaryDir>

using namespace codewheel;

namespace {

void readBlock(const QByteArray &bytes)
{
    QByteArray whole = bytes; // or the checksum would stop everything else
    const quint16 checksum = qChecksum(bytes);
    whole.append(static_cast<char>(checksum & 0xFFU)).append(static_cast<char>(checksum >> 8U));
    const auto block = unpackBlock(whole);
    if (!block)
        return;
    must(unpackBlock(packBlock(*block)) == block, "what was kept is the same");
    must(block->summary().extent.least <= block->summary().extent.greatest, "it has a summary");
}

void readChannel(const RecordingReader &reader, const RecordingReader::Device &device, Channel which)
{
    auto channel = reader.channel(device, which);
    if (!channel) {
        must(!refusalText(channel.error()).isEmpty(), "there is a sentence");
        return;
    }
    const TimeSpan all = channel->span().value_or(TimeSpan{Instant(0), Instant(1'000)});
    (void)channel->look(all, 50);
    (void)channel->look({all.from, all.from + Instant(1'000'000)}, 50);
    (void)channel->at(all.from + Instant(500));
    (void)channel->statistics(all);
    if (const auto damage = channel->damage())
        must(!refusalText(*damage).isEmpty(), "there is a sentence");
}

void readFile(const QString &path)
{
    const auto reader = RecordingReader::open(path);
    if (!reader) {
        must(!refusalText(reader.error()).isEmpty(), "there is a sentence");
        return;
    }
    constexpr TimeSpan all{Instant::min(), Instant::max()};
    (void)reader->head();
    (void)reader->buses();
    (void)reader->messages(all, 100);
    (void)reader->notes(all, 100);
    (void)reader->traffic(all, 100);
    (void)reader->losses();
    (void)reader->clock();
    const auto devices = reader->devices();
    for (std::size_t i = 0; devices && i < devices->size(); ++i) {
        if (const auto descriptions = reader->descriptions(devices->at(i)))
            for (const auto &description : *descriptions)
                (void)recordedDeviceFromJson(description.json);
        for (const Channel channel : devices->at(i).channels)
            readChannel(*reader, devices->at(i), channel);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const QTemporaryDir folder;
    if (size == 0)
        return 0;
    const QByteArray bytes(reinterpret_cast<const char *>(data) + 1, static_cast<qsizetype>(size) - 1);
    if (*data == 'B') {
        readBlock(bytes);
        return 0;
    }
    const QString path = folder.filePath(QStringLiteral("night.cwrec"));
    for (const char *suffix : {"", "-wal", "-shm", "-journal"})
        QFile::remove(path + QLatin1String(suffix));
    QFile file(path);
    must(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), "the file can be written");
    file.close();
    readFile(path);
    return 0;
}
