// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace codewheel {

// A pseudo terminal that stands in for a serial port: the program under test opens path(), the test uses the
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
    // This many bytes sent by the program; fewer if they do not come within 20 s.
    QByteArray receive(qsizetype count);
    // This program no longer has the near end open. Another one has to have it by then.
    void leave();
    // The far end disappears, as when an adapter is unplugged.
    void unplug();

private:
    int m_far = -1;
    int m_near = -1; // open, so that what is sent before the program opens it is kept
    QString m_path;
};

} // namespace codewheel
