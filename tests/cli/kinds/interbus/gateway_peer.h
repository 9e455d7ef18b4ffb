// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/plan/ring_plan.h"
#include "tests/cli/cli_run.h"

#include <QProcess>
#include <QTemporaryDir>

namespace codewheel {

// A ring behind a gateway, served by tests/cli/kinds/interbus/gateway_peer.py, which knows nothing of this
// program.
class GatewayPeer
{
public:
    explicit GatewayPeer(const QString &options = {});
    ~GatewayPeer();
    Q_DISABLE_COPY_MOVE(GatewayPeer)

    // "modbus-tcp:127.0.0.1:40123", with these settings.
    QString link(const QString &settings = {}) const;
    QString where() const { return m_where; } // port, or path
    int writes();                             // of OUT, until now
    QString out();                            // all OUT words
    void vanish();

private:
    QString ask(const char *question);

    QProcess m_process;
    QString m_where;
    bool m_isRtu;
};

// A project with a ring of FRABA K3, and calls with it.
class RingProject
{
public:
    // `link`: as in its file; empty: the training one.
    explicit RingProject(int encoders = 3, const ProjectLink &link = {});

    QString file() const { return m_folder.filePath(QStringLiteral("ring.codewheel")); }
    QString path(const QString &name) const { return m_folder.filePath(name); }
    // EEPROM writes are counted in a file of its own.
    CliRun run(const QString &line, const QString &link, const Person &person = {}) const;

private:
    QTemporaryDir m_folder;
};

// As a project keeps it.
ProjectLink plannedLink(const GatewayPeer &peer);

} // namespace codewheel
