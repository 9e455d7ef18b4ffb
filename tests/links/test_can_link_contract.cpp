// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of links to a CAN bus, at an SLCAN adapter that shares no code with this program, and at a
// simulated SocketCAN interface.
#include "can/can_log_reader.h"
#include "can/can_log_writer.h"
#include "links/socket_can_link.h"
#include "tests/can/can_link_contract.h"
#include "tests/links/bench_can_device.h"
#include "tests/links/slcan_peer.h"

namespace codewheel::test {
namespace {

// "185#8813"
QString loggedFrame(CanFrame frame)
{
    frame.time = Instant();
    return QString::fromStdString(canLogLine(frame)).section(u' ', 2, 2).trimmed();
}

std::vector<CanFrame> framesOfLog(const QStringList &logged)
{
    std::vector<CanFrame> frames;
    CanLogReader reader([&](const CanFrame &frame) { frames.push_back(frame); },
                        [](std::int64_t, CanLogFault) { ADD_FAILURE(); });
    for (const QString &frame : logged)
        reader.read(QStringLiteral("(0000000000.000000) can0 %1\n").arg(frame).toStdString());
    reader.finish();
    return frames;
}

class SlcanBench final : public CanBench
{
public:
    CanLink &link() override { return m_peer.link(); }
    void peerSends(const CanFrame &frame) override
    {
        m_peer.order(QStringLiteral("bus ") + loggedFrame(frame));
    }
    std::vector<CanFrame> peerHeard() override { return framesOfLog(m_peer.order(QStringLiteral("heard"))); }
    void setPeerThere(bool there) override
    {
        m_peer.order(there ? QStringLiteral("go") : QStringLiteral("hold"));
    }
    void makeBusOff() override {}
    void unplug() override { m_peer.unplug(); }

private:
    SlcanPeer m_peer;
};

QCanBusFrame asQtHasIt(const CanFrame &frame)
{
    QCanBusFrame made(frame.isRemote ? QCanBusFrame::RemoteRequestFrame : QCanBusFrame::DataFrame);
    made.setExtendedFrameFormat(frame.isExtended);
    made.setFrameId(frame.id);
    made.setPayload(QByteArray(reinterpret_cast<const char *>(frame.bytes.data()), frame.length));
    return made;
}

CanFrame fromQt(const QCanBusFrame &frame)
{
    const QByteArray data = frame.payload();
    CanFrame made{.id = frame.frameId(),
                  .isExtended = frame.hasExtendedFrameFormat(),
                  .isRemote = frame.frameType() == QCanBusFrame::RemoteRequestFrame,
                  .length = static_cast<std::uint8_t>(data.size())};
    std::ranges::copy(data, made.bytes.begin());
    return made;
}

class SocketCanBench final : public CanBench
{
public:
    CanLink &link() override { return m_link; }
    void peerSends(const CanFrame &frame) override { m_bus->device->bring(asQtHasIt(frame)); }
    std::vector<CanFrame> peerHeard() override
    {
        std::vector<CanFrame> frames;
        for (const QCanBusFrame &frame : std::exchange(m_bus->heard, {}))
            frames.push_back(fromQt(frame));
        return frames;
    }
    void setPeerThere(bool there) override
    {
        m_bus->isAcknowledged = there;
        if (!there)
            return;
        for (const QCanBusFrame &frame : std::exchange(m_bus->written, {})) {
            m_bus->heard << frame;
            m_bus->device->echo(frame);
        }
    }
    void makeBusOff() override { m_bus->device->bringError(QCanBusFrame::BusOffError, {}); }
    void unplug() override { m_bus->interface.reset(); }

private:
    std::shared_ptr<BenchCanBus> m_bus = std::make_shared<BenchCanBus>();
    SocketCanLink m_link{QStringLiteral("can7"),
                         [this](const QString &) { return std::make_unique<BenchCanDevice>(m_bus); },
                         [this](const QString &) { return m_bus->interface; }};
};

INSTANTIATE_TEST_SUITE_P(AtAdapters, CanLinkContract,
                         testing::Values(CanLinkUnderTest{.name = "SLCAN",
                                                          .make =
                                                              [] { return std::make_unique<SlcanBench>(); },
                                                          .tellsBusOff = false},
                                         CanLinkUnderTest{.name = "SocketCAN", .make = [] {
                                                              return std::make_unique<SocketCanBench>();
                                                          }}));

} // namespace
} // namespace codewheel::test
