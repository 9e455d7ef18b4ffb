// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "doctor/hindrance.h"
#include "links/computer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace codewheel {

// The folders in which a system tells about itself, made by hand.
class MadeComputer
{
public:
    // For users without rights too.
    MadeComputer() { EXPECT_EQ(::chmod(QFile::encodeName(m_folder.path()).constData(), 0755), 0); }
    Computer computer() const { return Computer(m_folder.path()); }

    void file(const QString &path, const QByteArray &contents = {})
    {
        folder(QFileInfo(path).path());
        QFile file(m_folder.path() + path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(contents + '\n');
    }
    void folder(const QString &path) { EXPECT_TRUE(QDir().mkpath(m_folder.path() + path)); }
    void link(const QString &path, const QByteArray &target)
    {
        folder(QFileInfo(path).path());
        EXPECT_EQ(::symlink(target.constData(), QFile::encodeName(m_folder.path() + path).constData()), 0);
    }
    void process(int id, const QByteArray &name, int terminal = 0)
    {
        file(QStringLiteral("/proc/%1/stat").arg(id),
             QByteArray::number(id) + " (" + name + ") S 1 1 1 " + QByteArray::number(terminal) + " -1");
        folder(QStringLiteral("/proc/%1/fd").arg(id));
    }
    // With a driver if it has one, and then with a port.
    void adapter(const QString &place, const QByteArray &vendor, const QByteArray &product,
                 const QByteArray &name, const QByteArray &driver = {})
    {
        const QString folder = QStringLiteral("/sys/bus/usb/devices/") + place;
        file(folder + QStringLiteral("/idVendor"), vendor);
        file(folder + QStringLiteral("/idProduct"), product);
        file(folder + QStringLiteral("/product"), name);
        const QString interface = folder + u'/' + place + QStringLiteral(":1.0");
        this->folder(interface);
        if (!driver.isEmpty())
            link(interface + QStringLiteral("/driver"), "../../../../bus/usb/drivers/" + driver);
        if (!driver.isEmpty() && driver != "usbfs")
            this->folder(interface + QStringLiteral("/ttyUSB0"));
    }

private:
    QTemporaryDir m_folder;
};

inline std::vector<QString> idsOf(const std::vector<Hindrance> &hindrances)
{
    std::vector<QString> ids;
    for (const Hindrance &one : hindrances)
        ids.push_back(hindranceKey(one.id));
    return ids;
}

} // namespace codewheel
