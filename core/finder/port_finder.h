// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/place_finder.h"
#include "finder/spoken_protocol.h"

#include <QStringList>

#include <deque>

namespace codewheel {

// Looks for whoever is on the line of a serial port, in an order that disturbs nobody: it listens first, and
// where somebody talks it sends nothing, but finds out with which settings the talk makes sense. Only a line
// that is silent is asked, and only if that is agreed to. As soon as anything comes that is not the answer to
// the request just sent, a master talks, and nothing more is sent. Each next() does one step. Time is that of
// the link.
class PortFinder final : public PlaceFinder
{
public:
    static constexpr Instant firstListening{1'500'000}; // a master polls in that time
    static constexpr Instant nextListening{700'000};    // with other settings, where somebody talks
    // Before other settings are asked with, and after the first bytes that make no sense: ten times at most,
    // so that asking takes a quarter longer than without.
    static constexpr Instant listeningAgain{400'000};
    static constexpr Instant quietAfterFind{20'000};

    // `link` must outlive this and is used by nobody else meanwhile.
    PortFinder(ByteLink &link, bool mayAsk);
    ~PortFinder() override; // closes the link
    Q_DISABLE_COPY_MOVE(PortFinder)

    bool isDone() const override { return m_isDone; }
    FinderNews next() override;
    void interrupt() override;
    // Nothing came while it listened: asking may find out more.
    bool isSilent() const { return m_isSilent; }

private:
    enum class Phase : std::uint8_t { listen, tune, ask };

    FinderNews listen();
    FinderNews tune();
    FinderNews ask();
    FinderNews confirm(const Found &found);
    FinderNews endOfAsking();
    FinderNews masterCame(const QByteArray &bytes);
    FinderNews cancelled();
    FinderNews news(FinderNews::Kind kind, const QString &sentence) const;
    FinderNews refused(const Refusal &why);
    FinderNews end(FinderNews::Kind kind, const QString &sentence);
    FinderNews foundBy(const Found &found);
    Result<void> open(const SerialSettings &settings);
    Result<QByteArray> hear(Instant duration);
    Result<QByteArray> hearStrangers(Instant duration);
    Result<QByteArray> hearBefore(const SerialSettings &settings);
    bool isOfOther(const QByteArray &bytes) const;
    void noteSenseless(const QByteArray &bytes);
    void dropAsked();
    std::optional<Found> sense(const QByteArray &bytes) const;
    void startAsking();

    ByteLink &m_link;
    const bool m_mayAsk;
    Phase m_phase = Phase::listen;
    std::optional<SerialSettings> m_opened;
    std::deque<SerialSettings> m_settings; // to listen with
    struct Turn
    {
        const SpokenProtocol *protocol = nullptr;
        std::unique_ptr<Asking> asking{};
    };
    std::deque<Turn> m_turns;
    QStringList m_senseless;     // the settings with which bytes came that make no sense
    bool m_listensAgain = false; // before the next request
    int m_found = 0;
    bool m_isSilent = false;
    bool m_isDone = false;
    std::atomic<bool> m_isStopped = false;
};

// What asking these ports would send where they are silent, protocol by protocol.
QStringList askingAnnouncements(const QStringList &ports);

} // namespace codewheel
