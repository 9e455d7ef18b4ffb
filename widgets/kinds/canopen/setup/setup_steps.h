// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/setup/node_setup.h"

#include <QStringList>
#include <QWidget>

#include <vector>

class QVBoxLayout;

namespace codewheel {

class RoleLabel;

// The steps of what is done with a device, one below the other, each with how it stands.
class SetupSteps final : public QWidget
{
    Q_OBJECT

public:
    explicit SetupSteps(QWidget *parent = nullptr);

    struct Row
    {
        canopen::NodeSetup::StepState state;
        QString text;
    };
    void show(const std::vector<Row> &rows);
    QStringList shown() const; // "done: It is reset"

private:
    QVBoxLayout *m_column;
    std::vector<RoleLabel *> m_rows;
};

} // namespace codewheel
