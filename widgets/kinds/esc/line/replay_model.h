// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_replay.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

struct ReplayRow
{
    ReplayStep step;
    std::optional<EscLineReplay::Verdict> verdict; // nothing: not sent yet
    QByteArray now;                                // the answer of today
};

// The requests of a recorded session that are sent again: the answers then and now.
class ReplayModel : public TableModelBase<ReplayRow>
{
    Q_OBJECT

public:
    enum Column { meaning, request, then, now, result };

    using TableModelBase::TableModelBase;

    void setSteps(const std::vector<ReplayStep> &steps);
    void setExplainOptions(const esc::ExplainOptions &options) { m_options = options; }
    void setAnswer(int row, EscLineReplay::Verdict verdict, const QByteArray &answer);
    int count(EscLineReplay::Verdict verdict) const;

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const ReplayRow &row, int column) const override;
    bool isNumber(int column) const override { return column == request || column == then || column == now; }
    QVariant cell(const ReplayRow &row, int column, int role) const override;

private:
    esc::ExplainOptions m_options;
};

} // namespace codewheel
