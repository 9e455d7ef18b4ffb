// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_bus.h"
#include "bus/word_channel.h"
#include "replay/playback.h"
#include "replay/recorded_rows.h"
#include "replay/replay_outline.h"
#include "replay/replay_session.h"

namespace codewheel {

// One bus of a recording, as views see any bus: it shows what the bus showed at the moment its Playback is
// at, and sends nothing. What passed on it is told as the moment goes forward; after a jump, and while it
// goes backward, the traffic begins anew with what passed just before.
class ReplayBus final : public EncoderBus
{
    Q_OBJECT

public:
    static constexpr std::size_t mostRowsAtOnce = 500; // of the traffic; of more, the newest
    static constexpr std::size_t mostRowsBefore = 100; // that it begins anew with

    // The recorded bus is shown under another number. All buses of a recording share its playback; the first
    // of them passes its time where they are driven by hand.
    ReplayBus(std::shared_ptr<Playback> playback, BusId recorded, BusId id, QString name,
              const Catalog &catalog, QObject *parent = nullptr);
    ~ReplayBus() override;

    const std::shared_ptr<Playback> &playback() const { return m_playback; }
    BusId recorded() const { return m_recorded; } // its number in the recording
    const QString &title() const { return m_name; }
    Place inRecording(Place place) const { return {m_recorded, place.node}; }

    const BusOutline &outline() const override { return m_outline; }
    std::vector<Place> places() const override;
    const Catalog &catalog() const override { return m_catalog; }
    std::optional<Participant> found(Place place) const override;
    std::map<NodeId, Refusal> strangers(const std::vector<Participant> &) const override { return {}; }
    Result<void> canBe(Place place, const DeviceDescription &device) const override;
    Result<void> name(Place place, const QString &deviceKey, int turns, int stepsPerTurn) override;

    BusState state() const override { return m_isOpen ? BusState::open : BusState::closed; }
    bool isSimulated() const override { return false; }
    bool isReplay() const override { return true; }
    bool hasTerminal() const override { return m_rows->areOfTerminal(); }
    bool isRunning() const override { return m_isOpen; }
    bool isOperating() const override { return false; }
    Instant now() const override { return m_shownAt; }
    QDateTime dateTime(Instant at) const override { return m_playback->dateTime(at); }

    void pump() override;
    void advance(Instant duration) override;
    void close() override;
    void setRunning(bool) override {}
    void setOperate(bool on) override; // refused, with a message
    void alarmStop() override {}

private:
    struct Device
    {
        std::size_t index = 0; // of the recorded encoder in the playback
        Place place{};
        std::unique_ptr<ReplayEncoderSession> session{}; // null: its description is not in the catalog
        std::unique_ptr<WordChannel> words{};
        RecordedDevice described{}; // without its values
    };

    EncoderSession *encoderAt(NodeId node) const override;
    WordChannel *channelAt(NodeId node) const override;
    const Device *find(NodeId node) const;
    RecordedEncoder &recordedOf(const Device &device) const { return m_playback->encoders()[device.index]; }
    bool describe(Device &device); // whether it is another one now
    void describeAll();
    void show(const Device &device, Instant from);
    void tellTrafficOf(const TimeSpan &span, std::size_t most);
    void tellMessagesOf(const TimeSpan &span);

    const std::shared_ptr<Playback> m_playback;
    const BusId m_recorded;
    const QString m_name;
    const Catalog &m_catalog;
    std::unique_ptr<RecordedRows> m_rows;
    std::vector<Device> m_devices; // by node
    std::vector<std::unique_ptr<QObject>> m_retired;
    ReplayOutline m_outline;
    Instant m_shownAt = Instant::min();
    int m_jumps = -1;
    bool m_isOpen = true;
};

Refusal onlyRecorded();

} // namespace codewheel
