// SPDX-License-Identifier: GPL-3.0-or-later
// Over real pseudo terminals. Anything timed waits for its event, for up to an hour.
#include "links/serial_port_link.h"
#include "tests/support/port_holder.h"
#include "tests/support/pty_pair.h"
#include "tests/support/without_rights.h"
#include "vocabulary/refusal_text.h"

#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr SerialSettings usual{};

template <typename T>
RefusalCode refusalOf(const Result<T> &result)
{
    return result ? RefusalId::nothingToDo : result.error().id;
}

class SerialLink : public testing::Test
{
protected:
    void open(const SerialSettings &settings = usual)
    {
        const auto opened = m_link.open(settings);
        ASSERT_TRUE(opened) << refusalText(opened.error()).toStdString();
    }
    QByteArray readCount(qsizetype count)
    {
        QByteArray bytes;
        while (bytes.size() < count) {
            const auto more = m_link.read(m_link.now() + 1h);
            if (!more || more->isEmpty())
                break;
            bytes += *more;
        }
        return bytes;
    }
    termios settingsOfPort() const
    {
        termios settings = {};
        ::tcgetattr(m_pty.descriptor(), &settings);
        return settings;
    }

    PtyPair m_pty;
    SerialPortLink m_link{m_pty.path()};
};

TEST_F(SerialLink, CarriesBytesBothWays)
{
    open();
    ASSERT_TRUE(m_link.write(QByteArray("\x1B"
                                        "05P\r\n\x00\xFF",
                                        8)));
    EXPECT_EQ(m_pty.receive(8), QByteArray("\x1B"
                                           "05P\r\n\x00\xFF",
                                           8));
    const QByteArray answer("\r\n00001235\r\n\x00\x11\x13\xFF\x03", 17); // XON, XOFF and ^C are bytes
    m_pty.send(answer);
    EXPECT_EQ(readCount(17), answer);
}

TEST_F(SerialLink, SendsNothingByItselfAndDropsWhatCameBefore)
{
    m_pty.send("old");
    open();
    m_pty.send("new");
    EXPECT_EQ(readCount(3), "new");
    ASSERT_TRUE(m_link.write("x"));
    EXPECT_EQ(m_pty.receive(1), "x");
}

TEST_F(SerialLink, WhatIsThereIsReadThoughTheTimeIsOver)
{
    open();
    m_pty.send("x");
    EXPECT_EQ(m_link.read({}).value(), "x");
}

