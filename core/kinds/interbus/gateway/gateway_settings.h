// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/register_port.h"
#include "kinds/interbus/ring/told_ring.h"
#include "serial/serial_settings.h"
#include "vocabulary/refusal.h"

#include <map>
#include <optional>

namespace codewheel {

// How a gateway that shows the process image of a ring as Modbus registers is reached, and where in its
// registers the image is. The map is the product's own, so all of it can be set; it is kept in the project
// (docs/protocols/modbus-gateway.md).
struct GatewaySettings
{
    enum class Transport : std::uint8_t { tcp, rtu };

    Transport transport = Transport::tcp;
    QString host{}; // name or address
    int tcpPort = modbus_limit::tcpPort;
    QString serialPort{}; // "/dev/ttyUSB0"
    SerialSettings serial{.baudRate = 19'200,
                          .dataBits = 8,
                          .parity = SerialSettings::Parity::even,
                          .stopBits = 1,
                          .lowLatency = true};
    int unit = 1;

    RegisterArea inArea = RegisterArea::input;
    int inFirst = 0;
    int outFirst = 0; // holding registers
    // By function 23, together with reading IN, which is in holding registers then.
    bool writesWithRead = false;
    bool highWordFirst = true;            // the first register is D31..D16
    std::optional<int> statusRegister{};  // in the area of IN; empty: none
    std::optional<int> controlRegister{}; // holding register; empty: none
    // What the status register means, by the manual of the gateway: without these nothing is taken from it.
    std::optional<int> runBit{};        // 1: the ring runs
    std::uint16_t faultBits = 0;        // any 1: it has failed
    std::optional<int> placeRegister{}; // where, in the area of IN (faultPlaceOf())
    // Whether OUT can be read back by function 3. Without it nobody notices what somebody else writes.
    bool readsBack = true;

    // Holding register that acknowledges a watchdog of the gateway that has tripped, and the value it takes.
    std::optional<int> watchdogRegister{};
    int watchdogValue = 1;

    int mostRead = modbus_limit::readRegisters;       // registers in one request
    int mostWritten = modbus_limit::writtenRegisters; // and with function 23 at most writtenWithRead

    // From one exchange to the next; 0: as fast as the link.
    Instant pollInterval = std::chrono::milliseconds(20);
    Instant reactionDelay{}; // after an exchange, until its words count as exchanged
    Instant timeOut = std::chrono::milliseconds(500);
    int retries = 2; // of a transaction without a valid answer
    // How far apart the gateway may copy the two registers of a word (spec modbus-gateway.md; assumed).
    Instant copyTime = std::chrono::milliseconds(3);
    // How long a gateway may be busy (exceptions 5, 6, 10, 11) until that counts as no answer.
    Instant patience = std::chrono::seconds(2);

    bool tellsRing() const { return statusRegister && (runBit || faultBits != 0); }

    friend bool operator==(const GatewaySettings &, const GatewaySettings &) = default;
};

// What the status register says of the ring, without the place of a fault; empty: its meaning is not set.
std::optional<ToldRing> toldRing(const GatewaySettings &settings, Register status);

inline constexpr char modbusTcpLink[] = "modbus-tcp";
inline constexpr char modbusRtuLink[] = "modbus-rtu";
bool isGatewayLink(const QString &kind);

// Limits of the settings, both ends included; those that no standard states are ours.
namespace gateway_limits {
struct Limits
{
    int least = 0;
    int most = 0;

    constexpr bool hold(int value) const { return value >= least && value <= most; }
};
inline constexpr Limits tcpPort{1, 65'535};
inline constexpr Limits tcpUnit{0, modbus_limit::lastUnit};
inline constexpr Limits rtuUnit{1, modbus_limit::lastSerialUnit};
inline constexpr Limits registers{0, modbus_limit::lastRegister};
inline constexpr Limits bit{0, 15};
inline constexpr Limits registerValue{0, 0xFFFF};
inline constexpr Limits mostRead{2, modbus_limit::readRegisters};
inline constexpr Limits mostWritten{2, modbus_limit::writtenRegisters};
inline constexpr Limits baudRate{1'200, 10'000'000};
inline constexpr Limits interval{0, 10'000}; // ms
inline constexpr Limits delay{0, 1'000};     // ms
inline constexpr Limits timeOut{10, 10'000}; // ms
inline constexpr Limits retries{0, 20};
inline constexpr Limits copyTime{0, 100};    // ms
inline constexpr Limits patience{0, 60'000}; // ms
} // namespace gateway_limits

// The settings by name, as projects keep them and the command line takes them: "unit" = "1". Only what
// differs from the defaults; without transport, host and serial port.
std::map<QString, QString> settingTexts(const GatewaySettings &settings);
std::map<QString, QString> allSettingTexts(const GatewaySettings &settings); // defaults too
// Takes them over into `settings`, whose transport decides which there are. Refused: linkSettingWrong,
// linkSettingUnknown; the first argument is the name.
Result<void> applySettings(GatewaySettings &settings, const std::map<QString, QString> &texts);
// All names for the transport, in the order of the table.
QStringList settingNames(GatewaySettings::Transport transport);

// The settings of a link as a project keeps it: all texts, with "host" and "port". Refused
// likewise.
Result<GatewaySettings> gatewaySettings(const QString &linkKind, const std::map<QString, QString> &texts);
QString linkKindOf(const GatewaySettings &settings); // "modbus-tcp"
std::map<QString, QString> linkTexts(const GatewaySettings &settings);
// "192.168.0.5:502", "/dev/ttyUSB0".
QString gatewayAddress(const GatewaySettings &settings);
// "192.168.0.5:502, unit 1".
QString gatewayUnit(const GatewaySettings &settings);
// As known to the user: the same, with the settings of a serial line.
QString gatewayText(const GatewaySettings &settings);

} // namespace codewheel
