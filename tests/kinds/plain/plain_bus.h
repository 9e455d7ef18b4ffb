// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "tests/kinds/plain/plain_kind.h"
#include "tests/kinds/plain/plain_node.h"
#include "tests/kinds/plain/plain_run.h"
#include "tests/kinds/plain/plain_session.h"
#include "tests/kinds/plain/telegram_node.h"

#include <map>
#include <memory>

namespace codewheel::test {

struct PlainStation
{
    Place place;
    QString name;
    QString deviceKey{}; // empty: no encoder
};
std::vector<PlainStation> plainStations();    // two plain nodes and a lamp
std::vector<PlainStation> telegramStations(); // two that are only asked

// A bus of the tests' own kind, whose encoders are sent one line of a job a millisecond.
class PlainBus final : public EncoderBus
{
public:
    explicit PlainBus(const Catalog &catalog, const std::vector<PlainStation> &stations = plainStations());
    ~PlainBus() override;

    const BusOutline &outline() const override { return m_outline; }
    std::vector<Place> places() const override { return m_places; }
    const Catalog &catalog() const override { return m_catalog; }
    std::optional<Participant> found(Place place) const override;
    std::map<NodeId, Refusal> strangers(const std::vector<Participant> &) const override { return {}; }
    Result<void> canBe(Place, const DeviceDescription &) const override { return {}; }
    Result<void> name(Place place, const QString &deviceKey, int turns, int stepsPerTurn) override;
    BusState state() const override { return m_isOpen ? BusState::open : BusState::closed; }
    bool isSimulated() const override { return m_isSimulated; }
    bool isRunning() const override { return m_isOpen; }
    bool isOperating() const override { return m_isOpen && m_isOperating; }
    Instant now() const override { return m_now; }
    void pump() override {}
    void advance(Instant duration) override;
    void close() override;
    void setRunning(bool) override {}
    void setOperate(bool on) override;
    void alarmStop() override;
    using EncoderBus::tellTraffic;

    PlainNode &node(Place place);
    TelegramNode &telegram(Place place);
    void passForReal() { m_isSimulated = false; }
    void switchOffAndOn(Place place);
    void carryOut(JobCommand command);

private:
    struct Seat;

    EncoderSession *encoderAt(NodeId node) const override;
    Seat &seatAt(Place place);
    void turn(Seat &seat);
    void ask(Seat &seat);
    QByteArray exchange(Seat &seat, const QByteArray &line);
    void takePosition(Seat &seat);
    void show(Seat &seat);
    void endJobs(const Refusal &why);

    const Catalog &m_catalog;
    const std::vector<Place> m_places;
    const PlainOutline m_outline;
    std::vector<std::unique_ptr<Seat>> m_seats;
    Instant m_now{1'000};
    bool m_isSimulated = true;
    bool m_isOpen = true;
    bool m_isOperating = false;
};

} // namespace codewheel::test
