// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

namespace codewheel {

// A request as it came.
struct SeenRequest
{
    quint16 transaction = 0; // TCP only
    quint8 unit = 0;
    QByteArray message{}; // function code and data
};

// What a peer does with a request.
struct Reaction
{
    QByteArray bytes{}; // sent as they are
    bool hangsUp = false;
    std::chrono::milliseconds deafFor{}; // before it hangs up: requests that come meanwhile are not read
    bool inPieces = false;               // each byte by itself, a moment after the one before
    bool endlessly = false;              // again and again, until there is another request
};

// Answers Modbus requests as the test wants it to, in a thread of its own: over TCP, for one client after the
// other, or at the far end of a pseudo terminal, which it leaves open.
class CrookedPeer
{
public:
    using React = std::function<Reaction(const SeenRequest &)>;

    explicit CrookedPeer(React react); // on TCP
    CrookedPeer(React react, int line);
    ~CrookedPeer();
    CrookedPeer(const CrookedPeer &) = delete;
    CrookedPeer &operator=(const CrookedPeer &) = delete;

    void reactBy(React react);
    int port() const { return m_port; }
    int connections();

    // An answer as it goes over the way that a request of this transaction came by.
    static QByteArray tcpFrame(quint16 transaction, quint8 unit, const QByteArray &message);
    static QByteArray lineFrame(quint8 unit, const QByteArray &message);

private:
    void serveClients();
    void serve(int descriptor);
    bool waitFor(int descriptor) const;
    void send(int descriptor, const Reaction &reaction) const;
    QByteArray receive(int descriptor, qsizetype count) const;
    bool receiveOverTcp(int descriptor, SeenRequest &request) const;
    bool receiveOverLine(int descriptor, SeenRequest &request) const;

    std::mutex m_mutex;
    React m_react;
    int m_connections = 0;
    int m_listener = -1;
    int m_port = 0;
    int m_ended; // readable: the peer is to end
    std::thread m_thread;
};

// The right answer: each register has its own number as its value.
QByteArray rightAnswer(const QByteArray &message);

} // namespace codewheel
