// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_settings.h"
#include "widgets/connect/link_form.h"
#include "widgets/input/number_fields.h"
#include "widgets/kinds/canopen/can_interface_row.h"

#include <optional>

class QComboBox;
class QFormLayout;

namespace codewheel {

class CanInterfaceField;
class PortField;

// The link to a CAN bus: an interface of the system, or an adapter at a serial port. Its settings are those
// of CanSetting. Its plan is a CanopenPlan.
class CanSettingsForm final : public LinkForm
{
    Q_OBJECT

public:
    enum class Adapter : std::uint8_t {
        interface, // SocketCAN
        serial,    // SLCAN
    };

    explicit CanSettingsForm(Adapter adapter, QWidget *parent = nullptr);

    QString title() const override;
    QString sentence() const override;
    bool canBeTested() const override { return true; }
    bool showPlan(const KindData &plan) override;
    KindData plan() const override;
    QString wrong() const override;

    // For an interface; for a serial adapter see setPorts().
    void setInterfaces(const CanInterfaceRows &interfaces);
    CanopenSettings settings() const;

private:
    bool isSerial() const { return m_adapter == Adapter::serial; }
    void addFields() override;
    void showPorts(const std::vector<PortRow> &ports, const Trouble &trouble) override;
    void makeRate(QFormLayout &form);
    void makeBaudRate(QFormLayout &form);
    void showSettings(const CanopenSettings &settings);
    void chooseRate(int rate);
    QString where() const; // interface or port, as entered

    const Adapter m_adapter;
    CanopenSettings m_given; // until there are fields
    std::optional<CanInterfaceRows> m_interfaces;
    CanInterfaceField *m_interface = nullptr;
    PortField *m_port = nullptr;
    QComboBox *m_rate = nullptr;
    IntegerField *m_baudRate = nullptr;
};

} // namespace codewheel
