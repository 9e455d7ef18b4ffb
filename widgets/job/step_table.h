// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"
#include "widgets/models/table_model_base.h"

#include <QString>

namespace codewheel {

struct DeviceDescription;

enum class StepState : std::uint8_t { planned, next, sent, done, failed };

struct StepRow
{
    Step step;
    QString what; // "Steps = 255"
    StepState state = StepState::planned;
    std::optional<Word> in; // what the encoder answered

    friend bool operator==(const StepRow &, const StepRow &) = default;
};

// The steps of a handshake: what, OUT, IN, state; on a serial line what, request, state. The review has no IN
// and no state.
class StepTable final : public TableModelBase<StepRow>
{
    Q_OBJECT

public:
    enum Column { what, out, in, state };
    enum class Stage { planned, running };

    explicit StepTable(Stage stage, QObject *parent = nullptr);

    // Keeps rows that are the same.
    void showSteps(const DeviceDescription &device, const std::vector<Step> &steps);
    // Has the steps and answers of another table.
    void goOnFrom(const DeviceDescription &device, std::vector<StepRow> rows, int current);
    void begin(); // no answers yet, all planned
    // steps[index] waits for the user, or is on its way; those before are done.
    void setCurrent(int index, bool waitsForUser);
    void answer(const Exchange &row);
    void finish(bool ok);
    int current() const { return m_current; }

protected:
    int columns() const override { return m_stage == Stage::planned ? 2 : m_isOnLine ? 3 : 4; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const StepRow &row, int column, int role) const override;

private:
    void setState(int row, StepState to);
    Column meaningOf(int column) const { return Column(m_isOnLine && column >= in ? state : column); }

    Stage m_stage;
    bool m_isOnLine = false; // a request instead of OUT, and no IN
    int m_current = -1;
};

} // namespace codewheel
