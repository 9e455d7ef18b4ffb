// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/desktop_bus.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel::test {
namespace {

constexpr char busVariable[] = "DBUS_SESSION_BUS_ADDRESS";
constexpr int longestBusWait = 30'000; // ms

QByteArray lineOf(QProcess &process)
{
    while (!process.canReadLine() && process.waitForReadyRead(longestBusWait)) {
    }
    return process.readLine().trimmed();
}

void end(QProcess &process)
{
    process.terminate();
    EXPECT_TRUE(process.waitForFinished(longestBusWait));
}

} // namespace

DesktopBus::DesktopBus()
    : m_before(qgetenv(busVariable))
{
    m_bus.start(QStringLiteral("dbus-daemon"),
                {QStringLiteral("--session"), QStringLiteral("--nofork"), QStringLiteral("--print-address"),
                 QStringLiteral("--address=unix:path=") + m_folder.filePath(QStringLiteral("bus"))});
    const QByteArray address = lineOf(m_bus);
    EXPECT_FALSE(address.isEmpty()) << m_bus.errorString().toStdString();
    qputenv(busVariable, address);
}

DesktopBus::~DesktopBus()
{
    qputenv(busVariable, m_before);
    if (m_service.state() != QProcess::NotRunning)
        end(m_service);
    end(m_bus);
}

void DesktopBus::serve(const QStringList &options)
{
    m_service.start(QStringLiteral(CODEWHEEL_PYTHON),
                    QStringList{QStringLiteral(CODEWHEEL_NOTIFICATION_SERVICE),
                                m_folder.filePath(QStringLiteral("bus"))} +
                        options);
    EXPECT_EQ(lineOf(m_service), QByteArray("ready")) << m_service.readAllStandardError().toStdString();
}

void DesktopBus::click(uint notice)
{
    m_service.write(QByteArray("click ") + QByteArray::number(notice) + '\n');
}

void DesktopBus::takeLines()
{
    while (m_service.canReadLine())
        m_lines += QString::fromUtf8(m_service.readLine());
}

std::vector<QJsonArray> DesktopBus::calls(const QString &name)
{
    takeLines();
    std::vector<QJsonArray> calls;
    for (const QString &line : std::as_const(m_lines)) {
        const QJsonObject call = QJsonDocument::fromJson(line.toUtf8()).object();
        if (call.value(QStringLiteral("call")).toString() == name)
            calls.push_back(call.value(QStringLiteral("values")).toArray());
    }
    return calls;
}

bool DesktopBus::waitForCalls(const QString &name, std::size_t count)
{
    return QTest::qWaitFor([&] { return calls(name).size() >= count; }, longestBusWait);
}

} // namespace codewheel::test
