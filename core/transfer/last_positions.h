// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "vocabulary/encoder_session.h"

#include <map>
#include <set>

namespace codewheel {

class Buses;
class EncoderBus;

// The position an encoder had last.
struct SeenPosition
{
    std::int64_t position = 0; // steps
    QDateTime at{};
    // What came after it.
    enum class Since : std::uint8_t {
        there,     // the encoder was not seen to be away
        unwatched, // nobody saw the encoder for long: the computer slept, the bus was stopped or lost
        gone,      // the encoder was seen to be away: it may be another now
    };
    Since since = Since::there;
    // What was written at its place afterwards.
    enum class Scaled : std::uint8_t {
        asThen,
        perhapsOtherwise, // a position, or a scale of which nobody knows what it was then
        otherwise,        // there it would be another position
    };
    Scaled scaled = Scaled::asThen;
    ParameterValues scale{}; // known of the encoder with it

    friend bool operator==(const SeenPosition &, const SeenPosition &) = default;
};

// Whether it is another position with these values: what is not known of both is not compared.
bool isOfAnotherScale(const ParameterValues &then, const ParameterValues &values);
// Whether it is the same position with these values, apart from its zero: all that is known of one is known
// of both.
bool isOfTheSameScale(const ParameterValues &then, const ParameterValues &values);
// Of the scale a position was seen with: whether anything is known of it, apart from its zero; whether all
// that these values give is.
bool isScaleKnown(const ParameterValues &then);
bool isScaleKnown(const ParameterValues &then, const ParameterValues &values);

// What the encoder shows, to be kept in a project; empty if it shows no position.
std::optional<LastPosition> positionToKeep(const EncoderSession &encoder);

// Watches the positions of the encoders of all buses, so that a replacement can be given the position of the
// encoder it replaces, and so that they are kept with the project. Nothing is sent. An encoder is gone once
// it was seen to be away for a second: in a ring it shows 00000000 without power, or is behind a fault; on a
// serial line it is silent. Its last position is kept until the next time. While nobody looks nothing is
// seen: after a pause of the computer, or on a bus that was stopped, an encoder is not gone, but it may be
// another. One that comes back where it was is the same, and was not away: an earlier loss is still the one
// that counts, as is an earlier stop.
class LastPositions : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds untilGone{1000};
    // Nobody replaces an encoder faster, so a shorter time without a look at it does not matter, unless the
    // bus was stopped: people do that in order to replace one.
    static constexpr std::chrono::seconds shortestReplacement{30};

    explicit LastPositions(const Buses &buses, QObject *parent = nullptr);

    // The encoder there is to be replaced: whatever was begun before.
    void beginReplacement(Place number) { m_watched[number].isReplaced = false; }
    // From now on another encoder may show itself there. at() stays that of the one before until something
    // was written to the new one.
    void takeReplaced(Place number);

    // The one to give to a new encoder: the position before the encoder went away, if it did; otherwise
    // before nobody saw it for long; otherwise the newest one. While it is away once more, and nothing was
    // written at its place in between, that before the first time.
    std::optional<SeenPosition> at(Place number) const;
    // The newest one, of whichever encoder is there. It differs from at() if the encoder, or a new one, has
    // shown positions since it came back.
    std::optional<SeenPosition> newest(Place number) const;
    // One that a project keeps, with what became of it since. If the new encoder gets the scale it was seen
    // with (`settings`), another scale of an encoder seen since does not matter.
    SeenPosition kept(Place number, const LastPosition &kept, const ParameterValues &settings = {}) const;

private:
    struct Watched
    {
        bool isSimulated = false;
        std::optional<SeenPosition> last{};
        ParameterValues scale{};               // known of the encoder with it
        bool isScaleOld = true;                // something else is known of the encoder since
        std::optional<SeenPosition> before{};  // the encoder went away, or nobody saw it for long
        std::optional<SeenPosition> earlier{}; // the one before that, until it shows whether it is back
        QDateTime lookedAt{};                  // invalid: never
        std::chrono::milliseconds awayFor{};   // as seen
        bool isReplaced = false;               // `before` is of the encoder that was replaced
        bool mayBeScaled = false;              // by the job that runs, apart from values it writes

        const std::optional<SeenPosition> &replaced() const; // of the encoder to be replaced
    };

    const Watched *watched(Place number) const; // null: nothing was seen of it
    void look(const EncoderBus &bus);
    void look(const EncoderBus &bus, const EncoderSession &encoder, const QDateTime &now, Watched &watched);
    void follow(const EncoderBus &bus);
    void follow(const EncoderSession &encoder);
    void meetAgain(const EncoderBus &bus);
    void isSame(Place place);
    void isAnother(Place place);
    void compareScale(const EncoderSession &encoder);
    void scaledAnew(Place place, SeenPosition::Scaled how);
    void scaledAnew(Place place, const ParameterValues &written);
    static bool isBack(const Watched &watched, std::int64_t position);
    static void comeBack(Watched &watched, std::int64_t position);
    static void keepBefore(Watched &watched, SeenPosition::Since since);

    const Buses &m_buses;
    std::map<Place, Watched> m_watched;
    std::set<const QObject *> m_followed; // buses and encoders
};

// The project as it is to be saved: with the newest position of each encoder that is where the project has
// it.
Project withLastPositions(Project project, const LastPositions &positions, const Buses &buses);

} // namespace codewheel
