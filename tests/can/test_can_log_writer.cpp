// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/can/read_log.h"

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr Instant someTime{1'544'106'679'432'583};

CanFrame dataFrame()
{
    return {.id = 0x185, .length = 4, .bytes = {0x88, 0x13}, .time = someTime};
}

std::vector<CanFrame> framesOfAllKinds()
{
    return {
        dataFrame(),
        {.id = 0x080, .time = someTime},
        {.id = 5, .isExtended = true, .length = 1, .bytes = {0xAB}, .time = someTime + Instant(1)},
        {.id = 0x1FFFFFFF,
         .isExtended = true,
         .length = 8,
         .bytes = {1, 2, 3, 4, 5, 6, 7, 8},
         .time = someTime},
        {.id = 0x705, .isRemote = true, .time = someTime},
        {.id = 0x705, .isRemote = true, .length = 8, .time = someTime},
        {.id = 0x88, .isError = true, .length = 8, .bytes = {0, 0, 4}, .time = someTime},
    };
}

std::string allLines()
{
    std::string text;
    for (const CanFrame &frame : framesOfAllKinds())
        text += canLogLine(frame);
    return text;
}

TEST(CanLogWriter, LinesAreThoseOfCandump)
{
    EXPECT_EQ(allLines(), "(1544106679.432583) can0 185#88130000\n"
                          "(1544106679.432583) can0 080#\n"
                          "(1544106679.432584) can0 00000005#AB\n"
                          "(1544106679.432583) can0 1FFFFFFF#0102030405060708\n"
                          "(1544106679.432583) can0 705#R\n"
                          "(1544106679.432583) can0 705#R8\n"
                          "(1544106679.432583) can0 20000088#0000040000000000\n");
}

TEST(CanLogWriter, ATimeAlwaysHasAllItsDigits)
{
    EXPECT_EQ(canLogLine({.id = 0x80}), "(0000000000.000000) can0 080#\n");
    EXPECT_EQ(canLogLine({.id = 0x80, .interface = "vcan1", .time = Instant(10)}),
              "(0000000000.000010) vcan1 080#\n");
    EXPECT_EQ(canLogLine({.id = 0x80, .time = Instant(-10)}), "(0000000000.000000) can0 080#\n");
}

TEST(CanLogWriter, WhatWasWrittenIsReadAgain)
{
    std::vector<CanFrame> written = framesOfAllKinds();
    for (CanFrame &frame : written)
        frame.interface = "can0";
    EXPECT_EQ(readLog(allLines()).frames, written);
}

// Programs that read logs, where they are installed.
class OtherProgram : public testing::Test
{
protected:
    void SetUp() override
    {
        QFile log(file);
        ASSERT_TRUE(log.open(QIODevice::WriteOnly));
        log.write(QByteArray::fromStdString(allLines()));
    }
    static QString output(const QString &program, const QStringList &arguments)
    {
        QProcess process;
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(60'000)) << program.toStdString();
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
        return QString::fromUtf8(process.readAllStandardOutput());
    }

    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("frames.log"));
};

TEST_F(OtherProgram, PythonCanReadsTheLog)
{
    const QString python = QStringLiteral(DEBIAN_PYTHON3);
    if (QProcess::execute(python, {QStringLiteral("-c"), QStringLiteral("import can")}) != 0)
        GTEST_SKIP() << "python3-can is not installed: it cannot be tried whether it reads our logs.";
    const QString script = QStringLiteral(
        "import can, sys\n"
        "for m in can.CanutilsLogReader(sys.argv[1]):\n"
        "    kind = 'e' if m.is_error_frame else 'r' if m.is_remote_frame else 'd'\n"
        "    print('%.6f %s %x %s %d %s' % (m.timestamp, kind, m.arbitration_id, 'x' if m.is_extended_id "
        "else 's', m.dlc, m.data.hex()) if kind != 'e' else 'error')\n");
    const QString read = output(python, {QStringLiteral("-c"), script, file});
    EXPECT_EQ(read.toStdString(), "1544106679.432583 d 185 s 4 88130000\n"
                                  "1544106679.432583 d 80 s 0 \n"
                                  "1544106679.432584 d 5 x 1 ab\n"
                                  "1544106679.432583 d 1fffffff x 8 0102030405060708\n"
                                  "1544106679.432583 r 705 s 0 \n"
                                  "1544106679.432583 r 705 s 8 \n"
                                  "error\n");
}

TEST_F(OtherProgram, WiresharkReadsTheLog)
{
    const QString tshark = QStandardPaths::findExecutable(QStringLiteral("tshark"));
    if (tshark.isEmpty())
        GTEST_SKIP() << "tshark is not installed: it cannot be tried whether Wireshark reads our logs.";
    const QString read =
        output(tshark, {QStringLiteral("-r"), file, QStringLiteral("-T"), QStringLiteral("fields"),
                        QStringLiteral("-e"), QStringLiteral("frame.time_epoch"), QStringLiteral("-e"),
                        QStringLiteral("can.id")});
    const QStringList lines = read.split(u'\n', Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), static_cast<qsizetype>(framesOfAllKinds().size())) << read.toStdString();
    EXPECT_TRUE(lines[0].startsWith(u"1544106679.432583")) << read.toStdString();
    EXPECT_TRUE(lines[0].endsWith(u"\t389") || lines[0].endsWith(u"0x00000185")) << read.toStdString();
}

} // namespace
} // namespace codewheel
