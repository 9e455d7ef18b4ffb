// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"
#include "widgets/connect/link_form.h"
#include "widgets/input/number_fields.h"

#include <map>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;

namespace codewheel {

class PortField;
class TextField;
struct GatewayPreset;
struct SettingField;

// The settings of a ring behind a Modbus gateway, for one transport. Its plan is a ProjectLink.
class GatewayForm final : public LinkForm
{
    Q_OBJECT

public:
    explicit GatewayForm(GatewaySettings::Transport transport, QWidget *parent = nullptr);

    QString title() const override;
    QString sentence() const override;
    bool canBeTested() const override { return true; }
    bool showPlan(const KindData &plan) override;
    KindData plan() const override;
    QString wrong() const override;
    QString complaint() const override;

    // Fills in settings that a test has found.
    void propose(const std::map<QString, QString> &texts);
    // What was used last, offered with the presets; empty: nothing.
    void setLast(const std::map<QString, QString> &texts);

private:
    using Texts = std::map<QString, QString>;

    void addFields() override;
    void showPorts(const std::vector<PortRow> &ports, const Trouble &trouble) override;
    void makeWhere(QFormLayout &form);
    void makePresets(QFormLayout &form);
    void addField(QFormLayout &form, const SettingField &field);
    Result<GatewaySettings> settings() const;
    Texts texts() const; // with host and port
    void setTexts(const Texts &texts);
    void showTexts(const Texts &texts);
    void showLast();
    Texts withRegistersOf(const GatewayPreset &preset) const;
    void usePreset(int index);
    void showPreset();

    const GatewaySettings::Transport m_transport;
    TextField *m_host = nullptr;
    IntegerField *m_tcpPort = nullptr;
    PortField *m_port = nullptr;
    QComboBox *m_preset = nullptr;
    QLabel *m_presetSentence = nullptr;
    Texts m_given; // all settings, as long as there are no fields
    Texts m_last;
    std::map<QString, IntegerField *> m_numbers; // by the name of the setting
    std::map<QString, QComboBox *> m_choices;
    std::map<QString, TextField *> m_texts;
    bool m_isSetting = false;
};

} // namespace codewheel