TEST_F(SerialLink, SetsTheLine)
{
    open();
    termios settings = settingsOfPort();
    EXPECT_EQ(::cfgetospeed(&settings), speed_t{B19200});
    EXPECT_EQ(settings.c_cflag & CSIZE, tcflag_t{CS8});
    EXPECT_NE(settings.c_cflag & CSTOPB, 0U);
    EXPECT_EQ(settings.c_cflag & CRTSCTS, 0U);
    EXPECT_EQ(settings.c_iflag & (IXON | IXOFF | ICRNL | INLCR), 0U);
    ASSERT_TRUE(m_link.setBaudRate(4'800));
    settings = settingsOfPort();
    EXPECT_EQ(::cfgetospeed(&settings), speed_t{B4800});
    open({.baudRate = 9'600, .parity = SerialSettings::Parity::even, .stopBits = 1});
    settings = settingsOfPort();
    EXPECT_EQ(::cfgetospeed(&settings), speed_t{B9600});
    EXPECT_EQ(settings.c_cflag & CSTOPB, 0U);
}

// It has no parity. Once one was set, the system refuses every further change.
TEST_F(SerialLink, APseudoTerminalIsOpenedWithAParityAgainAndAgain)
{
    for (int i = 0; i < 3; ++i) {
        SerialPortLink link(m_pty.path());
        for (const auto parity :
             {SerialSettings::Parity::even, SerialSettings::Parity::odd, SerialSettings::Parity::none}) {
            const auto opened =
                link.open({.baudRate = 19'200, .dataBits = 8, .parity = parity, .stopBits = 1});
            EXPECT_TRUE(opened) << (opened ? "" : refusalText(opened.error()).toStdString());
        }
    }
}

TEST_F(SerialLink, TakesAnyBaudRateAndRefusesWhatIsNone)
{
    open({.baudRate = 12'345});
    EXPECT_EQ(refusalOf(m_link.setBaudRate(0)), RefusalId::lineSettingWrong);
    EXPECT_EQ(refusalOf(m_link.open({.baudRate = -1})), RefusalId::lineSettingWrong);
    EXPECT_EQ(refusalOf(m_link.open({.dataBits = 9})), RefusalId::lineSettingWrong);
    EXPECT_EQ(refusalOf(m_link.open({.stopBits = 3})), RefusalId::lineSettingWrong);
}

TEST_F(SerialLink, InterruptEndsTheReadUnderWayOrTheNext)
{
    open();
    {
        const std::jthread other([&] { m_link.interrupt(); });
        EXPECT_EQ(m_link.read(m_link.now() + 1h).value(), "");
    }
    m_link.interrupt();
    EXPECT_EQ(m_link.read(m_link.now() + 1h).value(), "");
    m_pty.send("x");
    EXPECT_EQ(readCount(1), "x");
}

// As in a recording at the command line. Qt warns where something of its own is used by another thread.
TEST_F(SerialLink, AnotherThreadGoesOnWithIt)
{
    static int warnings = 0;
    const auto before =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext &, const QString &) { ++warnings; });
    const auto restore = qScopeGuard([before] { qInstallMessageHandler(before); });
    open();
    m_pty.send("x");
    std::jthread([&] {
        EXPECT_EQ(readCount(1), "x");
        EXPECT_TRUE(m_link.write("y"));
        m_link.close();
    }).join();
    EXPECT_EQ(m_pty.receive(1), "y");
    EXPECT_EQ(warnings, 0);
}

TEST_F(SerialLink, APseudoTerminalHasNoAdapterToAskForLowLatency)
{
    open();
    EXPECT_EQ(m_link.lowLatency(), LowLatency::notApplicable);
}

TEST_F(SerialLink, AnUnpluggedPortIsToldOnce)
{
    open();
    m_pty.unplug();
    const auto gone = m_link.read(m_link.now() + 1h);
    EXPECT_EQ(refusalOf(gone), RefusalId::portLost);
    EXPECT_EQ(gone.error().arguments, (std::vector<RefusalArgument>{m_link.name()}));
    EXPECT_EQ(refusalOf(m_link.read(m_link.now() + 1h)), RefusalId::lineClosed);
    EXPECT_EQ(refusalOf(m_link.write("x")), RefusalId::lineClosed);
    EXPECT_EQ(refusalOf(m_link.setBaudRate(9'600)), RefusalId::lineClosed);
    EXPECT_EQ(refusalOf(m_link.open(usual)), RefusalId::portNotFound);
}

TEST_F(SerialLink, UnpluggingIsNoticedByAWriteAndDuringARead)
{
    open();
    m_pty.unplug();
    EXPECT_EQ(refusalOf(m_link.write("x")), RefusalId::portLost);
    PtyPair second;
    SerialPortLink link(second.path());
    ASSERT_TRUE(link.open(usual));
    const std::jthread other([&] { second.unplug(); });
    EXPECT_EQ(refusalOf(link.read(link.now() + 1h)), RefusalId::portLost);
}

TEST_F(SerialLink, WhatCameBeforeItWasUnpluggedIsReadFirst)
{
    open();
    m_pty.send("last words");
    m_pty.unplug();
    const auto words = m_link.read(m_link.now() + 1h);
    // The system may have dropped them with the port, in which case the loss is reported at once.
    if (words) {
        EXPECT_EQ(*words, "last words");
    }
    EXPECT_EQ(refusalOf(words ? m_link.read(m_link.now() + 1h) : words), RefusalId::portLost);
}

TEST_F(SerialLink, APortThatIsTakenIsRefused)
{
    open();
    SerialPortLink second(m_pty.path());
    EXPECT_EQ(refusalOf(second.open(usual)), RefusalId::portInUse);
    m_link.close();
    EXPECT_TRUE(second.open(usual));
}

// Other programs mark their port only with a lock.
TEST_F(SerialLink, APortThatIsLockedIsRefused)
{
    const int other =
        ::open(m_pty.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT(*-vararg)
    ASSERT_GE(other, 0);
    ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(refusalOf(m_link.open(usual)), RefusalId::portInUse);
    ::close(other);
    EXPECT_TRUE(m_link.open(usual));
}

// It would go on at our rate.
TEST_F(SerialLink, APortThatAnotherProgramHasOpenIsRefusedAndKeepsItsSettings)
{
    PortHolder holder(QStringLiteral(CODEWHEEL_PYTHON), m_pty.path());
    const int line = ::open(m_pty.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT
    termios before = {};
    ASSERT_EQ(::tcgetattr(line, &before), 0);
    EXPECT_EQ(refusalOf(m_link.open(usual)), RefusalId::portInUse);
    termios after = {};
    ASSERT_EQ(::tcgetattr(line, &after), 0);
    ::close(line);
    EXPECT_EQ(::cfgetospeed(&after), ::cfgetospeed(&before));
    EXPECT_EQ(after.c_cflag, before.c_cflag);
    holder.end();
    EXPECT_TRUE(m_link.open(usual));
}

TEST_F(SerialLink, WhatIsNoPortIsRefused)
{
    EXPECT_EQ(refusalOf(SerialPortLink(QStringLiteral("ttyNone7")).open(usual)), RefusalId::portNotFound);
    for (const char *path : {"/dev/null", "/tmp"}) {
        const auto none = SerialPortLink(QString::fromLatin1(path)).open(usual);
        ASSERT_EQ(refusalOf(none), RefusalId::linkFailed) << path;
        EXPECT_TRUE(refusalText(none.error())
                        .endsWith(QString::fromLatin1(path) + QStringLiteral(" is not a serial port.")));
    }
}

TEST_F(SerialLink, MissingRightsAreToldWithTheGroupAndTheCommand)
{
    ASSERT_EQ(::chmod(m_pty.path().toLocal8Bit().constData(), 0), 0);
    const auto refused = [&] {
        const WithoutRights rights;
        return m_link.open(usual);
    }();
    ASSERT_EQ(refusalOf(refused), RefusalId::portNoRights);
    const std::vector<RefusalArgument> &arguments = refused.error().arguments;
    ASSERT_EQ(arguments.size(), 3U);
    const QString group = std::get<QString>(arguments[1]);
    EXPECT_FALSE(group.isEmpty());
    EXPECT_EQ(std::get<QString>(arguments[2]),
              QStringLiteral("sudo setfacl -m u:$USER:rw %1").arg(m_pty.path()))
        << "no group may use it";
}

} // namespace
} // namespace codewheel
