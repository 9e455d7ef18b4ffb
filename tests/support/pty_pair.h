// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace codewheel {

// A pseudo terminal that stands in for a serial port: the program under test opens path(), the test has the
// other end.
class PtyPair
{
public:
    PtyPair();
    ~PtyPair();
    PtyPair(const PtyPair &) = delete;
    PtyPair &operator=(const PtyPair &) = delete;

    QString path() const { return m_path; }
    int descriptor() const { return m_far; } // of the far end
    void send(const QByteArray &bytes);
    // So many bytes that the program sent; fewer where they do not come within 20 s.
    QByteArray receive(qsizetype count);
    // The far end goes, as when an adapter is unplugged.
    void unplug();

private:
    int m_far = -1;
    int m_near = -1; // kept, so that what is sent before the program opens it is there
    QString m_path;
};

} // namespace codewheel
